// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/scaling_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/motion/rotated_spectrum.hpp"
#include "spectral_scaling.hpp"

namespace glissade {
namespace {

constexpr double least_of_16_2 = 0.9,
                 mean_of_16_2 = 1.0;  // of the average over the target

constexpr std::array<ScalingRuleText, 5> texts{
    {{"walters_2012", "Walters et al. (2012)", "Walters et al. (2012)",
      "average SRSS spectrum nowhere below the target from 0 to 2 s", "SRSS"},
     {"asce7_10", "ASCE 7-10", "ASCE 7-10, 16.1.3.2",
      "average SRSS spectrum nowhere below the target from 0.2 T to 1.5 T", "SRSS"},
     {"asce7_16", "ASCE 7-16", "ASCE 7-16, 16.2.3.1 and 16.2.3.2",
      "average maximum-direction spectrum (RotD100) nowhere below 0.9 times the target and on "
      "average not below it",
      "RotD100"},
     {"asce7_22", "ASCE 7-22", "ASCE 7-22, 16.2.3.1 and 16.2.3.2",
      "average maximum-direction spectrum (RotD100) nowhere below 0.9 times the target and on "
      "average not below it",
      "RotD100"},
     {"single_period", "single period", "no clause of ASCE 7",
      "RotD50 of every motion equal to the target at one period", "RotD50"}}};

void check_building(ScalingRule rule, const FirstPeriods& building) {
  const auto is_period = [](double t_s) { return std::isfinite(t_s) && t_s > 0.0; };
  if (is_period(building.shortest_s) && is_period(building.longest_s) &&
      building.shortest_s <= building.longest_s)
    return;
  throw InputError({text_of(rule).key,
                    fmt::format("needs the building's first periods along both axes, above 0, the "
                                "shorter first: they are {:g} and {:g} s",
                                building.shortest_s, building.longest_s),
                    "give one period, or both", ""});
}

/// Neighbours 0.5 % apart.
std::vector<double> periods_over(const PeriodRange& range) {
  constexpr double growth = 1.005;
  const double steps = std::ceil(std::log(range.to_s / range.from_s) / std::log(growth));
  std::vector<double> periods_s;
  for (double i = 0.0; i <= steps; ++i)
    periods_s.push_back(range.from_s * std::pow(range.to_s / range.from_s, i / steps));
  return periods_s;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void refuse_unreached(const Suite& suite, double ratio, const char* what, double max_factor) {
  throw InputError({suite.name,
                    fmt::format("with every motion at max_factor = {:g} the average is {:.3g} of "
                                "the target {}",
                                max_factor, ratio, what),
                    "allow a larger factor, or choose stronger motions", ""});
}

SpectraByRule spectra_by_rule(const Suite& suite, ScalingRule rule, std::vector<double> periods_s) {
  SpectraByRule s{std::move(periods_s), {}};
  for (const Motion& motion : suite.motions) {
    s.rows_g.push_back(spectrum_by_rule_g(motion, rule, s.periods_s));
    if (!(std::ranges::min(s.rows_g.back()) > 0.0))
      throw InputError({motion.id,
                        "the motion's horizontals are zero throughout: no factor brings them to a "
                        "target",
                        "leave it out of the suite", ""});
  }
  return s;
}

Spectra views_of(const SpectraByRule& s) { return {s.rows_g.begin(), s.rows_g.end()}; }

void take_ratios(RuleScaling& scaling, const SpectraByRule& s,
                 const std::function<double(double)>& target_sa_g) {
  const RuleRatios ratios = ratios_by_rule(s, scaling.factors, target_sa_g);
  scaling.lowest = ratios.lowest;
  scaling.mean_ratio = ratios.mean;
  scaling.largest_factor = std::ranges::max(scaling.factors);
}

/// The least common factor for which the average is nowhere below `least` times
/// the target, nor on average below `mean` times it.
std::vector<double> lifted_factors(const Suite& suite, const SpectraByRule& s,
                                   const std::vector<double>& target_g, double least, double mean,
                                   double max_factor) {
  const Spectra spectra = views_of(s);
  const std::vector<double> at_most =
      average_ratios(std::vector<double>(spectra.size(), max_factor), spectra, target_g);
  const auto weakest = std::ranges::min_element(at_most);
  if (*weakest < least)
    refuse_unreached(
        suite, *weakest,
        fmt::format("at {:.3g} s", s.periods_s[static_cast<std::size_t>(weakest - at_most.begin())])
            .c_str(),
        max_factor);
  if (mean_of(at_most) < mean)
    refuse_unreached(suite, mean_of(at_most), "on average over the periods", max_factor);
  std::vector<double> closest(spectra.size());
  std::ranges::transform(spectra, closest.begin(), [&](std::span<const double> spectrum) {
    return closest_factor(spectrum, target_g);
  });
  const auto lifted = [&](double fraction) {
    std::vector<double> wanted_g = target_g;
    for (double& sa : wanted_g) sa *= fraction;
    return lift_to_target(closest, spectra, wanted_g, max_factor).factors;
  };
  // Where no motion is at max_factor the mean grows with the fraction, else by less.
  double fraction = least;
  std::vector<double> factors = lifted(fraction);
  constexpr int most_rounds = 200;
  constexpr double rounding = 1e-12;
  for (int round = 0; round < most_rounds; ++round) {
    const double reached = mean_of(average_ratios(factors, spectra, target_g));
    if (reached >= mean * (1.0 - rounding)) break;
    fraction = std::min(fraction * mean / reached, *weakest);
    factors = lifted(fraction);
  }
  return factors;
}

RuleScaling scale_at_one_period(const Suite& suite, const FirstPeriods& building,
                                const std::function<double(double)>& target_sa_g,
                                double max_factor) {
  const SpectraByRule s = spectra_by_rule(suite, ScalingRule::single_period, {building.longest_s});
  RuleScaling scaling;
  for (std::size_t i = 0; i < s.rows_g.size(); ++i) {
    scaling.factors.push_back(target_sa_g(building.longest_s) / s.rows_g[i][0]);
    if (scaling.factors.back() > max_factor)
      throw InputError({suite.motions[i].id,
                        fmt::format("needs the factor {:.4g}, above max_factor = {:g}",
                                    scaling.factors.back(), max_factor),
                        "allow it, or choose a stronger motion", ""});
  }
  take_ratios(scaling, s, target_sa_g);
  return scaling;
}

}  // namespace

const ScalingRuleText& text_of(ScalingRule rule) {
  return texts.at(static_cast<std::size_t>(rule));
}

ScalingRule parse_scaling_rule(const std::string& key) {
  std::string known;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (key == texts[i].key) return static_cast<ScalingRule>(i);
    known += (i == 0 ? "" : ", ") + std::string(texts[i].key);
  }
  throw InputError({"", "\"" + key + "\" is no rule of scaling", "give one of: " + known, ""});
}

PeriodRange period_range(ScalingRule rule, const FirstPeriods& building) {
  if (rule == ScalingRule::walters_2012) return {0.0, longest_scaled_period_s};
  check_building(rule, building);
  if (rule == ScalingRule::single_period) return {building.longest_s, building.longest_s};
  const double upper = rule == ScalingRule::asce7_10 || building.to_one_and_a_half ? 1.5 : 2.0;
  return {0.2 * building.shortest_s, upper * building.longest_s};
}

std::vector<double> periods_by_rule_s(ScalingRule rule, const FirstPeriods& building) {
  return rule == ScalingRule::walters_2012 ? walters_periods_s()
                                           : periods_over(period_range(rule, building));
}

std::string unmet_by(std::size_t motions, ScalingRule rule) {
  if (is_of_16_2(rule) && motions < motions_by_16_2)
    return fmt::format("{}, 16.2.2 requires {} at least", text_of(rule).name, motions_by_16_2);
  if (rule != ScalingRule::asce7_10 || motions >= 7) return "";
  return motions < 3 ? "ASCE 7-10, 16.1.3 requires 3 at least"
                     : "with fewer than 7, ASCE 7-10, 16.1.4 takes the largest "
                       "response, not the average";
}

std::vector<std::string> too_few_for(ScalingRule rule, std::size_t motions) {
  const std::string unmet = unmet_by(motions, rule);
  if (unmet.empty()) return {};
  return {counted(motions, "motion") + ": " + unmet};
}

RuleRatios ratios_by_rule(const SpectraByRule& spectra, const std::vector<double>& factors,
                          const std::function<double(double)>& target_sa_g) {
  const std::vector<double>& t = spectra.periods_s;
  const std::vector<double> ratios =
      average_ratios(factors, views_of(spectra), target_at(target_sa_g, t));
  const auto [low, high] = std::ranges::minmax_element(ratios);
  const auto at = [&](auto ratio) {
    return SpectralRatio{*ratio, t[static_cast<std::size_t>(ratio - ratios.begin())]};
  };
  return {at(low), at(high), mean_of(ratios)};
}

double missing_factor(ScalingRule rule, const RuleRatios& ratios) {
  return is_of_16_2(rule)
             ? std::max(least_of_16_2 / ratios.lowest.ratio, mean_of_16_2 / ratios.mean)
             : 1.0 / ratios.lowest.ratio;
}

std::vector<double> spectrum_by_rule_g(const Motion& motion, ScalingRule rule,
                                       const std::vector<double>& periods_s) {
  if (rule == ScalingRule::walters_2012 || rule == ScalingRule::asce7_10)
    return srss_spectrum_g(motion, periods_s);
  RotatedSpectrum rotated = rotated_spectrum(motion, periods_s);
  std::vector<double>& sa = is_of_16_2(rule) ? rotated.rotd100_mps2 : rotated.rotd50_mps2;
  for (double& value : sa) value /= standard_gravity_mps2;
  return std::move(sa);
}

RuleScaling scale_by_rule(const Suite& suite, ScalingRule rule, const FirstPeriods& building,
                          const std::function<double(double)>& target_sa_g, double max_factor) {
  const PeriodRange range = period_range(rule, building);
  RuleScaling scaling;
  if (rule == ScalingRule::walters_2012) {
    const SuiteScaling found =
        scale_suite_to_target(suite, target_sa_g, walters_periods_s(), max_factor);
    scaling.factors = found.factors;
    take_ratios(scaling, spectra_by_rule(suite, rule, walters_periods_s()), target_sa_g);
  } else {
    if (suite.motions.empty())
      throw InputError({suite.name, "the suite has no motions", "give at least one", ""});
    if (!(std::isfinite(max_factor) && max_factor > 0.0))
      throw InputError({suite.name,
                        fmt::format("max_factor = {} is not a positive number", max_factor),
                        "ASCE 7 has no limit; Walters et al. (2012) went up to 3 to 6", ""});
    if (rule == ScalingRule::single_period) {
      scaling = scale_at_one_period(suite, building, target_sa_g, max_factor);
    } else {
      const SpectraByRule s = spectra_by_rule(suite, rule, periods_by_rule_s(rule, building));
      const bool of_16_2 = is_of_16_2(rule);
      scaling.factors =
          lifted_factors(suite, s, target_at(target_sa_g, s.periods_s),
                         of_16_2 ? least_of_16_2 : 1.0, of_16_2 ? mean_of_16_2 : 0.0, max_factor);
      take_ratios(scaling, s, target_sa_g);
    }
  }
  scaling.range = range;
  scaling.warnings = too_few_for(rule, suite.motions.size());
  return scaling;
}

}  // namespace glissade
