// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "glissade/core/units.hpp"

namespace glissade {
namespace {

using Warning = std::optional<std::string>;

// Limits of what is probable. The largest mapped S_S of the United States is near 3 g, the largest
// recorded peak ground acceleration near 4 g; no building of two hundred storeys has a period above
// 10 s.
constexpr double most_probable_g = 4.0, longest_probable_period_s = 10.0,
                 largest_probable_clearance_m = 10.0;

Warning one_axis(const Plan& plan) {
  if (plan.config.two_axes()) return {};
  return "the array slides along one axis only (model.axes = 1): under both horizontal components "
         "it slides farther";
}

Warning without_target(const Plan& plan) {
  const auto& clearance = plan.config.clearance;
  if (!clearance || !clearance->without_target) return {};
  return "NOT FOR DESIGN: the clearance is of a suite that need not meet a design spectrum "
         "(clearance.without_target = true)";
}

Warning strong_levels(const Plan& plan) {
  const IntensityConfig& intensity = plan.config.intensity;
  const double highest = intensity.levels.back();
  if (intensity.measure.unit() != std::string("g") || highest <= most_probable_g) return {};
  return fmt::format("the highest level, {} of {:g} g, is above {:g} g: no site is known for it",
                     intensity.measure.key(), highest, most_probable_g);
}

Warning target_values(const Plan& plan) {
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite) {
    const DesignTarget* target = plan.target_of(suite);
    if (target == nullptr || !target->is_mapped()) continue;
    if (target->s1_g > target->ss_g)
      return fmt::format("S_1 of the target, {:g} g, is above its S_S, {:g} g", target->s1_g,
                         target->ss_g);
    if (target->ss_g > most_probable_g)
      return fmt::format("S_S of the target, {:g} g, is above {:g} g: no site is known for it",
                         target->ss_g, most_probable_g);
  }
  return {};
}

/// ASCE 7-16, 11.4.8 (recalled): where the mapped values and the site coefficients are not enough.
Warning site_specific(const Plan& plan) {
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite) {
    const DesignTarget* target = plan.target_of(suite);
    if (target == nullptr || !target->is_mapped() || target->edition != AsceEdition::asce7_16)
      continue;
    for (const SiteClass site : target->site_classes) {
      const bool is_e = site == SiteClass::e;
      if (!(is_e && target->ss_g >= 1.0) &&
          !((is_e || site == SiteClass::d) && target->s1_g >= 0.2))
        continue;
      return fmt::format(
          "ASCE 7-16, 11.4.8 (recalled: verify) requires a ground motion hazard analysis of the "
          "site, or an exception, for site class {} with S_S {:g} g and S_1 {:g} g",
          to_string(site), target->ss_g, target->s1_g);
    }
  }
  return {};
}

Warning long_periods(const Plan& plan) {
  double longest_s = 0.0;
  for (const Case& c : plan.cases.cases) longest_s = std::max(longest_s, c.period_s);
  if (longest_s <= longest_probable_period_s) return {};
  return fmt::format("a building period of {:g} s is longer than that of any building", longest_s);
}

Warning large_clearances(const Plan& plan) {
  const std::vector<double>& thresholds_m = plan.config.thresholds_m();
  if (thresholds_m.empty() || thresholds_m.back() <= largest_probable_clearance_m) return {};
  return fmt::format("a clearance of {:g} m is more than a roof has", thresholds_m.back());
}

Warning low_friction(const Plan& plan) {
  for (const char* key : {"mu", "across_mu"}) {
    const Quantity& mu = plan.config.quantities.at("friction", key);
    if (mu.is_drawn() && design_friction(*mu.drawn) <= 0.0)
      return fmt::format("the design value of friction.{}, mean - 2 std, is not above 0", key);
  }
  return {};
}

Warning free_sliding(const Plan& plan) {
  const auto free = std::ranges::count_if(plan.cases.cases, slides_freely);
  if (free == 0) return {};
  return fmt::format(
      "{:.2g} % of the cases slide without an earthquake: tan(slope) is friction or more",
      100.0 * static_cast<double>(free) / static_cast<double>(plan.cases.size()));
}

Warning twin_components(const Plan& plan) {
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    const Motion& motion = plan.motion(record);
    if (motion.horizontal_mps2[0] == motion.horizontal_mps2[1])
      return fmt::format("record {} has the same motion as both horizontal components", motion.id);
  }
  return {};
}

}  // namespace

std::vector<std::string> warnings_on(const Plan& plan) {
  std::vector<std::string> warnings;
  for (const auto warning :
       {without_target, one_axis, strong_levels, target_values, site_specific, long_periods,
        large_clearances, low_friction, free_sliding, twin_components}) {
    if (const Warning text = warning(plan)) warnings.push_back(*text);
  }
  return warnings;
}

}  // namespace glissade
