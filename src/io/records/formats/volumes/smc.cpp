// SPDX-License-Identifier: GPL-3.0-or-later
// SMC of the USGS: 11 text lines, 48 integers in 8I10, 50 reals in 5E15.7, comments, then values in
// cm/s2 in 8E10.4 or 5E14.7 (nsmp.wr.usgs.gov/smcfmt.html; Boore 2005, USGS Open-File Report
// 00-509, version 2.3).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr std::size_t smc_text_lines = 11, smc_integers = 48, smc_reals = 50;
constexpr double smc_missing_integer = -32768.0, smc_missing_real = 1.6e38;

constexpr std::array smc_kinds = {"UNKNOWN",      "UNCORRECTED", "CORRECTED", "VELOCITY",
                                  "DISPLACEMENT", "RESPONSE",    "FOURIER"};

/// 0 to 6, of "2 CORRECTED ACCELEROGRAM"; nothing: no SMC file.
std::optional<std::size_t> smc_kind(std::string_view line) {
  if (line.size() < 3 || line[0] < '0' || line[0] > '6' || line[1] != ' ') return std::nullopt;
  const auto kind = static_cast<std::size_t>(line[0] - '0');
  if (!trimmed(line.substr(2)).starts_with(smc_kinds[kind])) return std::nullopt;
  return kind;
}

bool is_smc(const RecordText& file) {
  LineReader lines(file.text);
  if (!lines.next() || !smc_kind(lines.line())) return false;
  while (lines.number() < smc_text_lines && lines.next()) continue;
  if (!lines.next()) return false;
  const auto integers = fixed_fields(lines.line(), 10);
  return integers.size() == 8 && fortran_number(integers.front()).has_value();
}

/// The numbers of a header, from 1 as the document counts them.
std::vector<double> smc_header(const RecordText& file, LineReader& lines, std::size_t count,
                               std::size_t width) {
  std::vector<double> values{0.0};
  while (values.size() <= count && lines.next())
    for (const std::string_view field : fixed_fields(lines.line(), width))
      values.push_back(parse_finite(file, lines.number(), field, "the header's value"));
  if (values.size() != count + 1)
    refuse_record(file, fmt::format("does not have {} values in its header", count), cut_short);
  return values;
}

/// The quantity that line 1 names, as a unit.
std::string smc_unit(const RecordText& file, std::size_t kind, const RecordFileOptions& options) {
  if (kind == 0 && !options.units)
    refuse_record(file.at(1), "does not say what it holds (0 UNKNOWN)",
                  "give units, where it holds accelerations: cm/s2 in SMC files");
  if (kind == 0) return "";
  if (kind <= 2) return "cm/s2";
  if (kind > 4)
    refuse_record(file.at(1), "is a spectrum, no motion",
                  "give the file of accelerations, 1 or 2 in its first line");
  return kind == 3 ? "cm/s" : "cm";
}

/// Line 4 has date and name of the event, line 5 its magnitudes.
void read_smc_line(const LineReader& lines, RecordHeader& header) {
  constexpr std::size_t event_line = 4, magnitude_line = 5;
  const std::string_view line = lines.line();
  if (lines.number() == event_line && !line.starts_with("*")) header.event = single_blanks(line);
  if (lines.number() == magnitude_line)
    state_magnitude(header, line, {{"Moment Mag=", "Mw"}, {"Ms=", "Ms"}, {"Ml=", "ML"}});
  if (line.starts_with("station")) {  // "station = San Francisco, 1295 Shafter, F component= 360"
    const std::string_view name = line.substr(0, std::min(line.find("component"), line.size()));
    header.station = trimmed(name.substr(std::min(name.find('=') + 1, name.size())));
  }
  if (line.starts_with("epicentral dist")) {
    const auto km = first_number(line);
    if (km && km->value > 0.0) header.epicentral_km = km->value;
  }
}

std::string smc_direction(const std::vector<double>& integers) {
  const double vertical = integers[13], azimuth = integers[14];
  if (vertical == 0.0) return "UP";
  if (vertical == 180.0) return "DOWN";
  return azimuth == smc_missing_integer ? "" : shortest_decimal(azimuth);
}

std::vector<FileComponent> read_smc(const RecordText& file, const RecordFileOptions& options) {
  LineReader lines(file.text);
  lines.next();
  const std::size_t kind = *smc_kind(lines.line());
  const std::string unit = smc_unit(file, kind, options);
  const double unit_mps2 = stated_unit(file, unit, 1, options);
  RecordHeader header;
  while (lines.number() < smc_text_lines && lines.next()) read_smc_line(lines, header);
  const std::vector<double> integers = smc_header(file, lines, smc_integers, 10);
  const std::size_t count_line = smc_text_lines + 3;
  const std::vector<double> reals = smc_header(file, lines, smc_reals, 15);
  const double rate = reals[2];
  const bool has_rate = rate > 0.0 && rate < smc_missing_real;
  for (double comments = integers[16]; comments > 0.0 && lines.next(); --comments) continue;
  const std::size_t count =
      stated_count(file, {"the count of values", shortest_decimal(integers[17]), count_line});
  const std::size_t width = integers[47] == 8.0 ? 14 : 10;  // digits
  double dt_s = 0.0;
  std::vector<double> samples;
  if (kind == 1 && !has_rate) {  // pairs of time and acceleration
    TimedSamples pairs;
    while (2 * pairs.samples_mps2.size() < count && lines.next())
      add_pairs(file, lines.number(), fixed_fields(lines.line(), width), unit_mps2, pairs);
    check_stated_count(file.at(count_line), count, 2 * pairs.samples_mps2.size());
    dt_s = digitised_step_s(file, pairs, options);
    samples = std::move(pairs.samples_mps2);
  } else {
    dt_s = stated_step(file.at(smc_text_lines + 7), "1 / " + shortest_decimal(rate) + " Hz",
                       has_rate ? 1.0 / rate : 0.0, options);
    samples = read_block(file, lines, {count, width, unit_mps2});
  }
  const std::string direction = smc_direction(integers);
  header.direction = direction;
  header.unit = unit;
  if (kind > 0) header.is_processed = kind == 2;
  FileComponent component =
      file_component(file, direction, dt_s, std::move(samples), std::move(header));
  if (kind == 1) component.record.notes.emplace_back("SMC, uncorrected accelerogram");
  return {std::move(component)};
}

}  // namespace

const RecordFormat smc_format{"SMC of the USGS", is_smc, read_smc};

}  // namespace glissade
