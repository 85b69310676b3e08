// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/at2_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "glissade/core/printable.hpp"
#include "records/record_units.hpp"
#include "records/time_column.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

constexpr std::size_t longest_header = 100;        // lines
constexpr std::size_t longest_header_line = 1000;  // characters

/// The first word at or after `begin`, without the `=` before it and the punctuation around it.
std::string_view word_at(std::string_view line, std::size_t begin) {
  constexpr std::string_view separators = " \t=,;:()[]_";
  begin = line.find_first_not_of(separators, begin);
  if (begin == std::string_view::npos) return {};
  const std::size_t end = line.find_first_of(separators, begin);
  return line.substr(begin, end == std::string_view::npos ? end : end - begin);
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Where the word DT stands (not as a part of another word).
std::size_t find_dt(const std::string& lower) {
  for (std::size_t at = lower.find("dt"); at != std::string::npos; at = lower.find("dt", at + 1)) {
    const auto is_letter = [&](std::size_t i) {
      return i < lower.size() && lower[i] >= 'a' && lower[i] <= 'z';
    };
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + 2)) return at;
  }
  return std::string::npos;
}

/// The step that `word`, a part of the line, states: in seconds, or in ms where that follows it.
std::optional<double> step_in(std::string_view line, std::string_view word) {
  std::optional<double> step = parse_number(word);
  const auto end = static_cast<std::size_t>(word.data() - line.data()) + word.size();
  const std::string unit = lower_case(word_at(line, end));
  if (step && (unit == "ms" || unit == "msec" || unit == "milliseconds")) *step *= 1e-3;
  return step;
}

void read_counts(std::string_view line, const std::string& lower, std::size_t npts_at,
                 At2Header& header) {
  const std::string_view first = word_at(line, 0);
  std::string_view npts, dt;
  if (npts_at > 0 && parse_number(first)) {  // 7997 0.0050 NPTS, DT
    npts = first;
    const auto rest = static_cast<std::size_t>(first.data() - line.data()) + first.size();
    dt = word_at(line.substr(0, npts_at), rest);
  } else {
    npts = word_at(line, npts_at + 4);
    const std::size_t dt_at = find_dt(lower);
    if (dt_at != std::string::npos) dt = word_at(line, dt_at + 2);
  }
  header.npts = parse_count(npts);
  if (dt.empty()) return;  // a line above may have stated it
  header.dt_text = dt;
  header.dt_s = step_in(line, dt);
}

}  // namespace

std::string units_in_header_line(std::string_view line) {
  const std::string lower = lower_case(line.substr(0, longest_header_line));
  const auto after = [&](std::string_view phrase) -> std::string {
    const std::size_t at = lower.find(phrase);
    if (at == std::string::npos) return {};
    std::string unit(word_at(lower, at + phrase.size()));
    while (unit.ends_with('.')) unit.pop_back();
    return unit;
  };
  for (const std::string_view phrase :
       {"units of ", "units are ", "units: ", "units = ", "units="}) {
    if (std::string unit = after(phrase); !unit.empty()) return unit;
  }
  for (const std::string_view quantity : {"acceleration", "velocity", "displacement"}) {
    const std::size_t at = lower.find(quantity);
    if (at == std::string::npos) continue;
    if (std::string unit = after(" in "); !unit.empty()) return unit;
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
  const std::size_t npts_at = lower.find("npts");
  if (npts_at == std::string::npos) {
    const std::size_t dt_at = trimmed(line).starts_with('#') ? find_dt(lower) : std::string::npos;
    const std::string_view word =
        dt_at == std::string::npos ? std::string_view() : word_at(line, dt_at + 2);
    if (const std::optional<double> dt_s = word.empty() ? std::nullopt : step_in(line, word)) {
      header.dt_text = word;
      header.dt_s = dt_s;
      header.lines = number;
    }
    return false;
  }
  header.lines = number;
  read_counts(line, lower, npts_at, header);
  return true;
}

double at2_step(const std::filesystem::path& file, const At2Header& header,
                const std::optional<double>& wanted) {
  const std::string where = place(file, header.lines);
  if (!wanted && header.dt_text.empty())
    throw InputError({where, "the header has NPTS but no DT", "give the step with dt_s", ""});
  return agreed_step(where, header.dt_text, header.dt_s, wanted);
}

void check_at2_count(const std::filesystem::path& file, const At2Header& header,
                     std::size_t found) {
  if (header.npts && *header.npts == found) return;
  const std::string stated = header.npts ? std::to_string(*header.npts) : "no whole number";
  const bool is_one_off = header.npts && (*header.npts == found + 1 || *header.npts + 1 == found);
  throw InputError(
      {place(file, header.lines),
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
    const bool has_count = read_header_line(reader.line(), reader.number(), header);
    if (has_count && !trimmed(reader.line()).starts_with('#')) return header;
  }
  return std::nullopt;
}

}  // namespace glissade
