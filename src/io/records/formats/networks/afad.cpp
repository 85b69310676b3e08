// SPDX-License-Identifier: GPL-3.0-or-later
// National Strong-Motion Network of Turkey (AFAD, formerly NSMN): lines "KEY : value", a heading of
// three columns, then rows in gal (kyhdata.deprem.gov.tr, as downloaded 2017).
#include "records/formats/reading.hpp"

namespace glissade {
namespace {

bool is_afad(const RecordText& file) {
  return trimmed(file.first_line()).starts_with("STRONG GROUND MOTION RECORDS OF TURK");
}

/// The heading, "N-S E-W U-D"; the lines go on after it.
std::vector<std::string> afad_directions(const RecordText& file, LineReader& lines) {
  constexpr std::size_t most_header_lines = 40;
  while (lines.number() < most_header_lines && lines.next()) {
    const auto names = fields(lines.line());
    if (names.size() == 3 && trimmed(lines.line()).find("N-S") != std::string_view::npos)
      return {names.begin(), names.end()};
  }
  refuse_record(file, "has no heading N-S E-W U-D above its columns", cut_short);
}

/// The two numbers of "36.91980N-27.44350E".
double afad_distance_km(const HeaderLines& header) {
  const auto places = [&](const char* key) {
    const std::string text = header.value(key);
    const std::size_t between = text.find('-');
    std::pair<std::optional<double>, std::optional<double>> found;
    if (const auto north = first_number(text)) found.first = north->value;
    if (between == std::string::npos) return found;
    if (const auto east = first_number(text, between + 1)) found.second = east->value;
    return found;
  };
  const auto event = places("EPICENTER COORDINATES"), station = places("STATION COORDINATES");
  return epicentral_km(event.first, event.second, station.first, station.second);
}

RecordHeader afad_header(const HeaderLines& lines, std::string direction) {
  RecordHeader header{lines.value("EARTHQUAKE DATE"), lines.value("STATION ID"),
                      std::move(direction), "gal"};
  const std::string magnitude = lines.value("EARTHQUAKE MAGNITUDE");  // "6.5 Mw"
  state_magnitude(header, "M " + magnitude, {{"M", "M"}});
  if (const auto words = fields(magnitude); header.magnitude > 0.0 && words.size() == 2)
    header.magnitude_kind = words[1];
  header.epicentral_km = afad_distance_km(lines);
  header.is_processed = false;
  return header;
}

std::vector<FileComponent> read_afad(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  lines.next();
  const HeaderLines header = HeaderLines::with_colons(lines);
  const HeaderLine& count = header.required(file, "NUMBER OF DATA");
  const HeaderLine& step = header.required(file, "SAMPLING INTERVAL (sec)");
  const HeaderLine& peaks = header.required(file, "RAW PGA VALUES (gal)");
  const double unit_mps2 = stated_unit(file, "gal", peaks.line, options);
  const double dt_s = stated_step(file, step, options);
  const std::vector<std::string> names = afad_directions(file, lines);
  std::vector<std::vector<double>> samples(names.size());
  while (lines.next())
    if (!trimmed(lines.line()).empty())
      add_row(file, lines.number(), fields(lines.line()), unit_mps2, samples);
  check_stated_count(file, count, samples[0].size());
  std::vector<FileComponent> components;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    components.push_back(file_component(file, names[i], dt_s, std::move(samples[i]),
                                        afad_header(header, plain_direction(names[i]))));
    components.back().record.notes.emplace_back("AFAD, raw: not corrected, its offset is in it");
  }
  return components;
}

}  // namespace

const RecordFormat afad_format{"AFAD or NSMN of Turkey", is_afad, read_afad};

}  // namespace glissade
