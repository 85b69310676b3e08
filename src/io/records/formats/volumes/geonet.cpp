// SPDX-License-Identifier: GPL-3.0-or-later
// GeoNet of New Zealand, V1A and V2A: per component 16 text lines, 40 integers in 10I8, 60 reals in
// 10F8, then accelerations (and velocities and displacements) in mm/s2 in 10F8.1 (GNS Science,
// "Format of the strong-motion data files", geonet.org.nz, as downloaded 2018).
#include <algorithm>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t geonet_text_lines = 16, geonet_width = 8, geonet_count_line = 3,
                      geonet_count_at = 3, geonet_integer_lines = 4, geonet_real_lines = 6;

bool is_geonet_title(std::string_view line) {
  return (line.starts_with("Uncorrected accelerogram") ||
          line.starts_with("Corrected accelerogram")) &&
         line.find("GNS") != std::string_view::npos;
}
bool is_geonet(const RecordText& file) { return is_geonet_title(file.first_line()); }

/// What the text lines of a component state.
struct GeonetText {
  std::string title, site, name, event;
  RecordHeader header;  ///< magnitude and distance
  std::string unit;     ///< of "Acceleration:  Peak   2394.8 mm/s/s at  48.13 s"
  std::size_t unit_line = 0, step_line = 0;
  std::optional<double> dt_s;
};

GeonetText geonet_text(LineReader& lines) {
  GeonetText text;
  text.title = lines.line();
  for (std::size_t i = 1; i < geonet_text_lines && lines.next(); ++i) {
    const std::string_view line = lines.line();
    if (line.starts_with("Site ")) text.site = trimmed(line.substr(0, 15));
    if (line.find(" UT") != std::string_view::npos && text.event.empty())
      text.event = single_blanks(line);  // "2016 November 13         11:02:56 UT"
    if (line.starts_with("Epicentre")) {
      state_magnitude(text.header, line, {{"Mw", "Mw"}, {"ML", "ML"}, {" M ", "M"}});
      const std::size_t distance = line.find("Dist");
      if (const auto km = distance == line.npos ? std::nullopt : first_number(line, distance))
        text.header.epicentral_km = std::max(0.0, km->value);
    }
    if (line.starts_with("Component ")) text.name = first_word(line.substr(9));
    const std::size_t at = line.find(" at ");
    if (line.starts_with("Acceleration:") && at != std::string_view::npos) {
      const auto words = fields(line.substr(0, at));
      if (words.size() > 1) text.unit = words.back();
      text.unit_line = lines.number();
    } else if (at != std::string_view::npos && line.find("interval") != std::string_view::npos) {
      const std::size_t interval = line.rfind(" at ");
      if (const auto step = first_number(line, interval)) text.dt_s = step->value;
      text.step_line = lines.number();
    }
  }
  return text;
}

/// The number of accelerations, the fourth integer of the fourth line; the lines go on behind the
/// reals.
std::size_t geonet_count(const RecordText& file, LineReader& lines) {
  HeaderLine count{"the count of accelerations", "", lines.number()};
  for (std::size_t i = 0; i < geonet_integer_lines && lines.next(); ++i) {
    const auto row = fixed_fields(lines.line(), geonet_width);
    if (i == geonet_count_line && row.size() > geonet_count_at)
      count = {count.key, std::string(row[geonet_count_at]), lines.number()};
  }
  for (std::size_t i = 0; i < geonet_real_lines && lines.next(); ++i) continue;
  return stated_count(file, count);
}

std::vector<FileComponent> read_geonet(const RecordText& file, const RecordFileOptions& options) {
  std::vector<FileComponent> components;
  for (LineReader lines(file.text); lines.next();) {
    if (!is_geonet_title(lines.line())) continue;  // velocities and displacements
    const GeonetText text = geonet_text(lines);
    const double unit_mps2 = stated_unit(file, text.unit, text.unit_line, options);
    const double dt_s = stated_step(file.at(text.step_line), "(none)", text.dt_s, options);
    const std::size_t count = geonet_count(file, lines);
    RecordHeader header = text.header;
    header.event = text.event.empty() ? text.title : text.event;
    header.station = text.site;
    header.direction = plain_direction(text.name);
    header.unit = text.unit;
    header.is_processed = text.title.starts_with("Corrected");
    add_component(file,
                  file_component(file, text.name, dt_s,
                                 read_block(file, lines, {count, geonet_width, unit_mps2}),
                                 std::move(header)),
                  components);
    if (text.title.starts_with("Uncorrected"))
      components.back().record.notes.emplace_back("GeoNet V1A: uncorrected accelerogram");
  }
  return components;
}

}  // namespace

const RecordFormat geonet_format{"GeoNet V1A or V2A", is_geonet, read_geonet};

}  // namespace glissade
