// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "max_pass.hpp"
#include "timing.hpp"

namespace glissade::bench {
namespace {

constexpr double shown_samples = 8000.0;

/// What reading the clock twice costs by itself: taken off every time measured.
double reading_seconds() {
  std::vector<double> readings(1001);
  for (double& reading : readings) {
    const double start_s = core_seconds();
    reading = core_seconds() - start_s;
  }
  return median(readings);
}

void judge(const TrialBatch& batch, const std::vector<double>& peaks_m, SchemeResult& result,
           std::vector<double>& errors) {
  for (std::size_t i = 0; i < batch.truth_m.size(); ++i) {
    errors.push_back(std::abs(peaks_m[i] / batch.truth_m[i] - 1.0));
    if (!result.worst_scene.empty() && errors.back() <= result.largest_error) continue;
    result.largest_error = errors.back();
    result.worst_scene = batch.scenes[i];
  }
}

}  // namespace

BatchScheme one_pass(std::span<const TrialBatch> batches) {
  return {.family = "one maximum-pass",
          .label = max_pass_target(),
          .peaks_m =
              [batches](std::size_t b) {
                std::vector<double> largest(batches[b].truth_m.size());
                for (double& value : largest) value = max_pass(batches[b].samples);
                return largest;
              },
          .problem = Problem::none};
}

std::vector<SchemeResult> run_trial(std::span<const TrialBatch> batches,
                                    const std::vector<BatchScheme>& schemes, std::size_t rounds) {
  const double reading_s = reading_seconds();
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector microseconds(schemes.size(), std::vector(batches.size(), never));
  std::vector<std::vector<double>> errors(schemes.size());
  std::vector<SchemeResult> results;
  for (const BatchScheme& scheme : schemes)
    results.push_back({.family = scheme.family, .label = scheme.label, .problem = scheme.problem});
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t b = 0; b < batches.size(); ++b) {
      const TrialBatch& batch = batches[b];
      const double histories = static_cast<double>(batch.truth_m.size());
      const double share = shown_samples / static_cast<double>(batch.samples.size()) / histories;
      max_pass(batch.samples);  // into the cache, so that nobody pays for it
      for (std::size_t s = 0; s < schemes.size(); ++s) {
        const double start_s = core_seconds();
        const std::vector<double> peaks_m = schemes[s].peaks_m(b);
        const double time_us = 1e6 * share * (core_seconds() - start_s - reading_s);
        microseconds[s][b] = std::min(microseconds[s][b], time_us);
        if (round == 0 && schemes[s].problem != Problem::none)
          judge(batch, peaks_m, results[s], errors[s]);
      }
    }
  }
  std::size_t histories = 0;
  for (const TrialBatch& batch : batches) histories += batch.truth_m.size();
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    results[s].sliding = {histories, median(microseconds[s]), mean(microseconds[s])};
    results[s].judged = errors[s].size();
    results[s].median_error = median(errors[s]);
  }
  return results;
}

std::vector<std::size_t> scattered(std::size_t count, std::size_t start) {
  std::size_t stride = std::max<std::size_t>(count * 618 / 1000, 1);
  while (std::gcd(stride, count) != 1) ++stride;
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = (start + i * stride) % count;
  return order;
}

}  // namespace glissade::bench
