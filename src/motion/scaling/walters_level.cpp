// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/walters_level.hpp"

#include <array>
#include <string>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"

namespace glissade {
namespace {

using Levels = std::array<WaltersLevel, 5>;

// Walters et al. (2012), Tables 1 and 2.
constexpr Levels sites_a_to_d = {{
    {0.45, 0.18, 5.9, 6.9, 10, 75, 340, 900, 3},
    {0.70, 0.27, 5.9, 6.9, 5, 50, 260, 600, 3},
    {1.95, 0.80, 6.7, 7.6, 5, 50, 260, 800, 4},
    {2.60, 1.10, 6.7, 7.6, 0, 15, 320, 800, 5},
    {3.70, 1.38, 6.7, 7.6, 0, 25, 270, 660, 6},
}};
constexpr Levels sites_e = {{
    {0.45, 0.18, 6.0, 6.9, 10, 60, 190, 280, 3},
    {0.70, 0.27, 5.8, 6.9, 5, 30, 190, 280, 4},
    {1.95, 0.80, 6.5, 7.6, 5, 50, 115, 285, 4},
    {2.60, 1.10, 6.5, 7.6, 0, 30, 190, 280, 5},
    {3.70, 1.38, 6.5, 7.6, 0, 25, 210, 280, 5},
}};

std::size_t level_index(int level) {
  if (level < 0 || level > 4)
    throw InputError(Problem{
        "", "level = " + std::to_string(level) + " is not one of Walters's Intensity Levels",
        "give a level from 0 to 4", ""});
  return static_cast<std::size_t>(level);
}

}  // namespace

const WaltersLevel& walters_level(int level, SiteGroup sites) {
  return (sites == SiteGroup::e ? sites_e : sites_a_to_d)[level_index(level)];
}

DesignTarget walters_target(int level, SiteGroup sites) {
  const WaltersLevel& of_level = walters_level(level, sites);
  DesignTarget target{
      .edition = AsceEdition::asce7_10, .ss_g = of_level.ss_g, .s1_g = of_level.s1_g};
  target.site_classes = {SiteClass::a, SiteClass::b, SiteClass::c, SiteClass::d};
  if (sites == SiteGroup::e) target.site_classes = {SiteClass::e};
  return target;
}

std::optional<int> intensity_level(const MappedValues& site) {
  GLISSADE_EXPECTS(site.ss_g > 0.0 && site.s1_g > 0.0);
  for (int level = 0; level <= 4; ++level) {
    const WaltersLevel& most = walters_level(level);
    if (site.ss_g <= most.ss_g && site.s1_g <= most.s1_g) return level;
  }
  return std::nullopt;
}

}  // namespace glissade
