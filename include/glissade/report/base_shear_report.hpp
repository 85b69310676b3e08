// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

// The report of the building's base shear. All expect results with base shear.
namespace glissade {

/// A row for each condition: the suite's mean over the orientations, and the largest history.
Table base_shear_table(const Results& results);
/// The means over those without an array. Without rows where the study has no such condition.
Table base_shear_ratio_table(const Results& results);
/// Over the building's period by support; and relative to the building without an array.
std::vector<Figure> base_shear_figures(const Results& results);
/// What came out, and what the array does to it where the study lists other supports.
std::vector<std::string> base_shear_sentences(const Results& results);

}  // namespace glissade
