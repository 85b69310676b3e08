// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/suite_scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"

namespace glissade {
namespace {

/// SRSS spectra of the unscaled horizontals in g, one row per motion.
std::vector<std::vector<double>> srss_spectra_g(const Suite& suite,
                                                const std::vector<double>& periods_s) {
  std::vector<std::vector<double>> spectra;
  for (const Motion& motion : suite.motions) {
    spectra.push_back(horizontal_spectrum_mps2(motion, periods_s, HorizontalCombination::srss));
    for (double& sa : spectra.back()) sa /= standard_gravity_mps2;
  }
  return spectra;
}

std::vector<double> target_at(const std::function<double(double)>& target_sa_g,
                              const std::vector<double>& periods_s) {
  std::vector<double> target(periods_s.size());
  std::ranges::transform(periods_s, target.begin(), target_sa_g);
  GLISSADE_EXPECTS(
      std::ranges::all_of(target, [](double sa) { return std::isfinite(sa) && sa > 0.0; }));
  return target;
}

void check_suite(const Suite& suite, ProblemList& problems) {
  if (suite.motions.empty()) {
    problems.add({suite.name, "the suite has no motions", "give at least one", ""});
  }
  for (const Motion& motion : suite.motions) {
    if (horizontal_pga_mps2(motion, HorizontalCombination::srss) == 0.0) {
      problems.add(
          {motion.id,
           "the motion's horizontals are zero throughout: no factor brings them to a target",
           "leave it out of the suite", ""});
    }
  }
}

/// The factor that brings a spectrum closest to the target in least squares of ln Sa: the mean log
/// ratio.
double closest_factor(const std::vector<double>& spectrum_g, const std::vector<double>& target_g) {
  double sum = 0.0;
  for (std::size_t i = 0; i < target_g.size(); ++i) sum += std::log(target_g[i] / spectrum_g[i]);
  return std::exp(sum / static_cast<double>(target_g.size()));
}

/// The least common factor c with (1/n) sum_j min(c f_j, f_max) S_j >= target at one period, where
/// all motions at f_max suffice. The left side is concave and piecewise linear in c, with a corner
/// at each c = f_max / f_j.
double common_factor(const std::vector<double>& factors, const std::vector<double>& sa_g,
                     double max_factor, double target_g) {
  std::vector<std::size_t> order(factors.size());  // in which motions reach their limit
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    return factors[i] != factors[j] ? factors[i] > factors[j] : i < j;
  });
  double needed = target_g * static_cast<double>(factors.size());  // of the motions not yet held
  double slope = 0.0;
  for (const std::size_t j : order) slope += factors[j] * sa_g[j];
  for (const std::size_t j : order) {
    if (needed <= slope * (max_factor / factors[j])) return needed / slope;
    needed -= max_factor * sa_g[j];
    slope -= factors[j] * sa_g[j];
  }
  return max_factor / factors[order.back()];
}

double average(const std::vector<double>& factors, const std::vector<double>& sa_g) {
  return std::inner_product(factors.begin(), factors.end(), sa_g.begin(), 0.0) /
         static_cast<double>(factors.size());
}

std::vector<double> column(const std::vector<std::vector<double>>& spectra, std::size_t i) {
  std::vector<double> values(spectra.size());
  std::ranges::transform(spectra, values.begin(),
                         [i](const auto& spectrum) { return spectrum[i]; });
  return values;
}

/// The period at which `factors` leave the average lowest beside the target, and the ratio there.
struct Lowest {
  double period_s;
  double ratio;
};

Lowest lowest_ratio(const std::vector<double>& factors,
                    const std::vector<std::vector<double>>& spectra,
                    const std::vector<double>& target_g, const std::vector<double>& periods_s) {
  Lowest lowest{0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < periods_s.size(); ++i) {
    const double ratio = average(factors, column(spectra, i)) / target_g[i];
    if (ratio < lowest.ratio) lowest = {periods_s[i], ratio};
  }
  return lowest;
}

}  // namespace

std::vector<double> walters_periods_s() {
  std::vector<double> periods_s;
  for (int i = 0; i < 200; ++i) periods_s.push_back(i / 1000.0);
  for (int i = 80; i < 200; ++i) periods_s.push_back(i / 400.0);
  for (int i = 100; i <= 400; ++i) periods_s.push_back(i / 200.0);
  return periods_s;
}

double suite_average_factor(const Suite& suite, const std::function<double(double)>& target_sa_g,
                            const std::vector<double>& periods_s) {
  GLISSADE_EXPECTS(!periods_s.empty());
  ProblemList problems;
  check_suite(suite, problems);
  problems.throw_if_any();

  const std::vector<std::vector<double>> spectra = srss_spectra_g(suite, periods_s);
  const std::vector<double> target_g = target_at(target_sa_g, periods_s);
  std::vector<double> own_scales(suite.motions.size());
  std::ranges::transform(suite.motions, own_scales.begin(), &Motion::scale);
  return 1.0 / lowest_ratio(own_scales, spectra, target_g, periods_s).ratio;
}

SuiteScaling scale_suite_to_target(const Suite& suite,
                                   const std::function<double(double)>& target_sa_g,
                                   const std::vector<double>& periods_s, double max_factor) {
  GLISSADE_EXPECTS(!periods_s.empty());
  ProblemList problems;
  check_suite(suite, problems);
  if (!(std::isfinite(max_factor) && max_factor > 0.0)) {
    problems.add({suite.name, fmt::format("max_factor = {} is not a positive number", max_factor),
                  "Walters et al. (2012) went up to 3 to 6, with the intensity level", ""});
  }
  problems.throw_if_any();

  const std::vector<std::vector<double>> spectra = srss_spectra_g(suite, periods_s);
  const std::vector<double> target_g = target_at(target_sa_g, periods_s);
  const std::vector<double> limits(spectra.size(), max_factor);
  const Lowest reach = lowest_ratio(limits, spectra, target_g, periods_s);
  if (reach.ratio < 1.0) {
    throw InputError(
        {suite.name,
         fmt::format(
             "with every motion at max_factor = {} the average is {:.3g} of the target at {} s",
             max_factor, reach.ratio, reach.period_s),
         fmt::format("allow a factor of {:.4g} at least, or choose stronger motions",
                     max_factor / reach.ratio),
         ""});
  }

  SuiteScaling scaling;
  scaling.factors.resize(spectra.size());
  std::ranges::transform(spectra, scaling.factors.begin(),
                         [&](const auto& spectrum) { return closest_factor(spectrum, target_g); });
  double common = 0.0;
  for (std::size_t i = 0; i < periods_s.size(); ++i) {
    const double factor =
        common_factor(scaling.factors, column(spectra, i), max_factor, target_g[i]);
    if (factor > common) {
      common = factor;
      scaling.controlling_period_s = periods_s[i];
    }
  }
  for (double& factor : scaling.factors) factor = std::min(common * factor, max_factor);
  scaling.largest_factor = std::ranges::max(scaling.factors);
  return scaling;
}

}  // namespace glissade
