// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/report/package.hpp"
#include "glissade/report/table.hpp"

// The tables of a calculation package. Their cells are text in the project's units.
namespace glissade {

/// The design displacement of ASCE 7-16, 13.6.12.
inline constexpr const char* displacement_symbol = "\u0394_MPV";

Table title_table(const Project& project);
/// Conditions of the exception for unattached arrays: value, limit, clause, verdict.
Table scope_table(const CalculationPackage& package);
/// What the verdict rests on and no analysis finds.
Table premises_table(const Project& project);
Table criteria_table(const CalculationPackage& package);
Table building_table(const CalculationPackage& package);
Table array_table(const CalculationPackage& package);
Table friction_table(const CalculationPackage& package);
/// Of each pull; expects some.
Table pull_tests_table(const ProjectFriction& friction);
/// What the project gives by points: a target spectrum, a hazard curve.
Table spectrum_table(const Project& project);
Table hazard_curve_table(const ProjectHazard& hazard);
/// @param files of the components, with the record sequence numbers in their names
Table motions_table(const std::vector<RecordSummary>& records,
                    const std::vector<ComponentFile>& files, bool of_roof);
Table scaled_motions_table(const CalculationPackage& package);
/// S_a of each scaled record at the building periods, their average and the design spectrum.
Table record_spectra_table(const CalculationPackage& package);
Table files_table(const CalculationPackage& package);
/// From which the mean of the governing case can be added up.
Table record_displacements_table(const CalculationPackage& package);
Table demand_table(const CalculationPackage& package);
/// Of a row of the table, in the sketch too: "A", "B" ... "Z", "A1".
std::string separation_letter(std::size_t row);
Table separations_table(const CalculationPackage& package);
Table open_items_table(const CalculationPackage& package);
Table uncertainty_table(const CalculationPackage& package);
/// Whether records or premises decide the displacement of the analysis.
std::string deciding_sentence(const DesignClearance& design);
Table exceedance_table(const CalculationPackage& package);
/// The governing displacement and what the available separations allow.
Table compared_table(const CalculationPackage& package);
/// Of the roof, computed and by the standards.
Table roof_accelerations_table(const CalculationPackage& package);
/// The separations of the prescribed displacement beside those required.
Table by_hand_table(const CalculationPackage& package);
Table prescribed_table(const CalculationPackage& package);
/// What is to be confirmed against the adopted code.
Table provisions_table(const CalculationPackage& package);
Table checks_table(const CalculationPackage& package);

/// "10 % of the histories at the DBE exceed 8.2 in (95 % interval 3.1 in to 12.0 in)".
std::string accepted_sentence(const DesignClearance& design);
/// Why a separation that is large enough is not called sufficient.
std::vector<std::string> open_items(const DesignClearance& design);
/// The warnings that are no open items.
std::vector<std::string> other_warnings(const DesignClearance& design);
/// "ASCE 7-16, 80 % of its displacement", "nonlinear response history analysis".
std::string governed_by(const CalculationPackage& package);
/// How often the governing displacement is exceeded and what adds up over the design life; or which
/// key of the project would give it.
std::string hazard_sentence(const CalculationPackage& package);
/// On the separations that the project states are available.
std::string verdict_sentence(const CalculationPackage& package);
/// "open"; of what is too short also by how much: "NOT SUFFICIENT: 1.2 in short".
std::string verdict_text(const ProjectSeparation& separation, const CalculationPackage& package);
/// What a reader of percentiles must know.
inline constexpr auto percentile_note =
    "A percentile is below the mean where few records slide far.";
/// "1.19 degrees", "1.19 to 2.39 degrees".
std::string range_text(const std::vector<double>& values, const char* unit);
/// What is varied of the building beside its period: "mass ratio", or "α_0" of modes.
const char* varied_of_building(const Project& project);

}  // namespace glissade
