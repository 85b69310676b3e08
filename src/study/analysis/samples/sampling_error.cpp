// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/sampling_error.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

constexpr double width_of_95_percent = 3.92;  // standard errors

/// ln median of the fit on the capacities of the samples that are in a block; NaN: no fit.
double log_median(const Results& results, const RunResults& run, std::size_t threshold,
                  const StudyConfig& config, std::uint64_t block) {
  CapacitySample sample;
  sample.censored_at = results.levels.back();
  const std::uint64_t samples = config.sampling.samples, size = samples / config.sampling.scrambles;
  for (std::size_t record = 0; record < results.records.size(); ++record) {
    for (std::size_t i = 0; i < run.cases; ++i) {
      if (i / results.cases.orientations % samples / size != block) continue;
      const double capacity = results.histories.capacity(record, run.first_case + i, threshold);
      if (std::isinf(capacity)) {
        sample.censored += 1.0;
      } else if (capacity == 0.0) {
        sample.free += 1.0;
      } else {
        sample.capacities.push_back(capacity);
      }
    }
  }
  const FitSummary fit = fit_capacities(sample);
  return fit.converged() ? std::log(fit.curve.median) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<SamplingErrorRow> sampling_error_rows(const StudyConfig& config,
                                                  const Results& results) {
  std::vector<SamplingErrorRow> rows;
  const std::uint64_t blocks = config.sampling.scrambles;
  if (blocks < 2 || !config.draws()) return rows;
  for (const RunResults& run : results.runs) {
    for (std::size_t t = 0; t < run.fragilities.size(); ++t) {
      std::vector<double> medians;
      for (std::uint64_t block = 0; block < blocks; ++block)
        medians.push_back(log_median(results, run, t, config, block));
      const double count = static_cast<double>(blocks),
                   mean = std::accumulate(medians.begin(), medians.end(), 0.0) / count;
      double spread = 0.0;
      for (const double m : medians) spread += (m - mean) * (m - mean);
      const FitSummary& fit = run.fragilities[t].capacities;
      rows.push_back(
          {run.label, run.fragilities[t].threshold_m, fit.curve.median,
           std::log(fit.median_interval.high / fit.median_interval.low) / width_of_95_percent,
           std::sqrt(spread / (count * (count - 1.0)))});
    }
  }
  return rows;
}

}  // namespace glissade
