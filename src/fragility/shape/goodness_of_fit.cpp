// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/goodness_of_fit.hpp"

#include <algorithm>
#include <boost/math/special_functions/owens_t.hpp>
#include <cmath>
#include <cstdint>
#include <map>

#include "glissade/core/contract.hpp"
#include "glissade/core/independent_units.hpp"
#include "glissade/core/normal.hpp"
#include "glissade/core/random.hpp"
#include "glissade/core/root.hpp"
#include "lognormal/point_fit.hpp"

namespace glissade {
namespace {

using namespace fragility;

/// Capacities of all records as y = ln x - center, in rising order, and those censored.
struct PooledCapacities {
  std::vector<double> y = {};
  double censored = 0.0, censored_at = std::numeric_limits<double>::infinity();  // as y

  double count() const { return static_cast<double>(y.size()) + censored; }
  LogRows rows() const {
    LogRows rows;
    for (const double value : y) rows.add_bracket(value, value, 1.0);
    if (censored > 0) rows.add_counts(censored_at, 0.0, censored);
    return rows;
  }
};

/// The integral of (share - u)^2 over u from `from` to `to`.
double square_integral(double share, double from, double to) {
  const auto cube = [](double x) { return x * x * x; };
  return (cube(share - from) - cube(share - to)) / 3;
}

double distance_of(const PooledCapacities& sample, const ProbitLine& line) {
  const auto curve = [&](double y) { return normal_cdf(line[0] + line[1] * y); };
  const double n = sample.count();
  double sum = 0, from = 0, share = 0;
  for (const double y : sample.y) {
    const double to = curve(y);
    sum += square_integral(share, from, to);
    from = to;
    share += 1 / n;
  }
  return sum + square_integral(share, from, sample.censored > 0 ? curve(sample.censored_at) : 1);
}

/// Probability that two standard normal variables of this correlation are both below z.
double both_below(double z, double correlation) {
  const double slope = std::sqrt((1 - correlation) / (1 + correlation));
  return normal_cdf(z) - 2 * boost::math::owens_t(z, slope);
}

/// By record, its rising capacities as y, and how many it has beside those censored.
struct RecordSample {
  std::vector<double> y;
  double count = 0.0;
  std::size_t unit = 0;
  double share_below(double limit) const {
    return static_cast<double>(std::ranges::upper_bound(y, limit) - y.begin());
  }
};

/// Correlation of the normal scores of two capacities of one record: that of the bivariate normal
/// which has as many pairs on one side of nine quantiles of the sample as the records have.
/// Products between records, of which none is counted with itself, give the marginal share without
/// bias.
double correlation_in(const std::vector<RecordSample>& records, const std::vector<double>& pooled) {
  std::vector<double> z, pairs_below;
  for (int decile = 1; decile <= 9; ++decile) {
    const std::size_t rank = static_cast<std::size_t>(decile) * pooled.size() / 10;
    const double limit = pooled[std::min(rank, pooled.size() - 1)];
    double within = 0, pairs = 0, sum = 0, squares = 0, all = 0, all_squares = 0;
    for (const RecordSample& record : records) {
      const double k = record.share_below(limit), n = record.count;
      within += k * (k - 1);
      pairs += n * (n - 1);
      sum += k;
      squares += k * k;
      all += n;
      all_squares += n * n;
    }
    const double between = (sum * sum - squares) / (all * all - all_squares);
    if (pairs == 0 || !(between > 0 && between < 1)) continue;
    z.push_back(normal_quantile(std::sqrt(between)));
    pairs_below.push_back(within / pairs);
  }
  const auto excess = [&](double correlation) {
    double sum = 0;
    for (std::size_t i = 0; i < z.size(); ++i)
      sum += both_below(z[i], correlation) - pairs_below[i];
    return sum;
  };
  constexpr double largest = 0.999;
  if (z.empty() || excess(0) >= 0) return 0;
  if (excess(largest) <= 0) return largest;
  return root_between(excess, 0.0, largest, 20);
}

/// The records of each unit together.
std::vector<RecordSample> units_of(const std::vector<RecordSample>& records) {
  std::map<std::size_t, RecordSample> units;
  for (const RecordSample& record : records) {
    RecordSample& unit = units[record.unit];
    unit.count += record.count;
    unit.y.insert(unit.y.end(), record.y.begin(), record.y.end());
  }
  std::vector<RecordSample> all;
  for (auto& [name, unit] : units) {
    std::ranges::sort(unit.y);
    all.push_back(std::move(unit));
  }
  return all;
}

/// Correlation of the capacities of two records of a unit: that of all pairs of a unit is the mean
/// of it and of that `in_record`, by the numbers of pairs.
double correlation_between(const std::vector<RecordSample>& records,
                           const std::vector<RecordSample>& units, double in_record,
                           const std::vector<double>& pooled) {
  const auto pairs = [](const std::vector<RecordSample>& samples) {
    double sum = 0;
    for (const RecordSample& sample : samples) sum += sample.count * (sample.count - 1);
    return sum;
  };
  const double all = pairs(units), within = pairs(records);
  if (all == within) return 0;
  const double of_all = correlation_in(units, pooled);
  return std::clamp((of_all * all - in_record * within) / (all - within), 0.0,
                    within > 0 ? in_record : 1.0);
}

/// Capacities as the null model has them: lognormal, correlated within records and within units.
class NullModel {
 public:
  NullModel(const std::vector<RecordSample>& records, double correlation, double between,
            double z_censored, std::uint64_t seed, bool stratified)
      : records_(records),
        correlation_(correlation),
        between_(between),
        z_censored_(z_censored),
        seed_(seed),
        stratified_(stratified) {}

