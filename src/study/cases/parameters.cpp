// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cstring>

#include "glissade/building/modes.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/study/cases/case.hpp"

namespace glissade {
namespace {

constexpr ParameterRange coefficient{0.0, 2.0, "0 to 2: no roof has more"};
constexpr ParameterRange damping_ratio{0.0, 0.999, "0 to 0.999"};

/// In the order in which lists vary, the first slowest.
const std::array parameter_rows = {
    Parameter{"building",
              "response_modification",
              "R",
              "-",
              {0.0, infinity, "0, or 1 or more"},
              11,
              "R: the building yields at the design spectrum's elastic demand over R; 0: it stays "
              "elastic",
              [](Case& c) -> double& { return c.response_modification; }},
    Parameter{"building",
              "yield_coefficient",
              "yield coefficient",
              "-",
              {0.0, infinity, "0 or more"},
              12,
              "yield force over the building's weight; 0: it stays elastic",
              [](Case& c) -> double& { return c.yield_coefficient; }},
    Parameter{"building",
              "hardening_ratio",
              "hardening ratio",
              "-",
              {0.0, 0.999, "0 to 0.999"},
              13,
              "stiffness after yielding over that before",
              [](Case& c) -> double& { return c.hardening_ratio; }},
    Parameter{"building",
              "mass_ratio",
              "mass ratio",
              "-",
              {0.0, 1.0, "0 to 1"},
              7,
              "the array's mass over the building's",
              [](Case& c) -> double& { return c.mass_ratio; }},
    Parameter{
        "building",
        "alpha",
        "alpha of the cantilever",
        "-",
        {0.0, largest_alpha, "0 to 500"},
        21,
        "the building is a uniform cantilever of flexure and shear with the first period "
        "period_s (Miranda & Taghavi 2005); usual: 0 to 2 walls, 1.5 to 6 walls with frames and "
        "braced frames, 5 to 20 moment frames (recalled). A smaller one gives more displacement",
        [](Case& c) -> double& { return c.alpha; },
        Parameter::Axes::any,
        "period_s",
        "one mass",
        [](const BuildingModel& b) { return b.kind == BuildingModel::Kind::cantilever; }},
    Parameter{"building", "damping", "building damping", "-", damping_ratio, 3,
              "the building's damping ratio", [](Case& c) -> double& { return c.damping; },
              Parameter::Axes::any, nullptr, nullptr,
              [](const BuildingModel& b) { return !b.has_own_damping; }},
    Parameter{"building",
              "period_ratio",
              "period ratio",
              "-",
              {1e-3, 1e3, "0.001 to 1000"},
              10,
              "period along the building's second axis over that along its first",
              [](Case& c) -> double& { return c.period_ratio; },
              Parameter::Axes::two},
    Parameter{
        "vertical",
        "period_s",
        "vertical period",
        "s",
        {0.0, infinity, "0 or more"},
        14,
        "period of the roof's vertical oscillator; 0: the roof moves vertically with the ground",
        [](Case& c) -> double& { return c.vertical_period_s; }},
    Parameter{"vertical", "damping", "vertical damping", "-", damping_ratio, 15,
              "damping ratio of that oscillator",
              [](Case& c) -> double& { return c.vertical_damping; }},
    Parameter{"friction",
              "static_over_sliding",
              "static over sliding friction",
              "-",
              {1.0, 100.0, "1 to 100: static friction is not below sliding friction"},
              16,
              "friction at rest over friction while sliding",
              [](Case& c) -> double& { return c.law.static_over_sliding; }},
    Parameter{"friction",
              "fast_over_slow",
              "fast over slow friction",
              "-",
              {1e-3, 1e3, "0.001 to 1000"},
              17,
              "friction of fast sliding over that of slow sliding, which mu is",
              [](Case& c) -> double& { return c.law.fast_over_slow; },
              Parameter::Axes::any,
              "rate_s_per_m"},
    Parameter{"friction",
              "rate_s_per_m",
              "friction rate",
              "s/m",
              {0.0, 1e5, "0 to 1e+05 (100,000)"},  // beyond, 1/a is less than 10 um/s
              18,
              "rate a of mu_fast - (mu_fast - mu_slow) exp(-a speed)",
              [](Case& c) -> double& { return c.law.rate_s_per_m; },
              Parameter::Axes::any,
              "fast_over_slow"},
    Parameter{"building",
              "period_s",
              "building period",
              "s",
              {0.0, infinity, "0 or more"},
              2,
              "the building's period along its first axis, without the array; 0: rigid",
              [](Case& c) -> double& { return c.period_s; }},
    Parameter{"roof",
              "azimuth_deg",
              "roof azimuth",
              "deg",
              {-360.0, 360.0, "-360 to 360 degrees"},
              8,
              "from the building's first axis to where the roof falls, toward the second",
              [](Case& c) -> double& { return c.azimuth_deg; },
              Parameter::Axes::two},
    Parameter{"roof",
              "slope_deg",
              "slope",
              "deg",
              {-89.9, 89.9, "-89.9 to 89.9 degrees"},
              1,
              "the roof's slope; positive where it falls toward the building's first axis",
              [](Case& c) -> double& { return c.slope_deg; }},
    Parameter{"friction", "mu", "friction", "-", coefficient, 0,
              "coefficient of friction along the slope",
              [](Case& c) -> double& { return c.friction; }},
    Parameter{"friction", "across_mu", "friction across", "-", coefficient, 6,
              "coefficient of friction across the slope",
              [](Case& c) -> double& { return c.friction_across; }, Parameter::Axes::two},
    Parameter{"friction", "neighbour_mu", "friction of the neighbour", "-", coefficient, 19,
              "coefficient of friction along the slope of a second, similar array on the roof, "
              "below or beside the first (or as roof.neighbour_slope states); 0: there is none",
              [](Case& c) -> double& { return c.neighbour_friction; }, Parameter::Axes::two},
    Parameter{
        "friction",
        "neighbour_over_mu",
        "friction of the neighbour over mu",
        "-",
        {0.0, 10.0, "0 to 10"},
        20,
        "the same over mu, for friction that is listed, in place of neighbour_mu; 0: not so stated",
        [](Case& c) -> double& { return c.neighbour_over_mu; },
        Parameter::Axes::two},
};

}  // namespace

bool Parameter::moves_roof() const {
  return std::strcmp(table, "building") == 0 || std::strcmp(table, "vertical") == 0;
}

std::string Parameter::description() const {
  return is_of == nullptr ? meaning : fmt::format("{} (NaN: not of this building)", meaning);
}

double value_of(const Parameter& parameter, const Case& c, const BuildingModel& building) {
  return parameter.is_of == nullptr || parameter.is_of(building) ? value_of(parameter, c) : nan;
}

std::span<const Parameter> parameters() { return parameter_rows; }

std::size_t parameter_index(const char* in_table, const char* key) {
  for (std::size_t i = 0; i < parameter_rows.size(); ++i) {
    if (std::strcmp(parameter_rows[i].table, in_table) == 0 &&
        std::strcmp(parameter_rows[i].key, key) == 0)
      return i;
  }
  GLISSADE_EXPECTS(false);
  return parameter_rows.size();
}

}  // namespace glissade
