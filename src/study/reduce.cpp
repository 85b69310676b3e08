// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/reduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/study/chart.hpp"
#include "glissade/study/impact.hpp"
#include "model_text.hpp"
#include "pooled_level.hpp"

#ifndef GLISSADE_VERSION
#error "the build defines GLISSADE_VERSION"
#endif

namespace glissade {
namespace {

constexpr std::size_t band_points = 120;

/// Periods at which spectra are shown: 0, then 0.02 to 4 s, equally spaced in the logarithm.
std::vector<double> shown_periods_s() {
  std::vector<double> periods{0.0};
  constexpr int count = 80;
  for (int i = 0; i < count; ++i) periods.push_back(0.02 * std::pow(200.0, i / (count - 1.0)));
  return periods;
}

RunResults assemble(const Plan& plan, const std::vector<const UnitResult*>& units,
                    std::size_t run) {
  const std::size_t records = plan.suite.motions.size(), samples = plan.samples.size();
  const std::size_t levels = plan.config.intensity.levels.size(),
                    thresholds = plan.config.thresholds_m.size();
  RunResults results;
  results.label = plan.runs[run].label;
  results.friction_description = plan.runs[run].description;
  results.peak_displacement_m = Array3<double>(records, samples, levels);
  results.uplift = Array3<std::uint8_t>(records, samples, levels);
  if (plan.config.base) results.tips = Array3<std::uint8_t>(records, samples, levels);
  const bool two_axes = plan.config.model.axes == SlidingAxes::two;
  if (two_axes) results.peak_vector_m = Array3<double>(records, samples, levels);
  const std::size_t crossings = plan.config.impact ? levels * thresholds : 0;  // of a sample
  results.crossing_time_s.resize(records * samples * crossings);
  results.crossing_speed_mps.resize(records * samples * crossings);
  results.capacity = Array3<double>(records, samples, thresholds);
  for (const UnitResult* unit : units) {
    const WorkUnit& work = plan.units[unit->unit];
    const UnitResult::Run& part = unit->runs[run];
    for (std::uint64_t i = 0; i < work.sample_count; ++i) {
      for (std::size_t j = 0; j < levels; ++j) {
        results.peak_displacement_m(work.record, work.first_sample + i, j) =
            part.peak_displacement_m[i * levels + j];
        results.uplift(work.record, work.first_sample + i, j) = part.uplift[i * levels + j];
        if (plan.config.base)
          results.tips(work.record, work.first_sample + i, j) = part.tips[i * levels + j];
        if (two_axes) {
          results.peak_vector_m(work.record, work.first_sample + i, j) =
              part.peak_vector_m[i * levels + j];
        }
      }
      for (std::size_t t = 0; t < thresholds; ++t) {
        results.capacity(work.record, work.first_sample + i, t) = part.capacity[i * thresholds + t];
      }
    }
    const auto to =
        static_cast<std::ptrdiff_t>((work.record * samples + work.first_sample) * crossings);
    std::copy(part.crossing_time_s.begin(), part.crossing_time_s.end(),
              results.crossing_time_s.begin() + to);
    std::copy(part.crossing_speed_mps.begin(), part.crossing_speed_mps.end(),
              results.crossing_speed_mps.begin() + to);
  }
  return results;
}

/// Reached the threshold and fell below it again at a higher level.
bool recrosses(const Array3<double>& peaks, std::size_t record, std::size_t sample,
               double threshold_m) {
  bool reached = false;
  for (std::size_t level = 0; level < peaks.depth; ++level) {
    const bool exceeds = peaks(record, sample, level) >= threshold_m;
    if (reached && !exceeds) return true;
    reached |= exceeds;
  }
  return false;
}

ThresholdFragility fit_threshold(const Plan& plan, const RunResults& run, std::size_t threshold,
                                 const BootstrapOptions& options) {
  const std::vector<double>& levels = plan.config.intensity.levels;
  const std::size_t records = run.capacity.rows, samples = run.capacity.columns;
  ThresholdFragility fragility;
  fragility.threshold_m = plan.config.thresholds_m[threshold];

  std::vector<RecordStripes> stripes(records);
  std::vector<RecordCapacities> capacities(records);
  // Of all histories, by record and level. Those that slide freely are no part of the stripes.
  std::vector<std::vector<double>> exceeding(records, std::vector<double>(levels.size()));
  double reached = 0.0, recrossed = 0.0, censored = 0.0, free = 0.0;
  for (std::size_t record = 0; record < records; ++record) {
    stripes[record].exceedances.assign(levels.size(), 0.0);
    double record_recrossed = 0.0;
    for (std::size_t sample = 0; sample < samples; ++sample) {
      const double capacity = run.capacity(record, sample, threshold);
      for (std::size_t level = 0; level < levels.size(); ++level) {
        if (run.peak_displacement_m(record, sample, level) < fragility.threshold_m) continue;
        exceeding[record][level] += 1.0;
        if (capacity != 0.0) stripes[record].exceedances[level] += 1.0;
      }
      if (std::isinf(capacity)) {
        capacities[record].censored += 1.0;
        ++censored;
      } else if (capacity == 0.0) {
        capacities[record].free += 1.0;
        ++free;
      } else {
        capacities[record].capacities.push_back(capacity);
      }
      if (!std::isinf(capacity)) ++reached;
      if (recrosses(run.peak_displacement_m, record, sample, fragility.threshold_m)) {
        ++recrossed;
        record_recrossed = 1.0;
      }
    }
    fragility.record_recross.push_back(record_recrossed);
    stripes[record].free = capacities[record].free;
    stripes[record].trials.assign(levels.size(),
                                  static_cast<double>(samples) - stripes[record].free);
  }
  const double histories = static_cast<double>(records * samples);
  fragility.recross_share = reached > 0.0 ? recrossed / reached : 0.0;
  fragility.censored_share = censored / histories;
  fragility.free_sliding_share = free / histories;
  fragility.stripes = fit_stripes_by_record(levels, stripes, options);
  fragility.capacities = fit_capacities_by_record(capacities, levels.back(), options,
                                                  run.band_intensities, &fragility.band);
  for (std::size_t level = 0; level < levels.size(); ++level) {
    double share = 0.0;
    for (const std::vector<double>& record : exceeding) share += record[level];
    fragility.probability.push_back(share / histories);
    if (share == 0.0 || share == histories) {  // resampling tells nothing of what was never seen
      fragility.probability_interval.push_back({});
      continue;
    }
    fragility.probability_interval.push_back(bootstrap_interval(
        records,
        [&](const std::vector<double>& weights) {
          double count = 0.0;
          for (std::size_t record = 0; record < records; ++record)
            count += weights[record] * exceeding[record][level];
          return count / histories;
        },
        options));
  }
  return fragility;
}

/// Over the histories at a level; NaN where there are none. Of flags: the share that is set.
template <class T>
double mean_at(const Array3<T>& values, std::size_t level) {
  double sum = 0.0;
  for (std::size_t record = 0; record < values.rows; ++record) {
    for (std::size_t sample = 0; sample < values.columns; ++sample)
      sum += values(record, sample, level);
  }
  return sum / static_cast<double>(values.rows * values.columns);
}

double share_at(const Array3<std::uint8_t>& flags, std::size_t level) {
  return mean_at(flags, level);
}

SlipStatistics statistics_of(const PooledLevel& pooled, const RunResults& run, std::size_t level,
                             double intensity, const BootstrapOptions& options) {
  SlipStatistics s;
  s.level = intensity;
  s.median_m = pooled.quantile_m(0.5);
  s.p84_m = pooled.quantile_m(0.84);
  s.p95_m = pooled.quantile_m(0.95);
  s.mean_m = pooled.mean_m();
  s.mean_interval = pooled.mean_interval(options);
  s.median_interval = pooled.quantile_interval(0.5, options);
  s.p84_interval = pooled.quantile_interval(0.84, options);
  s.uplift_share = share_at(run.uplift, level);
  s.tip_share = share_at(run.tips, level);
  s.mean_vector_m = mean_at(run.peak_vector_m, level);
  return s;
}

StandardComparison compare(Standard standard, double sds_g, const StandardsConfig& config,
                           const PooledLevel& pooled, const BootstrapOptions& options) {
  StandardComparison c;
  c.standard = standard;
  c.sds_g = sds_g;
  c.prescribed = prescribed_displacement(standard, sds_g, config);
  c.exceedance_probability = pooled.share_above(c.prescribed.value_m);
  c.exceedance_interval = pooled.share_interval(c.prescribed.value_m, options);
  return c;
}

RunResults reduce_run(const Plan& plan, const std::vector<const UnitResult*>& units,
                      std::size_t run_index) {
  const std::vector<double>& levels = plan.config.intensity.levels;
  const BootstrapOptions options{.seed = plan.config.seed,
                                 .replicates = plan.config.sampling.bootstrap_replicates};
  RunResults run = assemble(plan, units, run_index);
  if (plan.config.chart) return run;  // make_chart() tells what is to be told
  for (std::size_t i = 0; i < band_points; ++i) {
    run.band_intensities.push_back(levels.back() * static_cast<double>(i + 1) / band_points);
  }
  for (std::size_t t = 0; t < plan.config.thresholds_m.size(); ++t)
    run.fragilities.push_back(fit_threshold(plan, run, t, options));

  std::vector<PooledLevel> pooled;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    std::vector<std::vector<double>> slips(run.peak_displacement_m.rows);
    for (std::size_t record = 0; record < slips.size(); ++record) {
      for (std::size_t sample = 0; sample < run.peak_displacement_m.columns; ++sample) {
        slips[record].push_back(run.peak_displacement_m(record, sample, level));
      }
    }
    pooled.emplace_back(slips);
    run.slip.push_back(statistics_of(pooled.back(), run, level, levels[level], options));
  }
  if (plan.config.impact) {
    run.impact =
        impact_statistics({run.capacity.rows, run.capacity.columns, levels,
                           plan.config.thresholds_m, run.crossing_time_s, run.crossing_speed_mps},
                          options);
  }
  for (const Standard standard : plan.config.standards.compare) {
    for (std::size_t level = 0; level < levels.size(); ++level) {
      run.standards.push_back(
          compare(standard, levels[level], plan.config.standards, pooled[level], options));
    }
  }
  return run;
}

RecordSummary summarise(const Motion& motion, double factor_at_unit_level) {
  RecordSummary r;
  r.id = motion.id;
  r.event = motion.event;
  r.station = motion.station;
  r.magnitude = motion.magnitude;
  r.distance_km = motion.distance_km;
  r.vs30_mps = motion.vs30_mps;
  r.suite_scale = motion.scale;
  r.factor_at_unit_level = factor_at_unit_level;
  r.pga_g =
      horizontal_pga_mps2(motion, HorizontalCombination::geometric_mean) / standard_gravity_mps2;
  r.pgv_mps = horizontal_pgv_mps(motion, HorizontalCombination::geometric_mean);
  r.dt_s = motion.dt_s;
  r.samples = motion.horizontal_mps2[0].size();
  r.has_second = !motion.horizontal_mps2[1].empty();
  r.has_vertical = !motion.vertical_mps2.empty();
  return r;
}

/// At the level nearest S_DS = 1 g, of a chart at the one it shows, where the study is in sds_g;
/// else as the suite file scales it, beside its MCE target.
SuiteSpectra spectra_of(const Plan& plan) {
  const IntensityConfig& intensity = plan.config.intensity;
  const bool by_sds = intensity.measure == IntensityMeasure::sds_g;
  SuiteSpectra spectra;
  spectra.periods_s = shown_periods_s();
  if (by_sds && plan.config.chart) {
    spectra.reference_level = plan.config.chart->shown_level;
  } else if (by_sds) {
    spectra.reference_level =
        *std::min_element(intensity.levels.begin(), intensity.levels.end(),
                          [](double a, double b) { return std::abs(a - 1.0) < std::abs(b - 1.0); });
  }
  spectra.average_srss_g.assign(spectra.periods_s.size(), 0.0);
  for (std::size_t i = 0; i < plan.suite.motions.size(); ++i) {
    const Motion& motion = plan.suite.motions[i];
    const double factor =
        by_sds ? spectra.reference_level * plan.factor_at_unit_level[i] : motion.scale;
    std::vector<double> srss =
        horizontal_spectrum_mps2(motion, spectra.periods_s, HorizontalCombination::srss);
    for (std::size_t p = 0; p < srss.size(); ++p) {
      srss[p] *= factor / standard_gravity_mps2;
      spectra.average_srss_g[p] += srss[p] / static_cast<double>(plan.suite.motions.size());
    }
    spectra.srss_g.push_back(std::move(srss));
  }
  const std::optional<DesignTarget> target =
      intensity.target ? intensity.target : plan.suite.target;
  if (target) {
    const TargetSpectrum shape(*target);
    for (const double period : spectra.periods_s) {
      spectra.target_g.push_back(by_sds ? spectra.reference_level * shape.design_sa_g(period) /
                                              shape.sds_g()
                                        : shape.mce_sa_g(period));
    }
  }
  return spectra;
}

std::string percent(double share) {
  return share < 5e-4 ? "fewer than 0.1 %" : fmt::format("{:.1f} %", 100.0 * share);
}

/// Tipping is outside the model too: from which level, and how much of the study.
std::vector<std::string> notes_on_tipping(const Plan& plan, const Results& results) {
  std::vector<std::string> notes;
  if (!plan.config.base) return notes;
  const RigidBase& base = *plan.config.base;
  const std::string measure =
      results.intensity_label.substr(0, results.intensity_label.rfind(" ("));
  for (const RunResults& run : results.runs) {
    std::size_t first = 0;
    while (first < run.tips.depth && share_at(run.tips, first) == 0.0) ++first;
    const std::string body =
        fmt::format("{} friction: a body {:g} m wide with its centre of mass {:g} m above the roof",
                    run.label, base.width_m, base.centre_of_mass_height_m);
    const auto friction = std::max_element(
        plan.samples.begin(), plan.samples.end(),
        [](const SamplePoint& a, const SamplePoint& b) { return a.friction < b.friction; });
    const double rocking_friction = rocking_block({}, base).friction;
    if (friction->friction <= rocking_friction) {
      notes.push_back(
          fmt::format("Tipping, {} cannot tip: no friction is above {:.3g}, its width over twice "
                      "that height, so it slides first",
                      body, rocking_friction));
      continue;
    }
    if (first == run.tips.depth) {
      notes.push_back("Tipping, " + body + " does not begin to tip in any history");
      continue;
    }
    notes.push_back(fmt::format(
        "TIPPING, {} begins to tip in some histories, from {} = {:.3g} g on; at the highest level "
        "in {} of all. Tipping is outside "
        "the model: slip there is that of a body that does not tip",
        body, measure, results.levels[first], percent(share_at(run.tips, run.tips.depth - 1))));
  }
  return notes;
}

/// Uplift is outside the model: which records, from which level, and how much of the study.
std::vector<std::string> notes_on_uplift(const Results& results) {
  const char* table = results.chart ? "chart.csv" : "slip.csv";
  std::vector<std::string> notes;
  const std::string measure =
      results.intensity_label.substr(0, results.intensity_label.rfind(" ("));
  for (const RunResults& run : results.runs) {
    std::string names;
    std::size_t records = 0, first_level = results.levels.size();
    for (std::size_t record = 0; record < run.uplift.rows; ++record) {
      bool lifts = false;
      for (std::size_t sample = 0; sample < run.uplift.columns; ++sample) {
        for (std::size_t level = 0; level < run.uplift.depth; ++level) {
          if (run.uplift(record, sample, level) == 0) continue;
          lifts = true;
          first_level = std::min(first_level, level);
        }
      }
      if (!lifts) continue;
      ++records;
      if (records <= 8) names += (names.empty() ? "" : ", ") + results.records[record].id;
    }
    if (records == 0) continue;
    notes.push_back(fmt::format(
        "UPLIFT, {} friction: {} of {} records ({}{}) lift the array off its roof in some "
        "histories, from {} = {:.3g} g "
        "on; at the highest level {} of all histories do. Lift-off is outside the model: "
        "slip there is that of a block without friction while lifted (shares: tables/{})",
        run.label, records, run.uplift.rows, names, records > 8 ? ", ..." : "", measure,
        results.levels[first_level], percent(share_at(run.uplift, run.uplift.depth - 1)), table));
  }
  return notes;
}

/// Where the suite average touches the design spectrum, and how far above it lies elsewhere.
std::string note_on_suite(const SuiteSpectra& spectra) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0, at_least = 0.0, at_most = 0.0;
  for (std::size_t p = 0; p < spectra.periods_s.size() && spectra.periods_s[p] <= 2.0; ++p) {
    const double ratio = spectra.average_srss_g[p] / spectra.target_g[p];
    if (ratio < least) least = ratio, at_least = spectra.periods_s[p];
    if (ratio > most) most = ratio, at_most = spectra.periods_s[p];
  }
  return fmt::format(
      "The suite is scaled so that its average SRSS spectrum is nowhere below the design spectrum "
      "from 0 to 2 s: it "
      "touches it near {:.2g} s and lies up to {:.2g} times above it, at {:.2g} s",
      at_least, most, at_most);
}

}  // namespace

