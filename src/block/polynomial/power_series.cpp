// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/polynomial/power_series.hpp"

#include <algorithm>
#include <limits>

#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct ValueAndSlope {
  double value, slope;
};
ValueAndSlope at(const Series& f, double tau) {
  double value = 0.0, slope = 0.0;
  for (int k = f.terms; k-- > 0;) {
    slope = slope * tau + value;
    value = value * tau + f.c[k];
  }
  return {value, slope};
}

double curvature_at(const Series& f, double tau) {
  double sum = 0.0;
  for (int k = f.terms; k-- > 2;) sum = sum * tau + Series::second[k] * f.c[k];
  return sum;
}

struct Point {
  double tau, value;
};

/// The root of the first three terms between a and b, or else that of the chord.
double first_guess(const Series& f, const Point& a, const Point& b) {
  const double low = std::min(a.tau, b.tau), high = std::max(a.tau, b.tau);
  if (f.terms > 2) {
    const double c0 = f.c[0], c1 = f.c[1], c2 = f.c[2];
    const double discriminant = c1 * c1 - 4.0 * c0 * c2;
    const double q = -0.5 * (c1 + std::copysign(std::sqrt(std::max(discriminant, 0.0)), c1));
    for (const double tau : {c0 / q, q / c2})
      if (tau > low && tau < high) return tau;
  }
  return a.tau + (b.tau - a.tau) * (a.value / (a.value - b.value));
}

/// The root of f between `above`, where f >= 0, and `below`, where f < 0 (in either order), to
/// rounding: Newton's method kept inside the bracket. It doubles the correct digits, so the step
/// after one of 1e-9 is below rounding.
double root_between(const Series& f, const Point& above, const Point& below) {
  double high = above.tau, low = below.tau;  // where f is so
  double tau = first_guess(f, above, below);
  for (int i = 0; i < 100; ++i) {
    const auto [value, slope] = at(f, tau);
    (value < 0.0 ? low : high) = tau;
    double next = tau - value / slope;
    const bool inside = next >= std::min(low, high) && next <= std::max(low, high);
    if (!inside) next = 0.5 * (low + high);
    if (std::abs(next - tau) <= (inside ? 1e-9 : 2.0 * epsilon) * tau) return next;
    tau = next;
  }
  return tau;
}

/// Searches the first decrease below zero on shorter and shorter parts, until a part is monotone,
/// or has curvature of one sign, or has no zero.
class FallSearch {
 public:
  explicit FallSearch(const Series& f) : f_(f) {
    for (int k = 2; k < f.terms; ++k) {
      const double second = Series::second[k] * std::abs(f.c[k]);
      most_curvature_ += second;
      most_third_ += second * Series::order[k - 2];
    }
    if (!(std::abs(f.at(1.0)) + most_third_ < never))
      throw NotConverged(
          "a power series is not finite");  // its parts would be searched without end
  }

  /// f(a) >= 0.
  double first_fall(const Point& a, const Point& b) const {
    const double width = b.tau - a.tau;
    // The chord, less the largest departure of the curve below it.
    if (std::min(a.value, b.value) > 0.125 * most_curvature_ * width * width) return never;
    const double middle = a.tau + 0.5 * width;
    const auto [value, slope] = at(f_, middle);
    if (std::abs(slope) > 0.5 * most_curvature_ * width) return at_end(a, b);
    const double bend = curvature_at(f_, middle);
    if (std::abs(bend) > 0.5 * most_third_ * width)
      return bend < 0.0 ? at_end(a, b) : below_minimum(a, b);
    if (!(width > epsilon)) return b.value < 0.0 ? b.tau : never;
    const double found = first_fall(a, {middle, value});
    return found != never ? found : first_fall({middle, value}, b);
  }

 private:
  double at_end(const Point& a, const Point& b) const {
    return b.value < 0.0 ? root_between(f_, a, b) : never;
  }
  double below_minimum(const Point& a, const Point& b) const {
    const double slope_a = at(f_, a.tau).slope, slope_b = at(f_, b.tau).slope;
    if (slope_a >= 0.0) return never;
    if (slope_b <= 0.0) return at_end(a, b);
    const double lowest = root_between(f_.slope(), {b.tau, slope_b}, {a.tau, slope_a});
    const double value = f_.at(lowest);
    return value < 0.0 ? root_between(f_, a, {lowest, value}) : never;
  }

  const Series& f_;
  double most_curvature_ = 0.0, most_third_ = 0.0;
};

/// With the value at an extremum before `end`: where the slope changes sign, first down, or first
/// up.
double at_extremum(const Series& series, double end, Sign slope_sign) {
  const double extremum = first_fall(series.slope(), slope_sign);
  return extremum > 0.0 && extremum < end ? series.at(extremum) : series.c[0];
}

}  // namespace

double first_fall(const Series& series, Sign sign) {
  const double one = sign == Sign::plus ? 1.0 : -1.0;
  int zeros = 0;
  while (zeros < series.terms && series.c[zeros] == 0.0) ++zeros;
  if (zeros == series.terms) return never;
  const double begin = one * series.c[zeros];
  if (begin < 0.0) return 0.0;
  double rest = 0.0;
  for (int k = zeros + 1; k < series.terms; ++k) rest += std::min(one * series.c[k], 0.0);
  if (begin + rest >= 0.0) return never;
  Series f;  // without its root at the begin
  f.terms = series.terms - zeros;
  for (int k = 0; k < f.terms; ++k) f.c[k] = one * series.c[k + zeros];
  return FallSearch(f).first_fall({0.0, begin}, {1.0, f.at(1.0)});
}

double highest(const Series& series, double end) {
  return std::max({series.c[0], series.at(end), at_extremum(series, end, Sign::plus)});
}

double largest(const Series& series, double end) {
  const double low = at_extremum(series, end, Sign::minus),
               high = at_extremum(series, end, Sign::plus);
  return std::max({std::abs(series.c[0]), std::abs(series.at(end)), std::abs(low), std::abs(high)});
}

}  // namespace glissade::block_detail
