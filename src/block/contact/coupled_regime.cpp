// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/contact/coupled_regime.hpp"

namespace glissade::block_detail {

RegimeOscillator::RegimeOscillator(const ContactRegime& regime, double gravity,
                                   const BuildingOscillator& building, double step_s)
    : contact(regime),
      gravity_mps2(gravity),
      omega_radps(building.omega_radps),
      dt_s(step_s),
      lag(2.0 * building.damping_ratio / (building.omega_radps * step_s)),
      alpha_radps(building.damping_ratio * building.omega_radps / contact.mass),
      beta_radps(std::sqrt(building.omega_radps * building.omega_radps / contact.mass -
                           alpha_radps * alpha_radps)),
      phase(building.omega_radps / std::sqrt(contact.mass) * step_s),
      omega2(omega_radps * omega_radps),
      per_omega(1.0 / omega_radps),
      per_omega2(1.0 / omega2),
      per_beta(1.0 / beta_radps),
      per_mass(1.0 / contact.mass),
      angle(omega_radps * step_s),
      per_angle(1.0 / angle),
      s2_size(omega2 / contact.mass),
      s{-alpha_radps, beta_radps},
      s2(s * s) {
  const double size = std::exp(-alpha_radps * dt_s), turn = beta_radps * dt_s;
  const Amplitude interval{size * std::cos(turn), size * std::sin(turn)};
  powers[0] = {1.0, 0.0};
  for (std::size_t n = 1; n < window; ++n) powers[n] = powers[n - 1] * interval;
  squares[0] = powers[window - 1] * interval;
  for (std::size_t k = 1; k < squares.size(); ++k) squares[k] = squares[k - 1] * squares[k - 1];
  for (std::size_t n = 0; n < window; ++n) {
    power_re[n] = static_cast<float>(powers[n].re);
    power_im[n] = static_cast<float>(powers[n].im);
  }
}

}  // namespace glissade::block_detail
