// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/gain_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/response_spectrum.hpp"
#include "glissade/motion/simulation/bssa14.hpp"
#include "glissade/motion/simulation/gulerce_abrahamson.hpp"

namespace glissade {
namespace {

constexpr std::array gain_frequencies = {0.25, 0.4, 0.65, 1.0,  1.4,  1.9,  2.6,  3.6,
                                         5.0,  7.0, 10.0, 13.0, 18.0, 25.0, 33.0, 50.0};

}  // namespace

std::vector<double> target_horizontal_mps2(const Scenario& scenario,
                                           std::span<const double> periods_s) {
  std::vector<double> target;
  for (const double period_s : periods_s)
    target.push_back(bssa14_median_sa_g(scenario, period_s) * standard_gravity_mps2);
  return target;
}

std::vector<double> target_vertical_mps2(const Scenario& scenario,
                                         std::span<const double> periods_s) {
  std::vector<double> target = target_horizontal_mps2(scenario, periods_s);
  for (std::size_t p = 0; p < target.size(); ++p)
    target[p] *= vertical_to_horizontal_ratio(scenario, periods_s[p]);
  return target;
}

std::vector<double> horizontal_rotd50_mps2(const RawMotion& motion,
                                           std::span<const double> periods_s) {
  constexpr std::size_t orientations = 6;
  const auto& [first, second, vertical] = motion.acceleration_mps2;
  std::array<std::vector<double>, orientations> spectra;
  GLISSADE_EXPECTS(first.size() == second.size());
  std::vector<double> rotated(first.size());
  for (std::size_t k = 0; k < orientations; ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / orientations;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    std::transform(first.begin(), first.end(), second.begin(), rotated.begin(),
                   [&](double x, double y) { return cosine * x + sine * y; });
    spectra[k] = pseudo_acceleration_spectrum(motion.dt_s, rotated, periods_s);
  }
  std::vector<double> median;
  for (std::size_t p = 0; p < periods_s.size(); ++p) {
    std::vector<double> values;
    for (const auto& spectrum : spectra) values.push_back(spectrum[p]);
    median.push_back(quantile_of(std::move(values), 0.5));
  }
  return median;
}

std::vector<double> vertical_spectrum_mps2(const RawMotion& motion,
                                           std::span<const double> periods_s) {
  return pseudo_acceleration_spectrum(motion.dt_s, motion.acceleration_mps2[2], periods_s);
}

std::span<const double> gain_frequencies_hz() { return gain_frequencies; }

SuiteGain calibrate_gain(std::span<const EnsembleMember> ensemble) {
  constexpr int updates = 5;
  constexpr double step = 0.8;
  constexpr std::size_t count = gain_frequencies.size();
  std::array<double, count> periods_s;
  std::transform(gain_frequencies.begin(), gain_frequencies.end(), periods_s.begin(),
                 [](double f) { return 1.0 / f; });
  using LogRatios = std::array<double, count>;
  const auto add_logs = [](LogRatios& sum, const std::vector<double>& simulated,
                           const std::vector<double>& target) {
    for (std::size_t p = 0; p < count; ++p) sum[p] += std::log(simulated[p] / target[p]);
  };
  const auto update = [&](SpectralGain& gain, const LogRatios& sum) {
    for (std::size_t p = 0; p < count; ++p)
      gain.values[p] *= std::exp(-step * sum[p] / static_cast<double>(ensemble.size()));
  };

  const SpectralGain unit{{gain_frequencies.begin(), gain_frequencies.end()},
                          std::vector<double>(count, 1.0)};
  SuiteGain gain{unit, unit};
  for (int k = 0; k < updates; ++k) {
    LogRatios horizontal{}, vertical{};
    for (const EnsembleMember& member : ensemble) {
      const RawMotion motion = shape_motion(member.raw, gain);
      add_logs(horizontal, horizontal_rotd50_mps2(motion, periods_s),
               target_horizontal_mps2(member.scenario, periods_s));
      add_logs(vertical, vertical_spectrum_mps2(motion, periods_s),
               target_vertical_mps2(member.scenario, periods_s));
    }
    update(gain.horizontal, horizontal);
    update(gain.vertical, vertical);
  }
  return gain;
}

}  // namespace glissade
