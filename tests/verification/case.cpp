// SPDX-License-Identifier: GPL-3.0-or-later
#include "case.hpp"

#include <fmt/format.h>

#include <cmath>

namespace glissade::verification {

Case compare(const Subject& subject, const Comparison& c) {
  const bool relative = c.metric == Metric::relative;
  const double difference =
      relative ? std::abs(c.value / c.expected - 1.0) : std::abs(c.value - c.expected);
  return {subject.name,
          subject.quantity,
          fmt::format("{:.12g} ({})", c.expected, subject.source),
          relative ? "relative difference" : "difference",
          fmt::format("{:g}", c.tolerance),
          difference == 0.0 ? fmt::format("{:.8g} (equal)", c.value)
                            : fmt::format("{:.8g} (off by {:.1e})", c.value, difference),
          difference <= c.tolerance,
          subject.from,
          difference / c.tolerance};
}

std::vector<Case> compare_all(const std::string& name, const std::string& source,
                              std::initializer_list<Number> numbers) {
  std::vector<Case> cases;
  for (const auto& [quantity, comparison] : numbers)
    cases.push_back(compare({name, quantity, source}, comparison));
  return cases;
}

Case limit(const Subject& subject, const Bound& bound) {
  return {
      subject.name,
      subject.quantity,
      subject.source,
      bound.metric,
      fmt::format("{:g}", bound.at_most),
      fmt::format("{:.2g}", bound.value),
      bound.value <= bound.at_most,
      subject.from,
      bound.at_most > 0.0 ? bound.value / bound.at_most : std::numeric_limits<double>::quiet_NaN()};
}

Case within(const Subject& subject, const Range& range) {
  const std::string tolerance = std::isinf(range.high)
                                    ? fmt::format("at least {:g}", range.low)
                                    : fmt::format("{:g} to {:g}", range.low, range.high);
  return {subject.name,
          subject.quantity,
          subject.source,
          range.metric,
          tolerance,
          fmt::format("{:.5g}", range.value),
          range.value >= range.low && range.value <= range.high,
          subject.from};
}

Case all_equal(const Subject& subject, const Mismatches& m) {
  return {subject.name,
          subject.quantity,
          subject.source,
          fmt::format("differing, of {}", m.of),
          "0",
          fmt::format("{}", m.differing),
          m.differing == 0,
          subject.from};
}

std::vector<Case> joined(std::initializer_list<std::vector<Case>> parts) {
  std::vector<Case> all;
  for (const std::vector<Case>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::string yes(bool confirmed) { return confirmed ? "yes" : "no"; }

double worse(double a, double b) { return std::isnan(a) || b <= a ? a : b; }

}  // namespace glissade::verification
