// SPDX-License-Identifier: GPL-3.0-or-later
// PEER NGA-West2, NGA-East and the older PEER Strong Motion Database: header lines, one of which
// has NPTS and DT, then any number of values a line (peer.berkeley.edu, as downloaded 2000 to
// 2020).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "records/at2_header.hpp"
#include "records/formats/reading.hpp"

namespace glissade {
namespace {

/// As many rows of two numbers as NPTS states: times and accelerations, a table.
bool has_rows_of_two(const RecordText& file, const At2Header& header) {
  LineReader lines(file.text);
  while (lines.number() < header.lines && lines.next()) continue;
  std::size_t rows = 0;
  while (lines.next()) {
    const std::size_t columns = fields(lines.line()).size();
    if (columns != 0 && columns != 2) return false;
    rows += columns / 2;
  }
  return rows > 0 && rows == header.npts;
}

bool is_at2(const RecordText& file) {
  const auto header = find_at2_header(file.text);
  return header && !has_rows_of_two(file, *header);
}

/// "03/27/1980", and what may stand before and behind it.
bool has_date(std::string_view text) {
  const std::size_t first = text.find('/');
  if (first == std::string_view::npos || first == 0 || first + 1 >= text.size()) return false;
  const std::size_t second = text.find('/', first + 1);
  const auto is_digit = [&](std::size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
  };
  return second != std::string_view::npos && is_digit(first - 1) && is_digit(first + 1) &&
         is_digit(second + 1);
}

/// Of the second line of PEER's files: "Duzce, Turkey, 11/12/1999, Bolu, 0", and of the older ones
/// "LAZIO-ABRUZZO EQ, 05/07/84, 17:50, ROCCAMONFINA, NS", "CHI-CHI 09/20/99, HWA002, N (CWB)".
RecordHeader peer_header(const At2Header& stated) {
  RecordHeader header{.event = {}, .station = {}, .unit = stated.units};
  std::vector<std::string> parts;
  for (std::string_view rest = stated.title; !rest.empty();) {
    const std::size_t comma = rest.find(',');
    parts.emplace_back(trimmed(rest.substr(0, comma)));
    rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
  }
  const auto date = std::ranges::find_if(parts, has_date);
  if (parts.end() - date < 3) return header;
  auto station = date + 1;
  if (station->find(':') != std::string::npos && parts.end() - station > 2) ++station;
  const auto joined = [](auto begin, auto end) {
    return fmt::format("{}", fmt::join(begin, end, ", "));
  };
  header.event = joined(parts.begin(), station);
  header.station = joined(station, parts.end() - 1);
  header.direction = plain_direction(first_word(parts.back()));
  header.is_processed = true;
  return header;
}

std::vector<FileComponent> read_at2(const RecordText& file, const RecordFileOptions& options) {
  const At2Header header = *find_at2_header(file.text);
  const bool has_step = options.dt_s || !header.dt_text.empty();
  const double unit_mps2 = stated_unit(file, {header.units, header.units_line}, has_step, options);
  const double dt_s = at2_step(file.path, header, options.dt_s);
  LineReader lines(file.text);
  while (lines.number() < header.lines && lines.next()) continue;
  std::vector<double> samples = read_rest(file, lines, unit_mps2);
  check_at2_count(file.path, header, samples.size());
  FileComponent component = file_component(file, "", dt_s, std::move(samples));
  component.header = peer_header(header);
  component.record.source = header.source;
  return {std::move(component)};
}

}  // namespace

const RecordFormat at2_format{"PEER AT2", is_at2, read_at2};

}  // namespace glissade
