// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include "glissade/core/finite.hpp"
#include "lognormal/point_fit.hpp"
#include "shape/shape.hpp"

namespace glissade {
namespace fragility {

Eigen::ArrayXd monotone_shares(const Eigen::ArrayXd& exceedances, const Eigen::ArrayXd& trials) {
  struct Pool {
    double exceedances, trials;
    Eigen::Index levels;
    double share() const { return exceedances / trials; }
  };
  std::vector<Pool> pools;
  for (Eigen::Index j = 0; j < trials.size(); ++j) {
    pools.push_back({exceedances[j], trials[j], 1});
    while (pools.size() > 1 && pools.back().share() <= pools[pools.size() - 2].share()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().exceedances += last.exceedances;
      pools.back().trials += last.trials;
      pools.back().levels += last.levels;
    }
  }
  Eigen::ArrayXd shares(trials.size());
  Eigen::Index j = 0;
  for (const Pool& pool : pools) {
    shares.segment(j, pool.levels) = pool.share();
    j += pool.levels;
  }
  return shares;
}

namespace {

/// Probability of exceedance by level; empty: not fitted.
using Shares = Eigen::ArrayXd;

/// Models of all thresholds at once, fitted without one record.
class JointModels {
 public:
  explicit JointModels(const ShapeData& data) : data_(data), surface_data_(data) {
    const std::size_t records = data.stripes.front().size();
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
    Shares shares(static_cast<Eigen::Index>(data_.intensities.size()));
    for (Eigen::Index j = 0; j < shares.size(); ++j)
      shares[j] = probability(data_.intensities[static_cast<std::size_t>(j)]);
    return shares;
  }

  const ShapeData& data_;
  SurfaceData surface_data_;
  std::vector<TwoPartFit> two_part_;                      // by the record left out; last: none
  std::vector<std::optional<FragilitySurface>> surface_;  // so
};

/// The stripes of one threshold, by record and level.
struct Threshold {
  Eigen::ArrayXXd exceedances, trials;
  StripeData all;

  Threshold(const std::vector<double>& intensities, const std::vector<RecordStripes>& records) {
    const auto rows = static_cast<Eigen::Index>(records.size()),
               columns = static_cast<Eigen::Index>(intensities.size());
    exceedances.resize(rows, columns);
    trials.resize(rows, columns);
    std::vector<Stripe> stripes;
    for (Eigen::Index j = 0; j < columns; ++j) {
      const auto level = static_cast<std::size_t>(j);
      for (Eigen::Index i = 0; i < rows; ++i) {
        exceedances(i, j) = records[static_cast<std::size_t>(i)].exceedances[level];
        trials(i, j) = records[static_cast<std::size_t>(i)].trials[level];
      }
      stripes.push_back({intensities[level], trials.col(j).sum(), exceedances.col(j).sum()});
    }
    all = to_data(stripes);
  }
  StripeData without(std::size_t record) const {
    StripeData data = all;
    if (record == none) return data;
    data.exceedances -= exceedances.row(static_cast<Eigen::Index>(record)).transpose();
    data.trials -= trials.row(static_cast<Eigen::Index>(record)).transpose();
    return data;
  }
};

/// Nothing that was not seen in n records is impossible.
Shares predicting(const Shares& shares, double records) {
  return (records * shares + 0.5) / (records + 1);
}

Shares line_shares(const StripeData& data, Link link) {
  const auto line = maximise(
      [&](const ProbitLine& at) { return stripe_likelihood(data, at, link); }, first_guess(data));
  if (!line) return {};
  return ((*line)[0] + (*line)[1] * data.y).unaryExpr([&](double z) { return share_at(link, z); });
}

/// By ShapeModel.
std::vector<Shares> fitted(const Threshold& of, const JointModels& joint, std::size_t threshold,
                           std::size_t without) {
  const StripeData data = of.without(without);
  return {line_shares(data, Link::probit),
          line_shares(data, Link::logit),
          line_shares(data, Link::complementary_log_log),
          joint.two_part(threshold, without),
          monotone_shares(data.exceedances, data.trials),
          joint.surface(threshold, without)};
}

/// ln of the probability of what a record shows, mean over its histories and levels. What has no
/// probability in doubles has the least that they hold.
double score_of(const Threshold& of, Eigen::Index record, const Shares& shares) {
  constexpr double least = 1e-300;
  const Eigen::ArrayXd k = of.exceedances.row(record).transpose(),
                       n = of.trials.row(record).transpose();
  return (k * shares.max(least).log() + (n - k) * (1 - shares).max(least).log()).sum() / n.sum();
}

ComparisonStatus status_of(const Threshold& of) {
  if (of.all.trials.sum() == 0) return ComparisonStatus::always_exceeds;
  const auto records = static_cast<std::size_t>(of.trials.rows());
  if (records < 3) return ComparisonStatus::few_records;
  for (std::size_t i = 0; i < records; ++i) {
    const StripeShape shape = shape_of(of.without(i));
    if (shape == StripeShape::not_rising) return ComparisonStatus::no_rise;
    if (shape != StripeShape::overlapping) return ComparisonStatus::no_overlap;
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

ShapeComparison compare(const Threshold& of, const JointModels& joint, std::size_t threshold) {
  ShapeComparison comparison{status_of(of), {}};
  if (comparison.status != ComparisonStatus::compared) return comparison;
  const Eigen::Index records = of.trials.rows();
  Eigen::ArrayXXd scores(records, static_cast<Eigen::Index>(shape_model_count));
  for (Eigen::Index i = 0; i < records; ++i) {
    std::vector<Shares> models = fitted(of, joint, threshold, static_cast<std::size_t>(i));
    Shares& monotone = models[static_cast<std::size_t>(ShapeModel::monotone)];
    monotone = predicting(monotone, static_cast<double>(records - 1));
    for (std::size_t m = 0; m < shape_model_count; ++m)
      scores(i, static_cast<Eigen::Index>(m)) =
          models[m].size() == 0 ? nan : score_of(of, i, models[m]);
  }
  const std::vector<Shares> models = fitted(of, joint, threshold, none);
  for (std::size_t m = 0; m < shape_model_count; ++m) {
    ModelScore& model = comparison.models.emplace_back();
    model.model = static_cast<ShapeModel>(m);
    model.probability.assign(models[m].begin(), models[m].end());
    model.probability.resize(static_cast<std::size_t>(of.all.y.size()), nan);
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
  std::vector<ShapeComparison> comparisons;
  if (data.thresholds_m.empty()) return comparisons;
  const JointModels joint(data);
  for (std::size_t t = 0; t < data.thresholds_m.size(); ++t)
    comparisons.push_back(compare(Threshold(data.intensities, data.stripes[t]), joint, t));
  return comparisons;
}

}  // namespace glissade
