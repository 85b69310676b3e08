// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/design/design_clearance.hpp"

namespace glissade {

std::vector<StudiedFriction> frictions_of(const Project& project) {
  const ProjectFriction& mu = project.friction;
  if (mu.std == 0.0) return {{mu.design(), "mean"}};
  std::vector<StudiedFriction> frictions{
      {mu.design(), "mean - 2 std"}, {mu.mean, "mean"}, {mu.mean + 2.0 * mu.std, "mean + 2 std"}};
  const double tangent = std::tan(slopes_of(project).back() * rad_per_deg);
  if (mu.lower_bound && *mu.lower_bound < mu.design() && *mu.lower_bound > tangent)
    frictions.insert(frictions.begin(), {*mu.lower_bound, "95 % lower bound of the tests"});
  return frictions;
}

std::vector<double> slopes_of(const Project& project) {
  constexpr double steeper_deg = 1.0;
  std::vector<double> slopes = project.slope_deg;
  const double more_deg = slopes.back() + steeper_deg;
  if (slopes.size() == 1 && std::tan(more_deg * rad_per_deg) < project.friction.design())
    slopes.push_back(more_deg);
  return slopes;
}

std::vector<double> mass_ratios_of(const Project& project) {
  constexpr double of_none = 0.05, most = 1.0;
  std::vector<double> ratios = project.building.mass_ratio;
  const double more = ratios.back() > 0.0 ? 2.0 * ratios.back() : of_none;
  if (ratios.size() == 1 && more <= most) ratios.push_back(more);
  return ratios;
}

std::vector<double> periods_of(const Project& project) {
  std::vector<double> periods_s = project.building.period_s;
  if (const double only_s = periods_s.front(); periods_s.size() == 1 && only_s > 0.0)
    periods_s = {0.9 * only_s, only_s, 1.1 * only_s};
  return periods_s;
}

}  // namespace glissade
