// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupled_spring.hpp"

namespace glissade::block_detail {

// Having just unloaded, z = limit and y = 0 exactly: it leaves the limit as the first term of y
// that is not zero says. That term is the same, to the bit, elastic and yielding, so that one of
// the two goes on.
double Spring::yield_share(const Series& x, int side) const {
  Series left;  // up to the limit
  left.terms = x.terms;
  double swing = 0.0;
  for (int k = 1; k < x.terms; ++k) {
    left.c[k] = -side * x.c[k];
    swing += std::abs(x.c[k]);
  }
  left.c[0] = at_limit_ == side ? 0.0 : limit_ - side * (x.c[0] - plastic_);
  return left.c[0] > swing ? never : first_fall(left);
}

double Spring::unload_share(const Series& y) const {
  return first_fall(y, direction_ > 0 ? Sign::plus : Sign::minus);
}

void Spring::pass(double x_begin, double x_end, double share) {
  if (share > 0.0) at_limit_ = 0;
  if (direction_ == 0) return;
  dissipated_ += (1.0 - alpha_) * limit_ * direction_ * (x_end - x_begin);
  plastic_ = x_end - direction_ * limit_;
}

void Spring::yield(int side, double x) {
  direction_ = side;
  at_limit_ = 0;
  plastic_ = x - side * limit_;
}

void Spring::unload() {
  at_limit_ = direction_;
  direction_ = 0;
}

}  // namespace glissade::block_detail
