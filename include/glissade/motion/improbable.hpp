// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"

// What is possible and not probable: warnings that stand beside results.
namespace glissade {

/// Largest |acceleration| of a record: beyond it the units are wrong (100,000 g), and it is
/// refused.
inline constexpr double most_acceleration_mps2 = 1e6;

/// No site is known for more: the largest mapped S_S of the United States is near 3 g, the largest
/// recorded peak ground acceleration near 4 g.
inline constexpr double most_probable_g = 4.0;

/// The largest recorded of one horizontal component is that of station MYG004, Tohoku 2011, 2.7 g.
inline constexpr double most_probable_pga_g = 3.0;

/// A record is scaled by no more as a rule: `maxScale` of the program of Baker & Lee (2018).
inline constexpr double most_probable_factor = 5.0;

/// More is an error of units: maps give percent of g, other programs m/s2.
inline constexpr double most_possible_g = 10.0;

/// More than a roof has (recalled).
inline constexpr double largest_probable_clearance_m = 10.0;

/// Where periods of a list are farther apart (by this factor), something between them is missed. A
/// building of 0.06 s or less moves with the ground (ASCE 7-16, 11.2, recalled).
inline constexpr double widest_period_step = 1.3, longest_rigid_period_s = 0.06;

/// No building of two hundred storeys has a longer one.
inline constexpr double longest_probable_period_s = 10.0;

/// Of a motion without its scale: one motion as both horizontals, and what is outside what any
/// recorded motion has shown ("PGA of 12.3 g, above 3 g (largest horizontal: ...)"), most probably
/// for wrong units or a wrong step.
std::vector<std::string> improbable_values(const Motion& motion, bool of_roof = false);

/// What is taken for granted of a motion whose files do not state it.
std::vector<std::string> notes_on(const Motion& motion);

/// S_S above most_probable_g, S_1 above S_S, and sites for which ASCE 7-16, 11.4.8 requires more
/// than mapped values.
std::vector<std::string> improbable_values(const DesignTarget& target);
/// What ASCE 7-16, 11.4.8 requires of a site of mapped values, empty: nothing.
std::string hazard_analysis_required(const DesignTarget& target);
/// Why what the target states of it does not meet that: nothing, or an exception of another site
/// class; empty: it does, or nothing is required.
std::string unmet_hazard_analysis(const DesignTarget& target);
/// "exceptions 1, 3 of 11.4.8", of those that the target states.
std::string exceptions_text(const DesignTarget& target);
/// Exception 2, a rule on C_s, is stated and of the site class.
bool takes_exception_2(const DesignTarget& target);

// One set of checks for studies and projects; "": nothing to say.
/// @param periods_s increasing
std::string gaps_between(const std::vector<double>& periods_s);
/// Of a roof no part of which is steeper.
std::string improbable_slope(double steepest_deg);
std::string improbable_design_life(double years);
/// Numbers without a unit in a file with units = "us": "height_m = 54 (177 ft)".
std::string unmarked_numbers(const std::vector<std::string>& numbers);

/// Of a hazard curve at the MCE, which is exceeded about once in 2,475 years, near active faults
/// more often (ASCE 7-16, 21.2, recalled); "" from 200 to 25,000 years.
/// @param mce "S_MS, 1.58 g,"
std::string improbable_mce_rate(double annual_rate, const std::string& mce);

}  // namespace glissade
