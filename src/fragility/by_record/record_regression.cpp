// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/record_regression.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "by_record/resampling.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"
#include "lognormal/likelihood.hpp"

namespace glissade {
namespace {

constexpr int most_iterations = 1000;
constexpr double tie = 1e-9;  ///< of ln std: two names of one measure

Eigen::MatrixXd design_matrix(const RecordRegression& data) {
  const auto n = static_cast<Eigen::Index>(data.records());
  Eigen::MatrixXd x = Eigen::MatrixXd::Ones(n, static_cast<Eigen::Index>(data.unknowns()));
  for (std::size_t c = 0; c < data.covariates.size(); ++c)
    x.col(static_cast<Eigen::Index>(c) + 1) =
        Eigen::Map<const Eigen::VectorXd>(data.covariates[c].data(), n);
  return x;
}

/// Mean of the values and of the squared residuals, given that censored values are higher.
struct Expected {
  Eigen::ArrayXd value, extra_variance;
};

Expected expected(const RecordRegression& data, const Eigen::ArrayXd& mean, double std) {
  Expected e{Eigen::Map<const Eigen::ArrayXd>(data.value.data(), mean.size()),
             Eigen::ArrayXd::Zero(mean.size())};
  for (Eigen::Index i = 0; i < mean.size(); ++i) {
    if (!data.censored[static_cast<std::size_t>(i)] || std == 0.0) continue;
    const double t = (e.value[i] - mean[i]) / std;
    const double h = fragility::hazard(-t);  // phi(t) / Phi(-t)
    e.value[i] = mean[i] + std * h;
    e.extra_variance[i] = std * std * std::max(0.0, 1.0 + t * h - h * h);
  }
  return e;
}

double log_likelihood(const RecordRegression& data, const Eigen::ArrayXd& weights,
                      const Eigen::ArrayXd& mean, double std) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < mean.size(); ++i) {
    const auto record = static_cast<std::size_t>(i);
    const double z = (data.value[record] - mean[i]) / std;
    sum += weights[i] * (data.censored[record]
                             ? log_normal_cdf(-z)
                             : -0.5 * z * z - std::log(std) - 0.5 * std::log(2 * std::numbers::pi));
  }
  return sum;
}

RecordRegression with(RecordRegression data, const std::vector<double>& covariate) {
  data.covariates.push_back(covariate);
  return data;
}

/// Of each unit: how often it counts, and the sum of its records' departures.
struct UnitSums {
  Eigen::ArrayXd weights, departures;
  UnitSums(const RecordRegression& data, const Eigen::ArrayXd& of_records,
           const Eigen::ArrayXd& record_weights)
      : weights(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(data.units()))),
        departures(weights) {
    for (Eigen::Index i = 0; i < of_records.size(); ++i) {
      const auto unit = static_cast<Eigen::Index>(data.unit(static_cast<std::size_t>(i)));
      weights[unit] = record_weights[i];
      departures[unit] += of_records[i];
    }
  }
};

fragility::EstimateWithError log_std_of(const RecordFit& fit) {
  return {std::log(fit.std), fit.log_std_error};
}

}  // namespace

RecordFit fit_records(const RecordRegression& data, const std::vector<double>& weights) {
  const Eigen::MatrixXd x = design_matrix(data);
  const Eigen::ArrayXd w = weights.empty()
                               ? Eigen::ArrayXd::Ones(x.rows()).eval()
                               : Eigen::Map<const Eigen::ArrayXd>(weights.data(), x.rows()).eval();
  const double n = w.sum(), unknowns = static_cast<double>(data.unknowns());
  GLISSADE_EXPECTS(n > unknowns && data.censored.size() == data.records());
  const auto solver =
      (x.transpose() * w.matrix().asDiagonal() * x).completeOrthogonalDecomposition();
  const bool censored = std::ranges::count(data.censored, true) > 0;
  Eigen::VectorXd coefficients;
  Eigen::ArrayXd mean, squares;
  double std = 0.0;
  for (int i = 0; i < most_iterations; ++i) {
    const Expected e =
        i == 0 ? expected(data, Eigen::ArrayXd::Zero(x.rows()), 0.0) : expected(data, mean, std);
    coefficients = solver.solve(x.transpose() * (w * e.value).matrix());
    mean = (x * coefficients).array();
    squares = (e.value - mean).square() + e.extra_variance;
    const double before = std;
    std = std::sqrt((w * squares).sum() / n);
    if (!censored || std::abs(std - before) <= 1e-10 * std) break;
  }
  const double variance = std * std;
  const UnitSums of(data, squares - variance, w);
  return {{coefficients.begin(), coefficients.end()},
          std * std::sqrt(n / (n - unknowns)),
          std::sqrt((of.weights * of.departures.square()).sum()) / (2.0 * n * variance),
          log_likelihood(data, w, mean, std)};
}

SlopeTest test_slope(const RecordRegression& data, const std::vector<double>& covariate) {
  const double freedom =
      static_cast<double>(data.records()) - static_cast<double>(data.unknowns()) - 1.0;
  const auto [least, greatest] = std::ranges::minmax(covariate);
  if (freedom < 1.0 || !(least < greatest)) return {nan, nan};
  const RecordFit fit = fit_records(with(data, covariate));
  const double n = static_cast<double>(data.records());
  const double ratio = 2.0 * (fit.log_likelihood - fit_records(data).log_likelihood);
  const double t = std::sqrt(std::max(0.0, freedom * std::expm1(ratio / n)));
  return {fit.coefficients.back(), 2.0 * student_upper_tail(freedom, t)};
}

std::vector<RecordDispersion> record_dispersions(const std::vector<RecordRegression>& regressions,
                                                 const BootstrapOptions& options) {
  GLISSADE_EXPECTS(!regressions.empty());
  const std::size_t units = regressions.front().units();
  using Logs = std::vector<fragility::EstimateWithError>;
  std::vector<Logs> replicates(regressions.size());
  std::vector<double> smallest(regressions.size(), 0.0);
  const auto of_resample = [&](const std::vector<double>& of_units) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < regressions.front().records(); ++i)
      weights.push_back(of_units[regressions.front().unit(i)]);
    Logs logs;
    for (const RecordRegression& data : regressions)
      logs.push_back(log_std_of(fit_records(data, weights)));
    return logs;
  };
  for (const Logs& logs : fragility::resampled(units, options, of_resample)) {
    const double least = std::ranges::min(logs, {}, &fragility::EstimateWithError::value).value;
    for (std::size_t i = 0; i < regressions.size(); ++i) {
      replicates[i].push_back(logs[i]);
      if (logs[i].value <= least + tie) smallest[i] += 1.0 / options.replicates;
    }
  }
  std::vector<RecordDispersion> all;
  for (std::size_t i = 0; i < regressions.size(); ++i) {
    const RecordFit fit = fit_records(regressions[i]);
    const Interval logs = fragility::log_std_interval(
        log_std_of(fit), replicates[i], units - regressions[i].covariates.size(), options.level);
    all.push_back({fit.std, {std::exp(logs.low), std::exp(logs.high)}, smallest[i]});
  }
  return all;
}

}  // namespace glissade
