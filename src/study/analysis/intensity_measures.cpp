// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/intensity_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "glissade/core/finite.hpp"
#include "glissade/fragility/record_regression.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// Fewer records, or units, say nothing about a dispersion.
constexpr std::size_t fewest_records = 5;

/// ln of a measure of the record as recorded, by (record, case). Of one that goes with a power of
/// the motion, of its root.
struct Measure {
  std::string name;
  std::function<double(std::size_t record, std::size_t c)> log_value;
  bool scales = true;  ///< with the factor on the record: a duration does not
};

/// Linear in the logarithms between the periods of the spectra.
double at_period(const std::vector<double>& periods_s, const std::vector<double>& spectrum,
                 double period_s) {
  if (period_s <= periods_s.front()) return std::log(spectrum.front());
  const auto above = std::ranges::lower_bound(periods_s, period_s);
  if (above == periods_s.end()) return std::log(spectrum.back());
  const auto i = static_cast<std::size_t>(above - periods_s.begin());
  const double low = periods_s[i - 1], high = periods_s[i];
  const double part =
      low > 0.0 ? std::log(period_s / low) / std::log(high / low) : (period_s - low) / (high - low);
  return std::lerp(std::log(spectrum[i - 1]), std::log(spectrum[i]), part);
}

class Measures {
 public:
  Measures(const StudyConfig& config, const Results& results) : results_(results) {
    const std::vector<RecordSummary>& records = results.records;
    if (results.measure == IntensityMeasure::sds_g ||
        results.measure == IntensityMeasure::mce_fraction)
      add(results.measure.symbol(config.intensity),
          [&](std::size_t r, std::size_t) { return -std::log(records[r].factor_at_unit_level); });
    add("PGA", [&](std::size_t r, std::size_t) { return std::log(records[r].pga_g); });
    add("PGV", [&](std::size_t r, std::size_t) { return std::log(records[r].pgv_mps); });
    add("PGD", [&](std::size_t r, std::size_t) { return std::log(records[r].pgd_m); });
    if (!std::isnan(records.front().arias_mps))
      add("Arias intensity",
          [&](std::size_t r, std::size_t) { return 0.5 * std::log(records[r].arias_mps); });
    if (!results.record_periods_s.empty()) add_spectral(*config.intensity_measures);
    all_.push_back({"D5-95",
                    [&](std::size_t r, std::size_t) { return std::log(records[r].duration_s); },
                    false});
  }

  const std::vector<Measure>& all() const { return all_; }
  const Measure* named(const std::string& name) const {
    const auto at = std::ranges::find(all_, name, &Measure::name);
    return at == all_.end() ? nullptr : &*at;
  }

 private:
  void add(std::string name, std::function<double(std::size_t, std::size_t)> log_value) {
    all_.push_back({std::move(name), std::move(log_value)});
  }
  double log_sa(std::size_t record, double period_s) const {
    return at_period(results_.record_periods_s, results_.records[record].sa_g, period_s);
  }
  void add_spectral(const IntensityMeasuresConfig& config) {
    const std::vector<double> periods_s = config.sa_periods_s;
    for (const double period_s : periods_s)
      add(fmt::format("Sa({:g} s)", period_s),
          [this, period_s](std::size_t r, std::size_t) { return log_sa(r, period_s); });
    add("average Sa", [this, periods_s](std::size_t r, std::size_t) {
      double sum = 0.0;
      for (const double period_s : periods_s) sum += log_sa(r, period_s);
      return sum / static_cast<double>(periods_s.size());
    });
    const std::vector<Case>& cases = results_.cases.cases;
    if (std::ranges::none_of(cases, [](const Case& c) { return c.period_s > 0.0; })) return;
    add("roof acceleration",
        [this, &cases](std::size_t r, std::size_t c) { return log_sa(r, cases[c].period_s); });
    add("roof velocity", [this, &cases](std::size_t r, std::size_t c) {
      return at_period(results_.record_periods_s, results_.records[r].roof_velocity_mps,
                       cases[c].period_s);
    });
  }

  const Results& results_;
  std::vector<Measure> all_;
};

/// The median of a record's samples; those that are censored are the highest.
struct SampleValue {
  double value;
  bool censored;
};
SampleValue median_of(std::vector<SampleValue>& samples) {
  const auto less = [](const SampleValue& a, const SampleValue& b) {
    return a.censored != b.censored ? b.censored : a.value < b.value;
  };
  std::ranges::sort(samples, less);
  const SampleValue &low = samples[(samples.size() - 1) / 2], &high = samples[samples.size() / 2];
  if (!high.censored) return {0.5 * (low.value + high.value), false};
  // Above the bound that half of the samples pass at the least.
  double bound = infinity;
  for (const SampleValue& s : samples)
    if (s.censored) bound = std::min(bound, s.value);
  return {bound, true};
}

struct Ranking {
  const Results& results;
  const RunResults& run;
  std::size_t threshold;

