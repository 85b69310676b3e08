// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "glissade/building/building_model.hpp"
#include "glissade/building/motion_table.hpp"
#include "glissade/core/in_parallel.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/units.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/design/of_project.hpp"
#include "glissade/standards/floor_acceleration.hpp"

namespace glissade {
namespace {

struct RoofBuilding {
  double period_s, alpha;
  Modes modes;
};

/// Of the motions of a roof one, rigid.
std::vector<RoofBuilding> buildings_of(const ProjectBuilding& building) {
  const bool is_one_mass = building.alpha.empty();
  const BuildingModel model{is_one_mass ? BuildingModel::Kind::one_mass
                                        : BuildingModel::Kind::cantilever};
  std::vector<RoofBuilding> found;
  for (const double period_s : building.period_s)
    for (const double alpha : is_one_mass ? std::vector<double>{0.0} : building.alpha)
      found.push_back(
          {period_s, alpha, modes_along(model, 0, {period_s, building.damping}, alpha)});
  return found;
}

/// Of each building on one component.
std::vector<double> peaks_mps2(const std::vector<RoofBuilding>& buildings, double dt_s,
                               const Samples& component) {
  std::vector<double> peaks;
  for (const RoofBuilding& building : buildings) {
    const int parts = parts_needed(building.modes, dt_s);
    const auto ground = std::make_shared<GroundTable>(dt_s, component, std::max(parts, 1));
    peaks.push_back(peak_acceleration_mps2(
        parts == 0 ? tabulate_rigid(ground) : tabulate_response(ground, building.modes, {})));
  }
  return peaks;
}

}  // namespace

double RoofPeak::over_standards() const {
  return median_g / std::max(asce7_16_g, asce7_22_g.value_or(0.0));
}

std::vector<RoofPeak> roof_peaks(const Project& project, const Results& demand,
                                 const Suite& suite) {
  expect_of_project(suite.motions.size() == demand.records.size(), "as many records as the suite");
  const std::vector<RoofBuilding> buildings = buildings_of(project.building);
  std::vector<std::vector<double>> peaks_g(buildings.size(),
                                           std::vector<double>(suite.motions.size()));
  in_parallel(suite.motions.size(), [&](std::size_t record) {
    const Motion& motion = suite.motions[record];
    const auto& [first, second] = motion.horizontal_mps2;
    const std::vector<double> along = peaks_mps2(buildings, motion.dt_s, first),
                              across = second.empty() ? along
                                                      : peaks_mps2(buildings, motion.dt_s, second);
    const double factor = dbe_level(project) * demand.records[record].factor_at_unit_level;
    for (std::size_t i = 0; i < buildings.size(); ++i)
      peaks_g[i][record] = factor * std::sqrt(along[i] * across[i]) / standard_gravity_mps2;
  });
  const double sds_g = site_values(project.site).sds_g;
  std::vector<RoofPeak> found;
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    std::ranges::sort(peaks_g[i]);
    RoofPeak& roof = found.emplace_back(
        RoofPeak{buildings[i].period_s, buildings[i].alpha, quantile_of(peaks_g[i], 0.5),
                 quantile_of(peaks_g[i], 0.84), asce7_16_floor_acceleration_g(sds_g)});
    if (roof.period_s > 0.0) roof.asce7_22_g = asce7_22_floor_acceleration_g(sds_g, roof.period_s);
  }
  return found;
}

}  // namespace glissade
