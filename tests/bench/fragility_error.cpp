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
    "Peak slip of 0.3 m over PGA at five levels, seven built-in motions (component and sign by "
    "chance, no vertical), mu normal 0.55 +- 0.04, slope uniform 0 to 5 degrees, period uniform "
    "0.2 to 2 s";

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

struct Fit {
  bool converged = false;
  double median = 0.0, log_std = 0.0;

  explicit Fit(const FitSummary& summary)
      : converged(summary.converged()),
        median(summary.curve.median),
        log_std(summary.curve.log_std) {}
};

/// One study: what it gave and took.
struct Outcome {
  double histories_s, fit_s;
  double at_levels, searched;  // histories
  Fit counts, capacities;

  const Fit& fit(FittedOn fitted_on) const {
    return fitted_on == FittedOn::counts ? counts : capacities;
  }
};

/// The studies of 2^least, ..., 2^most samples by one seed.
std::vector<Outcome> replicate(const Suite& suite, SamplingMethod method, std::uint64_t seed,
                               const FragilityErrorOptions& options) {
  std::vector<Outcome> outcomes;
  for (int log2_samples = options.least_log2; log2_samples <= options.most_log2; ++log2_samples) {
    auto start = core_seconds();
    const Plan plan = make_plan(study(method, seed, log2_samples), {suite});
    std::vector<UnitResult> units;
    for (std::size_t unit = 0; unit < plan.units.size(); ++unit)
      units.push_back(execute(plan, unit));
    const double histories_s = core_seconds() - start;
    start = core_seconds();
    const Results results = reduce(plan, units);
    const double fit_s = core_seconds() - start;
    std::uint64_t searched = 0;
    for (const UnitResult& unit : units) searched += unit.count.searched;
    const ThresholdFragility& found = results.runs[0].fragilities[0];
    outcomes.push_back({histories_s, fit_s, static_cast<double>(plan.histories()),
                        static_cast<double>(searched), Fit(found.stripes), Fit(found.capacities)});
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

/// Mean and relative standard error.
struct Mean {
  double value = 0.0, uncertainty = 0.0;

  explicit Mean(const std::vector<double>& values) : value(mean(values)) {
    const double n = static_cast<double>(values.size());
    double squares = 0.0;
    for (const double one : values) squares += (one - value) * (one - value);
    uncertainty = std::sqrt(squares / (n - 1) / n) / value;
  }
};

FragilityTruth truth_of(const Replicates& sobol, FittedOn fitted_on) {
  std::vector<double> medians, log_stds;
  for (const std::vector<Outcome>& outcomes : sobol) {
    const Fit& fit = outcomes.back().fit(fitted_on);
    if (!fit.converged) continue;
    medians.push_back(fit.median);
    log_stds.push_back(fit.log_std);
  }
  const Mean median(medians), log_std(log_stds);
  return {median.value, log_std.value, median.uncertainty, log_std.uncertainty};
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

void add_rows(const Replicates& replicates, const Estimator& estimator,
              const FragilityErrorOptions& options, const FragilityTruth& truth,
              FragilityError& result) {
  const bool searches = estimator.fitted_on == FittedOn::capacities;
  for (int log2_samples = options.least_log2; log2_samples <= options.most_log2; ++log2_samples) {
    FragilityErrorRow row{.estimator = estimator, .log2_samples = log2_samples};
    std::vector<double> histories, histories_s, fit_s, median_errors, log_std_errors;
    for (const std::vector<Outcome>& outcomes : replicates) {
      const Outcome& o = outcomes[static_cast<std::size_t>(log2_samples - options.least_log2)];
      histories.push_back(o.at_levels + (searches ? o.searched : 0.0));
      histories_s.push_back(o.histories_s);
      fit_s.push_back(o.fit_s);
      const Fit& fit = o.fit(estimator.fitted_on);
      if (!fit.converged) continue;
      median_errors.push_back(fit.median / truth.median_pga_g - 1.0);
      log_std_errors.push_back(fit.log_std / truth.log_std - 1.0);
    }
    row.histories = median(histories);
    row.histories_s = median(histories_s);
    row.fit_s = median(fit_s);
    row.fitted = static_cast<int>(median_errors.size());
    const bool makes_the_truth =
        estimator.method == SamplingMethod::sobol && log2_samples == options.most_log2;
    const std::size_t freedom = median_errors.size() - (makes_the_truth ? 1 : 0);
    row.median = rms_error(median_errors, freedom);
    row.log_std = rms_error(log_std_errors, freedom);
    result.rows.push_back(row);
  }
}

}  // namespace

std::string Estimator::name() const {
  return std::string(method == SamplingMethod::sobol ? "Sobol" : "Monte Carlo") +
         (fitted_on == FittedOn::counts ? ", counts" : ", capacities");
}

std::vector<Estimator> estimators() {
  return {{SamplingMethod::monte_carlo, FittedOn::counts},
          {SamplingMethod::monte_carlo, FittedOn::capacities},
          {SamplingMethod::sobol, FittedOn::capacities}};
}

std::vector<FragilityErrorRow> rows_of(const FragilityError& measured, const Estimator& estimator) {
  std::vector<FragilityErrorRow> rows;
  std::ranges::copy_if(measured.rows, std::back_inserter(rows),
                       [&](const FragilityErrorRow& row) { return row.estimator == estimator; });
  return rows;
}

double histories_for(const std::vector<FragilityErrorRow>& rows, double error) {
  const auto below = std::ranges::find_if(
      rows, [&](const FragilityErrorRow& row) { return row.median.rms <= error; });
  if (below == rows.end()) return std::numeric_limits<double>::quiet_NaN();
  if (below == rows.begin()) return below->histories;
  const FragilityErrorRow& above = *std::prev(below);
  const double share =
      std::log(above.median.rms / error) / std::log(above.median.rms / below->median.rms);
  return above.histories * std::pow(below->histories / above.histories, share);
}

FragilityError fragility_error(const std::filesystem::path& suites,
                               const FragilityErrorOptions& options) {
  const Suite suite = load_suite(suites / "synthetic_level2.toml");
  const Replicates plain = replicates_of(suite, SamplingMethod::monte_carlo, options);
  const Replicates sobol = replicates_of(suite, SamplingMethod::sobol, options);
  FragilityError result{.study = study_sentence,
                        .of_counts = truth_of(sobol, FittedOn::counts),
                        .of_capacities = truth_of(sobol, FittedOn::capacities)};
  for (const Estimator& estimator : estimators())
    add_rows(estimator.method == SamplingMethod::sobol ? sobol : plain, estimator, options,
             estimator.fitted_on == FittedOn::counts ? result.of_counts : result.of_capacities,
             result);
  return result;
}

}  // namespace glissade::bench
