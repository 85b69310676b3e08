// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/at2_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "glissade/core/printable.hpp"
#include "records/formats/reading.hpp"
#include "records/record_units.hpp"
#include "records/time_column.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

constexpr std::size_t longest_header = 100;        // lines
constexpr std::size_t longest_header_line = 1000;  // characters

constexpr std::string_view word_separators = " \t=,;:()[]_";

/// The first word at or after `begin`, without the `=` before it and the punctuation around it.
std::string_view word_at(std::string_view line, std::size_t begin) {
  begin = line.find_first_not_of(word_separators, begin);
  if (begin == std::string_view::npos) return {};
  const std::size_t end = line.find_first_of(word_separators, begin);
  return line.substr(begin, end == std::string_view::npos ? end : end - begin);
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Where `name` ends, which begins a word of the line.
std::size_t end_of_name(const std::string& lower, std::string_view name) {
  std::size_t at = lower.find(name);
  while (at != std::string::npos && at > 0 && is_letter(lower[at - 1]))
    at = lower.find(name, at + 1);
  return at == std::string::npos ? at : at + name.size();
}

/// How text files name the step, or its inverse.
struct StepName {
  std::string_view name;
  bool is_rate = false;
};
constexpr std::array step_names = {StepName{"dt"},
                                   StepName{"delta t"},
                                   StepName{"delta_t"},
                                   StepName{"delta"},
                                   StepName{"time step"},
                                   StepName{"timestep"},
                                   StepName{"time_step"},
                                   StepName{"time increment"},
                                   StepName{"sampling interval"},
                                   StepName{"sample interval"},
                                   StepName{"sampling period"},
                                   StepName{"sampling step"},
                                   StepName{"sampling rate", true},
                                   StepName{"sampling frequency", true},
                                   StepName{"sampling freq", true},
                                   StepName{"sample rate", true}};

constexpr double longest_delta_s = 1.0;  ///< others are distances

/// The step that `text` behind one of the names states: "= 10 ms", " (s): 0.01", " 100 Hz". Other
/// names than DT are also words: they need = or : or a unit ("Delta, 262" is a station).
void read_step(std::string_view text, const StepName& name, std::size_t line, At2Header& header) {
  const std::size_t begin = text.find_first_of("0123456789.+-");
  const auto found = first_number(text, begin);
  const bool is_whole_name = !text.empty() && word_separators.find(text.front()) != text.npos;
  if (!found || !is_whole_name) return;
  const std::string before = lower_case(word_at(text.substr(0, begin), 0)),
                    unit = before.empty() ? lower_case(word_at(text, found->end)) : before;
  const HeaderUnit meaning = header_unit(unit);
  const bool is_rate = name.is_rate || meaning.kind == UnitKind::frequency,
             has_unit = meaning.kind == UnitKind::time || meaning.kind == UnitKind::frequency,
             has_mark = text.substr(0, begin).find_first_of("=:") != std::string_view::npos;
  if ((!before.empty() && !has_unit) || (name.name != "dt" && !has_unit && !has_mark)) return;
  const double dt_s = is_rate ? 1.0 / found->value
                              : (meaning.kind == UnitKind::time ? meaning.si : 1.0) * found->value;
  if (name.name == "delta" && dt_s > longest_delta_s) return;
  constexpr double rounding = 0.02;
  if (header.dt_s && !(std::abs(*header.dt_s - dt_s) <= rounding * dt_s))
    header.other_dt_text = header.dt_text;
  const std::string_view number = trimmed(text.substr(begin, found->end - begin));
  header.dt_text = dt_s == found->value ? std::string(number) : shortest_decimal(dt_s);
  header.dt_s = dt_s;
  header.dt_line = line;
}

bool read_npts_and_step(std::string_view line, const std::string& lower, std::size_t number,
                        At2Header& header) {
  const std::size_t npts_end = end_of_name(lower, "npts");
  bool is_stated = false;
  if (npts_end != std::string::npos) {
    const std::string_view first = word_at(line, 0);
    const bool is_before = npts_end > 4 && parse_count(first);  // 7997 0.0050 NPTS, DT
    header.npts = parse_count(is_before ? first : word_at(line, npts_end));
    header.npts_line = number;
    if (is_before) {
      const auto rest = static_cast<std::size_t>(first.data() - line.data()) + first.size();
      read_step(line.substr(rest, npts_end - 4 - rest), {"dt"}, number, header);
      return true;
    }
    is_stated = true;
  }
  for (const StepName& step : step_names) {
    const std::size_t end = end_of_name(lower, step.name);
    if (end == std::string::npos) continue;
    const std::size_t line_before = header.dt_line;
    read_step(line.substr(end), step, number, header);
    if (header.dt_line != line_before) return true;
  }
  return is_stated;
}

/// The unit behind "units of", "unit:", "UNIT  =", "units are"; "" where the line names none.
std::string unit_by_name(const std::string& lower) {
  std::size_t end = end_of_name(lower, "unit");
  if (end == std::string::npos) return {};
  if (end < lower.size() && lower[end] == 's') ++end;
  const std::size_t at = std::min(lower.find_first_not_of(" \t", end), lower.size());
  std::string_view rest = std::string_view(lower).substr(at);
  bool is_stated = rest.starts_with(':') || rest.starts_with('=');
  for (const std::string_view verb : {"of ", "are ", "is "}) {
    if (!rest.starts_with(verb)) continue;
    rest.remove_prefix(verb.size());
    is_stated = true;
  }
  std::string unit(is_stated ? word_at(rest, 0) : std::string_view());
  while (unit.ends_with('.')) unit.pop_back();
  return unit;
}

/// Two lines of a file may not state different steps.
void check_one_step(const std::filesystem::path& file, const At2Header& header) {
  if (header.other_dt_text.empty()) return;
  throw InputError({place(file, header.dt_line),
                    fmt::format("states two steps: {} s, and {} s in a line above it",
                                header.dt_text, header.other_dt_text),
                    "correct the line that is wrong", ""});
}

}  // namespace

