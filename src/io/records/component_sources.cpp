// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "glissade/core/printable.hpp"
#include "glissade/io/record_file.hpp"
#include "import/component_name.hpp"
#include "records/formats/reading.hpp"

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

std::optional<ComponentDirection> direction_of(const Record& record) {
  const auto source = source_of(record);
  return source ? component_direction(source->direction) : std::nullopt;
}

/// As the vertical where it is a horizontal, or the reverse.
[[noreturn]] void refuse_place(const Record& record, const char* what, const char* suggestion) {
  refuse_record(
      record.name,
      fmt::format("states its direction as {}: {}", in_quotes(source_of(record)->direction), what),
      suggestion);
}

bool are_perpendicular(double one_deg, double other_deg) {
  constexpr double tolerance_deg = 5.0;
  return std::abs(std::abs(std::remainder(one_deg - other_deg, 180.0)) - 90.0) <= tolerance_deg;
}

}  // namespace

std::string stated_direction(const FileComponent& component, const RecordFormat& format,
                             const std::filesystem::path& file) {
  if (component_direction(component.header.direction)) return component.header.direction;
  if (component_direction(component.name)) return plain_direction(component.name);
  const std::string stem = stem_of(file);
  if (&format == &at2_format) return peer_direction(stem);
  return &format == &cosmos_format || &format == &sac_format ? channel_in_name(stem) : "";
}

void state_direction(Record& record, const std::string& direction) {
  const auto source = source_of(record);
  record.source = (source ? source->station : "") + ", " + direction;
}

std::optional<double> stated_azimuth_deg(const Record& record) {
  const auto direction = direction_of(record);
  return direction ? direction->azimuth_deg : std::nullopt;
}

bool is_stated_vertical(const Record& record) {
  const auto direction = direction_of(record);
  return direction && direction->is_vertical;
}

std::vector<std::string> source_contradictions(const TimedRecord& first,
                                               const std::optional<TimedRecord>& second,
                                               const std::optional<TimedRecord>& vertical) {
  for (const Record* horizontal : {&first.record, second ? &second->record : nullptr})
    if (horizontal != nullptr && is_stated_vertical(*horizontal))
      refuse_place(*horizontal, "a vertical component, given as a horizontal one",
                   "give it as the vertical; where the file is wrong, state azimuth_deg of the "
                   "component in a suite");
  if (vertical && stated_azimuth_deg(vertical->record))
    refuse_place(vertical->record, "a horizontal component, given as the vertical one",
                 "give the file of the vertical component");
  std::vector<std::string> found;
  const auto one = source_of(first.record);
  for (const auto* component : {&second, &vertical}) {
    const auto other = *component ? source_of((*component)->record) : std::nullopt;
    if (one && other && !one->station.empty() && !other->station.empty() &&
        lower_case(one->station) != lower_case(other->station))
      found.push_back(fmt::format("components of two stations or locations (\"{}\" and \"{}\")",
                                  one->station, other->station));
  }
  const auto one_deg = stated_azimuth_deg(first.record),
             other_deg = second ? stated_azimuth_deg(second->record) : std::nullopt;
  if (one_deg && other_deg && !are_perpendicular(*one_deg, *other_deg))
    found.push_back(
        fmt::format("horizontal components of {:g} and {:g} degrees, which are not perpendicular",
                    *one_deg, *other_deg));
  return found;
}

}  // namespace glissade
