// SPDX-License-Identifier: GPL-3.0-or-later
// National Strong-Motion Network of Turkey (AFAD, formerly NSMN): lines "KEY : value", a heading of
// three columns, then rows in gal (kyhdata.deprem.gov.tr, as downloaded 2017).
#include <fmt/format.h>

#include <array>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

bool is_afad(const RecordText& file) {
  LineReader lines(file.text);
  return lines.next() && trimmed(lines.line()).starts_with("STRONG GROUND MOTION RECORDS OF TURK");
}

/// The heading, "N-S E-W U-D"; the lines go on after it.
std::vector<std::string> afad_directions(const RecordText& file, LineReader& lines) {
  constexpr std::size_t most_header_lines = 40;
  while (lines.number() < most_header_lines && lines.next()) {
    const auto names = fields(lines.line());
    if (names.size() == 3 && trimmed(lines.line()).find("N-S") != std::string_view::npos)
      return {names.begin(), names.end()};
  }
  refuse_record(file.path.string(), "has no heading N-S E-W U-D above its columns",
                "the file is cut short: get it again");
}

std::vector<FileComponent> read_afad(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  lines.next();
  const HeaderLines header = HeaderLines::with_colons(lines);
  const HeaderLine& count = header.required(file, "NUMBER OF DATA");
  const HeaderLine& step = header.required(file, "SAMPLING INTERVAL (sec)");
  const HeaderLine& peaks = header.required(file, "RAW PGA VALUES (gal)");
  const double unit_mps2 = stated_unit(file, "gal", peaks.line, options);
  const double dt_s =
      stated_step(place(file.path, step.line), step.value, fortran_number(step.value), options);
  const std::vector<std::string> names = afad_directions(file, lines);
  std::array<std::vector<double>, 3> samples;
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    const auto row = fields(lines.line());
    if (row.size() != samples.size())
      refuse_record(place(file.path, lines.number()),
                    fmt::format("{} columns where three are stated", row.size()),
                    "the file is cut short: get it again");
    for (std::size_t i = 0; i < row.size(); ++i)
      add_sample(file.path, parse_sample(file.path, lines.number(), row[i], unit_mps2), samples[i]);
  }
  check_stated_count(place(file.path, count.line), stated_count(file, count), samples[0].size());
  std::vector<FileComponent> components;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    components.push_back(file_component(file, names[i], dt_s, std::move(samples[i])));
    components.back().record.source =
        fmt::format("{}, {}, {}", header.value("EARTHQUAKE DATE"), header.value("STATION ID"),
                    plain_direction(names[i]));
    components.back().record.notes.emplace_back("AFAD, raw: not corrected, its offset is in it");
  }
  return components;
}

}  // namespace

const RecordFormat afad_format{"AFAD or NSMN of Turkey", is_afad, read_afad};

}  // namespace glissade
