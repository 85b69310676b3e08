// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include "glissade/core/error.hpp"
#include "glissade/core/finite.hpp"
#include "lognormal/newton_maximum.hpp"
#include "lognormal/point_fit.hpp"
#include "shape/shape.hpp"

namespace glissade {
namespace fragility {

std::vector<double> monotone_shares(const std::map<double, CutWeight>& levels) {
  struct Pool {
    CutWeight cut;
    std::size_t levels = 1;
    double share() const { return cut.exceeding / cut.trials(); }
  };
  std::vector<Pool> pools;
  for (const auto& [y, cut] : levels) {
    pools.push_back({cut});
    while (pools.size() > 1 && pools.back().share() <= pools[pools.size() - 2].share()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().cut.exceeding += last.cut.exceeding;
      pools.back().cut.held += last.cut.held;
      pools.back().levels += last.levels;
    }
  }
  std::vector<double> shares;
  for (const Pool& pool : pools) shares.insert(shares.end(), pool.levels, pool.share());
  return shares;
}

namespace {

/// Probability of exceedance by level; empty: not fitted.
using Shares = std::vector<double>;

/// Models of all thresholds at once, fitted without one record.
class JointModels {
 public:
  explicit JointModels(const ShapeData& data) : data_(data), surface_data_(data) {
    const std::size_t records = record_count(data.stripes.front());
    for (std::size_t i = 0; i <= records; ++i) {
      const std::size_t without = i < records ? i : none;
      two_part_.push_back(data.slips.empty() ? TwoPartFit{} : fit_two_part(slips(without)));
      surface_.push_back(surface_data_.fit(without));
    }
  }

  Shares two_part(std::size_t threshold, std::size_t without) const {
    const TwoPartFit& fit = two_part_[std::min(without, two_part_.size() - 1)];
    if (!fit.has_curve()) return {};
    return by_level([&](double x) { return fit.probability(x, data_.thresholds_m[threshold]); });
  }
  Shares surface(std::size_t threshold, std::size_t without) const {
    const auto& fit = surface_[std::min(without, surface_.size() - 1)];
    const double d = data_.thresholds_m[threshold];
    if (!fit || d < fit->thresholds_m.front() || d > fit->thresholds_m.back()) return {};
    return by_level([&](double x) { return fit->probability(x, d); });
  }

 private:
  std::vector<SlipSums> slips(std::size_t without) const {
    std::vector<SlipSums> sums;
    for (std::size_t level = 0; level < data_.intensities.size(); ++level) {
      SlipSums& sum = sums.emplace_back(SlipSums{.intensity = data_.intensities[level]});
      for (std::size_t i = 0; i < data_.slips.size(); ++i) {
        if (i == without) continue;
        const SlipSums& of = data_.slips[i][level];
        sum.trials += of.trials;
        sum.moved += of.moved;
        sum.sum_log += of.sum_log;
        sum.sum_log_squares += of.sum_log_squares;
      }
    }
    return sums;
  }
  Shares by_level(const std::function<double(double)>& probability) const {
    Shares shares;
    for (const double intensity : data_.intensities) shares.push_back(probability(intensity));
    return shares;
  }

  const ShapeData& data_;
  SurfaceData surface_data_;
  std::vector<TwoPartFit> two_part_;                      // by the record left out; last: none
  std::vector<std::optional<FragilitySurface>> surface_;  // so
};

/// The counts of one threshold, by record. All have all levels, with 0 trials where they lack one.
struct Threshold {
  std::vector<LogRows> records;
  LogRows all;

