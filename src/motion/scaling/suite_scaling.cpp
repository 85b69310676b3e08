// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/suite_scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/motion/intensity.hpp"
#include "spectral_scaling.hpp"

namespace glissade {
namespace {

/// A row per motion.
SpectrumRows srss_spectra_g(const Suite& suite, const std::vector<double>& periods_s) {
  SpectrumRows spectra;
  for (const Motion& motion : suite.motions) spectra.push_back(srss_spectrum_g(motion, periods_s));
  return spectra;
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

}  // namespace

std::vector<double> walters_periods_s() {
  std::vector<double> periods_s;
  for (int i = 0; i < 200; ++i) periods_s.push_back(i / 1000.0);
  for (int i = 80; i < 200; ++i) periods_s.push_back(i / 400.0);
  for (int i = 100; i <= 400; ++i) periods_s.push_back(i / 200.0);
  return periods_s;
}

std::vector<double> periods_beyond_scaled_s(double to_s) {
  GLISSADE_EXPECTS(to_s > longest_scaled_period_s);
  constexpr double growth = 1.005;
  std::vector<double> periods_s;
  for (double t_s = longest_scaled_period_s; t_s < to_s; t_s *= growth) periods_s.push_back(t_s);
  periods_s.push_back(to_s);
  return periods_s;
}

namespace {

void refuse_improper(const Suite& suite) {
  ProblemList problems;
  check_suite(suite, problems);
  problems.throw_if_any();
}

double average_factor(const Suite& suite, const std::function<double(double)>& target_sa_g,
                      const std::vector<double>& periods_s, const SpectrumRows& rows) {
  const Spectra spectra(rows.begin(), rows.end());
  const std::vector<double> target_g = target_at(target_sa_g, periods_s);
  std::vector<double> own_scales(suite.motions.size());
  std::ranges::transform(suite.motions, own_scales.begin(), &Motion::scale);
  return 1.0 / lowest_ratio(own_scales, spectra, target_g).ratio;
}

}  // namespace

double suite_average_factor(const Suite& suite, const std::function<double(double)>& target_sa_g,
                            const std::vector<double>& periods_s) {
  GLISSADE_EXPECTS(!periods_s.empty());
  refuse_improper(suite);
  return average_factor(suite, target_sa_g, periods_s, srss_spectra_g(suite, periods_s));
}

double suite_average_factor(const Suite& suite, const std::function<double(double)>& target_sa_g,
                            const SpectrumRows& walters_spectra_g) {
  refuse_improper(suite);
  return average_factor(suite, target_sa_g, walters_periods_s(), walters_spectra_g);
}

void normalise_by_pgv(Suite& suite) {
  refuse_improper(suite);
  std::vector<double> pgv_mps;
  for (const Motion& motion : suite.motions)
    pgv_mps.push_back(motion.scale *
                      horizontal_pgv_mps(motion, HorizontalCombination::geometric_mean));
  const double median_mps = quantile_of(pgv_mps, 0.5);
  for (std::size_t i = 0; i < pgv_mps.size(); ++i)
    suite.motions[i].scale *= median_mps / pgv_mps[i];
}

namespace {

using RatiosAt = std::function<std::vector<double>(const std::vector<double>&)>;

/// The least of `ratios_at` between two periods that enclose a minimum.
SpectralRatio refined_minimum(const RatiosAt& ratios_at, double from_s, double to_s) {
  constexpr int parts = 10, rounds = 4;
  SpectralRatio least{std::numeric_limits<double>::infinity(), from_s};
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> periods_s;
    for (int i = 0; i <= parts; ++i)
      periods_s.push_back(std::lerp(from_s, to_s, static_cast<double>(i) / parts));
    const std::vector<double> ratios = ratios_at(periods_s);
    const auto at = static_cast<std::size_t>(std::ranges::min_element(ratios) - ratios.begin());
    if (ratios[at] < least.ratio) least = {ratios[at], periods_s[at]};
    from_s = periods_s[at == 0 ? 0 : at - 1];
    to_s = periods_s[std::min<std::size_t>(at + 1, parts)];
  }
  return least;
}

SpectralRatio least_ratio(const RatiosAt& ratios_at, const std::vector<double>& periods_s,
                          const std::vector<double>& ratios) {
  const double lowest = std::ranges::min(ratios);
  SpectralRatio least{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, ratios.size() - 1);
    if (ratios[i] > ratios[before] || ratios[i] > ratios[after]) continue;
    // Below its neighbours a parabola falls so far; four times that is on the safe side.
    const double width = ratios[after] - ratios[before],
                 bend = ratios[after] + ratios[before] - 2.0 * ratios[i];
    const double fall = bend > 0.0 ? 4.0 * width * width / (8.0 * bend) : 0.0;
    if (ratios[i] - fall > lowest) continue;
    // Between 0 and the first period an oscillator swings many times a sample, and shows the PGA.
    const SpectralRatio here =
        i == 0 ? SpectralRatio{ratios[i], periods_s[i]}
               : refined_minimum(ratios_at, periods_s[before], periods_s[after]);
    if (here.ratio < least.ratio) least = here;
  }
  return least;
}

}  // namespace

