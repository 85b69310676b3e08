// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "case.hpp"
#include "glissade/fragility/fit.hpp"

namespace glissade::verification {

struct CoverageRow {
  std::string group;  ///< the row of the table in the page
  std::size_t records;
  std::string data;  ///< beside the number of records; may be empty
  std::string quantity;
  double share;  ///< of intervals that cover
  double low = 0.93, high = 0.97;
  std::string reference = "nominal 95 %";
};

class CoverageCases {
 public:
  void add(const CoverageRow& row);
  /// Lowest and highest share, in %, by group and number of records.
  std::string table() const;
  const std::vector<Case>& cases() const { return cases_; }

 private:
  std::vector<Case> cases_;
  std::vector<std::pair<std::string, std::map<std::size_t, Interval>>> groups_;
};

/// Rows of chapter 5.2: how often the intervals of `glissade fit` cover, by the form of the data.
void add_coverage_of_fits(CoverageCases& cases);
/// The same of percentiles and means of displacement, and of annual rates.
void add_coverage_of_means(CoverageCases& cases);

}  // namespace glissade::verification
