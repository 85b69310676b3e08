// SPDX-License-Identifier: GPL-3.0-or-later
// Median spectra of new simulations of each scenario of a suite, with the gain of the suite, over
// the medians of BSSA14: the numbers of suites/README.md.
//   scenario_medians SUITE.toml ...      prints Markdown; 60 simulations a scenario

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "glissade/io/suite_file.hpp"
#include "glissade/motion/simulation/gain_calibration.hpp"

namespace {

using namespace glissade;

constexpr std::size_t simulations = 60;
constexpr std::uint64_t first_realization = 1'000'000;  // beyond those of any recipe
constexpr std::array periods_s = {0.03, 0.04, 0.05, 0.075, 0.1, 0.15, 0.2,
                                  0.3,  0.4,  0.5,  0.75,  1.0, 1.5,  2.0};
using LogRatios = std::array<double, periods_s.size()>;

double mean(const LogRatios& x) {
  double sum = 0.0;
  for (const double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}

/// Mean over simulations of ln(RotD50 / BSSA14's median): the logarithm of the median ratio.
LogRatios median_ratios(const SyntheticRecipe& recipe, const Scenario& scenario,
                        std::uint64_t first) {
  const std::vector<double> target = target_horizontal_mps2(scenario, periods_s);
  LogRatios ratios{};
  for (std::uint64_t k = 0; k < simulations; ++k) {
    const RawMotion motion = shape_motion(
        simulate_raw_motion(scenario, {recipe.seed, first + k}, recipe.dt_s), gain_of(recipe));
    const std::vector<double> spectrum = horizontal_rotd50_mps2(motion, periods_s);
    for (std::size_t p = 0; p < periods_s.size(); ++p)
      ratios[p] += std::log(spectrum[p] / target[p]) / simulations;
  }
  return ratios;
}

std::string range(const LogRatios& x) {
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  return fmt::format("{:.2f} to {:.2f}", std::exp(*low), std::exp(*high));
}

void print_suite(const SyntheticRecipe& recipe) {
  LogRatios pooled{};
  std::uint64_t first = first_realization;
  for (const SyntheticMotion& motion : recipe.motions) {
    const LogRatios ratios = median_ratios(recipe, scenario_of(motion), first);
    first += simulations;
    for (std::size_t p = 0; p < pooled.size(); ++p)
      pooled[p] += ratios[p] / static_cast<double>(recipe.motions.size());
    std::cout << fmt::format("| {} | M {:g}, {:g} km, {:g} m/s | {:.2f} | {} |\n", recipe.name,
                             motion.magnitude, motion.distance_km, motion.vs30_mps,
                             std::exp(mean(ratios)), range(ratios));
  }
  std::cout << fmt::format("| {} | all scenarios | {:.2f} | {} |\n", recipe.name,
                           std::exp(mean(pooled)), range(pooled));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: scenario_medians SUITE.toml ...\n";
    return 2;
  }
  std::cout << "| suite | scenario | median over BSSA14, mean over periods | at single periods |\n"
               "|-|-|-|-|\n";
  for (int i = 1; i < argc; ++i) print_suite(read_recipe(argv[i]));
}
