// SPDX-License-Identifier: GPL-3.0-or-later
// One column of accelerations below two lines: a name, and "npts dt", as eqsig writes it
// (eqsig 1.2, load_values_and_dt, 2021); or a count, and the step. Rows of time and acceleration
// below one line "npts dt", as DEEPSOIL has them (DEEPSOIL 7, user manual, 2020).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

constexpr double shortest_usual_step_s = 0.0005, longest_usual_step_s = 0.1;

bool is_whole(double value) {
  return value >= 1.0 && value <= static_cast<double>(most_samples) && std::round(value) == value;
}

/// The first two lines, and whether they are of one of the two forms.
struct TwoLines {
  std::string name;  ///< of the first form
  double count = 0.0, dt_s = 0.0;
  std::string dt_text;
};

std::optional<double> only_number(std::string_view line) {
  const auto parts = fields(line);
  return parts.size() == 1 ? fortran_number(parts[0]) : std::nullopt;
}

/// Every other line holds one number at most; nothing: some line has more.
std::optional<std::size_t> values_below(LineReader lines) {
  std::size_t count = 0;
  while (lines.next()) {
    const auto parts = fields(lines.line());
    if (parts.size() > 1) return std::nullopt;
    count += parts.size();
  }
  return count;
}

std::optional<TwoLines> two_lines(const RecordText& file) {
  LineReader lines(file.text);
  if (!lines.next() || is_blank_or_comment(lines.line())) return std::nullopt;
  const std::string_view first = lines.line();
  if (!lines.next()) return std::nullopt;
  const auto below = fields(lines.line());
  TwoLines two;
  if (!fields(first).empty() && !fortran_number(fields(first)[0]) && below.size() == 2) {
    const auto count = fortran_number(below[0]), dt_s = fortran_number(below[1]);
    if (!count || !dt_s || !is_whole(*count) || !(*dt_s > 0.0 && *dt_s <= 1.0)) return std::nullopt;
    two = {std::string(trimmed(first)), *count, *dt_s, std::string(below[1])};
    return values_below(lines) ? std::optional(two) : std::nullopt;
  }
  const auto count = only_number(first), dt_s = only_number(lines.line());
  if (!count || !dt_s || !is_whole(*count)) return std::nullopt;
  if (*dt_s < shortest_usual_step_s || *dt_s > longest_usual_step_s) return std::nullopt;
  const auto values = values_below(lines);
  constexpr std::size_t least_values = 8;
  if (!values || *values < least_values ||
      (*count != 1.0 && *count != static_cast<double>(*values)))
    return std::nullopt;
  return TwoLines{"", *count, *dt_s, std::string(trimmed(lines.line()))};
}

/// "npts dt" above rows whose times have that step.
std::optional<At2Header> count_above_rows(const RecordText& file) {
  std::vector<std::vector<std::string_view>> lines;
  for (LineReader reader(file.text); lines.size() < 3 && reader.next();)
    lines.push_back(fields(reader.line()));
  if (lines.size() < 3 || std::ranges::any_of(lines, [](auto& line) { return line.size() != 2; }))
    return std::nullopt;
  const auto number = [&](std::size_t line, std::size_t at) {
    return fortran_number(lines[line][at]).value_or(-1.0);
  };
  const double count = number(0, 0), dt_s = number(0, 1), step_s = number(2, 0) - number(1, 0);
  if (!is_whole(count) || !(dt_s > 0.0 && dt_s <= 1.0) || std::abs(step_s - dt_s) > 0.1 * dt_s)
    return std::nullopt;
  At2Header header;
  header.npts = static_cast<std::uint64_t>(count);
  header.dt_text = lines[0][1];
  header.dt_s = dt_s;
  header.npts_line = header.dt_line = 1;
  return header;
}

std::vector<FileComponent> read_counted_rows(const RecordText& file, const At2Header& header,
                                             const RecordFileOptions& options) {
  const double unit_mps2 = stated_unit(file, "", 0, options);
  LineReader lines(file.text);
  lines.next();
  TimedSamples rows;
  while (lines.next()) add_pairs(file, lines.number(), fields(lines.line()), unit_mps2, rows);
  check_at2_count(file.path, header, rows.samples_mps2.size());
  FileComponent component = file_component(file, "", 0.0, {});
  component.record.dt_s = step_of_rows(file, rows, header, options, component.record.notes);
  component.record.acceleration_mps2 = std::move(rows.samples_mps2);
  return {std::move(component)};
}

bool is_headed_column(const RecordText& file) {
  return two_lines(file).has_value() || count_above_rows(file).has_value();
}

std::vector<FileComponent> read_headed_column(const RecordText& file,
                                              const RecordFileOptions& options) {
  if (const auto header = count_above_rows(file)) return read_counted_rows(file, *header, options);
  const TwoLines two = *two_lines(file);
  // With a step that is given the file is one column, whose reader knows a header.
  if (two.name.empty() && options.dt_s) return column_format.read(file, options);
  const double unit_mps2 = stated_unit(file, "", 0, options);
  const double dt_s = stated_step(file.at(2), two.dt_text, two.dt_s, options);
  LineReader lines(file.text);
  lines.next(), lines.next();
  std::vector<double> samples = read_rest(file, lines, unit_mps2);
  if (!two.name.empty())
    check_stated_count(file.at(2), static_cast<std::size_t>(two.count), samples.size());
  if (samples.empty()) refuse_record(file, "the file holds no samples", "get it again");
  FileComponent component = file_component(file, two.name, dt_s, std::move(samples));
  if (two.name.empty())
    component.record.notes.push_back(
        fmt::format("lines 1 and 2, {:g} and {}, are taken for a count and the step in s",
                    two.count, two.dt_text));
  return {std::move(component)};
}

}  // namespace

const RecordFormat headed_column_format{"a column below its count and step", is_headed_column,
                                        read_headed_column};

}  // namespace glissade
