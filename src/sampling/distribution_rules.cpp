// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "glissade/core/error.hpp"
#include "glissade/sampling/distribution.hpp"

namespace glissade {
namespace {

/// The rules of each distribution; violations are collected.
class Rules {
 public:
  void operator()(const Fixed& d) { finite("value", d.value); }
  void operator()(const Normal& d) {
    finite("mean", d.mean);
    positive("std", d.std);
  }
  void operator()(const TruncatedNormal& d) {
    operator()(Normal{d.mean, d.std});
    below("min", d.min, "max", d.max);
    constexpr double reach = 35.0;  // Phi(-35) = 1e-268 is still a normal double
    if (d.min > d.mean + reach * d.std || d.max < d.mean - reach * d.std) {
      add("min = " + text(d.min) + " and max = " + text(d.max) +
              " leave nothing of the parent normal",
          "move them within 35 std of mean");
    }
  }
  void operator()(const LogNormal& d) {
    positive("median", d.median);
    positive("log_std", d.log_std);
  }
  void operator()(const Uniform& d) {
    finite("min", d.min);
    finite("max", d.max);
    below("min", d.min, "max", d.max);
  }
  void operator()(const Triangular& d) {
    operator()(Uniform{d.min, d.max});
    if (!(d.min <= d.mode && d.mode <= d.max)) {
      add("mode = " + text(d.mode) + " is not between min = " + text(d.min) +
              " and max = " + text(d.max),
          "give the most likely value");
    }
  }
  void operator()(const Discrete& d) {
    if (d.values.empty()) add("values is empty", "give at least one value");
    if (d.weights.size() != d.values.size()) {
      add("weights has " + std::to_string(d.weights.size()) + " entries for " +
              std::to_string(d.values.size()) + " values",
          "give one weight per value");
    }
    for (double value : d.values) finite("values", value);
    for (double weight : d.weights) positive("weights", weight);
  }
  void operator()(const Empirical& d) {
    if (d.values.size() < 2) {
      add("values has " + std::to_string(d.values.size()) + " entries", "give at least two");
    }
    for (double value : d.values) finite("values", value);
  }

  void throw_if_any() const { problems_.throw_if_any(); }

 private:
  static std::string text(double value) { return (std::ostringstream() << value).str(); }
  void add(std::string what, std::string suggestion) {
    problems_.add(
        {.where = "", .what = std::move(what), .suggestion = std::move(suggestion), .excerpt = ""});
  }
  void finite(const std::string& name, double value) {
    if (!std::isfinite(value)) add(name + " = " + text(value) + " is not a finite number", "");
  }
  void positive(const std::string& name, double value) {
    if (!(value > 0 && std::isfinite(value))) {
      add(name + " = " + text(value) + " is not a finite number above 0", "");
    }
  }
  void below(const std::string& name, double value, const std::string& limit_name, double limit) {
    if (!(value < limit)) {
      add(name + " = " + text(value) + " is not below " + limit_name + " = " + text(limit), "");
    }
  }

  ProblemList problems_;
};

}  // namespace

void validate(const Distribution& distribution) {
  Rules rules;
  std::visit(rules, distribution);
  rules.throw_if_any();
}

}  // namespace glissade
