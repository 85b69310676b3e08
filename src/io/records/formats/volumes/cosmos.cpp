// SPDX-License-Identifier: GPL-3.0-or-later
// COSMOS V0, V1 and V2: per channel 13 text lines, 100 integers, 100 reals (the 62nd is the step in
// ms, the 34th that of the recorder in s, which processing may change), comments, a line with
// count, unit and Fortran format, then the values ("COSMOS Strong Motion Data Format",
// version 1.20, 2001).
#include <fmt/format.h>

#include <tuple>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t cosmos_recorder_step_at = 33, cosmos_step_at = 61;  // of the reals, from 0

bool is_cosmos(const RecordText& file) {
  return lower_case(file.first_line()).find("(format v01.") != std::string::npos;
}

/// What stands between two words of a line; "" where they do not.
std::string between(const std::string& line, std::string_view before, std::string_view after) {
  const std::size_t at = line.find(before);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + before.size();
  const std::size_t end = line.find(after, begin);
  return end == std::string::npos ? "" : std::string(trimmed(line.substr(begin, end - begin)));
}

/// The step in the reals of a channel, "100 Real-header values follow on  17 lines, Format=
/// (6F13.6)": that of the values in ms; where it is not stated, that of the recorder in s.
double cosmos_step_s(const RecordText& file, LineReader& lines) {
  const std::size_t begin = lines.number(), width = field_width(lines.line());
  std::vector<double> reals;
  while (width > 0 && reals.size() <= cosmos_step_at && lines.next()) {
    const auto row = fixed_fields(lines.line(), width);
    if (row.empty()) break;
    for (const std::string_view field : row) reals.push_back(fortran_number(field).value_or(0.0));
  }
  reals.resize(cosmos_step_at + 1);
  if (const double step_ms = reals[cosmos_step_at]; step_ms > 0.0) return step_ms / 1000.0;
  if (const double step_s = reals[cosmos_recorder_step_at]; step_s > 0.0) return step_s;
  refuse_record(file.at(begin), "the header does not state its step, the 62nd real or the 34th",
                cut_short);
}

/// What the lines above a block state.
struct CosmosChannel {
  ChannelLine line;
  std::string station, kind;
  RecordHeader header;  ///< its event and distance
  std::optional<double> event_latitude_deg, event_longitude_deg;
  double dt_s = 0.0;
  std::size_t step_line = 0;
};

/// "Origin:" and what follows it.
std::pair<std::string_view, std::string_view> cosmos_line(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return {};
  return {line.substr(0, colon + 1), line.substr(colon + 1)};
}

using TwoNumbers = std::pair<std::optional<double>, std::optional<double>>;
TwoNumbers two_numbers(std::string_view text) {
  const auto first = first_number(text);
  const auto second = first ? first_number(text, first->end) : std::nullopt;
  if (!second) return {};
  return {first->value, second->value};
}

void read_cosmos_line(const RecordText& file, LineReader& lines, CosmosChannel& channel) {
  const std::string_view line = lines.line();
  if (line.find("(Format v01.") != std::string_view::npos) {
    channel = {};
    channel.kind = trimmed(line.substr(0, line.find("(Format")));
  } else if (const auto [tag, rest] = cosmos_line(line); tag == "Origin:") {
    if (lower_case(trimmed(rest)) != "to be determined") channel.header.event = single_blanks(rest);
  } else if (tag == "Hypocenter:") {
    std::tie(channel.event_latitude_deg, channel.event_longitude_deg) = two_numbers(rest);
    state_magnitude(channel.header, rest, {{"Mw=", "Mw"}, {"ML=", "ML"}, {"Ms=", "Ms"}});
  } else if (tag == "Coords:") {
    const auto [latitude_deg, longitude_deg] = two_numbers(rest);
    channel.header.epicentral_km = epicentral_km(
        channel.event_latitude_deg, channel.event_longitude_deg, latitude_deg, longitude_deg);
  } else if (line.starts_with("Statn No")) {
    channel.station = trimmed(line);
  } else if (line.starts_with("Sta Cha")) {
    channel.line = channel_line(line.substr(4));
  } else if (line.find("Real-header values follow") != std::string_view::npos) {
    channel.dt_s = cosmos_step_s(file, lines);
    channel.step_line = lines.number();
  }
}

FileComponent cosmos_component(const RecordText& file, LineReader& lines,
                               const CosmosChannel& channel, const RecordFileOptions& options) {
  const std::string line(lines.line());
  const std::string unit = between(lower_case(line), "units=", "(");
  const double unit_mps2 = stated_unit(file, unit, lines.number(), options);
  const double dt_s = stated_step(file.at(channel.step_line), shortest_decimal(channel.dt_s),
                                  channel.dt_s, options);
  const std::size_t count =
      stated_count(file, {"the count of values", line.substr(0, line.find("pts")), lines.number()});
  constexpr double rounding_s = 1.5;
  const std::size_t approx = line.find("approx");
  if (const auto length_s = approx == line.npos ? std::nullopt : first_number(line, approx))
    check_duration(file.at(lines.number()), length_s->value, dt_s, count, rounding_s);
  RecordHeader header = channel.header;
  header.station = channel.station;
  take_channel(header, channel.line);
  header.unit = unit;
  header.is_processed = channel.kind.starts_with("Corrected");
  FileComponent component = file_component(
      file, channel.line.name, dt_s, read_block(file, lines, {count, field_width(line), unit_mps2}),
      std::move(header));
  component.direction = channel.line.direction;
  if (!channel.kind.starts_with("Corrected"))
    component.record.notes.push_back("COSMOS, \"" + channel.kind + "\": not corrected");
  return component;
}

std::vector<FileComponent> read_cosmos(const RecordText& file, const RecordFileOptions& options) {
  std::vector<FileComponent> components;
  CosmosChannel channel;
  std::string other;
  for (LineReader lines(file.text); lines.next();) {
    const std::string lower = lower_case(lines.line().substr(0, 200));
    if (lower.find("pts, approx") == std::string::npos) {
      read_cosmos_line(file, lines, channel);
    } else if (lower.find("accel") != std::string::npos) {
      add_component(file, cosmos_component(file, lines, channel, options), components);
    } else {
      other = channel.kind;
    }
  }
  if (components.empty())
    refuse_record(file,
                  other.empty() ? "is a COSMOS file without a block of values"
                                : "is a COSMOS file of " + in_quotes(other),
                  "give the file of accelerations, V1 or V2");
  return components;
}

}  // namespace

const RecordFormat cosmos_format{"COSMOS V0, V1 or V2", is_cosmos, read_cosmos};

}  // namespace glissade
