// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/events/coupled_spring.hpp"

namespace glissade::block_detail {

// Just after unloading z = limit, and y is zero or leads away from it. Where y = 0, z leaves the
// limit in the direction of the first non-zero term of y. That term has the same bits, elastic and
// yielding, so exactly one of the two continues.
double Spring::yield_fraction(const Series& x, int side) const {
  Series left;  // up to the limit
  left.terms = x.terms;
  double largest_change = 0.0;
  for (int k = 1; k < x.terms; ++k) {
    left.c[k] = -side * x.c[k];
    largest_change += std::abs(x.c[k]);
  }
  left.c[0] = limit_ - side * z_;
  return left.c[0] > largest_change ? never : first_fall(left);
}

double Spring::unload_fraction(const Series& y) const {
  return first_fall(y, direction_ > 0 ? Sign::plus : Sign::minus);
}

void Spring::pass(const Series& x, double fraction) {
  Series change = x;
  change.c[0] = 0.0;
  if (yielding())
    dissipated_ += (1.0 - alpha_) * limit_ * direction_ * change.at(fraction);
  else
    z_ += change.at(fraction);
}

void Spring::yield(int side) {
  direction_ = side;
  z_ = side * limit_;
}

}  // namespace glissade::block_detail
