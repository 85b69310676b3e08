// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/sobol_indices.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/jackknife.hpp"

namespace glissade {
namespace {

/// first <= i < end
struct IndexRange {
  std::size_t first = 0, end = 0;
  bool has(std::size_t i) const { return i >= first && i < end; }
};

/// What the jackknife leaves out.
struct Omitted {
  IndexRange units, samples;
};

/// 0 to count in up to so many parts of even size.
std::vector<IndexRange> parts_of(std::size_t count, std::size_t most_parts) {
  const std::size_t parts = std::min(most_parts, count);
  std::vector<IndexRange> ranges;
  for (std::size_t g = 0; g < parts; ++g)
    ranges.push_back({g * count / parts, (g + 1) * count / parts});
  return ranges;
}

/// Components of variance and shares without intervals.
struct Estimates {
  double of_records = 0.0, of_samples = 0.0, of_both = 0.0;
  double of_units = 0.0;       ///< as of_records, from the sums of units: of the error of the mean
  std::vector<double> shares;  ///< first and total: of records, all drawn, each factor

  double variance() const { return of_records + of_samples + of_both; }
};

class Estimator {
 public:
  Estimator(const CrossedResponse& response, const Omitted& omitted) : y_(response) {
    for (std::size_t r = 0; r < response.records(); ++r) {
      if (!omitted.units.has(response.unit(r))) records_.push_back(r);
    }
    for (std::size_t k = 0; k < response.samples(); ++k) {
      if (!omitted.samples.has(k)) samples_.push_back(k);
    }
  }

  Estimates estimates() const {
    Estimates e;
    add_components(e);
    const double v = e.variance();
    e.shares = {e.of_records / v, (e.of_records + e.of_both) / v, e.of_samples / v,
                (e.of_samples + e.of_both) / v};
    for (std::size_t factor = 0; factor < y_.factors(); ++factor) {
      if (y_.is_given_data()) {
        e.shares.push_back(of_groups(factor) / v);
        e.shares.push_back(nan);
      } else {
        add_factor(factor, v, e.shares);
      }
    }
    return e;
  }

 private:
  void add_components(Estimates& e) const {
    const std::size_t plain = y_.plain_matrices();
    const double n = static_cast<double>(records_.size()),
                 m = static_cast<double>(plain * samples_.size());
    std::vector<double> of_record(records_.size()), of_sample(plain * samples_.size());
    double all = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < records_.size(); ++i) {
      for (std::size_t j = 0; j < of_sample.size(); ++j) {
        const double y = y_(records_[i], j % plain, samples_[j / plain]);
        of_record[i] += y / m;
        of_sample[j] += y / n;
        all += y / (n * m);
        squares += y * y;
      }
    }
    double between_records = 0.0, between_samples = 0.0;
    std::vector<double> of_unit(y_.units());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      between_records += (of_record[i] - all) * (of_record[i] - all);
      of_unit[y_.unit(records_[i])] += of_record[i] - all;
    }
    for (const double mean : of_sample) between_samples += (mean - all) * (mean - all);
    const double rest = squares - n * m * all * all - m * between_records - n * between_samples;
    e.of_both = std::max(0.0, rest) / ((n - 1.0) * (m - 1.0));
    e.of_records = between_records / (n - 1.0) - e.of_both / m;
    double between_units = 0.0;
    for (const double sum : of_unit) between_units += sum * sum;
    const double u = static_cast<double>(y_.units());
    between_units *= (u / (u - 1.0)) / (n / (n - 1.0));
    e.of_units = between_units / (n - 1.0) - e.of_both / m;
    e.of_samples = between_samples / (m - 1.0) - e.of_both / n;
  }

  void add_factor(std::size_t factor, double variance, std::vector<double>& shares) const {
    const double n = static_cast<double>(records_.size()),
                 samples = static_cast<double>(samples_.size());
    double first = 0.0, total = 0.0;
    for (const std::size_t k : samples_) {
      double b = 0.0, change = 0.0, same_record = 0.0;
      for (const std::size_t r : records_) {
        const double from_b = y_(r, 1, k), changed = y_(r, 2 + factor, k) - y_(r, 0, k);
        b += from_b;
        change += changed;
        same_record += from_b * changed;
        total += changed * changed;
      }
      first += b * change - same_record;
    }
    shares.push_back(first / (n * (n - 1.0) * samples) / variance);
    shares.push_back(total / (2.0 * n * samples) / variance);
  }

