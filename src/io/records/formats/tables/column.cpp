// SPDX-License-Identifier: GPL-3.0-or-later
// One column of accelerations, or two, time and acceleration. `#` begins a comment; those before
// the first sample may state units, step and count.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/motion/improbable.hpp"
#include "records/at2_header.hpp"
#include "records/formats/reading.hpp"
#include "records/formats/tables/table_heading.hpp"

namespace glissade {
namespace {

constexpr std::size_t judged = 8;  ///< of the values without a time, to know a header

/// Digits behind the point: programs write samples with as many each.
std::size_t decimals_of(std::string_view token) {
  const std::size_t point = token.find('.');
  if (point == std::string_view::npos) return 0;
  const std::size_t end = token.find_first_of("eEdD", point);
  return (end == std::string_view::npos ? token.size() : end) - point - 1;
}

/// A value of a header that is no comment, before values without a time.
struct HeaderValue {
  double value;  ///< in the file's unit
  const char* what;
};

/// The number of values that follow; among the first three a whole number that is nearly that, or
/// far above all that follow, or any number that is far above them and any motion; a first whole
/// number, however small, that is far above them.
std::optional<HeaderValue> find_count(const Record& record, double unit_mps2) {
  constexpr std::size_t headed = 3, least = 5;
  constexpr double least_count = 100.0, count_error = 0.05, far_above = 3.0;
  const Samples& a = record.acceleration_mps2;
  if (a.size() < least) return std::nullopt;
  const double first = a.front() / unit_mps2, after = static_cast<double>(a.size() - 1);
  if (std::round(first) == after || std::round(first) == after - 1.0)
    return HeaderValue{first, "the number of values that follow"};
  if (a.size() < judged) return std::nullopt;
  double largest_after = 0.0;
  for (std::size_t i = headed; i < a.size(); ++i)
    largest_after = std::max(largest_after, std::abs(a[i]) / unit_mps2);
  for (std::size_t i = 0; i < headed; ++i) {
    const double value = a[i] / unit_mps2;
    if (value >= least_count && std::round(value) == value &&
        (std::abs(value - after) <= count_error * after || value > far_above * largest_after))
      return HeaderValue{value, "a count"};
    // A record begins at rest.
    if (a[i] > most_probable_pga_g * standard_gravity_mps2 && largest_after > 0.0 &&
        value > 10.0 * largest_after)
      return HeaderValue{value, "far above all that follow"};
  }
  if (first >= 1.0 && std::round(first) == first && largest_after > 0.0 &&
      first > far_above * largest_after)
    return HeaderValue{first, "a whole number far above all that follow"};
  return std::nullopt;
}

/// The step, or one that is usual of recorders beside a count (of components, of parts), a hundred
/// times the values after it, or written with other digits than they are: alone, or behind a PGA.
/// @param decimals of the first `judged` values
std::optional<HeaderValue> find_step(const Record& record, double unit_mps2,
                                     const std::vector<std::size_t>& decimals) {
  const Samples& a = record.acceleration_mps2;
  const double first = a.front() / unit_mps2;
  const auto equals_step = [&](double value) {
    return std::abs(value - record.dt_s) <= 1e-9 * record.dt_s;
  };
  if (equals_step(first)) return HeaderValue{first, "a time step"};
  if (a.size() < judged) return std::nullopt;
  const double second = a[1] / unit_mps2;
  const auto is_usual_step = [](double value) { return value >= 0.0005 && value <= 0.1; };
  if (first >= 1.0 && std::round(first) == first && (equals_step(second) || is_usual_step(second)))
    return HeaderValue{first, "a count, and a time step"};
  for (std::size_t i = 0; i < 2; ++i) {
    const double value = a[i] / unit_mps2;
    const bool is_round = std::abs(std::remainder(value, 1e-4)) < 1e-12;
    if (is_usual_step(value) && is_round &&
        std::all_of(decimals.begin() + i + 1, decimals.end(),
                    [&](auto digits) { return digits == decimals.back() && digits > decimals[i]; }))
      return HeaderValue{value, "a time step"};
  }
  const auto is_far_below_first = [&](double value) {
    return 100.0 * std::abs(value) <= std::abs(a.front());
  };
  if (is_usual_step(first) && std::all_of(a.begin() + 1, a.begin() + judged, is_far_below_first))
    return HeaderValue{first, "a time step"};
  return std::nullopt;
}

void refuse_header(const Record& record, double unit_mps2,
                   const std::vector<std::size_t>& decimals) {
  auto found = find_count(record, unit_mps2);
  if (!found) found = find_step(record, unit_mps2, decimals);
  if (!found) return;
  throw InputError(
      {record.name,
       fmt::format("begins with {:g}, {}: a header, not an acceleration", found->value,
                   found->what),
       "put # before the lines of the header; a sample of that value needs a column of times", ""});
}

/// What the comments before the first sample state. InputError where they head a spectrum.
At2Header comments_of(const RecordText& file) {
  At2Header header;
  LineReader reader(file.text);
  constexpr std::size_t most_lines = 1000;
  while (reader.number() < most_lines && reader.next() && is_blank_or_comment(reader.line())) {
    read_header_line(reader.line(), reader.number(), header);
    const std::string heading(without_comment_mark(reader.line().substr(0, most_lines)));
    if (const auto column = spectrum_column(table_columns({heading}, ' ', 2)); !column.empty())
      refuse_spectrum(file.at(reader.number()), column);
  }
  return header;
}

std::vector<FileComponent> read_columns(const RecordText& file, const RecordFileOptions& options) {
  const At2Header header = comments_of(file);
  TimedSamples rows;
  std::size_t columns = 0;
  double unit_mps2 = 1.0;
  std::vector<std::size_t> decimals;
  LineReader reader(file.text);
  constexpr std::size_t most_lines_above = 100'000;
  while (reader.next() && (columns > 0 || reader.number() <= most_lines_above)) {
    if (is_blank_or_comment(reader.line())) continue;
    const std::vector<std::string_view> parts = fields(reader.line());
    const std::size_t line = reader.number();
    if (columns == 0) {
      parse_finite(file, line, parts.front(),
                   "the value");  // text is reported as text, however many words
      columns = parts.size();
      const bool has_step = columns == 2 || options.dt_s || header.dt_s;
      if (columns <= 2)
        unit_mps2 = stated_unit(file, {header.units, header.units_line}, has_step, options);
    }
    if (parts.size() > 2 || parts.size() != columns)
      refuse_record(file.at(line),
                    std::to_string(parts.size()) + (parts.size() == 1 ? " column" : " columns") +
                        (parts.size() > 2 ? "; at most two are read"
                                          : ", " + std::to_string(columns) + " above"),
                    what_is_read);
    if (columns == 2) rows.time.add(parse_finite(file, line, parts[0], "the time"), parts[0], line);
    add_sample(file, line, parts.back(), unit_mps2, rows.samples_mps2);
    if (columns == 1 && decimals.size() < judged) decimals.push_back(decimals_of(parts.back()));
  }
  if (columns == 0)
    refuse_record(file,
                  reader.number() > most_lines_above
                      ? fmt::format("holds no samples in its first {} lines", most_lines_above)
                      : "the file holds no samples",
                  what_is_read);
  if (header.npts) check_at2_count(file.path, header, rows.samples_mps2.size());
  FileComponent component = file_component(file, "", 0.0, {});
  component.header.unit = header.units;
  Record& record = component.record;
  if (columns == 1 && !options.dt_s && !header.dt_s)
    refuse_record(file, "one column does not give the time step", "give it with dt_s");
  record.dt_s = columns == 2 ? step_of_rows(file, rows, header, options, record.notes)
                             : at2_step(file.path, header, options.dt_s);
  record.acceleration_mps2 = std::move(rows.samples_mps2);
  if (columns == 1) refuse_header(record, unit_mps2, decimals);
  return {std::move(component)};
}

bool is_any_text(const RecordText&) { return true; }

}  // namespace

const RecordFormat column_format{"one or two columns", is_any_text, read_columns};

}  // namespace glissade
