// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/conditional_selection.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "../scaling/record_screening.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/in_parallel.hpp"
#include "glissade/core/random.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/rotated_spectrum.hpp"

namespace glissade {
namespace {

/// ln Sa (g) by period.
using LogSpectrum = std::vector<double>;

double square(double x) { return x * x; }

double distance_square(const LogSpectrum& a, const LogSpectrum& b) {
  double sum = 0.0;
  for (std::size_t p = 0; p < a.size(); ++p) sum += square(a[p] - b[p]);
  return sum;
}

/// Sums over some spectra, by period, and how far their mean and sigma are from a target's.
class SpectrumSums {
 public:
  explicit SpectrumSums(const SpectrumDistribution& target)
      : target_(&target), sums_(target.size()), squares_(target.size()) {
    for (std::size_t p = 0; p < target.size(); ++p) sigma_.push_back(target.sigma(p));
  }

  void add(const LogSpectrum& spectrum) {
    count_ += 1.0;
    for (std::size_t p = 0; p < spectrum.size(); ++p) {
      const double above = spectrum[p] - target_->mean[p];
      sums_[p] += above;
      squares_[p] += above * above;
    }
  }

  /// Of those and one more.
  double deviation_with(const LogSpectrum& spectrum) const {
    double deviation = 0.0;
    for (std::size_t p = 0; p < spectrum.size(); ++p) {
      const double above = spectrum[p] - target_->mean[p];
      deviation += of_period(p, count_ + 1.0, sums_[p] + above, squares_[p] + above * above);
    }
    return deviation;
  }

  double deviation() const {
    double deviation = 0.0;
    for (std::size_t p = 0; p < sums_.size(); ++p)
      deviation += of_period(p, count_, sums_[p], squares_[p]);
    return deviation;
  }

  double mean(std::size_t p) const { return target_->mean[p] + sums_[p] / count_; }
  double sigma(std::size_t p) const { return sigma_of(count_, sums_[p], squares_[p]); }

 private:
  static double sigma_of(double count, double sum, double squares) {
    if (count < 2.0) return 0.0;
    return std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1.0)));
  }
  double of_period(std::size_t p, double count, double sum, double squares) const {
    constexpr double weight_of_sigma = 2.0;
    return square(sum / count) +
           weight_of_sigma * square(sigma_of(count, sum, squares) - sigma_[p]);
  }

  const SpectrumDistribution* target_;
  double count_ = 0.0;
  std::vector<double> sums_, squares_;  // of what is above the target's mean
  std::vector<double> sigma_;           // of the target
};

/// Times its transpose it is the covariance, of which eigenvalues below zero are left out: the
/// correlations are fitted pair by pair.
Eigen::MatrixXd root_of_covariance(const SpectrumDistribution& target) {
  const auto n = static_cast<Eigen::Index>(target.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(
      Eigen::Map<const Eigen::MatrixXd>(target.covariance.data(), n, n));
  return solved.eigenvectors() *
         solved.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal().toDenseMatrix();
}

/// A set of `count` spectra drawn from the target.
std::vector<LogSpectrum> drawn_spectra(const SpectrumDistribution& target,
                                       const Eigen::MatrixXd& root, std::size_t count,
                                       std::uint64_t seed, std::size_t set) {
  std::vector<LogSpectrum> spectra;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::VectorXd normal(root.cols());
    for (Eigen::Index k = 0; k < normal.size(); ++k)
      normal[k] = keyed_normal(seed, RandomPurpose::target_spectra, set * count + i,
                               static_cast<std::uint32_t>(k));
    const Eigen::VectorXd above = root * normal;
    LogSpectrum& spectrum = spectra.emplace_back(target.mean);
    for (std::size_t p = 0; p < spectrum.size(); ++p)
      spectrum[p] += above[static_cast<Eigen::Index>(p)];
  }
  return spectra;
}

/// Candidates with their spectra, scaled to the target at its period.
struct SpectraPool {
  Screening screening;
  std::vector<LogSpectrum> spectra;
  std::vector<double> factors;
  std::vector<const std::string*> events;
};

SpectraPool pool_of(const Suite& library, const ConditionalTarget& target,
                    const SelectionCriteria& criteria) {
  std::vector<LogSpectrum> of_record(library.motions.size());
  std::vector<double> factor_of(library.motions.size());
  const auto can_be_scaled = [&](std::size_t record) {
    const RotatedSpectrum rotated =
        rotated_spectrum(library.motions[record], target.spectrum.periods_s);
    const double factor = target.sa_g * standard_gravity_mps2 / rotated.rotd50_mps2[target.period];
    for (const double sa_mps2 : rotated.rotd50_mps2)
      of_record[record].push_back(std::log(factor * sa_mps2 / standard_gravity_mps2));
    factor_of[record] = factor;
    return factor <= criteria.max_scale && factor >= 1.0 / criteria.max_scale;
  };
  SpectraPool pool{screen(library, criteria, can_be_scaled), {}, {}, {}};
  for (const std::size_t record : pool.screening.candidates) {
    pool.spectra.push_back(std::move(of_record[record]));
    pool.factors.push_back(factor_of[record]);
    pool.events.push_back(&library.motions[record].event);
  }
  return pool;
}

