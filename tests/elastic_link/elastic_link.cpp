// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic_link/elastic_link.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/contract.hpp"

namespace glissade::test {
namespace {

/// Stiffness per mass, 1/s2, of a spring that carries a weight of 1 N.
double omega_squared(const ElasticLink& link, const Block& block) {
  return 1000.0 * link.stiffness_npmm * block.gravity_mps2;
}

/// Wen's z after a displacement of x yield displacements: dz/dx = 1 - z^2 while loading, 1 while
/// unloading.
double wen(double z, double x) {
  if (z * x < 0.0) {
    if (std::abs(x) <= std::abs(z)) return z + x;
    x += z;
    z = 0.0;
  }
  const double t = std::tanh(x);
  return (z + t) / (1.0 + z * t);
}

/// The link along the slope: a force per mass of at most mu N, elastic at first.
class Shear {
 public:
  Shear(FrictionLaw law, double omega_squared, double static_force, double static_strength)
      : law_(law),
        omega_squared_(omega_squared),
        static_force_(static_force),
        force_(static_force),
        share_(static_force / static_strength) {}

  double force(double displacement, double strength) {
    const double trial = omega_squared_ * (displacement - displacement_);
    displacement_ = displacement;
    if (law_ == FrictionLaw::elastic_plastic || strength == 0.0) {
      force_ = std::clamp(force_ + trial, -strength, strength);
    } else {
      share_ = wen(share_, trial / strength);
      force_ = strength * share_;
    }
    return force_;
  }

  /// Displacement less the spring's deflection.
  double slider() const { return displacement_ - (force_ - static_force_) / omega_squared_; }

 private:
  FrictionLaw law_;
  double omega_squared_, static_force_, force_, share_;
  double displacement_ = 0.0;
};

/// Newmark's explicit half of one degree of freedom.
struct Motion {
  double displacement, velocity = 0.0, acceleration = 0.0;

  void move(double dt) { displacement += dt * (velocity + 0.5 * dt * acceleration); }
  void accelerate(double dt, double next) {
    velocity += 0.5 * dt * (acceleration + next);
    acceleration = next;
  }
};

class SteppedLink {
 public:
  SteppedLink(const ElasticLink& link, const Block& block, double slope)
      : omega_squared_(omega_squared(link, block)),
        mu_(block.friction.along),
        along_(block.gravity_mps2 * std::sin(slope)),
        normal_(block.gravity_mps2 * std::cos(slope)),
        sin_(std::sin(slope)),
        cos_(std::cos(slope)),
        shear_(link.law, omega_squared_, along_, mu_ * normal_),
        slip_{0.0},
        compression_{normal_ / omega_squared_} {}

  /// One substep, to the roof's acceleration at its end.
  void step(double dt, double roof_mps2) {
    slip_.move(dt);
    compression_.move(dt);
    const double normal = std::max(0.0, omega_squared_ * compression_.displacement);
    const double shear = shear_.force(slip_.displacement, mu_ * normal);
    slip_.accelerate(dt, along_ - roof_mps2 * cos_ - shear);
    compression_.accelerate(dt, normal_ + roof_mps2 * sin_ - normal);
    peak_ = std::max(peak_, std::abs(slider_m()));
  }

  double slider_m() const { return shear_.slider() * cos_; }
  double peak_m() const { return peak_; }

 private:
  double omega_squared_, mu_, along_, normal_, sin_, cos_;
  Shear shear_;
  Motion slip_, compression_;
  double peak_ = 0.0;
};

/// With the roof at rest: until the slider has been where it is for a second.
void come_to_rest(SteppedLink& body, double dt) {
  constexpr double still_s = 1.0, longest_s = 100.0;
  constexpr double rounding_m = 1e-12;
  double rests_at = body.slider_m(), since = 0.0;
  for (double time = 0.0; time - since < still_s && time < longest_s; time += dt) {
    body.step(dt, 0.0);
    if (std::abs(body.slider_m() - rests_at) <= rounding_m) continue;
    rests_at = body.slider_m();
    since = time;
  }
}

}  // namespace

double explicit_step(const ElasticLink& link, const Block& block) {
  return std::sqrt(omega_squared(link, block)) * link.longest_substep_s;
}

LinkSlip slide_on_elastic_link(const RoofAcceleration& roof, const Block& block,
                               const ElasticLink& link) {
  GLISSADE_EXPECTS(link.stiffness_npmm > 0.0 && link.longest_substep_s > 0.0);
  GLISSADE_EXPECTS(roof.vertical_mps2.empty() && block.directions == SlipDirections::both);
  const double slope = std::abs(block.slope_rad);
  GLISSADE_EXPECTS(block.friction.along > std::tan(slope));
  const double factor = (block.slope_rad < 0.0 ? -1.0 : 1.0) * roof.horizontal_factor;
  const auto& samples = roof.horizontal_mps2;
  const auto sample = [&](std::size_t i) { return i < samples.size() ? factor * samples[i] : 0.0; };
  const int parts = static_cast<int>(std::ceil(roof.dt_s / link.longest_substep_s * (1.0 - 1e-9)));
  const double dt = roof.dt_s / parts;

  SteppedLink body(link, block, slope);
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (int part = 1; part <= parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      body.step(dt, sample(i) + share * (sample(i + 1) - sample(i)));
    }
  come_to_rest(body, dt);
  return {body.peak_m(), body.slider_m()};
}

}  // namespace glissade::test
