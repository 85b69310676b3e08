// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/contact/two_axis_contact.hpp"

namespace glissade::block_detail {

// v_i = p_i sigma / (sigma + lambda mu_i^2) with sigma = |(mu_s v_s, mu_y v_y)|, so sigma is the
// root of |x| = 1, x_i = mu_i p_i / (sigma + lambda mu_i^2). Newton's method on 1/|x|, which is
// nearly a line in sigma (Hebden 1973).
Vector FrictionEllipse::on_ellipse(Vector p, double lambda) const {
  const Vector forced = scaled(mu_, p), shift = lambda * scaled(mu_, mu_);
  const double least = std::max(0.0, length(forced) - std::max(shift.s, shift.y));
  // To the first order in lambda, friction shortens p as a circle's would.
  const Vector squares = scaled(forced, forced);
  double sigma = std::max(least, length(forced) - dot(squares, shift) / (squares.s + squares.y));
  Vector x;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vector divisor{sigma + shift.s, sigma + shift.y};
    x = {forced.s / divisor.s, forced.y / divisor.y};
    const double size = length(x), excess = size - 1.0;
    if (std::abs(excess) <= 4.0 * std::numeric_limits<double>::epsilon()) break;
    const double change = excess * size * size / (x.s * x.s / divisor.s + x.y * x.y / divisor.y);
    sigma = std::max(least, sigma + change);
  }
  return scaled(mu_, x);
}

}  // namespace glissade::block_detail
