// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/fragility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/pooled_level.hpp"
#include "analysis/shape/threshold_data.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/in_parallel.hpp"
#include "glissade/fragility/share.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/study/analysis/impact.hpp"
#include "glissade/study/plan/plan.hpp"
#include "words/length_unit.hpp"

namespace glissade {
namespace {

constexpr std::size_t band_points = 120;

/// Reached the threshold and fell below it again at a higher level.
bool recrosses(const HistoryTable& histories, std::size_t record, std::size_t c,
               double threshold_m) {
  bool reached = false;
  for (std::size_t level = 0; level < histories.levels; ++level) {
    const bool exceeds = histories.displacement_m(record, c, level) >= threshold_m;
    if (reached && !exceeds) return true;
    reached |= exceeds;
  }
  return false;
}

/// What follows from the capacities of records that are run at all levels.
void fit_capacities(const Results& results, const RunResults& run, std::size_t threshold,
                    const BootstrapOptions& options, SamplingMethod method,
                    ThresholdFragility& fragility) {
  const HistoryTable& table = results.histories;
  const std::vector<Bracket> rows = capacities_of(results, slice_of(run), threshold);
  double recrossed = 0.0;
  for (std::size_t record = 0; record < table.records; ++record) {
    double record_recrossed = 0.0;
    for (std::size_t i = run.first_case; i < run.first_case + run.cases; ++i) {
      if (!recrosses(table, record, i, fragility.threshold_m)) continue;
      ++recrossed;
      record_recrossed = 1.0;
    }
    fragility.record_recross.push_back(record_recrossed);
  }
  const auto number = [&](double Bracket::*end, double value) {
    return static_cast<double>(std::ranges::count(rows, value, end));
  };
  const double histories = static_cast<double>(rows.size()),
               censored = number(&Bracket::high, infinity), reached = histories - censored;
  fragility.recross_share = reached > 0.0 ? recrossed / reached : 0.0;
  fragility.censored_share = censored / histories;
  fragility.free_sliding_share = number(&Bracket::high, 0.0) / histories;
  fragility.capacities =
      fit_brackets(by_unit(rows, table), Independent::records, run.band_intensities);
  fragility.lognormal =
      lognormal_goodness_of_fit(rows, options, method == SamplingMethod::sobol, table.unit_of);
}

ThresholdFragility fit_threshold(const Results& results, const RunResults& run,
                                 std::size_t threshold, const BootstrapOptions& options,
                                 SamplingMethod method) {
  const HistoryTable& table = results.histories;
  ThresholdFragility fragility;
  fragility.threshold_m = results.thresholds_m[threshold];
  fragility.on_stripes = results.by_stripes;
  const std::vector<Stripe> stripes = stripes_of(results, all_of(slice_of(run)), threshold);
  fragility.stripes =
      fit_stripes(stripes, Independent::records,
                  results.by_stripes ? run.band_intensities : std::vector<double>());
  if (results.by_stripes)
    fragility.free_sliding_share = stripes.front().trials / static_cast<double>(run.cases);
  else
    fit_capacities(results, run, threshold, options, method, fragility);
  for (std::size_t level = 0; level < results.levels.size(); ++level) {
    std::vector<double> shares;  // of all histories, by record
    std::vector<std::size_t> units;
    double exceeding = 0.0;
    for (std::size_t record = 0; record < table.records; ++record) {
      if (!table.has(record, level)) continue;
      double of_record = 0.0;
      for (std::size_t i = run.first_case; i < run.first_case + run.cases; ++i)
        if (table.displacement_m(record, i, level) >= fragility.threshold_m) of_record += 1.0;
      exceeding += of_record;
      shares.push_back(of_record / static_cast<double>(run.cases));
      units.push_back(table.unit(record));
    }
    fragility.probability.push_back(exceeding / static_cast<double>(shares.size() * run.cases));
    fragility.probability_interval.push_back(share_interval(UnitValues(shares, units)));
  }
  order_intervals(fragility.probability, fragility.probability_interval);
  return fragility;
}

SlipStatistics statistics_of(const PooledLevel& pooled, const Results& results,
                             const RunResults& run, std::size_t level) {
  const HistoryTable& histories = results.histories;
  SlipStatistics s;
  s.level = results.levels[level];
  s.median_m = pooled.quantile_m(0.5);
  s.p84_m = pooled.quantile_m(0.84);
  s.p95_m = pooled.quantile_m(0.95);
  s.mean_m = pooled.mean_m();
  s.mean_interval = pooled.mean_interval();
  if (results.histories.units() > 1) {
    s.median_interval = pooled.exceeded_interval(0.5);
    s.p84_interval = pooled.exceeded_interval(0.16);
  }
  s.uplift_share = mean_of(histories, histories.fields.uplift, slice_of(run), level);
  s.mean_vector_m = mean_of(histories, histories.fields.peak_vector_m, slice_of(run), level);
  return s;
}

StandardComparison compare(Standard standard, double sds_g, const StandardsConfig& config,
                           const PooledLevel& pooled) {
  StandardComparison c;
  c.standard = standard;
  c.sds_g = sds_g;
  c.prescribed = prescribed_displacement(standard, sds_g, config);
  c.exceedance_probability = pooled.share_above(c.prescribed.value_m);
  c.exceedance_interval = pooled.share_interval(c.prescribed.value_m);
  return c;
}

std::string design_text(const Quantity& mu) {
  if (!mu.is_drawn()) return describe(mu);
  const double design = design_friction(*mu.drawn);
  return fmt::format("mean - 2 std = {:.4g}{}", design,
                     design == 0.0 ? " (below zero: taken as 0)" : "");
}

RunResults fragility_of(const StudyConfig& config, const Results& results,
                        std::size_t combination) {
  const std::vector<double>& levels = results.levels;
  const BootstrapOptions options{.seed = config.seed,
                                 .replicates = config.sampling.bootstrap_replicates};
  RunResults run;
  run.label = results.cases.label(combination);
  run.cases = results.cases.per_combination();
  run.first_case = combination * run.cases;
  run.friction = friction_text(config, results.cases.cases[run.first_case]);
  for (std::size_t i = 0; i < band_points; ++i)
    run.band_intensities.push_back(levels.back() * static_cast<double>(i + 1) / band_points);
  run.fragilities.resize(results.thresholds_m.size());
  const auto fit = [&](std::size_t t) {
    run.fragilities[t] = fit_threshold(results, run, t, options, config.sampling.method);
  };
  const std::vector<Standard>& standards = config.standards.compare;
  run.standards.resize(standards.size() * levels.size());
  run.slip.resize(levels.size());
  const auto describe_level = [&](std::size_t level) {
    const PooledLevel pooled = pooled_at(results.histories, slice_of(run), level);
    run.slip[level] = statistics_of(pooled, results, run, level);
    for (std::size_t s = 0; s < standards.size(); ++s) {
      run.standards[s * levels.size() + level] =
          compare(standards[s], levels[level], config.standards, pooled);
    }
  };
  const std::size_t fits = run.fragilities.size();
  in_parallel(fits + levels.size(), [&](std::size_t i) {
    if (i < fits)
      fit(i);
    else
      describe_level(i - fits);
  });
  if (config.impact)
    run.impact = impact_statistics(results.histories, slice_of(run), levels, results.thresholds_m);
  return run;
}

}  // namespace

std::string friction_text(const StudyConfig& config, const Case& c) {
  const Quantity& along = config.quantities.at("friction", "mu");
  const Quantity& across = config.quantities.at("friction", "across_mu");
  const bool design = c.friction_value == FrictionValue::design;
  std::string text =
      design ? "mu = " + design_text(along)
             : "mu " + (along.is_drawn() ? describe(along) : fmt::format("{:g}", c.friction));
  if (config.friction.across_is_given)
    text += "; across the slope " + (design ? design_text(across) : describe(across));
  return text;
}

std::vector<RunResults> FragilityAnalysis::find(const StudyConfig& config, const Results& results) {
  const CaseSet& set = results.cases;
  std::vector<std::size_t> isolated;
  for (std::size_t i = 0; i < set.combinations(); ++i)
    if (set.cases[set.index(i, 0, 0)].support == ArraySupport::isolated) isolated.push_back(i);
  std::vector<RunResults> runs(isolated.size());
  in_parallel(runs.size(),
              [&](std::size_t i) { runs[i] = fragility_of(config, results, isolated[i]); });
  return runs;
}

std::vector<std::string> FragilityAnalysis::plan_warnings(const Plan& plan) {
  if (!plan.config.fragility) return {};
  std::vector<std::string> warnings;
  const double largest_m = plan.config.thresholds_m().back();
  const UnitSystem units = plan.config.units;
  if (largest_m > largest_probable_clearance_m)
    warnings.push_back(fmt::format("a clearance of {:.3g} {} is more than a roof has",
                                   length_value(largest_m, units), length_unit(units)));
  return warnings;
}

std::vector<std::string> FragilityAnalysis::plan_notes(const Plan& plan) {
  if (!plan.config.fragility || !plan.config.fragility->stop_at_largest) return {};
  return {fmt::format(
      "[fragility] stop_at_largest: a history is not run above the level that takes it past {:g} "
      "m; its slip there is reported as infinite, and a recrossing there would not be seen",
      plan.config.fragility->thresholds_m.back())};
}

/// Fragilities that are not lognormal.
std::vector<std::string> FragilityAnalysis::warnings_of_curves(const Results& results,
                                                               const StudyConfig& study) {
  std::size_t fitted = 0, refused = 0;
  const ThresholdFragility* worst = nullptr;
  const RunResults* worst_run = nullptr;
  std::vector<double> refused_m;
  for (const RunResults& run : results.runs) {
    for (const ThresholdFragility& fragility : run.fragilities) {
      const GoodnessOfFit& fit = fragility.lognormal;
      if (std::isnan(fit.p_value)) continue;
      ++fitted;
      if (!departs_from_lognormal(fit)) continue;
      ++refused;
      refused_m.push_back(fragility.threshold_m);
      if (worst == nullptr || std::abs(fit.largest_gap) > std::abs(worst->lognormal.largest_gap))
        worst = &fragility, worst_run = &run;
    }
  }
  if (worst == nullptr) return {};
  std::ranges::sort(refused_m);
  refused_m.erase(std::unique(refused_m.begin(), refused_m.end()), refused_m.end());
  const std::string unit = results.measure.unit(),
                    length = std::string(" ") + length_unit(study.units);
  const std::string at_run =
      results.runs.size() > 1
          ? results.cases.describe(worst_run->first_case / results.cases.per_combination()) + ", "
          : "";
  return {fmt::format(
      "{} of {} fragility curves {} not lognormal (p < {:g} and a gap of {:g} or more): of "
      "clearance {}{}. The largest gap is at {}clearance {}{}: at {} = {:.3g}{} the share of the "
      "histories that exceed it is {:.2f} {} the curve. Probabilities and annual rates are of the "
      "histories, not of the curve; medians are of the curve; [shape] compares other curves",
      refused, fitted, refused == 1 ? "is" : "are", goodness_of_fit_level, goodness_of_fit_gap,
      lengths_text(refused_m, study.units), length, at_run,
      lengths_text({worst->threshold_m}, study.units), length,
      results.measure.symbol(study.intensity), worst->lognormal.gap_intensity,
      unit == "-" ? "" : " " + unit, std::abs(worst->lognormal.largest_gap),
      worst->lognormal.largest_gap > 0.0 ? "above" : "below")};
}

}  // namespace glissade