  /// In units of z: the fitted median is 0 and log_std is 1.
  PooledCapacities draw(std::uint64_t replicate) const {
    constexpr std::uint32_t strata = 64, unit_index = ~std::uint32_t{0};
    PooledCapacities sample{.censored_at = z_censored_};
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const std::uint64_t item = replicate * records_.size() + i;
      const auto uniform = [&](std::uint32_t index) {
        return keyed_uniform(seed_, RandomPurpose::goodness_of_fit, item, index);
      };
      double shift = std::sqrt(correlation_ - between_) * normal_quantile(uniform(0));
      if (between_ > 0)
        shift += std::sqrt(between_) *
                 normal_quantile(keyed_uniform(seed_, RandomPurpose::goodness_of_fit,
                                               replicate * records_.size() + records_[i].unit,
                                               unit_index));
      const bool in_strata = stratified_ && records_[i].count > strata;
      const auto count = in_strata ? strata : static_cast<std::uint32_t>(records_[i].count);
      for (std::uint32_t j = 0; j < count; ++j) {
        const double u = in_strata ? (j + uniform(1 + j)) / strata : uniform(1 + j);
        const double y = shift + std::sqrt(1 - correlation_) * normal_quantile(u);
        if (y < z_censored_) {
          sample.y.push_back(y);
        } else {
          ++sample.censored;
        }
      }
    }
    std::ranges::sort(sample.y);
    return sample;
  }

 private:
  const std::vector<RecordSample>& records_;
  double correlation_, between_, z_censored_;
  std::uint64_t seed_;
  bool stratified_;
};

/// Share of replicates, the data among them, at least as far from their fit.
double p_value(const NullModel& null, double distance, int replicates) {
  double fitted = 0, as_far = 0;
  for (int r = 0; r < replicates; ++r) {
    const PooledCapacities sample = null.draw(static_cast<std::uint64_t>(r));
    const PointFit fit = fit_point(sample.rows(), {0, 1});
    if (fit.status != FitStatus::maximum_likelihood) continue;
    ++fitted;
    if (distance_of(sample, fit.line) >= distance) ++as_far;
  }
  return (as_far + 1) / (fitted + 1);
}

void find_gap(const PooledCapacities& sample, const ProbitLine& line, double center,
              GoodnessOfFit& result) {
  result.largest_gap = 0;
  for (std::size_t i = 0; i < sample.y.size(); ++i) {
    const double u = normal_cdf(line[0] + line[1] * sample.y[i]);
    for (const std::size_t below : {i, i + 1}) {
      const double gap = static_cast<double>(below) / sample.count() - u;
      if (std::abs(gap) <= std::abs(result.largest_gap)) continue;
      result.largest_gap = gap;
      result.gap_intensity = std::exp(center + sample.y[i]);
    }
  }
}

}  // namespace

bool departs_from_lognormal(const GoodnessOfFit& fit) {
  return fit.p_value < goodness_of_fit_level && std::abs(fit.largest_gap) >= goodness_of_fit_gap;
}

GoodnessOfFit lognormal_goodness_of_fit(const std::vector<Bracket>& rows,
                                        const BootstrapOptions& options, bool stratified,
                                        const std::vector<std::size_t>& unit_of) {
  std::vector<double> exact;
  for (const Bracket& row : rows)
    if (row.low > 0 && row.low == row.high) exact.push_back(row.low);
  const double center = mean_log(exact);
  PooledCapacities pooled;
  std::map<std::size_t, RecordSample> by_record;
  for (const Bracket& row : rows) {
    if (row.high == 0) continue;
    RecordSample& record = by_record[row.record];
    record.unit = unit_at(unit_of, row.record);
    ++record.count;
    const double y = std::log(row.low) - center;
    if (row.low == row.high) {
      record.y.push_back(y);
      pooled.y.push_back(y);
    } else {
      GLISSADE_EXPECTS(std::isinf(row.high) && (pooled.censored == 0 || y == pooled.censored_at));
      pooled.censored_at = y;
      ++pooled.censored;
    }
  }
  std::ranges::sort(pooled.y);
  std::vector<RecordSample> samples;
  for (auto& [name, record] : by_record) {
    std::ranges::sort(record.y);
    samples.push_back(std::move(record));
  }
  GoodnessOfFit result;
  const LogRows data = pooled.rows();
  const PointFit fit = fit_point(data, first_guess(data));
  const std::vector<RecordSample> units = units_of(samples);
  if (units.size() < 3 || fit.status != FitStatus::maximum_likelihood) return result;
  result.distance = distance_of(pooled, fit.line);
  result.correlation = correlation_in(samples, pooled.y);
  find_gap(pooled, fit.line, center, result);
  const double between = correlation_between(samples, units, result.correlation, pooled.y);
  const NullModel null(samples, std::max(result.correlation, between), between,
                       fit.line[0] + fit.line[1] * pooled.censored_at, options.seed, stratified);
  result.p_value = p_value(null, result.distance, std::min(options.replicates, 199));
  return result;
}

}  // namespace glissade
