// SPDX-License-Identifier: GPL-3.0-or-later
// China Strong Motion Network Center: 15 lines, among them "COMP. EW", "UNCORRECTED ACCELERATION
// UNIT: CM/SEC/SEC" and "NO. OF POINTS: N EQUALLY SPACED INTERVALS OF: DT SEC", then the values
// (csmnc.net, as downloaded 2013).
#include <fmt/format.h>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t csmnc_header_lines = 20;

/// What follows a word of a line; "" where the line has it not.
std::string_view csmnc_behind(std::string_view line, std::string_view word) {
  const std::size_t at = line.find(word);
  return at == line.npos ? std::string_view() : trimmed(line.substr(at + word.size()));
}

bool is_csmnc(const RecordText& file) {
  LineReader lines(file.text);
  while (lines.number() < csmnc_header_lines && lines.next())
    if (lines.line().starts_with("NO. OF POINTS") &&
        !csmnc_behind(lines.line(), "EQUALLY SPACED INTERVALS OF:").empty())
      return true;
  return false;
}

struct CsmncHeader {
  RecordHeader stated;
  std::string quantity;
  HeaderLine count{"NO. OF POINTS", "", 0}, step{"INTERVALS OF", "", 0};
  std::size_t unit_line = 0;
};

/// To the line CSMNC, behind which the values stand.
CsmncHeader csmnc_header(const RecordText& file, LineReader& lines) {
  CsmncHeader header;
  RecordHeader& stated = header.stated;
  while (lines.number() < csmnc_header_lines && lines.next()) {
    const std::string_view line = trimmed(lines.line());
    if (line == "CSMNC") return header;
    if (const auto unit = csmnc_behind(line, "UNIT:"); !unit.empty()) {
      header.quantity = single_blanks(line.substr(0, line.find("UNIT:")));
      stated.unit = unit;
      header.unit_line = lines.number();
    } else if (line.starts_with("NO. OF POINTS")) {
      header.count.value = first_word(csmnc_behind(line, ":"));
      header.step.value = first_word(csmnc_behind(line, "INTERVALS OF:"));
      header.count.line = header.step.line = lines.number();
    } else if (line.find("EARTHQUAKE") != line.npos) {
      stated.event = single_blanks(line);
    } else if (line.starts_with("STATION:")) {
      stated.station = first_word(csmnc_behind(line, ":"));
    } else if (line.starts_with("OBSERVING POINT:")) {
      stated.location = single_blanks(csmnc_behind(line, ":"));
    } else if (line.starts_with("COMP.")) {
      stated.direction = plain_direction(csmnc_behind(line, "COMP."));
    } else if (line.starts_with("MAGNITUDE")) {  // "7.0(Ms)"
      const bool is_ms = line.find("(Ms)") != line.npos, is_mw = line.find("(Mw)") != line.npos;
      state_magnitude(stated, line, {{"MAGNITUDE", is_ms ? "Ms" : is_mw ? "Mw" : "M"}});
    }
  }
  refuse_record(file, "ends before the line CSMNC of its header", cut_short);
}

std::vector<FileComponent> read_csmnc(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  CsmncHeader header = csmnc_header(file, lines);
  if (header.quantity.find("ACCELERATION") == std::string::npos)
    refuse_record(file.at(header.unit_line),
                  "holds " + in_quotes(lower_case(header.quantity)) + ", not acceleration",
                  "give the file of accelerations");
  header.stated.is_processed = !header.quantity.starts_with("UNCORRECTED");
  const double unit_mps2 = stated_unit(file, header.stated.unit, header.unit_line, options),
               dt_s = stated_step(file, header.step, options);
  std::vector<double> samples = read_rest(file, lines, unit_mps2);
  check_stated_count(file, header.count, samples.size());
  const std::string direction = header.stated.direction;
  FileComponent component =
      file_component(file, direction, dt_s, std::move(samples), std::move(header.stated));
  if (component.header.is_processed == false)
    component.record.notes.emplace_back("CSMNC: not corrected");
  return {std::move(component)};
}

}  // namespace

const RecordFormat csmnc_format{"CSMNC of China", is_csmnc, read_csmnc};

}  // namespace glissade
