// SPDX-License-Identifier: GPL-3.0-or-later
// PEER NGA-West2: "Time Series Search Report" (ngawest2.berkeley.edu, as downloaded 2019). ESM:
// flat file with columns between semicolons (Lanzano et al. 2019, Bull. Earthquake Eng. 17).
#include "import/search_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/io/record_header.hpp"
#include "import/component_name.hpp"
#include "text/csv_rows.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

/// As it was before a spreadsheet took a cell with quotes, `" ""Place"""`, for a text with them.
std::string without_quotes(std::string_view cell) {
  std::string text;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    text += cell[i];
    if (cell.substr(i).starts_with("\"\"")) ++i;
  }
  std::string_view inside = trimmed(text);
  while (inside.size() > 1 && inside.front() == '"' && inside.back() == '"')
    inside = trimmed(inside.substr(1, inside.size() - 2));
  return std::string(inside);
}

/// A heading and where its columns are.
class ReportColumns {
 public:
  explicit ReportColumns(const Cells& names) {
    for (const std::string_view name : names) names_.push_back(lower_case(name));
  }
  bool have(std::string_view name) const {
    return std::ranges::find(names_, lower_case(name)) != names_.end();
  }
  /// "": the table has no such column, or nothing in it.
  std::string text(const Cells& row, std::string_view name) const {
    const auto at =
        static_cast<std::size_t>(std::ranges::find(names_, lower_case(name)) - names_.begin());
    return at < row.size() ? without_quotes(row[at]) : "";
  }
  /// 0 where it is no number above 0 and up to `most`: reports write "-", "-999" or nothing. A
  /// spreadsheet may write 6,5 between semicolons or tabs.
  double number(const Cells& row, std::string_view name, double most) const {
    std::string written = text(row, name);
    std::ranges::replace(written, ',', '.');
    const auto value = parse_number(written);
    return value && *value > 0.0 && *value <= most ? *value : 0.0;
  }
  std::size_t size() const { return names_.size(); }

 private:
  std::vector<std::string> names_;
};

constexpr double largest_scale = 1000.0;

/// A column, and of which kind its numbers are.
struct KindColumn {
  const char *name, *kind;
};
using KindColumns = std::initializer_list<KindColumn>;

/// Of the first column with a number.
void take_magnitude(ReportRow& row, const ReportColumns& columns, const Cells& cells,
                    KindColumns of) {
  for (auto at = of.begin(); at != of.end() && row.magnitude == 0.0; ++at) {
    row.magnitude = columns.number(cells, at->name, largest_magnitude);
    if (row.magnitude > 0.0) row.magnitude_kind = at->kind;
  }
}
void take_distance(ReportRow& row, const ReportColumns& columns, const Cells& cells,
                   KindColumns of) {
  for (auto at = of.begin(); at != of.end() && row.distance_km == 0.0; ++at) {
    row.distance_km = columns.number(cells, at->name, longest_distance_km);
    if (row.distance_km > 0.0) row.distance_kind = at->kind;
  }
}

bool is_peer_heading(const ReportColumns& columns) {
  return columns.have("Record Sequence Number") && columns.have("Horizontal-1 Acc. Filename");
}
bool is_esm_heading(const ReportColumns& columns) {
  return columns.have("event_id") && columns.have("station_code") && columns.have("network_code");
}

/// "Friuli, Italy-01" of "Friuli_ Italy-01": the site writes no commas.
std::string with_commas(std::string name) {
  for (std::size_t at; (at = name.find("_ ")) != std::string::npos;) name[at] = ',';
  return name;
}

/// "" of "-----".
std::string peer_file(const std::string& name) {
  return name.find_first_not_of("- ") == std::string::npos ? "" : name;
}

ReportRow peer_row(const ReportColumns& columns, const Cells& cells) {
  ReportRow row;
  row.rsn = plain_line(columns.text(cells, "Record Sequence Number"));
  row.event = plain_line(with_commas(columns.text(cells, "Earthquake Name")) + " " +
                         columns.text(cells, "Year"));
  row.station = plain_line(with_commas(columns.text(cells, "Station Name")));
  take_magnitude(row, columns, cells, {{"Magnitude", "Mw"}});
  take_distance(row, columns, cells, {{"Rrup (km)", "rupture"}, {"Rjb (km)", "joyner_boore"}});
  row.vs30_mps = columns.number(cells, "Vs30 (m/sec)", fastest_vs30_mps);
  row.scale = columns.number(cells, "Scale Factor", largest_scale);
  row.files = {peer_file(columns.text(cells, "Horizontal-1 Acc. Filename")),
               peer_file(columns.text(cells, "Horizontal-2 Acc. Filename")),
               peer_file(columns.text(cells, "Vertical Acc. Filename"))};
  return row;
}

