// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

namespace glissade {

/// Where f, of these values at both ends, changes its sign between them, to `bits` of it.
template <class Function>
double root_between(const Function& f, double low, double high, double f_low, double f_high,
                    int bits) {
  std::uintmax_t iterations = 200;
  const auto [below, above] = boost::math::tools::toms748_solve(
      f, low, high, f_low, f_high, boost::math::tools::eps_tolerance<double>(bits), iterations);
  return 0.5 * (below + above);
}
template <class Function>
double root_between(const Function& f, double low, double high, int bits) {
  return root_between(f, low, high, f(low), f(high), bits);
}

}  // namespace glissade