  /// ln of the factor on the record at which a history reaches the threshold.
  SampleValue log_factor(std::size_t record, std::size_t c) const {
    const double capacity = results.histories.capacity(record, c, threshold);
    const bool censored = std::isinf(capacity);
    const double level = censored ? results.levels.back() : capacity;
    return {std::log(results.records[record].factor_at_unit_level *
                     results.measure.factor_of_level(level)),
            censored};
  }
  template <class Value>
  RecordRegression regression(Value value) const {
    RecordRegression data{.unit_of = results.histories.unit_of};
    for (std::size_t record = 0; record < results.records.size(); ++record) {
      std::vector<SampleValue> samples;
      for (std::size_t i = 0; i < run.cases; ++i)
        samples.push_back(value(record, run.first_case + i));
      const SampleValue median = median_of(samples);
      data.value.push_back(median.value);
      data.censored.push_back(median.censored);
    }
    return data;
  }
  RecordRegression of(const Measure& measure) const {
    return regression([&](std::size_t record, std::size_t c) {
      const SampleValue factor = log_factor(record, c);
      return SampleValue{factor.value + measure.log_value(record, c), factor.censored};
    });
  }
  /// The capacity in the first measure, given the ratio of the second to it.
  RecordRegression of(const Measure& first, const Measure& second) const {
    RecordRegression data = of(first);
    data.covariates.push_back(regression([&](std::size_t record, std::size_t c) {
                                return SampleValue{
                                    second.log_value(record, c) -
                                        (second.scales ? first.log_value(record, c) : 0.0),
                                    false};
                              }).value);
    return data;
  }
};

bool can_be_ranked(const RecordRegression& data) {
  const auto censored = static_cast<std::size_t>(std::ranges::count(data.censored, true));
  const auto is_finite = [](const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
  };
  return data.units() >= fewest_records && 2 * censored < data.records() && is_finite(data.value) &&
         std::ranges::all_of(data.covariates, is_finite);
}

/// Over the records that have it.
SlopeTest slope_on(const RecordRegression& data, const std::vector<double>& values) {
  RecordRegression known;
  known.covariates.resize(data.covariates.size());
  std::vector<double> covariate;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    known.value.push_back(data.value[i]);
    known.censored.push_back(data.censored[i]);
    for (std::size_t c = 0; c < data.covariates.size(); ++c)
      known.covariates[c].push_back(data.covariates[c][i]);
    covariate.push_back(values[i]);
  }
  if (covariate.size() < fewest_records)
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  return test_slope(known, covariate);
}

std::vector<RankedMeasure> rank(const Measures& measures, const Ranking& ranking,
                                const BootstrapOptions& options) {
  std::vector<RankedMeasure> rows;
  std::vector<RecordRegression> data;
  const auto add = [&](const std::string& name, RecordRegression regression) {
    if (!can_be_ranked(regression)) return;
    RankedMeasure& row = rows.emplace_back();
    row.name = name;
    row.pair = regression.covariates.size();
    row.censored_records =
        static_cast<std::uint64_t>(std::ranges::count(regression.censored, true));
    data.push_back(std::move(regression));
  };
  for (const Measure& measure : measures.all())
    if (measure.scales) add(measure.name, ranking.of(measure));
  for (const auto& [first, second] :
       {std::pair("PGA", "PGV"), std::pair("PGA", "D5-95"), std::pair("PGV", "PGD"),
        std::pair("PGV", "D5-95"), std::pair("roof acceleration", "PGV"),
        std::pair("roof velocity", "D5-95")}) {
    const Measure *a = measures.named(first), *b = measures.named(second);
    if (a != nullptr && b != nullptr)
      add(std::string(first) + " and " + second, ranking.of(*a, *b));
  }
  if (rows.empty()) return rows;
  std::vector<double> magnitude, log_distance;
  for (const RecordSummary& record : ranking.results.records) {
    magnitude.push_back(record.magnitude > 0.0 ? record.magnitude : infinity);
    log_distance.push_back(record.distance_km > 0.0 ? std::log(record.distance_km) : infinity);
  }
  const std::vector<RecordDispersion> found = record_dispersions(data, options);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].dispersion = {found[i].std, found[i].interval};
    rows[i].smallest_share = found[i].smallest_share;
    const SlopeTest on_magnitude = slope_on(data[i], magnitude),
                    on_distance = slope_on(data[i], log_distance);
    rows[i].magnitude_slope = on_magnitude.slope;
    rows[i].magnitude_p = on_magnitude.p_value;
    rows[i].distance_slope = on_distance.slope;
    rows[i].distance_p = on_distance.p_value;
  }
  std::ranges::stable_sort(rows, {}, [](const RankedMeasure& row) { return row.dispersion.value; });
  return rows;
}

}  // namespace

std::vector<RankedMeasure> IntensityMeasuresAnalysis::find(const StudyConfig& config,
                                                           const Results& results) {
  const BootstrapOptions options{.seed = config.seed,
                                 .replicates = config.sampling.bootstrap_replicates};
  const Measures measures(config, results);
  std::vector<RankedMeasure> all;
  for (std::size_t run = 0; run < results.runs.size(); ++run) {
    for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
      for (RankedMeasure& row : rank(measures, {results, results.runs[run], t}, options)) {
        row.run = run;
        row.threshold_m = results.thresholds_m[t];
        all.push_back(std::move(row));
      }
    }
  }
  return all;
}

}  // namespace glissade
