// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cases.hpp"

namespace glissade::convergence {

/// The cases of some motions, all at paper_substeps.
struct Group {
  std::string name;     ///< in the table
  std::string motions;  ///< "22 built-in motions", in the figure
  std::vector<Case> cases;
};

/// A row for each group and P: errors, the records' share in them, processor times. CSV with a unit
/// in every column's name; NaN is an empty field.
std::string table_csv(const std::vector<Group>& groups);

/// After Fig. 5 of the paper: errors over P, a panel for each group; below them the longest times
/// over all groups. Throws std::runtime_error where gnuplot fails.
void draw(std::span<const Group> groups, const std::filesystem::path& svg);

}  // namespace glissade::convergence
