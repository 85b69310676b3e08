// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/suite_design.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/core/in_parallel.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/simulation/gain_calibration.hpp"
#include "glissade/motion/suite_scaling.hpp"

namespace glissade {
namespace {

constexpr auto strike_slip = FaultMechanism::strike_slip;
constexpr auto reverse = FaultMechanism::reverse;
const std::array<std::array<Scenario, 7>, 5> scenarios = {{
    {{{5.9, 12, 420, strike_slip},
      {6.1, 16, 520, reverse},
      {6.3, 20, 380, strike_slip},
      {6.5, 25, 600, strike_slip},
      {6.6, 30, 450, reverse},
      {6.8, 35, 360, strike_slip},
      {6.9, 50, 760, strike_slip}}},
    {{{5.9, 8, 400, strike_slip},
      {6.1, 10, 350, reverse},
      {6.3, 14, 500, strike_slip},
      {6.5, 18, 300, strike_slip},
      {6.6, 20, 560, reverse},
      {6.8, 25, 380, strike_slip},
      {6.9, 32, 450, strike_slip}}},
    {{{6.7, 7, 400, reverse},
      {6.8, 10, 560, strike_slip},
      {6.9, 12, 330, strike_slip},
      {7.1, 15, 450, strike_slip},
      {7.2, 9, 700, reverse},
      {7.4, 18, 380, strike_slip},
      {7.6, 25, 500, strike_slip}}},
    {{{6.7, 5, 450, reverse},
      {6.8, 7, 380, strike_slip},
      {7.0, 9, 560, strike_slip},
      {7.1, 6, 350, reverse},
      {7.2, 12, 420, strike_slip},
      {7.4, 8, 700, strike_slip},
      {7.6, 14, 500, strike_slip}}},
    {{{6.7, 5, 360, reverse},
      {6.9, 6, 420, strike_slip},
      {7.1, 8, 500, strike_slip},
      {7.2, 5, 340, strike_slip},
      {7.3, 10, 600, reverse},
      {7.5, 7, 400, strike_slip},
      {7.6, 12, 300, strike_slip}}},
}};

constexpr std::size_t candidates_per_scenario = 30;

/// Four significant digits, so that the text of the recipe has the exact numbers.
double rounded(double value) {
  const double power = std::pow(10.0, 3.0 - std::floor(std::log10(value)));
  return std::round(value * power) / power;
}

SyntheticRecipe recipe_of_level(int level, std::uint64_t seed) {
  SyntheticRecipe recipe;
  recipe.name = "synthetic_level" + std::to_string(level);
  recipe.nearest_to_target = true;
  recipe.description =
      "Seven simulated three-component motions scaled to the MCE of Intensity Level " +
      std::to_string(level) + " of Walters et al. (2012), site classes A-D";
  recipe.seed = seed;
  recipe.max_scale = walters_level(level).max_scale;
  recipe.target = walters_target(level);
  return recipe;
}

/// Thirty of each scenario in turn; no two levels share a realization.
std::vector<SyntheticMotion> candidate_motions(int level) {
  std::vector<SyntheticMotion> candidates;
  for (const Scenario& scenario : level_scenarios(level))
    for (std::size_t k = 0; k < candidates_per_scenario; ++k)
      candidates.push_back(
          {.id = "",
           .magnitude = scenario.magnitude,
           .distance_km = scenario.distance_km,
           .vs30_mps = scenario.vs30_mps,
           .mechanism = scenario.mechanism,
           .realization = 1000 * static_cast<std::uint64_t>(level) + candidates.size()});
  return candidates;
}

void set_gain(SyntheticRecipe& recipe, const std::vector<SyntheticMotion>& candidates) {
  std::vector<EnsembleMember> ensemble;
  for (const SyntheticMotion& motion : candidates) {
    const Scenario scenario = scenario_of(motion);
    ensemble.push_back(
        {scenario, simulate_raw_motion(scenario, {recipe.seed, motion.realization}, recipe.dt_s)});
  }
  const SuiteGain gain = calibrate_gain(ensemble);
  recipe.gain_frequencies_hz = gain.horizontal.frequencies_hz;
  for (const double value : gain.horizontal.values)
    recipe.horizontal_gain.push_back(rounded(value));
  for (const double value : gain.vertical.values) recipe.vertical_gain.push_back(rounded(value));
}

/// SRSS spectrum of a candidate over the MCE spectrum, scaled as close to one as possible.
struct SpectralFit {
  double scale = 1.0;       ///< that factor
  Eigen::ArrayXd ratio;     ///< per period, scaled
  double log_square = 0.0;  ///< mean square of ln ratio
};

SpectralFit fit_to_target(const Motion& motion, const TargetSpectrum& target,
                          const std::vector<double>& periods_s) {
  const auto sa_mps2 = horizontal_spectrum_mps2(motion, periods_s, HorizontalCombination::srss);
  Eigen::ArrayXd ratio(static_cast<Eigen::Index>(periods_s.size()));
  for (std::size_t p = 0; p < periods_s.size(); ++p)
    ratio[static_cast<Eigen::Index>(p)] =
        sa_mps2[p] / (target.mce_sa_g(periods_s[p]) * standard_gravity_mps2);
  const double scale = std::exp(-ratio.log().mean());
  ratio *= scale;
  return {scale, ratio, ratio.log().square().mean()};
}

using Choice = std::array<std::size_t, 7>;  ///< a candidate for each scenario

/// Mean square of ln(Sa / MCE) over the seven motions and all periods, after the common factor for
/// which their average is nowhere below the MCE spectrum.
double misfit(const std::vector<SpectralFit>& fits, const Choice& choice) {
  Eigen::ArrayXd average = Eigen::ArrayXd::Zero(fits.front().ratio.size());
  double log_square = 0.0;
  for (const std::size_t k : choice) {
    average += fits[k].ratio / static_cast<double>(choice.size());
    log_square += fits[k].log_square / static_cast<double>(choice.size());
  }
  const double log_lift = -std::log(average.minCoeff());
  return log_square + log_lift * log_lift;
}

/// The choice of least misfit that no exchange of one candidate improves, from the candidates whose
/// factors can be increased by the common factor within the scale limit. Starts from the nearest
/// candidate of each scenario.
Choice choose(const std::vector<SpectralFit>& fits, double max_scale) {
  const auto allowed = [&](std::size_t k) { return fits[k].scale <= 0.7 * max_scale; };
  Choice choice;
  for (std::size_t m = 0; m < choice.size(); ++m) {
    const std::size_t first = m * candidates_per_scenario;
    choice[m] = first;
    for (std::size_t k = first; k < first + candidates_per_scenario; ++k)
      if (!allowed(choice[m]) || (allowed(k) && fits[k].log_square < fits[choice[m]].log_square))
        choice[m] = k;
  }
  for (bool better = true; better;) {
    better = false;
    for (std::size_t m = 0; m < choice.size(); ++m)
      for (std::size_t k = m * candidates_per_scenario; k < (m + 1) * candidates_per_scenario;
           ++k) {
        Choice exchanged = choice;
        exchanged[m] = k;
        if (!allowed(k) || misfit(fits, exchanged) >= misfit(fits, choice)) continue;
        choice = exchanged;
        better = true;
      }
  }
  return choice;
}

void set_scales(SyntheticRecipe& recipe, const TargetSpectrum& target,
                const std::vector<double>& periods_s) {
  const SuiteScaling scaling = scale_suite_to_target(
      simulate_suite(recipe), [&](double period_s) { return target.mce_sa_g(period_s); }, periods_s,
      recipe.max_scale);
  for (std::size_t i = 0; i < recipe.motions.size();
       ++i)  // upwards, so that the average stays above the target
    recipe.motions[i].scale = std::min(std::ceil(scaling.factors[i] * 1e4) / 1e4, recipe.max_scale);
}

}  // namespace

const std::array<Scenario, 7>& level_scenarios(int level) {
  walters_level(level);  // InputError if there is no such level
  return scenarios[static_cast<std::size_t>(level)];
}

SyntheticRecipe design_suite(int level, std::uint64_t seed) {
  SyntheticRecipe recipe = recipe_of_level(level, seed);
  const std::vector<SyntheticMotion> candidates = candidate_motions(level);
  set_gain(recipe, candidates);

  const TargetSpectrum target(recipe.target);
  const std::vector<double> periods_s = walters_periods_s();
  std::vector<SpectralFit> fits(candidates.size());
  in_parallel(fits.size(), [&](std::size_t i) {
    fits[i] = fit_to_target(simulate_motion(recipe, candidates[i]), target, periods_s);
  });
  for (const std::size_t k : choose(fits, recipe.max_scale)) {
    recipe.motions.push_back(candidates[k]);
    recipe.motions.back().id =
        "level" + std::to_string(level) + "_" + std::to_string(recipe.motions.size());
  }
  set_scales(recipe, target, periods_s);
  return recipe;
}

}  // namespace glissade
