// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

// Annual rates and slip over the design life. Expects results with a hazard analysis.
namespace glissade {

/// "1 % in 50 years", "1/2475 a year".
std::string rate_text(double annual_rate);
/// "site.csv" of a curve from a file in any folder, "0.001 x^-2.2" of a law.
std::string curve_name(const HazardResults& hazard);
/// What slip over a design life assumes.
inline constexpr auto not_returned = "the array not returned to its initial position";
inline constexpr auto kept_over_life =
    "The record of each earthquake is drawn; friction, slope, building and orientation (which "
    "component acts along the slope, with which signs) are those of one sample for the whole life.";
/// "largest peak of one earthquake".
std::string quantity_name(LifeQuantity quantity);
/// "25 years".
std::string life_text(const HazardResults& hazard);

/// "< " where no history decides the rate: it is an upper bound.
const char* sign_of(const ThresholdRate& row);
/// Per run and threshold, or of one threshold.
Table hazard_table(const Results& results, std::optional<double> threshold_m = {});
/// The points of the hazard curve itself.
Table hazard_ground_table(const Results& results);
/// Per run and displacement: a curve each.
Table hazard_curve_table(const Results& results);
/// Per run and target rate.
Table hazard_targets_table(const Results& results);
/// Per run and standard: no rows where the study compares with none, or S_DS of the site is not
/// known.
Table hazard_standards_table(const Results& results);
/// Per run, quantity and share of the lives.
Table life_distribution_table(const Results& results);
/// Per run: largest peak of one earthquake, accumulated slip, largest distance.
Table design_life_table(const Results& results);
/// The 95th percentiles alone, a row per run: on a page.
Table shown_design_life_table(const Results& results);
std::vector<std::string> hazard_sentences(const Results& results);

/// Annual rate over displacement, of four runs at most.
Figure hazard_figure(const Results& results);
/// Over displacement the share of the design lives that exceed it, of the run with the most slip:
/// largest earthquake, accumulated, largest distance.
Figure life_figure(const Results& results);

}  // namespace glissade
