// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/mathematics.hpp"

#include <cmath>

#include "glissade/core/hash.hpp"

namespace glissade {

std::string mathematics() {
  Hasher hasher;
  constexpr int count = 2000;
  for (int i = 1; i <= count; ++i) {
    const double x = 2.0 * i / count;
    for (const double y : {std::exp(x), std::expm1(x), std::exp2(x), std::log(x), std::log1p(x),
                           std::log2(x), std::log10(x), std::pow(x, 1.7), std::hypot(x, 0.7),
                           std::sin(x), std::cos(x), std::tan(x), std::asin(0.5 * x), std::atan(x),
                           std::atan2(x, 0.7), std::erfc(x), std::lgamma(x)})
      hasher.number(y);
  }
  return to_hex(hasher.value());
}

}  // namespace glissade