  Threshold(const std::vector<double>& intensities, const std::vector<Stripe>& rows)
      : records(record_count(rows)) {
    all.center = mean_log(intensities);
    for (const double intensity : intensities)
      all.add_counts(std::log(intensity) - all.center, 0.0, 0.0);
    std::ranges::fill(records, all);
    for (const Stripe& row : rows) {
      if (row.intensity == 0) continue;
      for (LogRows* sums : {&records[row.record], &all})
        sums->add_counts(std::log(row.intensity) - all.center, row.exceedances,
                         row.trials - row.exceedances);
    }
  }
  LogRows without(std::size_t record) const {
    LogRows rest = all;
    if (record == none) return rest;
    for (const auto& [y, cut] : records[record].cuts) rest.add_counts(y, -cut.exceeding, -cut.held);
    return rest;
  }
};

/// Nothing that was not seen in n records is impossible.
Shares predicting(Shares shares, double records) {
  for (double& share : shares) share = (records * share + 0.5) / (records + 1);
  return shares;
}

Shares line_shares(const LogRows& counts, Link link) {
  const auto line = newton_maximum(
      [&](const ProbitLine& at) { return likelihood(counts, at, link); }, first_guess(counts));
  Shares shares;
  for (const auto& [y, cut] : counts.cuts)
    if (line) shares.push_back(share_at(link, (*line)[0] + (*line)[1] * y));
  return shares;
}

/// By ShapeModel.
std::vector<Shares> fitted(const Threshold& of, const JointModels& joint, std::size_t threshold,
                           std::size_t without) {
  const LogRows counts = of.without(without);
  return {line_shares(counts, Link::probit),
          line_shares(counts, Link::logit),
          line_shares(counts, Link::complementary_log_log),
          joint.two_part(threshold, without),
          monotone_shares(counts.cuts),
          joint.surface(threshold, without)};
}

/// ln of the probability of what a record shows, mean over its histories and levels. What has no
/// probability in doubles has the least that they hold.
double score_of(const LogRows& record, const Shares& shares) {
  constexpr double least = 1e-300;
  double sum = 0, trials = 0;
  auto share = shares.begin();
  for (const auto& [y, cut] : record.cuts) {
    sum += cut.exceeding * std::log(std::max(*share, least)) +
           cut.held * std::log(std::max(1 - *share, least));
    trials += cut.trials();
    ++share;
  }
  return sum / trials;
}

ComparisonStatus status_of(const Threshold& of) {
  if (shape_of(of.all) == RowsShape::empty) return ComparisonStatus::always_exceeds;
  if (of.records.size() < 3) return ComparisonStatus::few_records;
  for (std::size_t i = 0; i < of.records.size(); ++i) {
    const RowsShape shape = shape_of(of.without(i));
    if (shape == RowsShape::not_rising) return ComparisonStatus::no_rise;
    if (shape != RowsShape::overlapping) return ComparisonStatus::no_overlap;
  }
  return ComparisonStatus::compared;
}

void add_differences(const Eigen::ArrayXXd& scores, std::vector<ModelScore>& models) {
  const auto n = static_cast<double>(scores.rows());
  for (std::size_t m = 0; m < shape_model_count; ++m) {
    const auto column = static_cast<Eigen::Index>(m);
    const Eigen::ArrayXd difference = scores.col(column) - scores.col(0);
    models[m].score = scores.col(column).mean();
    models[m].difference = difference.mean();
    models[m].standard_error =
        std::sqrt((difference - difference.mean()).square().sum() / (n * (n - 1)));
  }
}

/// Counts are a table of records by intensities, however few of its places have any.
void check_table(std::size_t records, std::size_t intensities) {
  constexpr std::size_t most = 10'000'000;
  if (records <= most / std::max<std::size_t>(1, intensities)) return;
  throw InputError({"counts",
                    std::to_string(records) + " records at " + std::to_string(intensities) +
                        " intensities are more than ten million places",
                    "give the counts at the levels of the analysis, which the records share, or "
                    "each history as a row of --capacities or --cloud",
                    ""});
}

ShapeComparison compare(const Threshold& of, const JointModels& joint, std::size_t threshold) {
  ShapeComparison comparison{status_of(of), {}};
  if (comparison.status != ComparisonStatus::compared) return comparison;
  const std::size_t records = of.records.size();
  Eigen::ArrayXXd scores(records, shape_model_count);
  for (std::size_t i = 0; i < records; ++i) {
    std::vector<Shares> models = fitted(of, joint, threshold, i);
    Shares& monotone = models[static_cast<std::size_t>(ShapeModel::monotone)];
    monotone = predicting(std::move(monotone), static_cast<double>(records - 1));
    for (std::size_t m = 0; m < shape_model_count; ++m)
      scores(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m)) =
          models[m].empty() ? nan : score_of(of.records[i], models[m]);
  }
  std::vector<Shares> models = fitted(of, joint, threshold, none);
  for (std::size_t m = 0; m < shape_model_count; ++m) {
    ModelScore& model = comparison.models.emplace_back();
    model.model = static_cast<ShapeModel>(m);
    model.probability = std::move(models[m]);
    model.probability.resize(of.all.cuts.size(), nan);
  }
  add_differences(scores, comparison.models);
  return comparison;
}

}  // namespace
}  // namespace fragility

std::string to_string(ComparisonStatus status) {
  switch (status) {
    case ComparisonStatus::compared:
      return "compared";
    case ComparisonStatus::few_records:
      break;
    case ComparisonStatus::no_overlap:
      return "shares do not overlap without a record";
    case ComparisonStatus::no_rise:
      return "no rise with intensity without a record";
    case ComparisonStatus::always_exceeds:
      return "exceeds at any intensity";
  }
  return "fewer than three records";
}

std::vector<ShapeComparison> compare_shapes(const ShapeData& data) {
  using namespace fragility;
  for (const std::vector<Stripe>& rows : data.stripes)
    check_table(record_count(rows), data.intensities.size());
  std::vector<ShapeComparison> comparisons;
  if (data.thresholds_m.empty()) return comparisons;
  const JointModels joint(data);
  for (std::size_t t = 0; t < data.thresholds_m.size(); ++t)
    comparisons.push_back(compare(Threshold(data.intensities, data.stripes[t]), joint, t));
  return comparisons;
}

}  // namespace glissade
