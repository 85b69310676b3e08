// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/motion/design_spectrum.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/study/results.hpp"
#include "words/length_unit.hpp"
#include "words/plan_notes.hpp"

namespace glissade {

std::string improbable_rates(const HazardCurve& curve) {
  // Near the most active faults 0.5 g is exceeded once in 20 years or so, 1 g once in 70
  // (recalled).
  constexpr double weakest_g = 0.2, most_at_1g = 0.015;
  std::vector<HazardPoint> points = curve.points();
  if (curve.is_power_law()) points = {{0.5, curve.annual_rate(0.5)}, {1.0, curve.annual_rate(1.0)}};
  for (const auto& [intensity_g, annual_rate] : points) {
    if (intensity_g < weakest_g || annual_rate * intensity_g * intensity_g <= most_at_1g) continue;
    return fmt::format(
        "the hazard curve gives {:g} g once in {:.3g} years, more often than at any site: are its "
        "rates probabilities in 50 years? Of a probability p in 50 years the annual rate is -ln(1 "
        "- p)/50",
        intensity_g, 1.0 / annual_rate);
  }
  return "";
}

/// Levels beyond the ends of the curve, and a curve that does not fit the design spectra.
std::vector<std::string> HazardAnalysis::plan_warnings(const StudyOutline& study) {
  if (!study.config.hazard) return {};
  const IntensityConfig& intensity = study.config.intensity;
  const HazardCurve& curve = study.config.hazard->curve;
  std::vector<std::string> warnings;
  if (intensity.of_roof)
    warnings.emplace_back(
        "the motions are of a roof: the hazard curve must be that of their intensity measure, not "
        "of the ground");
  const double from = curve.points().front().intensity, to = curve.points().back().intensity;
  if (!curve.is_power_law() && (intensity.levels.front() < from || intensity.levels.back() > to))
    warnings.push_back(
        fmt::format("the hazard curve goes from {:g} to {:g}, the levels from {:g} to {:g}: beyond "
                    "its ends the rates are extrapolated",
                    from, to, intensity.levels.front(), intensity.levels.back()));
  const bool is_in_g = intensity.measure.unit() == std::string("g");
  for (const std::string& text : {is_in_g ? improbable_rates(curve) : "",
                                  improbable_design_life(study.config.hazard->design_life_years)})
    if (!text.empty()) warnings.push_back(text);
  if (study.mce_level == 0.0) return warnings;
  const bool by_sds = intensity.measure == IntensityMeasure::sds_g;
  const std::string text =
      improbable_mce_rate(curve.annual_rate(study.mce_level),
                          by_sds ? fmt::format("S_MS, {:.3g} g,", study.mce_level) : "the MCE");
  if (!text.empty()) warnings.push_back(text);
  return warnings;
}

/// A curve of a measure that has no rate, and one that is no site's.
std::vector<std::string> HazardAnalysis::plan_notes(const StudyOutline& study) {
  const std::optional<HazardConfig>& hazard = study.config.hazard;
  std::vector<std::string> notes;
  if (!hazard) return notes;
  const bool by_sds = study.config.intensity.measure == IntensityMeasure::sds_g;
  if (by_sds)
    notes.emplace_back(
        "annual rates by S_DS come out high: S_DS has no single annual rate, and the average "
        "spectrum of a suite lies above its target; for rates use measure = \"sa_g\"");
  const double target_g = by_sds ? study.mce_level / mce_over_dbe : 0.0;
  if (target_g > 0.0 && hazard->sds_g > 0.0 && std::abs(hazard->sds_g / target_g - 1.0) > 0.01)
    notes.push_back(fmt::format(
        "the displacements that standards prescribe are those of hazard.sds_g, {:.3g} g, where "
        "their rates are given, and of the design target's S_DS, {:.3g} g, at DBE and MCE",
        hazard->sds_g, target_g));
  if (hazard->is_assumed)
    notes.push_back(
        "hazard curve " + hazard->source +
        " (1 % collapse in 50 years, 10 % at MCE, log_std 0.6: ASCE 7-16, 21.2.1.2, recalled): it "
        "is not that of the site; where MCE_R is limited by a deterministic earthquake the rates "
        "of the site are higher");
  return notes;
}

/// Annual rates that rest on shaking above the highest level.
std::vector<std::string> HazardAnalysis::warnings(const Results& results,
                                                  const StudyConfig& study) {
  constexpr double notable_share = 0.2;
  if (!results.hazard) return {};
  double largest = 0.0;
  std::vector<double> concerned_m;
  for (const HazardRun& run : results.hazard->runs) {
    for (const ThresholdRate& row : run.thresholds) {
      if (!(row.beyond_share >= notable_share)) continue;
      largest = std::max(largest, row.beyond_share);
      concerned_m.push_back(row.threshold_m);
    }
  }
  if (concerned_m.empty()) return {};
  std::ranges::sort(concerned_m);
  concerned_m.erase(std::unique(concerned_m.begin(), concerned_m.end()), concerned_m.end());
  return {fmt::format(
      "annual rates: up to {:.0f} % of the rate of clearance {} {} is the assumption that any "
      "shaking above the highest level exceeds it. The rate is an upper estimate; add higher "
      "levels",
      100.0 * largest, lengths_text(concerned_m, study.units), length_unit(study.units))};
}

}  // namespace glissade