ReportRow esm_row(const ReportColumns& columns, const Cells& cells) {
  ReportRow row;
  row.event_id = columns.text(cells, "event_id");
  row.station = columns.text(cells, "network_code") + "." + columns.text(cells, "station_code");
  take_magnitude(row, columns, cells, {{"Mw", "Mw"}, {"EMEC_Mw", "Mw"}, {"ML", "ML"}});
  take_distance(row, columns, cells,
                {{"rup_dist", "rupture"}, {"JB_dist", "joyner_boore"}, {"epi_dist", "epicentral"}});
  row.vs30_mps = columns.number(cells, "vs30_m_sec", fastest_vs30_mps);
  return row;
}

/// Where a table of records ends: footers of a spreadsheet have as many cells.
bool is_row(const ReportColumns& columns, const Cells& cells, bool is_peer) {
  return cells.size() >= columns.size() &&
         (is_peer ? parse_number(columns.text(cells, "Record Sequence Number")).has_value()
                  : !columns.text(cells, "event_id").empty());
}

/// What most often separates the cells of a heading.
char separator_of(std::string_view heading) {
  return std::ranges::max(std::string_view(",;\t"), {},
                          [&](char c) { return std::ranges::count(heading, c); });
}

void warn_of_scaling(std::string_view text, SearchReport& report) {
  const bool is_scaled = std::ranges::any_of(
      report.rows, [](const ReportRow& row) { return row.scale > 0.0 && row.scale != 1.0; });
  if (is_scaled && text.find("UNSCALED") == std::string_view::npos)
    report.warnings.emplace_back(
        "has scale factors, and does not state that the files are unscaled: are the factors in "
        "them already? They are written into the suite");
}

}  // namespace

bool is_search_report(std::string_view text) {
  constexpr std::size_t most_lines = 200;
  LineReader lines(text);
  while (lines.number() < most_lines && lines.next()) {
    const std::string_view line = lines.line();
    if (line.starts_with("event_id") ||
        (line.find("Record Sequence Number") != std::string_view::npos &&
         line.find("Horizontal-1 Acc. Filename") != std::string_view::npos))
      return true;
  }
  return false;
}

SearchReport read_search_report(const TextFile& file) {
  refuse_no_text(file.path, file.text);
  SearchReport report{file.path, {}, {}, {}};
  LineReader lines(file.text);
  bool is_known = false;
  while (lines.next()) {
    if (lines.line().find("Record Sequence Number") == std::string_view::npos &&
        lines.line().find("event_id") == std::string_view::npos)
      continue;
    const char separator = separator_of(lines.line());
    const Cells heading = quoted_cells(lines.line(), separator);
    if (trimmed(heading.front()) == "Record Sequence Number:")  // of what was searched
      for (const std::string_view cell : heading)
        if (parse_number(cell)) report.searched_rsns.push_back(plain_line(cell));
    const ReportColumns columns(heading);
    const bool is_peer = is_peer_heading(columns);
    if (!is_peer && !is_esm_heading(columns)) continue;
    is_known = true;
    // The table goes on to the first line that is none of its rows.
    for (LineReader ahead = lines; ahead.next(); lines = ahead) {
      const auto cells = quoted_cells(ahead.line(), separator);
      if (!is_row(columns, cells, is_peer)) break;
      report.rows.push_back(is_peer ? peer_row(columns, cells) : esm_row(columns, cells));
    }
  }
  if (!is_known || report.rows.empty())
    throw InputError({file.path.string(),
                      is_known ? "its table of records has no rows"
                               : "has no table of records with the columns of a report",
                      "give the _SearchResults.csv of PEER's NGA-West2 data base (Record Sequence "
                      "Number, Horizontal-1 Acc. Filename), or the flatfile of ESM (event_id, "
                      "network_code, station_code)",
                      ""});
  warn_of_scaling(file.text, report);
  return report;
}

}  // namespace glissade