Results reduce(const Plan& plan, const std::vector<UnitResult>& units) {
  std::vector<const UnitResult*> in_order(plan.units.size(), nullptr);
  for (const UnitResult& unit : units) in_order.at(unit.unit) = &unit;
  if (std::find(in_order.begin(), in_order.end(), nullptr) != in_order.end()) {
    throw std::logic_error("reduce: a unit of the plan is missing");
  }

  Results results;
  results.study_name = plan.config.name;
  results.program_version = GLISSADE_VERSION;
  results.plan_hash = plan.hash;
  results.study_text = plan.config.source_text;
  results.seed = plan.config.seed;
  results.measure = plan.config.intensity.measure;
  results.intensity_label = intensity_label(plan.config.intensity);
  results.suite_name = plan.suite.name;
  results.suite_description = plan.suite.description;
  results.model = model_text(plan);
  results.levels = plan.config.intensity.levels;
  results.thresholds_m = plan.config.thresholds_m;
  results.samples = plan.samples;
  for (std::size_t i = 0; i < plan.suite.motions.size(); ++i) {
    results.records.push_back(summarise(plan.suite.motions[i], plan.factor_at_unit_level[i]));
  }
  results.spectra = spectra_of(plan);
  for (std::size_t run = 0; run < plan.runs.size(); ++run)
    results.runs.push_back(reduce_run(plan, in_order, run));
  if (plan.config.chart) results.chart = make_chart(plan, results.runs.front());
  results.notes = plan.notes;
  for (std::string& note : notes_on_uplift(results)) results.notes.push_back(std::move(note));
  for (std::string& note : notes_on_tipping(plan, results))
    results.notes.push_back(std::move(note));
  if (results.measure == IntensityMeasure::sds_g)
    results.notes.push_back(note_on_suite(results.spectra));
  return results;
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
  add("histories whose roof peak stays in the stick range",
      "they cannot slip: zero without integration", count.held);
  const std::uint64_t integrated = count.integrated + count.searched;
  add("roof motions, beside those made",
      "one serves every intensity, friction and slope on its record, period and damping",
      integrated - std::min(count.roofs, integrated));
  add("histories on a flat roof without vertical",
      "their point of the record's curve slip / lambda = F(mu / lambda) was known",
      count.from_curve);
  add("histories above the level that reaches the largest threshold",
      "[clearance] stop_at_largest = true", count.beyond);
  add("searches for a capacity", "the levels decide: not reached, or reached without shaking",
      count.decided);
  return skips;
}

}  // namespace glissade
