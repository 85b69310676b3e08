// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/roof/spring_step.hpp"

#include "block/full_model/chord_deviation.hpp"
#include "block/two_axes/roof/one_mass_series.hpp"

namespace glissade::block_detail::two_axes {

/// Of a state or ground that is 1, all else 0.
SpringStep::SpringStep(double phase, double stiffness, double twice_zeta, double per_mass) {
  constexpr auto terms = static_cast<std::size_t>(Series::most_terms);
  for (std::size_t j = 0; j < 4; ++j) {
    OneMassSeries::Terms x{}, y{}, a{};
    x[0] = j == 0 ? 1.0 : 0.0;
    y[0] = j == 1 ? 1.0 : 0.0;
    const double begin = j == 2 ? 1.0 : 0.0, end = j == 3 ? 1.0 : 0.0;  // ground
    const OneMassSeries axis{phase, stiffness, twice_zeta, per_mass, {begin, end - begin}};
    axis.expand(terms, x, y, a);
    to_x_[j] = Series{x, terms}.at(1.0);
    to_y_[j] = Series{y, terms}.at(1.0);
    a_deviation_[j] = chord_deviation(a);
    x_deviation_[j] = chord_deviation(x);
    y_deviation_[j] = chord_deviation(y);
  }
}

}  // namespace glissade::block_detail::two_axes
