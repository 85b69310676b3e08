// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/html_text.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// What an analysis gives to a report. A part may be missing, and is made only of results that the
/// analysis is in.
struct AnalysisReport {
  bool (*is_in)(const Results&) = nullptr;
  std::string (*summary)(const Results&) = nullptr;                 ///< for the terminal, in ASCII
  std::vector<std::string> (*sentences)(const Results&) = nullptr;  ///< the answers of a page
  std::vector<Figure> (*figures)(const Results&) = nullptr;
  std::vector<Table> (*tables)(const Results&) = nullptr;  ///< files; without rows: none
  Html (*section)(const Results&) = nullptr;               ///< of a page, with a heading
};

/// A part that has what each of some functions gives.
template <auto... functions>
auto each(const Results& results) {
  return std::vector{functions(results)...};
}

/// Of the analyses that the results have, in the order in which they are reported.
std::vector<AnalysisReport> analyses_in(const Results& results);

/// What a part gives for each analysis, one after the other.
template <class T>
std::vector<T> collected(const Results& results,
                         std::vector<T> (*AnalysisReport::*part)(const Results&)) {
  std::vector<T> all;
  for (const AnalysisReport& analysis : analyses_in(results)) {
    if (analysis.*part == nullptr) continue;
    for (T& one : (analysis.*part)(results)) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace glissade
