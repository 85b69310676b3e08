// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/results.hpp"

// What tables, figures and sentences of required clearance and base shear share. Where an axis is
// not the one shown, its value is that of shown_condition().
namespace glissade {

using Places = std::vector<Condition>;

/// "DBE", "MCE"; "" of other levels.
std::string level_name(const Results& results, double level);
/// "T 0.2 s", "m/M 0.05", "R 2", "slope 1/4:12", "DBE", "no vertical motion", "anchored array"
std::string label_of(const ConditionGrid& grid, ConditionAxis axis, std::size_t place);
std::string label_of(const ConditionGrid& grid, ConditionAxis axis, const Condition& at);
/// "1/4:12", and "1/4:12 (1.19 deg)"; "1.3 deg" of both where the rise is not of quarters.
std::string slope_name(double slope_deg);
std::string slope_text(double slope_deg);
/// The labels of all axes that have more than one value but those of `without`.
std::string distinguished(const ConditionGrid& grid, const Condition& at,
                          const std::vector<ConditionAxis>& without = {});
/// "level2; DBE; slope 1/4:12 (1.19 deg), friction 0.47; m/M 0.05; elastic building", without some
/// axes.
std::string conditions_text(const Results& results, const Condition& at,
                            const std::vector<ConditionAxis>& without = {});
/// "0.47", "E-W 0.47, N-S 0.52"
std::string friction_text(const Results& results, const Condition& at = {});

/// Along the array's two axes.
bool has_two_frictions(const Results& results);

/// "0.280 m (11.0 in)"; where the array slides freely, that no clearance is enough.
std::string clearance_text(double clearance_m);

/// The level of the design earthquake (2/3 of MCE) where it is listed, else the highest; the first
/// value on every other axis.
Condition shown_condition(const ConditionGrid& grid);
/// Every place on one axis, the others as shown.
Places shown_along(const ConditionGrid& grid, ConditionAxis axis);
/// "slope E-W, along it + first, across - second"; on one axis without what acts across.
std::string orientation_text(const Results& results, const Orientation& orientation);

/// The same with the strength that displacements of yielding buildings are divided by: R = 1 where
/// it is listed (Walters et al. 2012, Fig. 15), else the first.
Condition with_reference_strength(const ConditionGrid& grid, Condition at);
/// "the building of R = 1", "the elastic building"
std::string reference_strength_text(const ConditionGrid& grid);

/// Where a kind of support stands on its axis, if it is there.
std::optional<std::size_t> place_of(const ConditionGrid& grid, ArraySupport support);
/// "sixteen orientations", "both orientations", "32 orientations"; of one: "".
std::string orientations_text(const Results& results);
/// "0.210 m (8.27 in), from 0.180 m (7.09 in) to 0.260 m (10.2 in) over the sixteen orientations"
/// ", largest of the orientations": what a required clearance is of. Empty where there is one.
std::string rule_text(const Results& results);
std::string range_text(const Results& results, const OrientationRange& range);
/// ", the largest over the building periods"; of a roof's motions "".
const char* over_building_periods(const Results& results);

/// mean(at) / mean(of) by orientation; both must be above zero to count. Sorted; may be empty.
std::vector<double> ratios_by_orientation(const Results& results, const MeanQuestion& question,
                                          const Condition& at, const Condition& of);

}  // namespace glissade
