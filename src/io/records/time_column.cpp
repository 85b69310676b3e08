// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/time_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "glissade/core/error.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

/// The fewest decimals that meet `value` to within `tolerance`; where they are many, a whole rate
/// that does.
double shortest_within(double value, double tolerance) {
  constexpr int few = 3;
  const double of_rate = 1.0 / std::round(1.0 / value);
  for (int digits = 0; digits < 17; ++digits) {
    char buffer[40];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, digits)
            .ptr;
    double rounded = 0.0;
    std::from_chars(buffer, end, rounded);
    if (digits == few && std::abs(of_rate - value) <= tolerance) return of_rate;
    if (std::abs(rounded - value) <= tolerance) return rounded;
  }
  return value;
}

/// Every step must be dt_s but for the rounding of two printed times. Where dt_s is a whole number
/// of last decimals there is none to allow for, and a lost sample shows. Times summed up in single
/// precision drift a little.
void check_even(const std::filesystem::path& file, const TimeColumn& column, double dt_s) {
  const double decimals_per_step = dt_s / column.resolution_s;
  const bool is_exact =
      std::abs(decimals_per_step - std::round(decimals_per_step)) < 1e-6 * decimals_per_step;
  const double tolerance_s = (is_exact ? 0.0 : 1.001 * column.resolution_s) + 0.01 * dt_s;
  const std::vector<double>& t = column.times_s;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (std::abs(t[i] - t[i - 1] - dt_s) <= tolerance_s && t[i] >= t[i - 1]) continue;
    throw InputError({place(file, column.lines[i]),
                      "the time goes from " + shortest_decimal(t[i - 1]) + " to " +
                          shortest_decimal(t[i]) + " s where the step is " +
                          shortest_decimal(dt_s) + " s",
                      "the samples must be evenly spaced, with the time in the first column: "
                      "resample the record",
                      ""});
  }
}

}  // namespace

void check_step(const std::string& where, const std::string& text, double dt_s) {
  if (std::isfinite(dt_s) && dt_s > 0.0) return;
  throw InputError({where, "the time step dt = " + text + " s is not above 0",
                    "give the true step with dt_s", ""});
}

double agreed_step(const std::string& where, const std::string& text,
                   const std::optional<double>& stated, const std::optional<double>& wanted) {
  if (!wanted) {
    check_step(where, text, stated.value_or(0.0));
    return *stated;
  }
  if (std::abs(stated.value_or(*wanted) - *wanted) <= 0.02 * *wanted) return *wanted;
  throw InputError({where,
                    "the header's DT = " + text + " is not dt_s = " + shortest_decimal(*wanted),
                    "leave dt_s out: the file states its step", ""});
}

void TimeColumn::scale(double factor) {
  for (double& time_s : times_s) time_s *= factor;
  resolution_s *= factor;
}

void TimeColumn::add(double time_s, std::string_view token, std::size_t line) {
  times_s.push_back(time_s);
  lines.push_back(line);
  const std::size_t exponent_at = std::min(token.find_first_of("eE"), token.size());
  const std::size_t point_at = std::min(token.find('.'), exponent_at);
  const double decimals =
      static_cast<double>(exponent_at - point_at) - (point_at < exponent_at ? 1.0 : 0.0);
  const double exponent =
      exponent_at < token.size() ? parse_number(token.substr(exponent_at + 1)).value_or(0.0) : 0.0;
  // Zero is printed with any exponent and does not show that of the others.
  if (time_s != 0.0) resolution_s = std::min(resolution_s, std::pow(10.0, exponent - decimals));
}

double step_of(const std::filesystem::path& file, const TimeColumn& column,
               const std::optional<double>& wanted) {
  const std::vector<double>& t = column.times_s;
  if (t.size() < 2) {
    if (wanted) return *wanted;
    throw InputError(
        {file.string(), "one sample does not give the time step", "give it with dt_s", ""});
  }
  const auto intervals = static_cast<double>(t.size() - 1);
  const double mean_s = (t.back() - t.front()) / intervals;
  if (!(mean_s > 0.0) || !std::isfinite(mean_s))
    throw InputError({place(file, column.lines.back()),
                      fmt::format("the column of times goes from {:g} to {:g}: it is no time",
                                  t.front(), t.back()),
                      "give time and acceleration, the time increasing", ""});
  const double uncertainty_s = column.resolution_s / intervals + 1e-9 * mean_s;
  const bool is_as_wanted = wanted && std::abs(*wanted - mean_s) <= uncertainty_s;
  const double dt_s = is_as_wanted ? *wanted : shortest_within(mean_s, uncertainty_s);
  check_even(file, column, dt_s);
  if (wanted && !is_as_wanted) {
    throw InputError({file.string(),
                      "the time column has steps of " + shortest_decimal(dt_s) + " s, dt_s is " +
                          shortest_decimal(*wanted) + " s",
                      "leave dt_s out, or correct the file", ""});
  }
  return dt_s;
}

}  // namespace glissade
