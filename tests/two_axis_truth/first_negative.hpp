// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "two_axis_truth/radau.hpp"

namespace glissade::test {

/// Power series over [0, 1].
constexpr std::size_t terms = 24;
using Series = std::array<Long, terms>;

inline Series plus(const Series& a, Long factor, const Series& b) {
  Series sum;
  for (std::size_t k = 0; k < terms; ++k) sum[k] = a[k] + factor * b[k];
  return sum;
}

inline Series product(const Series& a, const Series& b) {
  Series c{};
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; i + j < terms; ++j) c[i + j] += a[i] * b[j];
  return c;
}

inline Long value(const Series& s, Long x) {
  Long sum = 0;
  for (std::size_t k = terms; k-- > 0;) sum = sum * x + s[k];
  return sum;
}

inline Long rate(const Series& s, Long x) {
  Long sum = 0;
  for (std::size_t k = terms; k-- > 1;) sum = sum * x + static_cast<Long>(k) * s[k];
  return sum;
}

/// The first x in [0, 1] at which the series is negative; 1 if there is none. An interval is passed
/// over only where a bound on the second derivative proves the series positive.
inline Long first_negative(const Series& s) {
  Long bound = 0;
  for (std::size_t k = 2; k < terms; ++k) bound += static_cast<Long>(k * (k - 1)) * std::abs(s[k]);
  const auto search = [&](const auto& self, Long a, Long b) -> Long {
    const Long width = b - a, at_b = value(s, b);
    if (std::min(value(s, a), at_b) > bound * width * width / 8.0L) return 1.0L;
    if (width < 1e-19L) return at_b < 0.0L ? b : 1.0L;
    const Long middle = 0.5L * (a + b), found = self(self, a, middle);
    return found < 1.0L ? found : self(self, middle, b);
  };
  return search(search, 0.0L, 1.0L);
}

}  // namespace glissade::test
