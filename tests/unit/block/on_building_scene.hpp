// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "glissade/block/on_building.hpp"
#include "unit/block/reference.hpp"

namespace glissade::test {

/// A scene of slide_on_building(): rough motions, and all that can be chosen.
struct OnBuilding {
  double dt_s = 0.005;
  std::vector<double> first, second, up;
  Oscillator vertical{0.0};
  double factor = 1.0;
  BiaxialBuilding building{{{{0.5, 0.05}, {0.8, 0.05}}}, {}, 0.1};
  Block block{{0.3, 0.3}, 2.0 * rad_per_deg, 0.4};
  double tolerance = 1e-6;

  explicit OnBuilding(unsigned seed = 1, std::size_t n = 1200, double peak_mps2 = 20.0)
      : first(made_up_record(n, seed, peak_mps2)),
        second(made_up_record(n, seed + 50, 0.8 * peak_mps2)),
        up(made_up_record(n, seed + 100, 3.0)) {}

  /// Any size of everything.
  OnBuilding(std::mt19937& random, unsigned seed, std::size_t n) : OnBuilding(seed, n, 8.0) {
    const auto uniform = [&](double low, double high) { return test::uniform(random, low, high); };
    dt_s = uniform(0.003, 0.02);
    factor = uniform(0.5, 2.0);
    for (Modes& o : building.horizontal)
      o = {std::exp(uniform(std::log(0.05), std::log(3.0))), uniform(0.01, 0.1)};
    building.mass_ratio = uniform(0.0, 0.5);
    const double mu = uniform(0.05, 0.6);
    block.friction = mu;
    block.slope_rad = uniform(0.0, 0.9) * std::min(std::atan(mu), 0.3);
    block.azimuth_rad = uniform(-3.0, 3.0);
  }

  BuildingGround ground() const {
    BuildingGround g;
    g.horizontal[0] = std::make_shared<GroundTable>(dt_s, first);
    if (!second.empty()) g.horizontal[1] = std::make_shared<GroundTable>(dt_s, second);
    if (up.empty()) return g;
    const auto lifts = std::make_shared<GroundTable>(dt_s, up);
    MotionTable table;
    if (vertical.period_s == 0.0) {
      table = tabulate_rigid(lifts);
    } else {
      table = tabulate_response(lifts, vertical, for_vertical({.quiet_vertical_mps2 = 1e-6}));
    }
    g.vertical = std::make_shared<const MotionTable>(std::move(table));
    return g;
  }
  BuildingSlip result() const {
    return slide_on_building(ground(), {factor, factor}, building, block, tolerance);
  }
  BuildingSlip result(std::span<const double> thresholds_m, std::span<Crossing> crossings) const {
    return slide_on_building(ground(), {factor, factor}, building, block, thresholds_m, crossings,
                             tolerance);
  }
};

}  // namespace glissade::test