SpectralRatios ratios_to_target(const Suite& suite, const std::vector<double>& factors,
                                const std::function<double(double)>& target_sa_g) {
  return ratios_to_target(suite, factors, target_sa_g, srss_spectra_g(suite, walters_periods_s()));
}

SpectralRatios ratios_to_target(const Suite& suite, const std::vector<double>& factors,
                                const std::function<double(double)>& target_sa_g,
                                const SpectrumRows& walters_spectra_g) {
  GLISSADE_EXPECTS(factors.size() == suite.motions.size() && !factors.empty());
  const auto ratios_of = [&](const SpectrumRows& rows, const std::vector<double>& periods_s) {
    return average_ratios(factors, Spectra(rows.begin(), rows.end()),
                          target_at(target_sa_g, periods_s));
  };
  const auto ratios_at = [&](const std::vector<double>& periods_s) {
    return ratios_of(srss_spectra_g(suite, periods_s), periods_s);
  };
  const auto negated_at = [&](const std::vector<double>& periods_s) {
    std::vector<double> ratios = ratios_at(periods_s);
    for (double& ratio : ratios) ratio = -ratio;
    return ratios;
  };
  const std::vector<double> periods_s = walters_periods_s();
  std::vector<double> ratios = ratios_of(walters_spectra_g, periods_s);
  const SpectralRatio lowest = least_ratio(ratios_at, periods_s, ratios);
  for (double& ratio : ratios) ratio = -ratio;
  const SpectralRatio highest = least_ratio(negated_at, periods_s, ratios);
  return {lowest, {-highest.ratio, highest.period_s}};
}

SpectralRatio lowest_ratio_to_target(const Suite& suite, const std::vector<double>& factors,
                                     const std::function<double(double)>& target_sa_g,
                                     const std::vector<double>& periods_s) {
  GLISSADE_EXPECTS(factors.size() == suite.motions.size() && !periods_s.empty());
  const SpectrumRows rows = srss_spectra_g(suite, periods_s);
  const AverageRatio lowest =
      lowest_ratio(factors, Spectra(rows.begin(), rows.end()), target_at(target_sa_g, periods_s));
  return {lowest.ratio, periods_s[lowest.period]};
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

  const SpectrumRows rows = srss_spectra_g(suite, periods_s);
  const Spectra spectra(rows.begin(), rows.end());
  const std::vector<double> target_g = target_at(target_sa_g, periods_s);
  const std::vector<double> limits(spectra.size(), max_factor);
  const AverageRatio reach = lowest_ratio(limits, spectra, target_g);
  if (reach.ratio < 1.0) {
    throw InputError(
        {suite.name,
         fmt::format(
             "with every motion at max_factor = {} the average is {:.3g} of the target at {} s",
             max_factor, reach.ratio, periods_s[reach.period]),
         fmt::format("allow a factor of {:.4g} at least, or choose stronger motions",
                     max_factor / reach.ratio),
         ""});
  }

  std::vector<double> closest(spectra.size());
  std::ranges::transform(spectra, closest.begin(), [&](std::span<const double> spectrum) {
    return closest_factor(spectrum, target_g);
  });
  const LiftedFactors lifted = lift_to_target(closest, spectra, target_g, max_factor);
  return {lifted.factors, std::ranges::max(lifted.factors), periods_s[lifted.controlling_period]};
}

}  // namespace glissade
