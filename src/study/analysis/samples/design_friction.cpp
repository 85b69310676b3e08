// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/samples/design_friction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/pooled_level.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/jackknife.hpp"
#include "glissade/fragility/bootstrap.hpp"
#include "glissade/fragility/share.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// The same cases with drawn and with design friction.
struct FrictionPair {
  std::size_t drawn = 0, design = 0, count = 0;  ///< first cases, and how many
  std::size_t samples = 0;  ///< of each pick-freeze matrix: cases this far apart share draws
};

/// Samples that the jackknife leaves out.
struct OmittedSamples {
  std::size_t first = 0, end = 0;
  bool has(std::size_t k) const { return k >= first && k < end; }
};

double weighted_mean(const std::vector<double>& of_record, const std::vector<double>& weights) {
  return std::inner_product(of_record.begin(), of_record.end(), weights.begin(), 0.0) /
         std::accumulate(weights.begin(), weights.end(), 0.0);
}

class PairAtLevel {
 public:
  PairAtLevel(const Results& results, const FrictionPair& pair, std::size_t level,
              const OmittedSamples& omitted = {}) {
    const HistoryTable& table = results.histories;
    for (std::size_t record = 0; record < table.records; ++record) {
      double above = 0.0, sum = 0.0;
      std::vector<double>& slips = drawn_m_.emplace_back();
      for (std::size_t i = 0; i < pair.count; ++i) {
        if (omitted.has(i % pair.samples)) continue;
        const double drawn = table.displacement_m(record, pair.drawn + i, level),
                     design = table.displacement_m(record, pair.design + i, level);
        above += drawn > design ? 1.0 : 0.0;
        sum += design;
        slips.push_back(drawn);
      }
      std::ranges::sort(slips);
      const double count = static_cast<double>(slips.size());
      same_motion_.push_back(above / count);
      design_mean_m_.push_back(sum / count);
    }
  }

  double same_motion(const std::vector<double>& weights) const {
    return weighted_mean(same_motion_, weights);
  }
  double design_mean_m(const std::vector<double>& weights) const {
    return weighted_mean(design_mean_m_, weights);
  }
  double above_mean(const std::vector<double>& weights) const {
    const double mean_m = design_mean_m(weights);
    std::vector<double> shares;
    for (const std::vector<double>& slips : drawn_m_) {
      const auto above = slips.end() - std::ranges::upper_bound(slips, mean_m);
      shares.push_back(static_cast<double>(above) / static_cast<double>(slips.size()));
    }
    return weighted_mean(shares, weights);
  }

 private:
  std::vector<double> same_motion_, design_mean_m_;
  std::vector<std::vector<double>> drawn_m_;  ///< sorted
};

constexpr std::size_t most_groups = 16;

struct SampleErrors {
  double same_motion, above_mean;
};

/// Standard errors of both probabilities from the samples, on these records: jackknife over groups
/// of samples (Efron & Stein 1981). NaN of one sample.
SampleErrors sample_errors(const Results& results, const FrictionPair& pair, std::size_t level) {
  const std::size_t groups = std::min(most_groups, pair.samples);
  if (groups < 2) return {nan, nan};
  const std::vector<double> once(results.records.size(), 1.0);
  std::vector<double> same_motion, above_mean;
  for (std::size_t g = 0; g < groups; ++g) {
    const PairAtLevel at(results, pair, level,
                         {g * pair.samples / groups, (g + 1) * pair.samples / groups});
    same_motion.push_back(at.same_motion(once));
    above_mean.push_back(at.above_mean(once));
  }
  return {std::sqrt(jackknife_variance(same_motion)), std::sqrt(jackknife_variance(above_mean))};
}

/// An interval over records with the error of the samples added, which all records share.
Interval with_samples(const Interval& records, double probability, double error,
                      std::size_t groups) {
  if (std::isnan(error)) return records;
  const double half = student_quantile(static_cast<double>(groups) - 1.0, 0.975) * error;
  return {std::max(0.0, probability - std::hypot(probability - records.low, half)),
          std::min(1.0, probability + std::hypot(records.high - probability, half))};
}

DesignFrictionRow row_of(const Results& results, const FrictionPair& pair, std::size_t level,
                         const BootstrapOptions& options) {
  const PairAtLevel at(results, pair, level);
  const std::vector<double> once(results.records.size(), 1.0);
  DesignFrictionRow row{
      .first_case = pair.drawn,
      .condition = results.cases.describe(pair.drawn / pair.count, {"friction.value"}),
      .level = results.levels[level],
      .same_motion = {at.same_motion(once), {}},
      .design_mean_m = at.design_mean_m(once),
      .above_mean = {at.above_mean(once), {}}};
  const std::size_t units = results.histories.units();
  const double effective = effective_units(results);
  const std::vector<Interval> intervals = bootstrap_intervals(
      units, 2,
      [&](const std::vector<double>& of_units) {
        const std::vector<double> weights = results.histories.record_weights(of_units);
        return std::vector{at.same_motion(weights), at.above_mean(weights)};
      },
      options);
  // Every record has a part of it, so that their spread shows its error, but where none has.
  const double same_motion = row.same_motion.value, above_mean = row.above_mean.value;
  const bool shows = same_motion > 0.0 && same_motion < 1.0;
  const SampleErrors errors = sample_errors(results, pair, level);
  const std::size_t groups = std::min(most_groups, pair.samples);
  row.same_motion_error = errors.same_motion;
  row.above_mean_error = errors.above_mean;
  row.same_motion.interval =
      with_samples(shows ? intervals[0] : widened(intervals[0], same_motion, effective),
                   same_motion, errors.same_motion, groups);
  row.above_mean.interval = with_samples(widened(intervals[1], above_mean, effective), above_mean,
                                         errors.above_mean, groups);
  return row;
}

}  // namespace

std::vector<DesignFrictionRow> design_friction_rows(const StudyConfig& config,
                                                    const Results& results) {
  const CaseSet& set = results.cases;
  const std::size_t axis = set.axis("friction.value");
  std::vector<DesignFrictionRow> rows;
  if (axis == set.axes.size()) return rows;
  const BootstrapOptions options{.seed = config.seed,
                                 .replicates = config.sampling.bootstrap_replicates};
  for (const RunResults& run : results.runs) {
    if (set.cases[run.first_case].friction_value != FrictionValue::as_drawn) continue;
    std::vector<std::size_t> places = set.places(run.first_case / run.cases);
    places[axis] = 1 - places[axis];
    const FrictionPair pair{run.first_case, set.combination(places) * run.cases, run.cases,
                            config.draws() ? config.sampling.samples : 1};
    for (std::size_t level = 0; level < results.levels.size(); ++level)
      rows.push_back(row_of(results, pair, level, options));
  }
  return rows;
}

}  // namespace glissade