std::string units_in_header_line(std::string_view line) {
  line = line.substr(0, longest_header_line);
  const std::string lower = lower_case(line);
  if (std::string unit = unit_by_name(lower); !unit.empty()) return unit;
  for (const std::string_view quantity : {"acceleration", "velocity", "displacement"}) {
    const std::size_t at = lower.find(quantity);
    if (at == std::string::npos) continue;
    if (const std::size_t in = lower.find(" in "); in != std::string::npos) {
      std::string unit(word_at(lower, in + 4));
      while (unit.ends_with('.')) unit.pop_back();
      if (!unit.empty()) return unit;
    }
    // A heading of columns: acceleration_g, acceleration (m/s2).
    std::string unit(word_at(lower, at + quantity.size()));
    const UnitKind kind = header_unit(unit).kind;
    if (kind == UnitKind::acceleration || kind == UnitKind::velocity) return unit;
  }
  return {};
}

bool read_header_line(std::string_view line, std::size_t number, At2Header& header) {
  line = line.substr(0, longest_header_line);
  const std::string lower = lower_case(line);
  if (std::string units = units_in_header_line(line); !units.empty()) {
    header.units = units;
    header.units_line = number;
  }
  const bool has_counts = read_npts_and_step(line, lower, number, header);
  return has_counts || !unit_by_name(lower).empty();
}

double at2_step(const std::filesystem::path& file, const At2Header& header,
                const std::optional<double>& wanted) {
  if (!wanted && header.dt_text.empty())
    throw InputError({place(file, header.npts_line), "the header has NPTS but no DT",
                      "give the step with dt_s", ""});
  check_one_step(file, header);
  return agreed_step(place(file, header.dt_line), header.dt_text, header.dt_s, wanted);
}

void check_at2_count(const std::filesystem::path& file, const At2Header& header,
                     std::size_t found) {
  if (header.npts && *header.npts == found) return;
  const std::string stated = header.npts ? std::to_string(*header.npts) : "no whole number";
  const bool is_one_off = header.npts && (*header.npts == found + 1 || *header.npts + 1 == found);
  throw InputError(
      {place(file, header.npts_line),
       "NPTS is " + stated + ", the file contains " + std::to_string(found) + " values",
       is_one_off ? fmt::format("one off: where the file is whole, correct NPTS to {} there", found)
                  : "the file is cut short or its header is wrong: get it again",
       ""});
}

std::optional<At2Header> find_at2_header(std::string_view text) {
  At2Header header;
  LineReader reader(text);
  bool is_nga = false, is_peer = false;
  while (reader.next() && reader.number() <= longest_header) {
    if (reader.number() == 1) {
      is_nga = reader.line().starts_with("PEER NGA");
      is_peer = reader.line().starts_with("PEER ") || reader.line().starts_with("PACIFIC ENG");
    } else if (reader.number() == 2 && is_peer) {
      header.title = trimmed(reader.line().substr(0, longest_header_line));
      if (is_nga && printable_name(header.title) == header.title) header.source = header.title;
    }
    const std::string_view line = reader.line();
    if (header.lines > 0 && line.find_first_of(":=") == std::string_view::npos) break;
    read_header_line(line, reader.number(), header);
    const bool has_npts = header.npts_line == reader.number() && !trimmed(line).starts_with('#');
    if (has_npts || header.lines > 0) header.lines = reader.number();
  }
  return header.lines > 0 ? std::optional(header) : std::nullopt;
}

}  // namespace glissade
