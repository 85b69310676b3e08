// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "block/contact/line.hpp"

namespace glissade::block_detail {

/// The factors of each order k as doubles: converting k would take as long as the rest.
struct SeriesFactors {
  static constexpr int most_terms = 20;
  using All = std::array<double, most_terms + 1>;
  static constexpr All all(double (*of)(double)) {
    All factors{};
    for (int k = 1; k <= most_terms; ++k) factors[k] = of(k);
    return factors;
  }
};

/// A power series on a piece of time; tau in [0, 1] is the elapsed fraction of the piece.
struct Series {
  static constexpr int most_terms = SeriesFactors::most_terms;
  static constexpr auto order = SeriesFactors::all([](double k) { return k; });
  static constexpr auto inverse = SeriesFactors::all([](double k) { return 1.0 / k; });
  static constexpr auto second = SeriesFactors::all([](double k) { return k * (k - 1.0); });

  std::array<double, most_terms> c;  // the first `terms`
  int terms = 0;

  double at(double tau) const {
    double sum = 0.0;
    for (int k = terms; k-- > 0;) sum = sum * tau + c[k];
    return sum;
  }
  Series slope() const {
    Series d;
    d.terms = terms > 0 ? terms - 1 : 0;
    for (int k = 1; k < terms; ++k) d.c[k - 1] = order[k] * c[k];
    return d;
  }
  /// Its integral over time from the start of the piece, with the initial value `begin`.
  Series integral(double length_s, double begin) const {
    Series s;
    s.terms = terms + 1;
    s.c[0] = begin;
    for (int k = 0; k < terms; ++k) s.c[k + 1] = length_s * c[k] * inverse[k + 1];
    return s;
  }
  /// No |value| on the piece is larger.
  double bound() const {
    double sum = 0.0;
    for (int k = 0; k < terms; ++k) sum += std::abs(c[k]);
    return sum;
  }
};

inline double coefficient(const Series& s, int k) {
  return k < s.terms ? s.c[static_cast<std::size_t>(k)] : 0.0;
}

/// Of a series or of its negative.
enum class Sign { plus, minus };

/// The first tau at which the series becomes negative, or never. A series that begins at zero is
/// negative at once only if it decreases from zero.
/// @throw NotConverged if it is not finite
double first_fall(const Series& series, Sign sign = Sign::plus);
inline double first_rise(const Series& series) { return first_fall(series, Sign::minus); }

/// The largest |value| up to tau = end, including the first extremum.
double largest(const Series& series, double end);
/// The largest value, the same.
double highest(const Series& series, double end);

}  // namespace glissade::block_detail