  /// First order of given data, times the variance: of the sum over the records less the sum of
  /// those of each record, so that products of different records remain.
  double of_groups(std::size_t factor) const {
    const double n = static_cast<double>(records_.size());
    std::vector<double> sum(samples_.size()), of_record(samples_.size());
    double same_record = 0.0;
    for (const std::size_t r : records_) {
      for (std::size_t j = 0; j < samples_.size(); ++j)
        sum[j] += of_record[j] = y_(r, 0, samples_[j]);
      same_record += between_groups(factor, of_record);
    }
    return (between_groups(factor, sum) - same_record) / (n * (n - 1.0));
  }

  double between_groups(std::size_t factor, const std::vector<double>& y) const {
    return y_.blocks() > 1 ? between_groups_of_blocks(factor, y)
                           : between_groups_of_samples(factor, y);
  }

  struct Group {
    double count = 0.0, sum = 0.0;
  };

  /// Variance of the means of the groups, less what their scatter adds to it.
  double between_groups_of_samples(std::size_t factor, const std::vector<double>& y) const {
    std::map<std::size_t, Group> groups;
    double all = 0.0, squares = 0.0;
    for (std::size_t j = 0; j < y.size(); ++j) {
      Group& group = groups[y_.group(factor, samples_[j])];
      group.count += 1.0;
      group.sum += y[j];
      all += y[j];
      squares += y[j] * y[j];
    }
    double means = 0.0;
    for (const auto& [at, group] : groups) means += group.sum * group.sum / group.count;
    const double count = static_cast<double>(y.size()), g = static_cast<double>(groups.size());
    const double within = (squares - means) / (count - g);
    return (means - all * all / count - (g - 1.0) * within) / count;
  }

  /// Mean of the products of two different values.
  struct Products {
    double count = 0.0, sum = 0.0, squares = 0.0;
    void add(double value) {
      count += 1.0;
      sum += value;
      squares += value * value;
    }
    double mean() const {
      return count > 1.0 ? (sum * sum - squares) / (count * (count - 1.0)) : 0.0;
    }
  };

  /// Covariance over the groups of the means of two blocks, over all pairs of blocks.
  double between_groups_of_blocks(std::size_t factor, const std::vector<double>& y) const {
    std::map<std::size_t, std::map<std::size_t, Group>> groups;  // by group, then by block
    std::map<std::size_t, Group> blocks;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const std::size_t block = y_.block(samples_[j]);
      for (Group* of : {&groups[y_.group(factor, samples_[j])][block], &blocks[block]}) {
        of->count += 1.0;
        of->sum += y[j];
      }
    }
    double means = 0.0;
    for (const auto& [at, of_blocks] : groups) {
      Products products;
      double count = 0.0;
      for (const auto& [block, group] : of_blocks) {
        products.add(group.sum / group.count);
        count += group.count;
      }
      means += count / static_cast<double>(y.size()) * products.mean();
    }
    Products all;
    for (const auto& [block, group] : blocks) all.add(group.sum / group.count);
    return means - all.mean();
  }

  const CrossedResponse& y_;
  std::vector<std::size_t> records_, samples_;
};

/// The variances of the shares by leaving out one part after the other (Efron & Stein 1981).
std::vector<double> jackknife(const CrossedResponse& response, const std::vector<Omitted>& parts) {
  std::vector<std::vector<double>> without;  // by share, then by part
  for (const Omitted& part : parts) {
    const std::vector<double> shares = Estimator(response, part).estimates().shares;
    without.resize(shares.size());
    for (std::size_t i = 0; i < shares.size(); ++i) without[i].push_back(shares[i]);
  }
  std::vector<double> variances;
  for (const std::vector<double>& of_share : without)
    variances.push_back(jackknife_variance(of_share));
  return variances;
}

struct IndexError {
  double of_records, of_samples;  ///< variances of an estimate
  double records, groups;         ///< how many of them
};

VarianceShare share(double value, const IndexError& spread) {
  const double variance = spread.of_records + spread.of_samples;
  if (!(variance > 0.0)) return {value, value, value};  // NaN too
  const double freedom = variance * variance /
                         (spread.of_records * spread.of_records / (spread.records - 1.0) +
                          spread.of_samples * spread.of_samples / (spread.groups - 1.0));
  const double half = std::sqrt(variance) * student_quantile(freedom, 0.975);
  return {value, std::clamp(value - half, 0.0, 1.0), std::clamp(value + half, 0.0, 1.0)};
}

