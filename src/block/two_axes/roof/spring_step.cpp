// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/roof/spring_step.hpp"

#include "block/full_model/chord_deviation.hpp"

namespace glissade::block_detail::two_axes {

/// x' = stiffness omega y,   y' = omega (a - a_ground),   a = -(2 zeta y + x) / (1 + r), of a state
/// or ground that is 1 and all else 0.
SpringStep::SpringStep(double phase, double stiffness, double twice_zeta, double per_mass) {
  constexpr std::size_t terms = Series::most_terms;
  for (std::size_t j = 0; j < 4; ++j) {
    std::array<double, terms> x{}, y{}, a{};
    x[0] = j == 0 ? 1.0 : 0.0;
    y[0] = j == 1 ? 1.0 : 0.0;
    const double ground[] = {j == 2 ? 1.0 : 0.0, j == 2 ? -1.0 : j == 3 ? 1.0 : 0.0};
    for (std::size_t k = 0; k < terms; ++k) {
      a[k] = -(twice_zeta * y[k] + x[k]) * per_mass;
      if (k + 1 == terms) break;
      const double factor = phase * Series::inverse[k + 1];
      x[k + 1] = stiffness * (factor * y[k]);
      y[k + 1] = factor * (k < 2 ? a[k] - ground[k] : a[k]);
    }
    to_x_[j] = Series{x, terms}.at(1.0);
    to_y_[j] = Series{y, terms}.at(1.0);
    a_deviation_[j] = chord_deviation(a);
    x_deviation_[j] = chord_deviation(x);
    y_deviation_[j] = chord_deviation(y);
  }
}

}  // namespace glissade::block_detail::two_axes
