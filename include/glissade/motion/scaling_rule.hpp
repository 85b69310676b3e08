// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/motion/suite_scaling.hpp"

namespace glissade {

/// How a suite is scaled to a target: each rule is whole, with its own spectrum, periods and
/// fraction of the target. Provisions of ASCE 7 are recalled: verify them against the standard.
enum class ScalingRule { walters_2012, asce7_10, asce7_16, asce7_22, single_period };

/// ASCE 7-16 and 7-22, 16.2: RotD100, 0.9 of the target, eleven motions.
inline bool is_of_16_2(ScalingRule rule) {
  return rule == ScalingRule::asce7_16 || rule == ScalingRule::asce7_22;
}

/// Periods of the building: of the first modes along its two axes.
struct FirstPeriods {
  double shortest_s = 0.0, longest_s = 0.0;
  /// A dynamic analysis under MCE_R shows that 1.5 times the longest suffices (ASCE 7-16 and 7-22,
  /// 16.2.3.1).
  bool to_one_and_a_half = false;
};

/// What a report prints of a rule; `combination`: of the horizontals, "SRSS".
struct ScalingRuleText {
  const char *key, *name, *clause, *spectrum, *combination;
};
const ScalingRuleText& text_of(ScalingRule rule);
/// "walters_2012", "asce7_10" ...; InputError otherwise.
ScalingRule parse_scaling_rule(const std::string& key);

/// The periods over which the suite is compared with the target, s. Throws InputError where the
/// rule needs the building's and they are not above 0 or not in order.
struct PeriodRange {
  double from_s = 0.0, to_s = 0.0;
};
PeriodRange period_range(ScalingRule rule, const FirstPeriods& building);
/// At which it is compared: those of Walters, else 0.5 % apart.
std::vector<double> periods_by_rule_s(ScalingRule rule, const FirstPeriods& building);

/// The spectrum of one motion that the rule averages, unscaled, in g: SRSS of the horizontals, or
/// RotD100.
std::vector<double> spectrum_by_rule_g(const Motion& motion, ScalingRule rule,
                                       const std::vector<double>& periods_s);

/// Spectra by a rule, of each motion, at its periods.
struct SpectraByRule {
  std::vector<double> periods_s;
  SpectrumRows rows_g;
};

/// The average spectrum of a suite over its target, at the periods of a rule.
struct RuleRatios {
  SpectralRatio lowest, highest;
  double mean = 0.0;  ///< over the logarithms of the periods
};
RuleRatios ratios_by_rule(const SpectraByRule& spectra, const std::vector<double>& factors,
                          const std::function<double(double)>& target_sa_g);

/// The factor by which the ratios must be multiplied to meet the rule (not
/// single_period): the lowest to 1, of 16.2 to 0.9, and there the mean to 1. At
/// most 1: it is met.
double missing_factor(ScalingRule rule, const RuleRatios& ratios);

/// The least number of motions by ASCE 7-16 and 7-22, 16.2.2.
inline constexpr std::size_t motions_by_16_2 = 11;
/// What the rule requires of the number of motions and is not met; empty: nothing.
std::string unmet_by(std::size_t motions, ScalingRule rule);
/// "6 motions: ", and that; empty likewise.
std::vector<std::string> too_few_for(ScalingRule rule, std::size_t motions);

/// A suite scaled by a rule.
struct RuleScaling {
  std::vector<double> factors;  ///< per motion, on all its components
  double largest_factor = 0.0;
  PeriodRange range;
  SpectralRatio lowest;     ///< of the average spectrum to the target, over the range
  double mean_ratio = 0.0;  ///< the same, mean over the logarithms of the periods of the range
  std::vector<std::string> warnings;  ///< too few motions for the rule
};

/// Factors for which the average spectrum meets the rule: each motion is first scaled closest to
/// the target, then one common factor lifts the average.
/// - walters_2012: scale_suite_to_target() over walters_periods_s().
/// - asce7_10: the average SRSS spectrum nowhere below the target from 0.2 T to 1.5 T (16.1.3.2).
/// - asce7_16, asce7_22: the average RotD100 nowhere below 0.9 of the target, and on average over
///   the periods not below it ("generally matches or exceeds"), from 0.2 T_min to 2 T_max (16.2.3).
/// - single_period: every motion's RotD50 at T_max is the target.
/// Motions at max_factor stay there. Throws InputError where the target is not reached, or the
/// suite has no motions or one that is zero throughout.
RuleScaling scale_by_rule(const Suite& suite, ScalingRule rule, const FirstPeriods& building,
                          const std::function<double(double)>& target_sa_g, double max_factor);

}  // namespace glissade