double mean_of(const CrossedResponse& response) {
  double sum = 0.0;
  for (std::size_t r = 0; r < response.records(); ++r) {
    for (std::size_t k = 0; k < response.samples(); ++k) {
      for (std::size_t m = 0; m < response.plain_matrices(); ++m) sum += response(r, m, k);
    }
  }
  return sum /
         static_cast<double>(response.plain_matrices() * response.records() * response.samples());
}

/// Products then lose no digits, and estimates of small shares scatter least.
CrossedResponse centred(CrossedResponse response, double mean) {
  for (std::size_t r = 0; r < response.records(); ++r) {
    for (std::size_t m = 0; m < response.matrices(); ++m) {
      for (std::size_t k = 0; k < response.samples(); ++k) response(r, m, k) -= mean;
    }
  }
  return response;
}

std::vector<VarianceShare> shares_of(const CrossedResponse& response, const Estimates& all) {
  constexpr std::size_t most_groups = 16, most_record_groups = 64;
  std::vector<Omitted> units, samples;
  for (const IndexRange& part : parts_of(response.units(), most_record_groups))
    units.push_back({part, {}});
  const bool has_blocks = response.blocks() > 1;
  const std::size_t of_samples = has_blocks ? response.blocks() : response.samples(),
                    size = response.samples() / of_samples;
  for (const IndexRange& part : parts_of(of_samples, has_blocks ? most_record_groups : most_groups))
    samples.push_back({{}, {part.first * size, part.end * size}});
  const std::vector<double> by_record = jackknife(response, units),
                            by_sample = jackknife(response, samples);
  std::vector<VarianceShare> shares;
  for (std::size_t i = 0; i < all.shares.size(); ++i)
    shares.push_back(
        share(all.shares[i], {by_record[i], by_sample[i], static_cast<double>(units.size()),
                              static_cast<double>(samples.size())}));
  return shares;
}

bool varies(const CrossedResponse& response) {
  for (std::size_t r = 0; r < response.records(); ++r) {
    for (std::size_t m = 0; m < response.plain_matrices(); ++m) {
      for (std::size_t k = 0; k < response.samples(); ++k) {
        if (response(r, m, k) != response(0, 0, 0)) return true;
      }
    }
  }
  return false;
}

}  // namespace

FactorGroups groups_of(const std::vector<double>& values) {
  constexpr std::size_t most = 16, least_samples = 8;
  const std::size_t count = std::clamp<std::size_t>(values.size() / least_samples, 2, most);
  std::vector<double> distinct = values;
  std::ranges::sort(distinct);
  distinct.erase(std::ranges::unique(distinct).begin(), distinct.end());
  FactorGroups groups(values.size());
  if (distinct.size() <= count) {
    for (std::size_t k = 0; k < values.size(); ++k)
      groups[k] = static_cast<std::size_t>(std::ranges::lower_bound(distinct, values[k]) -
                                           distinct.begin());
    return groups;
  }
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return values[k]; });
  for (std::size_t i = 0; i < order.size(); ++i) groups[order[i]] = i * count / order.size();
  return groups;
}

SobolIndices sobol_indices(const CrossedResponse& response) {
  GLISSADE_EXPECTS(response.units() >= 3 && response.samples() >= 2);
  SobolIndices indices;
  indices.mean = mean_of(response);
  if (!varies(response)) {
    const VarianceShare unknown{nan, nan, nan};
    indices.records = indices.drawn = {unknown, unknown};
    indices.factors.assign(response.factors(), indices.records);
    return indices;
  }
  const CrossedResponse y = centred(response, indices.mean);
  const Estimates all = Estimator(y, {}).estimates();
  indices.variance = all.variance();
  const double n = static_cast<double>(y.records()),
               m = static_cast<double>(y.plain_matrices() * y.samples());
  indices.record_error = std::sqrt(std::max(0.0, all.of_units) / n);
  indices.sample_error = std::sqrt(std::max(0.0, all.of_samples) / m + all.of_both / (n * m));
  const std::vector<VarianceShare> shares = shares_of(y, all);
  indices.records = {shares[0], shares[1]};
  indices.drawn = {shares[2], shares[3]};
  for (std::size_t i = 0; i < y.factors(); ++i)
    indices.factors.push_back({shares[4 + 2 * i], shares[5 + 2 * i]});
  return indices;
}

}  // namespace glissade
