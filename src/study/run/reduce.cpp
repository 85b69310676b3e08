// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "analysis/fragility.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/study/analysis/chart.hpp"
#include "plan/model_text.hpp"
#include "run/results_notes.hpp"

#ifndef GLISSADE_VERSION
#error "the build defines GLISSADE_VERSION"
#endif

namespace glissade {
namespace {

/// The units in plan order. Each must be there once.
std::vector<const UnitResult*> in_plan_order(const Plan& plan,
                                             const std::vector<UnitResult>& units) {
  std::vector<const UnitResult*> in_order(plan.units.size(), nullptr);
  for (const UnitResult& unit : units) in_order.at(unit.unit) = &unit;
  if (std::ranges::find(in_order, nullptr) != in_order.end())
    throw std::logic_error("reduce: a unit of the plan is missing");
  return in_order;
}

/// A mirrored history ends on the other side.
void mirror_residuals(const Plan& plan, HistoryTable& table) {
  std::vector<double>& across = table.fields.residual_across_m;
  if (across.empty()) return;
  for (std::size_t i = 0; i < table.cases; ++i) {
    const Orientation& run = plan.cases.cases[plan.same_as[i]].orientation;
    if (plan.cases.cases[i].orientation.across_sign == run.across_sign) continue;
    for (std::size_t record = 0; record < table.records; ++record) {
      for (std::size_t level = 0; level < table.levels; ++level) {
        double& residual = across[table.at(record, i, level)];
        residual = residual == 0.0 ? 0.0 : -residual;
      }
    }
  }
}

HistoryTable assemble(const Plan& plan, const std::vector<UnitResult>& units) {
  HistoryTable table{plan.records.size(),
                     plan.cases.size(),
                     plan.config.intensity.levels.size(),
                     plan.config.thresholds_m().size(),
                     {}};
  // By (record, case that is run): its unit and its place there.
  struct Place {
    const UnitResult* unit = nullptr;
    std::size_t position = 0;
  };
  std::vector<Place> place(table.records * table.cases);
  for (const UnitResult* unit : in_plan_order(plan, units)) {
    const WorkUnit& work = plan.units[unit->unit];
    for (std::size_t i = 0; i < work.count; ++i)
      place[work.record * table.cases + plan.order[work.first + i]] = {unit, i};
  }
  for_each_history_field([&](auto field) {
    const std::size_t depth = table.depth(field.depth);
    if (depth == 0 || (units.front().fields.*field.of).empty()) return;
    auto& values = table.fields.*field.of;
    values.resize(place.size() * depth);
    for (std::size_t at = 0; at < place.size(); ++at) {
      const std::size_t row = at - at % table.cases;  // of the record
      const Place& from = place[row + plan.same_as[at % table.cases]];
      const auto begin = (from.unit->fields.*field.of).begin() +
                         static_cast<std::ptrdiff_t>(from.position * depth);
      std::copy(begin, begin + static_cast<std::ptrdiff_t>(depth),
                values.begin() + static_cast<std::ptrdiff_t>(at * depth));
    }
  });
  mirror_residuals(plan, table);
  return table;
}

double integral_of_squares(const std::vector<double>& a) {
  return std::inner_product(a.begin(), a.end(), a.begin(), 0.0);
}

/// Periods at which spectra are shown: 0, then 0.02 to 4 s, equally spaced in the logarithm; of a
/// suite that its file scales to MCE those of the rule it is scaled by, 0 to 2 s.
std::vector<double> shown_periods_s(bool as_scaled_to_mce) {
  std::vector<double> periods{0.0};
  if (as_scaled_to_mce) {
    constexpr int count = 200;
    for (int i = 1; i <= count; ++i) periods.push_back(2.0 * i / count);
    return periods;
  }
  constexpr int count = 80;
  for (int i = 0; i < count; ++i) periods.push_back(0.02 * std::pow(200.0, i / (count - 1.0)));
  return periods;
}

RecordSummary summary_of(const Plan& plan, std::size_t record) {
  const Motion& motion = plan.motion(record);
  const auto& [first, second] = motion.horizontal_mps2;
  RecordSummary r;
  r.suite = plan.records[record].suite;
  r.id = motion.id;
  r.event = motion.event;
  r.station = motion.station;
  r.magnitude = motion.magnitude;
  r.distance_km = motion.distance_km;
  r.vs30_mps = motion.vs30_mps;
  r.suite_scale = motion.scale;
  r.factor_at_unit_level = plan.factor_at_unit_level[record];
  r.pga_g =
      horizontal_pga_mps2(motion, HorizontalCombination::geometric_mean) / standard_gravity_mps2;
  r.pgv_mps = horizontal_pgv_mps(motion, HorizontalCombination::geometric_mean);
  r.pgd_m = horizontal_pgd_m(motion, HorizontalCombination::geometric_mean);
  r.duration_s = significant_duration_s(motion.dt_s, first, second);
  r.arias_mps = arias_intensity_mps(motion);
  r.sa_g = horizontal_spectrum_mps2(motion, shown_periods_s(false),
                                    HorizontalCombination::geometric_mean);
  for (double& sa : r.sa_g) sa /= standard_gravity_mps2;
  r.roof_velocity_mps = horizontal_roof_velocity_mps(motion, shown_periods_s(false));
  r.dt_s = motion.dt_s;
  r.samples = first.size();
  r.has_second = !second.empty();
  r.has_vertical = !motion.vertical_mps2.empty();
  r.stronger = integral_of_squares(second) > integral_of_squares(first) ? 1 : 0;
  return r;
}

/// By S_DS at the level nearest 1 g, of a chart at the one it shows; else 0: as the suite file
/// scales it, beside its MCE target.
double reference_level(const StudyConfig& config) {
  const std::vector<double>& levels = config.intensity.levels;
  if (config.intensity.measure != IntensityMeasure::sds_g) return 0.0;
  if (config.chart) return config.chart->shown_level;
  return *std::ranges::min_element(
      levels, [](double a, double b) { return std::abs(a - 1.0) < std::abs(b - 1.0); });
}

SuiteSpectra spectra_of(const Plan& plan, std::size_t suite) {
  const IntensityConfig& intensity = plan.config.intensity;
  const bool by_sds = intensity.measure == IntensityMeasure::sds_g;
  SuiteSpectra spectra;
  spectra.periods_s = shown_periods_s(intensity.measure == IntensityMeasure::mce_fraction);
  spectra.reference_level = reference_level(plan.config);
  spectra.average_srss_g.assign(spectra.periods_s.size(), 0.0);
  const double motions = static_cast<double>(plan.suites[suite].motions.size());
  std::vector<double> factors;
  std::size_t first = 0;
  while (plan.records[first].suite != suite) ++first;
  for (std::size_t record = first; record < first + plan.suites[suite].motions.size(); ++record) {
    const Motion& motion = plan.motion(record);
    const double factor =
        by_sds ? spectra.reference_level * plan.factor_at_unit_level[record] : motion.scale;
    factors.push_back(factor);
    std::vector<double> srss =
        horizontal_spectrum_mps2(motion, spectra.periods_s, HorizontalCombination::srss);
    for (std::size_t p = 0; p < srss.size(); ++p) {
      srss[p] *= factor / standard_gravity_mps2;
      spectra.average_srss_g[p] += srss[p] / motions;
    }
    spectra.srss_g.push_back(std::move(srss));
  }
  const DesignTarget* target = plan.target_of(suite);
  if (target == nullptr) return spectra;
  const TargetSpectrum shape(*target);
  const auto target_sa_g = [&](double period) {
    return by_sds ? spectra.reference_level * shape.design_sa_g(period) / shape.sds_g()
                  : shape.mce_sa_g(period);
  };
  for (const double period : spectra.periods_s) spectra.target_g.push_back(target_sa_g(period));
  if (!by_sds || spectra.reference_level > 0.0)
    spectra.to_target = ratios_to_target(plan.suites[suite], factors, target_sa_g);
  return spectra;
}

/// The plan's part of the results.
Results header_of(const Plan& plan) {
  const StudyConfig& c = plan.config;
  Results results;
  results.study_name = c.name;
  results.study_description = c.description;
  results.program_version = GLISSADE_VERSION;
  results.plan_hash = plan.hash;
  results.study_text = c.source_text;
  results.units = c.units;
  results.seed = c.seed;
  results.measure = c.intensity.measure;
  results.intensity_label = intensity_label(c.intensity);
  results.model = model_text(plan);
  results.axes = c.model.axes;
  results.displacement = c.model.displacement;
  results.levels = c.intensity.levels;
  results.thresholds_m = c.thresholds_m();
  results.cases = plan.cases;
  for (std::size_t s = 0; s < plan.suites.size(); ++s)
    results.suites.push_back(
        {plan.suites[s].name, plan.suites[s].description, spectra_of(plan, s)});
  for (std::size_t record = 0; record < plan.records.size(); ++record)
    results.records.push_back(summary_of(plan, record));
  results.record_periods_s = shown_periods_s(false);
  return results;
}

void analyse(const StudyConfig& study, Results& results) {
  if (study.clearance || study.base_shear) results.conditions = condition_table(results);
  if (study.fragility) results.runs = fragility_runs(study, results);
  if (study.chart) results.chart = make_chart(study, results);
  if (study.clearance) results.clearance = required_clearance(results, *study.clearance);
  if (study.base_shear) results.base_shear = base_shear_results(results);
  if (study.tipping) results.tipping = tipping_results(results, *study.tipping);
  if (study.hazard) results.hazard = hazard_results(study, results);
  if (study.verdict) results.verdict = verdict_results(study, results);
  if (study.sensitivity) results.sensitivity = sensitivity_results(study, results);
  if (study.shape) results.shape = shape_results(results);
  if (study.rare) results.rare = rare_results(study, results);
  results.sampling_errors = sampling_error_rows(study, results);
  if (study.sampling.target)
    results.reached_target = reached_target(study, results.sampling_errors);
  if (study.intensity_measures)
    results.intensity_measures = rank_intensity_measures(study, results);
}

}  // namespace

Results reduce(const Plan& plan, const std::vector<UnitResult>& units) {
  Results results = header_of(plan);
  results.histories = assemble(plan, units);
  analyse(plan.config, results);
  results.warnings = plan.warnings;
  for (std::string& warning : warnings_on(results, plan.config))
    results.warnings.push_back(std::move(warning));
  results.notes = plan.notes;
  for (std::string& note : notes_on(results, plan.config)) results.notes.push_back(std::move(note));
  return results;
}

void analyse_again(StudyConfig study, Results& results) {
  if (results.reached_target)
    study.sampling = study.sampling.first_blocks(results.reached_target->scrambles);
  results.study_text = study.source_text;
  results.conditions.reset();
  results.runs.clear();
  results.chart.reset();
  results.clearance.reset();
  results.base_shear.reset();
  results.tipping.reset();
  results.hazard.reset();
  results.verdict.reset();
  results.sensitivity.reset();
  results.shape.reset();
  results.rare.reset();
  results.intensity_measures.reset();
  analyse(study, results);
}

WorkCount total_count(const std::vector<UnitResult>& units) {
  WorkCount total;
  for (const UnitResult& unit : units) total += unit.count;
  return total;
}

std::vector<Skip> skipped(const Plan& plan, const WorkCount& count) {
  std::vector<Skip> skips = plan.skips;
  const auto add = [&](const char* what, const char* why, std::uint64_t number) {
    if (number > 0) skips.push_back({what, why, number});
  };
  add("histories whose roof moves too little to start sliding",
      "they cannot slide: zero without integration", count.below_yield);
  const std::uint64_t integrated = count.integrated + count.searched;
  add("roof motions, beside those made",
      "one serves every intensity, friction and slope on its record, period and damping",
      integrated - std::min(count.roofs, integrated));
  add("histories on a flat roof without vertical",
      "their point of the record's curve slip / lambda = F(mu / lambda) was computed before",
      count.from_curve);
  add("histories above the level that reaches the largest threshold",
      "[fragility] stop_at_largest = true", count.beyond);
  add("searches for a capacity", "the levels decide: not reached, or exceeded without shaking",
      count.decided);
  return skips;
}

}  // namespace glissade
