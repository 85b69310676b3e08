// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "glissade/core/units.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/study/analysis/sampling_error.hpp"

namespace glissade {

std::string bound_name(const ProjectFriction& mu) {
  const std::string of_all = "95 % lower bound of the tests";
  return mu.tested.size() > 1 ? of_all + ", " + mu.bound_direction : of_all;
}

std::vector<StudiedFriction> frictions_of(const Project& project) {
  const ProjectFriction& mu = project.friction;
  if (mu.std == 0.0) return {{mu.design(), "mean"}};
  std::vector<StudiedFriction> frictions{{mu.design(), "mean - 2 std"}};
  const double tangent = std::tan(slopes_of(project).back() * rad_per_deg);
  if (mu.lower_bound && *mu.lower_bound < mu.design() && *mu.lower_bound > tangent)
    frictions.insert(frictions.begin(), {*mu.lower_bound, bound_name(mu)});
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
  if (!project.building.alpha.empty()) return ratios;
  const double more = ratios.back() > 0.0 ? 2.0 * ratios.back() : of_none;
  if (!project.of_roof && ratios.size() == 1 && more <= most) ratios.push_back(more);
  return ratios;
}

std::vector<double> periods_of(const Project& project) {
  std::vector<double> periods_s = project.building.period_s;
  if (const double only_s = periods_s.front(); periods_s.size() == 1 && only_s > 0.0)
    periods_s = {0.9 * only_s, only_s, 1.1 * only_s};
  return periods_s;
}

std::vector<double> dampings_of(const Project& project) {
  constexpr double most = 0.999;
  const double stated = project.building.damping;
  if (project.of_roof || stated == 0.0 || stated == most) return {stated};
  return {0.5 * stated, stated, std::min(2.0 * stated, most)};
}

std::optional<FrictionEnds> friction_ends(const Project& project) {
  constexpr double most = 2.0;
  const auto& [mean, std, tests] =
      std::tie(project.friction.mean, project.friction.std, project.friction.tests);
  if (std == 0.0) return std::nullopt;
  const double reach =
      tests ? half_width(std / std::sqrt(static_cast<double>(*tests)), *tests) : std;
  return FrictionEnds{std::max(0.0, mean - reach), std::min(most, mean + reach),
                      tests ? fmt::format("95 % interval of the mean of {} tests", *tests)
                            : "one standard deviation: number of tests not stated"};
}

bool slides_freely_on(const Project& project, double friction) {
  return std::tan(project.slope_deg.back() * rad_per_deg) >= friction;
}

double dbe_level(const Project& project) {
  return project.of_roof ? project.roof_factor : site_values(project.site).sds_g;
}

std::vector<double> levels_of(const Project& project) {
  std::vector<double> shares = {0.25, 0.5, 0.75, 1.0};
  if (project.hazard)
    shares = {0.1,  0.15, 0.2,  0.25, 0.28, 0.31, 0.35, 0.4,
              0.45, 0.5,  0.56, 0.63, 0.71, 0.8,  0.9,  1.0};
  shares.insert(shares.end(), {1.25, mce_over_dbe, 2.0, 2.5, 3.0, 3.75});
  const double dbe = dbe_level(project);
  std::vector<double> levels;
  for (const double share : shares) {
    if (share <= mce_over_dbe || project.of_roof || share * dbe <= most_probable_g)
      levels.push_back(share * dbe);
  }
  return levels;
}

}  // namespace glissade
