// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/fragility/cloud.hpp"
#include "glissade/fragility/fit.hpp"

// The CSV files of `glissade fit`: a header that names the columns, in any order, then a row each.
// All may have the columns `record` (any text; rows of one record are not independent), `event`
// (any text; records of one event are not independent) and `weight` (0 or more). Lines that begin
// with # are comments. InputError names the wrong lines.
namespace glissade {

/// Which columns a file has beside those it needs.
struct FitColumns {
  bool record = false, event = false, weight = false;
  /// What is independent is named: `record` of a row is the event where there is one.
  bool unit() const { return record || event; }
};

/// "a and b": the first two records with the same rows, which have digits enough for no coincidence
/// (counts: six levels that some of ten or more exceed); "" of none. One may be the other under
/// another name.
using SameRecords = std::string;

/// Columns im, num_gms, num_exceed: im > 0, num_gms a whole number above 0, num_exceed a whole
/// number up to it. Each im once (of each record).
struct CountsInput {
  FitColumns has;
  SameRecords same;
  std::vector<Stripe> rows;
};
CountsInput read_counts(const std::filesystem::path& file);

/// Column im_cap >= 0 (0: exceeded without shaking, as by an array that slides freely; inf: not
/// reached, whose highest level the caller must know); or im_low
/// and im_high: reached above im_low (0: by the first level) and not above im_high (inf or nothing:
/// not reached by im_low).
struct CapacitiesInput {
  FitColumns has;
  SameRecords same;
  bool brackets = false;
  std::vector<Bracket> rows;  ///< low = high of im_cap
};
CapacitiesInput read_capacities(const std::filesystem::path& file);

/// Columns im > 0 and edp >= 0; inf: collapse, beyond every displacement.
struct CloudInput {
  FitColumns has;
  SameRecords same;
  std::vector<CloudPoint> rows;
};
CloudInput read_cloud(const std::filesystem::path& file);

}  // namespace glissade
