// SPDX-License-Identifier: GPL-3.0-or-later
#include "fragility_error.hpp"

#include <algorithm>
#include <atomic>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <thread>

#include "glissade/io/suite_file.hpp"
#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/execute.hpp"
#include "glissade/study/run/reduce.hpp"
#include "timing.hpp"

namespace glissade::bench {
namespace {

constexpr const char* study_sentence =
    "Peak slip of 0.3 m over PGA, the two shortest built-in motions (component and sign by chance, "
    "no vertical), mu normal 0.55 +- 0.04, slope uniform 0 to 5 degrees, period uniform 0.2 to 2 s";

StudyConfig study(SamplingMethod method, std::uint64_t seed, int log2_samples) {
  StudyConfig config;
  config.model.axes = SlidingAxes::one;
  config.name = "run time against error";
  config.seed = seed;
  config.intensity.measure = *IntensityMeasure::named("pga_g");
  config.intensity.levels = {0.4, 0.8, 1.2, 1.6, 2.0};
  config.suite_files = {"synthetic_level2.toml"};
  config.quantities.at("building", "period_s") = {{}, Uniform{0.2, 2.0}};
  config.quantities.at("roof", "slope_deg") = {{}, Uniform{0.0, 5.0}};
  config.quantities.at("friction", "mu") = {
      {}, TruncatedNormal{0.55, 0.04, 0.0, std::numeric_limits<double>::infinity()}};
  config.friction.values = {FrictionValue::as_drawn};
  config.vertical = {VerticalChoice::none};
  config.sampling = {.method = method,
                     .samples = std::uint64_t{1} << log2_samples,
                     .bootstrap_replicates = 100};  // the fewest; its intervals are not looked at
  config.fragility = FragilityConfig{.thresholds_m = {0.3}};
  return config;
}

/// One study: what it gave and took.
struct Outcome {
  double histories_s = 0.0, fit_s = 0.0;
  bool converged = false;
  double median = 0.0, log_std = 0.0;
};

/// The studies of 2^least, ..., 2^most samples by one seed.
std::vector<Outcome> replicate(const Suite& suite, SamplingMethod method, std::uint64_t seed,
                               const FragilityErrorOptions& options) {
  std::vector<Outcome> outcomes;
  for (int log2_samples = options.least_log2; log2_samples <= options.most_log2; ++log2_samples) {
    Outcome outcome;
    auto start = core_seconds();
    const Plan plan = make_plan(study(method, seed, log2_samples), {suite});
    std::vector<UnitResult> units;
    for (std::size_t unit = 0; unit < plan.units.size(); ++unit)
      units.push_back(execute(plan, unit));
    outcome.histories_s = core_seconds() - start;
    start = core_seconds();
    const Results results = reduce(plan, units);
    outcome.fit_s = core_seconds() - start;
    const FitSummary& fit = results.runs[0].fragilities[0].capacities;
    outcome.converged = fit.converged();
    outcome.median = fit.curve.median;
    outcome.log_std = fit.curve.log_std;
    outcomes.push_back(outcome);
  }
  return outcomes;
}

/// [replicate][number of samples]
using Replicates = std::vector<std::vector<Outcome>>;

Replicates replicates_of(const Suite& suite, SamplingMethod method,
                         const FragilityErrorOptions& options) {
  Replicates all(static_cast<std::size_t>(options.replicates));
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < all.size(); i = next++)
      all[i] = replicate(suite, method, 1000 + i, options);
  };
  std::vector<std::thread> threads;
  for (int t = 1; t < options.threads; ++t) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return all;
}

/// Mean and relative standard error of a quantity over converged outcomes.
struct Mean {
  double value = 0.0, uncertainty = 0.0;
};

Mean mean_of(const Replicates& replicates, double Outcome::*quantity) {
  std::vector<double> values;
  for (const std::vector<Outcome>& outcomes : replicates)
    if (outcomes.back().converged) values.push_back(outcomes.back().*quantity);
  const double n = static_cast<double>(values.size()), average = mean(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - average) * (value - average);
  return {average, std::sqrt(squares / (n - 1) / n) / average};
}

/// @param degrees_of_freedom of `errors`: one less than there are where the truth is their own mean
RmsError rms_error(const std::vector<double>& errors, std::size_t degrees_of_freedom) {
  double squares = 0.0;
  for (const double error : errors) squares += error * error;
  const double n = static_cast<double>(degrees_of_freedom);
  const boost::math::chi_squared distribution(n);
  return {std::sqrt(squares / n),
          std::sqrt(squares / boost::math::quantile(complement(distribution, 0.025))),
          std::sqrt(squares / boost::math::quantile(distribution, 0.025))};
}

void add_rows(const Replicates& replicates, SamplingMethod method,
              const FragilityErrorOptions& options, FragilityError& result) {
  for (int log2_samples = options.least_log2; log2_samples <= options.most_log2; ++log2_samples) {
    FragilityErrorRow row{.method = method, .log2_samples = log2_samples};
    std::vector<double> histories_s, fit_s, median_errors, log_std_errors;
    for (const std::vector<Outcome>& outcomes : replicates) {
      const Outcome& o = outcomes[static_cast<std::size_t>(log2_samples - options.least_log2)];
      histories_s.push_back(o.histories_s);
      fit_s.push_back(o.fit_s);
      if (!o.converged) continue;
      median_errors.push_back(o.median / result.median_pga_g - 1.0);
      log_std_errors.push_back(o.log_std / result.log_std - 1.0);
    }
    row.histories_s = median(histories_s);
    row.fit_s = median(fit_s);
    row.fitted = static_cast<int>(median_errors.size());
    const bool makes_the_truth =
        method == SamplingMethod::sobol && log2_samples == options.most_log2;
    const std::size_t freedom = median_errors.size() - (makes_the_truth ? 1 : 0);
    row.median = rms_error(median_errors, freedom);
    row.log_std = rms_error(log_std_errors, freedom);
    result.rows.push_back(row);
  }
}

}  // namespace

FragilityError fragility_error(const std::filesystem::path& suites,
                               const FragilityErrorOptions& options) {
  Suite suite = load_suite(suites / "synthetic_level2.toml");
  std::ranges::stable_sort(suite.motions, {},
                           [](const Motion& motion) { return motion.horizontal_mps2[0].size(); });
  suite.motions.resize(2);
  const Replicates plain = replicates_of(suite, SamplingMethod::monte_carlo, options);
  const Replicates sobol = replicates_of(suite, SamplingMethod::sobol, options);

  const Mean median = mean_of(sobol, &Outcome::median), log_std = mean_of(sobol, &Outcome::log_std);
  FragilityError result{.study = study_sentence,
                        .median_pga_g = median.value,
                        .log_std = log_std.value,
                        .median_uncertainty = median.uncertainty,
                        .log_std_uncertainty = log_std.uncertainty};
  add_rows(plain, SamplingMethod::monte_carlo, options, result);
  add_rows(sobol, SamplingMethod::sobol, options, result);
  return result;
}

}  // namespace glissade::bench
