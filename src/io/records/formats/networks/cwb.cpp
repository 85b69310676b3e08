// SPDX-License-Identifier: GPL-3.0-or-later
// Central Weather Bureau (now Administration) of Taiwan: "#Key: value" lines, then rows of time, U,
// N and E ("Data: 4F10.3", gdms.cwa.gov.tw, as downloaded 2018).
#include <fmt/format.h>

#include "records/formats/reading.hpp"
#include "records/time_column.hpp"

namespace glissade {
namespace {

bool is_cwb(const RecordText& file) {
  return file.first_line().starts_with("#Earthquake Information") &&
         file.text.find("#StationCode:") != std::string::npos;
}

/// The keys of lines "#StationCode: ECU"; the lines go on with the first row.
std::vector<HeaderLine> cwb_header(LineReader& lines) {
  std::vector<HeaderLine> header;
  for (LineReader ahead = lines; ahead.next();) {
    const std::string_view line = trimmed(ahead.line());
    if (!line.empty() && line.front() != '#') break;
    if (auto stated = line_with_colon(ahead)) {
      stated->key = trimmed(stated->key.substr(1));
      header.push_back(*std::move(stated));
    }
    lines = ahead;
  }
  return header;
}

/// "U", "N", "E" of "Time U(+); N(+); E(+)".
std::vector<std::string> cwb_directions(const RecordText& file, const HeaderLine& sequence) {
  std::vector<std::string> names;
  for (const std::string_view part : fields(sequence.value)) {
    const std::size_t sign = part.find("(+)");
    if (sign != std::string_view::npos) names.emplace_back(part.substr(0, sign));
  }
  if (!sequence.value.starts_with("Time") || names.size() != 3)
    refuse_record(file.at(sequence.line),
                  "its DataSequence is not Time and three components, positive as named",
                  "get the file again");
  return names;
}

void check_cwb_length(const RecordText& file, const std::vector<HeaderLine>& header,
                      std::size_t found) {
  const HeaderLine length = line_beginning(header, "RecordLength"),
                   rate = line_beginning(header, "SampleRate");
  const auto length_s = first_number(length.value), rate_hz = first_number(rate.value);
  if (!length_s || !rate_hz || length_s->value * rate_hz->value == static_cast<double>(found))
    return;
  refuse_record(file.at(length.line),
                fmt::format("{} s at {} Hz are {:g} rows, the file contains {}", length.value,
                            rate.value, length_s->value * rate_hz->value, found),
                cut_short);
}

RecordHeader cwb_record_header(const std::vector<HeaderLine>& lines, std::string direction) {
  const auto number = [&](const char* key) {
    return fortran_number(line_beginning(lines, key).value);
  };
  RecordHeader header{line_beginning(lines, "Origin Time").value,
                      line_beginning(lines, "StationCode").value, std::move(direction),
                      line_beginning(lines, "AmplitudeUnit").value};
  const HeaderLine magnitude = line_beginning(lines, "Magnitude");  // "Magnitude(Ml)"
  state_magnitude(header, magnitude.key + " " + magnitude.value,
                  {{"Magnitude(Mw)", "Mw"}, {"Magnitude(Ml)", "ML"}, {"Magnitude", "M"}});
  header.epicentral_km = epicentral_km(number("EpicenterLatitude"), number("EpicenterLongitude"),
                                       number("StationLatitude"), number("StationLongitude"));
  return header;
}

std::vector<FileComponent> read_cwb(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  const std::vector<HeaderLine> header = cwb_header(lines);
  const HeaderLine unit = line_beginning(header, "AmplitudeUnit");
  const std::vector<std::string> names =
      cwb_directions(file, line_beginning(header, "DataSequence"));
  // "gal. DCoffset(corr)"
  const double unit_mps2 = stated_unit(file, first_word(unit.value), unit.line, options);
  std::vector<std::vector<double>> samples(names.size());
  TimeColumn time;
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    const auto row = fixed_fields(lines.line(), 10);
    time.add(parse_finite(file, lines.number(), row[0], "the time"), row[0], lines.number());
    add_row(file, lines.number(), std::span(row).subspan(1), unit_mps2, samples);
  }
  if (samples[0].empty()) refuse_record(file, "has no rows", cut_short);
  check_cwb_length(file, header, samples[0].size());
  const double dt_s = step_of(file.path, time, options.dt_s);
  std::vector<FileComponent> components;
  for (std::size_t i = 0; i < samples.size(); ++i)
    components.push_back(file_component(file, names[i], dt_s, std::move(samples[i]),
                                        cwb_record_header(header, plain_direction(names[i]))));
  return components;
}

}  // namespace

const RecordFormat cwb_format{"CWB of Taiwan", is_cwb, read_cwb};

}  // namespace glissade
