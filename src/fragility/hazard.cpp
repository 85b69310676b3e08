// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/hazard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& suggestion) {
  throw InputError({"", what, suggestion, ""});
}

}  // namespace

HazardCurve::HazardCurve(std::vector<HazardPoint> points) : points_(std::move(points)) {
  if (points_.size() < 2)
    refuse("a hazard curve needs two points or more", "give more of them, or k0 and k");
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const HazardPoint& p = points_[i];
    if (!(p.intensity > 0.0 && p.annual_rate > 0.0 && std::isfinite(p.intensity) &&
          std::isfinite(p.annual_rate)))
      refuse(fmt::format("point {} of the hazard curve is ({}, {}): both must be above 0", i + 1,
                         p.intensity, p.annual_rate),
             "leave out intensities that the hazard analysis gives no rate");
    if (i > 0 &&
        !(p.intensity > points_[i - 1].intensity && p.annual_rate < points_[i - 1].annual_rate))
      refuse(fmt::format("point {} of the hazard curve, ({}, {}), does not follow ({}, {})", i + 1,
                         p.intensity, p.annual_rate, points_[i - 1].intensity,
                         points_[i - 1].annual_rate),
             "intensities rise and annual rates fall from row to row; leave out repeated rows");
  }
}

HazardCurve HazardCurve::power_law(double k0, double k) {
  if (!(k0 > 0.0 && k > 0.0)) refuse("k0 and k must be above 0", "give both");
  return HazardCurve({{1.0, k0}, {2.0, k0 * std::pow(2.0, -k)}});
}

HazardCurve HazardCurve::of_risk_target(double mce, double k) {
  constexpr double log_std = 0.6, collapse_at_mce = 0.1, target = 0.01, years = 50.0;
  const double median = mce * std::exp(-log_std * normal_quantile(collapse_at_mce));
  // k0 median^-k exp(k^2 log_std^2 / 2) is the annual rate of collapse.
  return power_law(
      rate_of(target, years) * std::pow(median, k) * std::exp(-0.5 * k * k * log_std * log_std), k);
}

double HazardCurve::exponent(std::size_t interval) const {
  const HazardPoint &a = points_.at(interval), &b = points_.at(interval + 1);
  return std::log(a.annual_rate / b.annual_rate) / std::log(b.intensity / a.intensity);
}

double HazardCurve::annual_rate(double intensity) const {
  if (!(intensity > 0.0)) return infinity;
  if (std::isinf(intensity)) return 0.0;
  const auto after =
      std::upper_bound(points_.begin() + 1, points_.end() - 1, intensity,
                       [](double x, const HazardPoint& p) { return x < p.intensity; });
  const auto i = static_cast<std::size_t>(after - points_.begin()) - 1;
  return points_[i].annual_rate * std::pow(intensity / points_[i].intensity, -exponent(i));
}

double HazardCurve::intensity_at(double annual_rate) const {
  GLISSADE_EXPECTS(annual_rate > 0.0);
  if (std::isinf(annual_rate)) return 0.0;
  const auto after =
      std::upper_bound(points_.begin() + 1, points_.end() - 1, annual_rate,
                       [](double rate, const HazardPoint& p) { return rate > p.annual_rate; });
  const auto i = static_cast<std::size_t>(after - points_.begin()) - 1;
  return points_[i].intensity * std::pow(annual_rate / points_[i].annual_rate, -1 / exponent(i));
}

double annual_rate(const HazardCurve& hazard, const FragilityCurve& fragility) {
  if (fragility.floor > 0.0) return infinity;
  const double theta = fragility.median, beta = fragility.log_std;
  const std::vector<HazardPoint>& points = hazard.points();
  const auto z = [&](std::size_t i) { return std::log(points[i].intensity / theta) / beta; };
  double rate = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    // Capacities X of the interval: mean of A X^-k = A theta^-k exp(k^2 beta^2 / 2) x [Phi(z + k
    // beta)] between its ends, in logarithms, since the factors alone may overflow.
    const double k = hazard.exponent(i);
    const double from = i == 0 ? -infinity : z(i) + k * beta;
    const double to = i + 2 == points.size() ? infinity : z(i + 1) + k * beta;
    rate += std::exp(std::log(points[i].annual_rate) + k * std::log(points[i].intensity / theta) +
                     0.5 * k * k * beta * beta + log_normal_between(from, to));
  }
  return rate;
}

double probability_in(double years, double annual_rate) {
  return -std::expm1(-annual_rate * years);
}

double rate_of(double probability, double years) { return -std::log1p(-probability) / years; }

}  // namespace glissade
