// SPDX-License-Identifier: GPL-3.0-or-later
// CSMIP and USGS V1 and V2, before COSMOS: per channel text lines, integers, reals, then blocks
// with a line "N points of accel data equally spaced at .005 sec, in cm/sec2. (8f10.6)" each
// (Shakal & Huang 1985, CDMG "Standard Tape Format for CSMIP Strong-Motion Data Tapes", OSMS
// 85-03); since 2000 "N Accelerogram points at 200 pts/sec in units of g. Format: (8f9.6)".
// Corrected files of USC (Volume II) have the same blocks, "N POINTS OF ACC DATA ...".
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

/// "acc", "vel" or "dis" of the line above a block; "" of another line.
std::string_view csmip_quantity(const std::string& lower) {
  const bool is_above_block = lower.find("equally spaced at") != std::string::npos ||
                              lower.find("pts/sec") != std::string::npos;
  if (!is_above_block) return "";
  for (const std::string_view quantity : {"acc", "vel", "dis"})
    if (lower.find(quantity) != std::string::npos) return quantity;
  return "";
}

bool is_csmip(const RecordText& file) {
  constexpr std::size_t most_header_lines = 100;
  LineReader lines(file.text);
  while (lines.number() < most_header_lines && lines.next()) {
    const std::string lower = lower_case(lines.line().substr(0, 200));
    if (!csmip_quantity(lower).empty() && lower.find("points ") != std::string::npos) return true;
  }
  return false;
}

/// "cm/sec2" of ", in cm/sec2. (8f10.6)", "cm/sec/sec" of "(units: cm/sec/sec)", "g" of "in units
/// of g.".
std::string csmip_unit(const std::string& lower) {
  for (const std::string_view before : {"units:", "in units of ", "in units ", ", in "}) {
    const std::size_t at = lower.find(before);
    if (at == std::string::npos) continue;
    const std::size_t begin = lower.find_first_not_of(' ', at + before.size());
    if (begin == std::string::npos) return "";
    return lower.substr(begin, lower.find_first_of(" )(", begin) - begin);
  }
  return "";
}

/// The number behind a word.
std::optional<double> csmip_number(const std::string& lower, std::string_view word) {
  const auto found = first_number(lower, lower.find(word));
  return found ? std::optional(found->value) : std::nullopt;
}

/// Seconds of "equally spaced at .005 sec" or "points at 200 pts/sec".
std::optional<double> csmip_step_s(const std::string& lower) {
  const bool is_rate = lower.find("pts/sec") != std::string::npos;
  const auto stated = csmip_number(lower, is_rate ? "points at" : "spaced at");
  return stated && is_rate ? std::optional(1.0 / *stated) : stated;
}

/// The width of the fields, where the line above them states no format: one at which they are
/// numbers; 0: they stand between blanks.
std::size_t csmip_width(LineReader lines) {
  if (!lines.next()) return 0;
  const auto are_numbers = [&](std::size_t width) {
    return std::ranges::all_of(fixed_fields(lines.line(), width), [](std::string_view field) {
      return fortran_number(field).has_value();
    });
  };
  constexpr std::array widths{std::size_t{10}, std::size_t{9}};
  const auto width = std::ranges::find_if(widths, are_numbers);
  return width == widths.end() ? 0 : *width;
}

struct CsmipChannel {
  ChannelLine line;
  RecordHeader stated;
  bool corrected = false;
  std::optional<double> dt_s;  ///< of the text, which the line above a block states again
};

void read_csmip_line(std::string_view line, const std::string& lower, CsmipChannel& channel) {
  constexpr std::size_t text_width = 72;  // behind it USC counts characters
  RecordHeader& stated = channel.stated;
  if (lower.starts_with("corrected accelerogram") || lower.starts_with("uncorrected accel"))
    channel.corrected = channel.corrected || lower.starts_with("corrected");
  else if (lower.starts_with("station"))
    stated.station = trimmed(line.substr(0, 18));
  else if (stated.event.empty() && (lower.starts_with("record of") || lower.starts_with("rcrd of")))
    stated.event = single_blanks(line.substr(0, std::min(text_width, line.rfind(':'))));  // minutes
  else if (stated.event.empty() && lower.find("earthquake") != std::string::npos)
    stated.event = single_blanks(line.substr(0, text_width));
  else if (lower.starts_with("chan"))
    channel.line = channel_line(line);
  else if (lower.starts_with("comp "))
    channel.line = channel_line(line.substr(5, 12));
  else if (lower.starts_with("hypocenter") || lower.starts_with("magnitude"))
    state_magnitude(stated, line, {{"mw", "Mw"}, {"ms", "Ms"}, {"ml", "ML"}, {"magnitude", "M"}});
  else if (lower.starts_with("peak acceleration") && lower.find("cms/sec/sec") != lower.npos)
    stated.unit = "cm/sec/sec";  // of a block that states none
  else if (lower.starts_with("at equally-spaced intervals of"))
    channel.dt_s = csmip_number(lower, "intervals of");
  else if (lower.starts_with("/&"))
    channel = {};
}

FileComponent csmip_component(const RecordText& file, LineReader& lines, const std::string& lower,
                              const CsmipChannel& channel, const RecordFileOptions& options) {
  const std::size_t line = lines.number(), stated_width = field_width(lower);
  RecordHeader stated = channel.stated;
  if (std::string unit = csmip_unit(lower); !unit.empty()) stated.unit = std::move(unit);
  stated.is_processed = channel.corrected;
  const double unit_mps2 = stated_unit(file, stated.unit, line, options);
  const std::optional<double> step_s = csmip_step_s(lower);
  constexpr double rounding = 0.02;
  if (step_s && channel.dt_s && !(std::abs(*step_s - *channel.dt_s) <= rounding * *step_s))
    refuse_record(file.at(line),
                  fmt::format("states a step of {:g} s, and its header one of {:g} s", *step_s,
                              *channel.dt_s),
                  "the file contradicts itself: get it again, or find out which step is right");
  const double dt_s = stated_step(file.at(line), in_quotes(lower), step_s, options);
  const std::size_t count =
      stated_count(file, {"the count of points", lower.substr(0, lower.find("points")), line});
  const std::size_t width = stated_width > 0 ? stated_width : csmip_width(lines);
  take_channel(stated, channel.line);
  FileComponent component =
      file_component(file, channel.line.name, dt_s,
                     read_block(file, lines, {count, width, unit_mps2}), std::move(stated));
  component.direction = channel.line.direction;
  if (!channel.corrected) component.record.notes.emplace_back("CSMIP or USGS V1: not corrected");
  return component;
}

std::vector<FileComponent> read_csmip(const RecordText& file, const RecordFileOptions& options) {
  std::vector<FileComponent> components;
  CsmipChannel channel;
  for (LineReader lines(file.text); lines.next();) {
    const std::string lower = lower_case(trimmed(lines.line().substr(0, 200)));
    if (csmip_quantity(lower) == "acc")
      add_component(file, csmip_component(file, lines, lower, channel, options), components);
    else
      read_csmip_line(lines.line(), lower, channel);
  }
  if (components.empty())
    refuse_record(file, "holds velocities or displacements, and no accelerations",
                  "give the file of accelerations, V1 or V2");
  return components;
}

}  // namespace

const RecordFormat csmip_format{"CSMIP or USGS V1 or V2, or USC Volume II", is_csmip, read_csmip};

}  // namespace glissade
