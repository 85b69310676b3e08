// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "glissade/core/units.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/fragility/goodness_of_fit.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade {

double rounded_to(double value, int digits) {
  return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

std::string format_number(double value) {
  if (!std::isfinite(value)) return "-";
  if (value == 0.0) return "0";
  // The decimal exponent after rounding to three digits: 9.996 has 1, as 10.0 has.
  std::string scientific = fmt::format("{:.2e}", value);
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  if (exponent < -4 || exponent > 8) return scientific;
  const bool is_whole = value == std::round(value);
  if (exponent > 2) return fmt::format("{:.0f}", is_whole ? value : rounded_to(value, 3));
  return fmt::format("{:.{}f}", value, std::max(0, 2 - exponent));
}

std::string format_rate(double annual_rate) {
  if (!std::isfinite(annual_rate)) return "-";
  if (annual_rate == 0.0) return "0";
  const std::string scientific = fmt::format("{:.1e}", annual_rate);
  const std::size_t at = scientific.find('e');
  return scientific.substr(0, at) + fmt::format("e{}", std::stoi(scientific.substr(at + 1)));
}

std::string format_exact(double value) {
  if (std::isnan(value)) return "";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return fmt::format("{}", value);
}

namespace {
UnitSystem first_unit = UnitSystem::si;

/// Below this a length is not distinguished from none.
constexpr double least_length_m = 0.0005;

bool is_small(double length_m) { return length_m > 0.0 && length_m < least_length_m; }

std::string metres(double length_m) { return length_number(length_m, UnitSystem::si) + " m"; }
std::string inches(double length_m) {
  return length_number(length_m, UnitSystem::us_customary) + " in";
}
}  // namespace

std::string length_number(double length_m, UnitSystem units) {
  const bool si = units == UnitSystem::si;
  if (is_small(length_m)) return si ? "< 0.001" : "< 0.02";
  const double value = si ? length_m : length_m / inch_m;
  const int decimals = si ? 4 : 3;
  std::string text = format_number(value);
  const std::size_t point = text.find('.');
  if (point == std::string::npos || text.size() - point - 1 <= static_cast<std::size_t>(decimals))
    return text;
  return fmt::format("{:.{}f}", value, decimals);
}

LengthUnits::LengthUnits(UnitSystem units) : before_(std::exchange(first_unit, units)) {}
LengthUnits::~LengthUnits() { first_unit = before_; }
UnitSystem LengthUnits::first() { return first_unit; }

std::string short_length(double length_m) {
  return first_unit == UnitSystem::si ? metres(length_m) : inches(length_m);
}

double in_first_unit(double length_m) {
  return first_unit == UnitSystem::si ? length_m : length_m / inch_m;
}

std::string format_length(double length_m) {
  if (!std::isfinite(length_m)) return "-";
  const bool si = first_unit == UnitSystem::si;
  if (is_small(length_m)) return si ? "less than 1 mm" : "less than 0.02 in";
  return short_length(length_m) + " (" + (si ? inches(length_m) : metres(length_m)) + ")";
}

std::string format_share(double share) {
  if (!std::isfinite(share)) return "-";
  const double percent = 100.0 * share;
  if (percent == 0.0) return "0 %";
  if (percent < 0.1) return "< 0.1 %";
  if (percent > 99.9 && percent < 100.0) return "> 99.9 %";
  if (percent < 10.0 || (percent > 99.0 && percent < 100.0))
    return fmt::format("{:.1f} %", percent);
  return fmt::format("{:.0f} %", percent);
}

std::string in_brackets(const Interval& of_share) {
  if (std::isnan(of_share.low + of_share.high)) return "";
  return fmt::format(" (95 % interval {} to {})", format_share(of_share.low),
                     format_share(of_share.high));
}

std::string format_p(double p_value) {
  return fmt::format("p {} {:.2g}", p_value > least_p_value ? "=" : "<=", p_value);
}

NumberCell p_cell(double p_value) { return {{p_value, {}}, p_value > least_p_value ? "" : "<= "}; }

std::string format_interval(const Interval& interval) {
  if (std::isnan(interval.low) || std::isnan(interval.high)) return "no interval";
  const auto end = [](double value) {
    return std::isinf(value) ? "unbounded" : format_number(value);
  };
  return end(interval.low) + " to " + end(interval.high);
}

std::string format_length_interval(const Interval& interval_m) {
  const Interval interval{in_first_unit(interval_m.low), in_first_unit(interval_m.high)};
  const std::string unit = LengthUnits::first() == UnitSystem::si ? " m" : " in";
  if (std::isnan(interval.low + interval.high)) return format_interval(interval);
  if (std::isfinite(interval.low) && std::isinf(interval.high))
    return format_number(interval.low) + unit + " or more";
  return format_interval(interval) + unit;
}

std::string open_percentile(std::size_t units, const std::string& name) {
  const std::size_t fewest = records_that_bound(0.16);
  return units >= fewest ? ""
                         : fmt::format(
                               "Fewer than {} {} do not bound the 84th percentile from above (95 % "
                               "interval), fewer than {} the 95th.",
                               fewest, name, records_that_bound(0.05));
}

std::string standard_name(Standard standard) {
  return standard == Standard::seaoc_pv1_2012 ? "SEAOC PV1-2012" : "ASCE 7-16";
}

std::string provenance_name(Provenance provenance) {
  return provenance == Provenance::checked ? "checked" : "recalled";
}

std::string provenance_label(Provenance provenance) {
  return provenance == Provenance::checked ? "checked" : "recalled: verify against the standard";
}

std::string recalled_in_brackets(Provenance provenance) {
  return provenance == Provenance::checked ? "" : " (" + provenance_label(provenance) + ")";
}

std::string format_skip(const Skip& skip) {
  const std::string count = skip.count > 0 ? fmt::format(" ({})", skip.count) : "";
  return skip.what + count + ": " + skip.why;
}

std::string capitalised(std::string text) {
  const std::string first_word = text.substr(0, text.find(' '));
  const bool is_key = first_word.find_first_of("._") != std::string::npos;
  if (!text.empty() && !is_key)
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::vector<std::string> capitalised(std::vector<std::string> texts) {
  for (std::string& text : texts) text = capitalised(std::move(text));
  return texts;
}

std::string wrapped(const std::string& text) {
  return "  " + wrapped(text, terminal_width, 4) + "\n";
}

std::string paragraphs(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += wrapped(text);
  return all;
}

}  // namespace glissade
