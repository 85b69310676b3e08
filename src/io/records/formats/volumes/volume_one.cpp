// SPDX-License-Identifier: GPL-3.0-or-later
// Uncorrected accelerograms in g/10 as the California Institute of Technology published them
// (Hudson, Brady & Trifunac 1969-75, EERL, "Strong-Motion Earthquake Accelerograms", Volume I):
// - USC, CDMG and RENADIC of Chile: text lines, integers, reals, then pairs of time and
//   acceleration in 10F7.3, mostly uneven, as films were digitised;
// - BHRC of Iran: "* VOL1DS FILE" and the same header per component, then accelerations in 10E13.6
//   (smd.bhrc.ac.ir, as downloaded 2012).
#include <algorithm>
#include <cmath>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t volume_one_header_lines = 14;  // integers and reals

bool is_usc(const RecordText& file) {
  return file.first_line().find("UNCORRECTED ACCELEROGRAM DATA") != std::string_view::npos;
}
bool is_bhrc(const RecordText& file) {
  return trimmed(file.first_line()).starts_with("* VOL1DS FILE");
}

/// The text lines of a component, to the one with its units; the lines go on behind integers and
/// reals.
struct VolumeOneHeader {
  std::string name, station, unit;
  RecordHeader stated;  ///< its magnitude
  std::size_t points = 0, unit_line = 0, points_line = 0;
  double duration_s = 0.0;
};

void read_points(const RecordText& file, const LineReader& lines, VolumeOneHeader& header) {
  const std::string line(lines.line());
  const std::size_t duration = std::min(line.find("DURATION"), line.find("RECORD LENGTH"));
  header.points_line = lines.number();
  header.points = stated_count(
      file, {"NO. OF POINTS", line.substr(0, duration).substr(13), header.points_line});
  const auto found = duration == std::string::npos ? std::nullopt : first_number(line, duration);
  header.duration_s = found ? found->value : 0.0;
}

std::optional<VolumeOneHeader> volume_one_header(const RecordText& file, LineReader& lines) {
  VolumeOneHeader header;
  while (lines.next()) {
    const std::string_view line = trimmed(lines.line());
    if (line.starts_with("COMP")) {
      header.name = std::string(trimmed(line.substr(4, 12)));
    } else if (line.starts_with("CHAN")) {
      const ChannelLine channel = channel_line(line);
      header.name = channel.direction;
      take_channel(header.stated, channel);
    } else if (const std::size_t at = line.find("(ORIGIN: "); at != std::string_view::npos) {
      const std::string_view time = line.substr(at + 9, line.rfind(')') - at - 9);
      // That of a clock that was not set.
      if (!time.starts_with("01/01/1980")) header.stated.event = single_blanks(time);
    } else if (line.starts_with("NO. OF POINTS")) {
      read_points(file, lines, header);
    } else if (line.starts_with("Origin Time")) {
      header.stated.event = single_blanks(line.substr(std::min(line.find(':') + 1, line.size())));
    } else if (line.starts_with("Epicenter") || line.starts_with("HYPOCENTER")) {
      state_magnitude(header.stated, line,
                      {{"Mw", "Mw"}, {"Ms", "Ms"}, {"ML", "ML"}, {"mb", "mb"}});
    } else if (line.starts_with("STATION NO.")) {
      lines.next();
      header.station = std::string(trimmed(lines.line().substr(0, lines.line().find("S/N"))));
    } else if (line.find("STATION") != std::string_view::npos ||
               line.find("Station") != std::string_view::npos) {
      header.station = std::string(trimmed(line.substr(0, 40)));
    } else if (line.starts_with("UNITS ") && line.find(" ARE SEC") != std::string_view::npos &&
               line.find("AND") != std::string_view::npos) {
      header.unit = first_word(line.substr(line.find("AND") + 3));
      while (header.unit.ends_with('.')) header.unit.pop_back();
      header.unit_line = lines.number();
      lines.next();  // blank, or the RMS
      for (std::size_t i = 0; i < volume_one_header_lines && lines.next(); ++i) continue;
      if (header.points == 0) break;
      return header;
    }
  }
  if (header.name.empty()) return std::nullopt;
  refuse_record(file, "has a component without NO. OF POINTS and units", cut_short);
}

/// The step and the samples of a component, whose lines follow.
struct VolumeOneSamples {
  double dt_s;
  std::vector<double> samples_mps2;
};

/// Every component of a file.
/// @param read the samples below a header, in units of so many m/s2
template <class Read>
std::vector<FileComponent> volume_one_components(const RecordText& file,
                                                 const RecordFileOptions& options,
                                                 const Read& read) {
  std::vector<FileComponent> components;
  LineReader lines(file.text);
  while (const auto header = volume_one_header(file, lines)) {
    const double unit_mps2 = stated_unit(file, header->unit, header->unit_line, options);
    auto [dt_s, samples_mps2] = read(lines, *header, unit_mps2);
    RecordHeader stated = header->stated;
    stated.station = header->station;
    stated.direction = plain_direction(header->name);
    stated.unit = header->unit;
    stated.is_processed = false;
    add_component(
        file, file_component(file, header->name, dt_s, std::move(samples_mps2), std::move(stated)),
        components);
    components.back().record.notes.emplace_back("uncorrected accelerogram (Volume I)");
  }
  if (components.empty()) refuse_record(file, "has no component", cut_short);
  return components;
}

/// Pairs of time and acceleration; a blank may stand before them (1X, 10F7.3).
std::vector<FileComponent> read_usc(const RecordText& file, const RecordFileOptions& options) {
  constexpr std::size_t width = 7;
  const auto read = [&](LineReader& lines, const VolumeOneHeader& header, double unit_mps2) {
    TimedSamples pairs;
    for (LineReader ahead = lines; ahead.next(); lines = ahead) {
      const std::string_view line = ahead.line();
      if (line.starts_with("FILE") || line.starts_with("/&")) break;
      add_pairs(file, ahead.number(),
                fixed_fields(line.size() % width == 1 ? line.substr(1) : line, width), unit_mps2,
                pairs);
    }
    check_stated_count(file.at(header.points_line), header.points, pairs.samples_mps2.size());
    const double dt_s = digitised_step_s(file, pairs, options);
    return VolumeOneSamples{dt_s, std::move(pairs.samples_mps2)};
  };
  return volume_one_components(file, options, read);
}

std::vector<FileComponent> read_bhrc(const RecordText& file, const RecordFileOptions& options) {
  constexpr std::size_t width = 13;
  const auto read = [&](LineReader& lines, const VolumeOneHeader& header, double unit_mps2) {
    // Of the duration, to the digits it is printed with.
    const double mean_s = header.duration_s / static_cast<double>(header.points);
    const double dt_s = stated_step(file.at(header.points_line), shortest_decimal(mean_s),
                                    std::round(mean_s * 1e6) * 1e-6, options);
    return VolumeOneSamples{dt_s, read_block(file, lines, {header.points, width, unit_mps2})};
  };
  return volume_one_components(file, options, read);
}

}  // namespace

const RecordFormat usc_format{"USC or CDMG Volume I", is_usc, read_usc};
const RecordFormat bhrc_format{"BHRC of Iran", is_bhrc, read_bhrc};

}  // namespace glissade
