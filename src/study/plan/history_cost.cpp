// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan/history_cost.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "glissade/building/motion_table.hpp"
#include "glissade/study/cases/case_scene.hpp"

namespace glissade {
namespace {

/// Values that stand for all: those that are listed, or quantiles.
std::vector<double> some_values(const Quantity& quantity) {
  if (!quantity.drawn) return quantity.values;
  std::vector<double> values;
  for (const double share : {0.02, 0.2, 0.4, 0.6, 0.8, 0.98})
    values.push_back(quantile(*quantity.drawn, share));
  return values;
}

}  // namespace

HistoryCost history_cost(Kernel kernel, const StudyConfig& config, double step_s) {
  constexpr double ring_down_s = 120.0;  // RoofMotionOptions, the limit
  const double at_5_percent = 1.0 / (2.0 * std::numbers::pi * 0.05);
  const double cycle_us = kernel == Kernel::tables ? 0.5 : 32.0,
               base_us = history_us(kernel, config);
  Case c;
  if (!config.quantities.at("building", "alpha").drawn)
    c.alpha = config.quantities.at("building", "alpha").values.front();
  HistoryCost cost;
  double count = 0.0;
  for (const double period_s : some_values(config.quantities.at("building", "period_s")))
    for (const double damping : some_values(config.quantities.at("building", "damping"))) {
      c.period_s = period_s;
      c.damping = damping;
      double us = base_us, cycles = 0.0;
      const Modes modes = building_axes(c, config.building)[0];
      us *= std::max(1, parts_needed(modes, step_s));
      for (const Mode& mode : modes)
        if (mode.period_s > 0.0)
          cycles = std::max(cycles, std::min(ring_down_s / mode.period_s,
                                             1.0 / (2.0 * std::numbers::pi * mode.damping_ratio)));
      us += cycle_us * std::max(0.0, cycles - at_5_percent);
      cost.mean_us += us;
      cost.largest_us = std::max(cost.largest_us, us);
      ++count;
    }
  cost.mean_us /= count;
  return cost;
}

double predicted_fit_seconds(const Plan& plan) {
  const double resample_us = 40.0 + 9.0 * static_cast<double>(plan.records.size());  // measured
  return 1e-6 * resample_us * static_cast<double>(plan.config.sampling.bootstrap_replicates) *
         static_cast<double>(plan.config.thresholds_m().size() * plan.cases.combinations());
}

}  // namespace glissade
