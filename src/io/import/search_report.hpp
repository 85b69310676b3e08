// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "glissade/io/text_files.hpp"

namespace glissade {

/// What a report states of one record; what it does not is empty or 0.
struct ReportRow {
  std::string rsn;             ///< of PEER
  std::string event_id;        ///< of ESM
  std::string event, station;  ///< of ESM: "IT.AMT"
  double magnitude = 0.0;
  std::string magnitude_kind;
  double distance_km = 0.0;
  std::string distance_kind;  ///< "rupture", "joyner_boore", "epicentral"
  double vs30_mps = 0.0;
  double scale = 0.0;
  std::array<std::string, 3> files;  ///< first and second horizontal, vertical: names only
};

/// The report of a search in PEER's NGA-West2 data base (_SearchResults.csv: a table of what was
/// searched, one of the records below it, then spectra), or the flatfile of ESM.
struct SearchReport {
  std::filesystem::path path;
  std::vector<ReportRow> rows;
  std::vector<std::string> searched_rsns;  ///< of PEER, as the search named them
  std::vector<std::string> warnings;
};

bool is_search_report(std::string_view text);

/// Throws InputError where the file is neither.
SearchReport read_search_report(const TextFile& file);

}  // namespace glissade
