// SPDX-License-Identifier: GPL-3.0-or-later
// CSMIP and USGS V1 and V2, before COSMOS: per channel text lines, integers, reals, then blocks
// with a line "N points of accel data equally spaced at .005 sec, in cm/sec2. (8f10.6)" each
// (Shakal & Huang 1985, CDMG "Standard Tape Format for CSMIP Strong-Motion Data Tapes", OSMS
// 85-03).
#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t csmip_field_width = 10;  // 8F10, where the line states no format

/// "accel", "veloc" or "displ" of the line above a block; "" of another line.
std::string_view csmip_quantity(const std::string& lower) {
  if (lower.find("equally spaced at") == std::string::npos) return "";
  for (const std::string_view quantity : {"accel", "veloc", "displ"})
    if (lower.find(quantity) != std::string::npos) return quantity;
  return "";
}

bool is_csmip(const RecordText& file) {
  constexpr std::size_t most_header_lines = 100;
  LineReader lines(file.text);
  while (lines.number() < most_header_lines && lines.next()) {
    const std::string lower = lower_case(lines.line().substr(0, 200));
    if (!csmip_quantity(lower).empty() && lower.find("points of") != std::string::npos) return true;
  }
  return false;
}

/// "cm/sec2" of ", in cm/sec2. (8f10.6)", "cm/sec/sec" of "(units: cm/sec/sec)".
std::string csmip_unit(const std::string& lower) {
  for (const std::string_view before : {"units:", ", in "}) {
    const std::size_t at = lower.find(before);
    if (at == std::string::npos) continue;
    const std::size_t begin = lower.find_first_not_of(' ', at + before.size());
    if (begin == std::string::npos) return "";
    return lower.substr(begin, lower.find_first_of(" )(", begin) - begin);
  }
  return "";
}

struct CsmipChannel {
  std::string name, station, event;
  bool corrected = false;
};

void read_csmip_line(std::string_view line, const std::string& lower, CsmipChannel& channel) {
  if (lower.starts_with("corrected accelerogram") || lower.starts_with("uncorrected accel"))
    channel.corrected = channel.corrected || lower.starts_with("corrected");
  else if (lower.starts_with("station no"))
    channel.station = trimmed(line.substr(0, 18));
  else if (lower.starts_with("record of") && channel.event.empty())
    channel.event = single_blanks(line);
  else if (lower.starts_with("chan"))
    channel.name = single_blanks(line);
  else if (lower.starts_with("/&"))
    channel = {};
}

FileComponent csmip_component(const RecordText& file, LineReader& lines, const std::string& lower,
                              const CsmipChannel& channel, const RecordFileOptions& options) {
  const std::size_t line = lines.number(), width = field_width(lower);
  const std::string unit = csmip_unit(lower);
  const double unit_mps2 = stated_unit(file, unit, line, options);
  const auto step = first_number(lower, lower.find("spaced at"));
  const double dt_s = stated_step(place(file.path, line), lower.substr(lower.find("spaced at")),
                                  step ? std::optional(step->value) : std::nullopt, options);
  const std::size_t count =
      stated_count(file, {"the count of points", lower.substr(0, lower.find("points")), line});
  FileComponent component = file_component(
      file, channel.name, dt_s,
      read_block(file, lines, {count, width > 0 ? width : csmip_field_width, unit_mps2}));
  component.direction = trimmed(channel.name.substr(channel.name.find(':') + 1));
  state_header(component, {.event = channel.event,
                           .station = channel.station,
                           .direction = plain_direction(component.direction),
                           .unit = unit,
                           .is_processed = channel.corrected});
  if (!channel.corrected) component.record.notes.emplace_back("CSMIP or USGS V1: not corrected");
  return component;
}

std::vector<FileComponent> read_csmip(const RecordText& file, const RecordFileOptions& options) {
  std::vector<FileComponent> components;
  CsmipChannel channel;
  for (LineReader lines(file.text); lines.next();) {
    const std::string lower = lower_case(trimmed(lines.line().substr(0, 200)));
    if (csmip_quantity(lower) == "accel")
      components.push_back(csmip_component(file, lines, lower, channel, options));
    else
      read_csmip_line(lines.line(), lower, channel);
  }
  if (components.empty())
    refuse_record(file.path.string(), "holds velocities or displacements, and no accelerations",
                  "give the file of accelerations, V1 or V2");
  return components;
}

}  // namespace

const RecordFormat csmip_format{"CSMIP or USGS V1 or V2", is_csmip, read_csmip};

}  // namespace glissade