/// For each drawn spectrum the closest candidate that is left.
std::vector<std::size_t> closest_to(const std::vector<LogSpectrum>& drawn, const SpectraPool& pool,
                                    std::optional<std::size_t> per_event) {
  std::vector<std::size_t> choice;
  for (const LogSpectrum& spectrum : drawn) {
    std::size_t closest = pool.spectra.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < pool.spectra.size(); ++k) {
      const double distance = distance_square(spectrum, pool.spectra[k]);
      if (!(distance < least) || !may_join(choice, choice.size(), k, pool.events, per_event))
        continue;
      least = distance;
      closest = k;
    }
    choice.push_back(closest);
  }
  return choice;
}

/// Makes the best exchange of each record in turn until none brings the set closer; its deviation.
double improve(std::vector<std::size_t>& choice, const SpectraPool& pool,
               const SpectrumDistribution& target, std::optional<std::size_t> per_event) {
  constexpr int most_rounds = 50;  // each has a smaller deviation: rounding aside it ends before
  constexpr double rounding = 1e-12;
  bool improved = true;
  for (int round = 0; improved && round < most_rounds; ++round) {
    improved = false;
    for (std::size_t out = 0; out < choice.size(); ++out) {
      SpectrumSums others(target);
      for (std::size_t i = 0; i < choice.size(); ++i)
        if (i != out) others.add(pool.spectra[choice[i]]);
      double least = others.deviation_with(pool.spectra[choice[out]]) * (1.0 - rounding);
      for (std::size_t k = 0; k < pool.spectra.size(); ++k) {
        const double deviation = others.deviation_with(pool.spectra[k]);
        if (!(deviation < least) || !may_join(choice, out, k, pool.events, per_event)) continue;
        least = deviation;
        choice[out] = k;
        improved = true;
      }
    }
  }
  SpectrumSums sums(target);
  for (const std::size_t k : choice) sums.add(pool.spectra[k]);
  return sums.deviation();
}

/// A set of candidates that no exchange of one improves.
struct LocalBest {
  std::vector<std::size_t> choice;
  double deviation = 0.0;
};

}  // namespace

double ConditionalSelection::mean_error(const SpectrumDistribution& target) const {
  double largest = 0.0;
  for (std::size_t p = 0; p < target.size(); ++p)
    largest = std::max(largest, std::abs(mean[p] - target.mean[p]));
  return largest;
}

double ConditionalSelection::sigma_error(const SpectrumDistribution& target) const {
  double largest = 0.0;
  for (std::size_t p = 0; p < target.size(); ++p)
    if (target.sigma(p) > 0.0)
      largest = std::max(largest, std::abs(sigma[p] / target.sigma(p) - 1.0));
  return largest;
}

ConditionalSelection select_conditional(const Suite& library, const ConditionalTarget& target,
                                        const SelectionCriteria& criteria, std::uint64_t seed,
                                        std::size_t starts) {
  GLISSADE_EXPECTS(target.period < target.spectrum.size() && target.sa_g > 0.0 && starts > 0);
  SpectraPool pool = pool_of(library, target, criteria);
  const SpectrumDistribution& spectrum = target.spectrum;
  const Eigen::MatrixXd root = root_of_covariance(spectrum);
  std::vector<LocalBest> found(starts);
  in_parallel(starts, [&](std::size_t start) {
    auto& [choice, deviation] = found[start];
    choice = closest_to(drawn_spectra(spectrum, root, criteria.count, seed, start), pool,
                        criteria.per_event);
    deviation = improve(choice, pool, spectrum, criteria.per_event);
  });
  std::vector<std::size_t> choice =
      std::ranges::min_element(found, {}, &LocalBest::deviation)->choice;

  ConditionalSelection selection;
  selection.candidates = pool.spectra.size();
  selection.left_out = std::move(pool.screening.left_out);
  const auto misfit = [&](std::size_t k) {
    return std::sqrt(distance_square(pool.spectra[k], spectrum.mean) /
                     static_cast<double>(spectrum.size()));
  };
  std::ranges::sort(choice);
  std::ranges::stable_sort(choice, {}, misfit);
  SpectrumSums sums(spectrum);
  for (const std::size_t k : choice) {
    sums.add(pool.spectra[k]);
    selection.records.push_back({pool.screening.candidates[k], pool.factors[k], misfit(k)});
    std::vector<double>& sa_g = selection.spectra_g.emplace_back();
    for (const double log_sa : pool.spectra[k]) sa_g.push_back(std::exp(log_sa));
  }
  for (std::size_t p = 0; p < spectrum.size(); ++p) {
    selection.mean.push_back(sums.mean(p));
    selection.sigma.push_back(sums.sigma(p));
  }
  selection.objective = sums.deviation();
  return selection;
}

}  // namespace glissade
