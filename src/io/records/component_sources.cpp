// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "glissade/io/record_file.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

/// "Kobe Japan, 1/16/1995, Nishi-Akashi, 90" in two parts: all before the last comma, and what
/// follows.
struct Source {
  std::string station, direction;
};

std::optional<Source> source_of(const Record& record) {
  const std::string_view text = record.source;
  const std::size_t comma = text.rfind(',');
  if (comma == std::string_view::npos) return std::nullopt;
  return Source{std::string(trimmed(text.substr(0, comma))),
                std::string(trimmed(text.substr(comma + 1)))};
}

std::optional<Source> source_of(const std::optional<TimedRecord>& component) {
  return component ? source_of(component->record) : std::nullopt;
}

bool is_vertical(const Source& source) {
  constexpr std::array names = {"up", "dwn", "down", "v", "ver", "vert", "z"};
  return std::ranges::find(names, lower_case(source.direction)) != names.end();
}

/// Clockwise from north; nothing of a direction by name.
std::optional<double> azimuth_deg(const Source& source) { return parse_number(source.direction); }

bool are_perpendicular(double one_deg, double other_deg) {
  constexpr double tolerance_deg = 5.0;
  return std::abs(std::abs(std::remainder(one_deg - other_deg, 180.0)) - 90.0) <= tolerance_deg;
}

}  // namespace

std::optional<double> stated_azimuth_deg(const Record& record) {
  const auto source = source_of(record);
  const auto azimuth = source ? azimuth_deg(*source) : std::nullopt;
  return azimuth && std::abs(*azimuth) <= 360.0 ? azimuth : std::nullopt;
}

std::vector<std::string> source_contradictions(const TimedRecord& first,
                                               const std::optional<TimedRecord>& second,
                                               const std::optional<TimedRecord>& vertical) {
  std::vector<std::string> found;
  const auto one = source_of(first), other = source_of(second), up = source_of(vertical);
  for (const auto& component : {other, up}) {
    if (one && component && lower_case(one->station) != lower_case(component->station))
      found.push_back(fmt::format("components of two stations or locations (\"{}\" and \"{}\")",
                                  one->station, component->station));
  }
  for (const auto& horizontal : {one, other}) {
    if (horizontal && is_vertical(*horizontal))
      found.push_back(
          fmt::format("a vertical component, {}, as a horizontal one", horizontal->direction));
  }
  if (up && azimuth_deg(*up))
    found.push_back(fmt::format("a horizontal component, {}, as the vertical one", up->direction));
  const auto one_deg = one ? azimuth_deg(*one) : std::nullopt,
             other_deg = other ? azimuth_deg(*other) : std::nullopt;
  if (one_deg && other_deg && !are_perpendicular(*one_deg, *other_deg))
    found.push_back(
        fmt::format("horizontal components of {:g} and {:g} degrees, which are not perpendicular",
                    *one_deg, *other_deg));
  return found;
}

}  // namespace glissade
