// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/events/coupled_energy.hpp"

#include <boost/math/quadrature/gauss.hpp>

namespace glissade::block_detail {

void EnergyMeter::add(const GroundPiece& ground, const RoofMotionSeries& roof,
                      const SlipSeries& slip, double end) {
  const double r = contact_.mass_ratio(), sine = contact_.sin_slope(), g = contact_.gravity(),
               cosine = contact_.cos_slope(), omega = building_.omega_radps;
  const auto at = [&](double tau) {
    const double a_g = ground.begin.a + tau * (ground.end.a - ground.begin.a);
    const double w = ground.begin.w + tau * (ground.end.w - ground.begin.w);
    const double u_velocity = building_.rigid() ? 0.0 : roof.y.at(tau) / omega;
    const double speed = slip.direction == 0 ? 0.0 : slip.speed.at(tau);
    const double v = slip.direction * speed;
    const double normal = (g + w) * cosine + roof.a.at(tau) * sine;
    struct Power {
      double input, gravity, damped, friction;
    };
    return Power{-a_g * (u_velocity + r * (u_velocity + v * cosine)) + r * w * v * sine,
                 r * g * v * sine, 2.0 * building_.damping_ratio * omega * u_velocity * u_velocity,
                 r * slip.friction * normal * speed};
  };
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  const auto add_point = [&](double tau, double weight_s) {
    const auto power = at(tau);
    sum_.input_m2ps2 += weight_s * power.input;
    sum_.gravity_m2ps2 += weight_s * power.gravity;
    sum_.damped_m2ps2 += weight_s * power.damped;
    sum_.friction_m2ps2 += weight_s * power.friction;
  };
  const double half = 0.5 * end;
  for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
    const double z = Gauss::abscissa()[k], weight_s = half * Gauss::weights()[k] * ground.length_s;
    add_point(half * (1.0 + z), weight_s);
    if (z != 0.0) add_point(half * (1.0 - z), weight_s);
  }
}

CoupledEnergy EnergyMeter::total(const RoofState& state, const Spring& spring,
                                 double slip_velocity_mps) const {
  CoupledEnergy e = sum_;
  const double per_omega = building_.rigid() ? 0.0 : 1.0 / building_.omega_radps;
  const double u_velocity = state.y * per_omega;
  const double along = u_velocity + slip_velocity_mps * contact_.cos_slope();
  const double down = slip_velocity_mps * contact_.sin_slope();
  e.kinetic_m2ps2 =
      0.5 * (u_velocity * u_velocity + contact_.mass_ratio() * (along * along + down * down));
  e.strain_m2ps2 = spring.stored_m2ps2(state.x, per_omega);
  e.hysteretic_m2ps2 = spring.dissipated() * (per_omega * per_omega);
  return e;
}

}  // namespace glissade::block_detail
