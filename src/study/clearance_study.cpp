// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/clearance_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/bytes.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/study/kernel.hpp"
#include "keep_records.hpp"

namespace glissade {
namespace {

bool yields(const ClearanceGrid& grid) { return grid.response_modification.back() > 1.0; }

bool requires_vertical(const ClearanceGrid& grid) {
  return std::ranges::any_of(grid.vertical, [](const VerticalCondition& condition) {
    return condition.use == VerticalChoice::required;
  });
}

void check(const ClearanceConfig& config, const Suite& suite, const std::string& file,
           ProblemList& problems) {
  if (yields(config.grid) && !suite.target) {
    problems.add({file, "has no [target], and a building's strength for R above 1 rests on it",
                  "give the suite its design spectrum, or ask for R = 1 only", ""});
  }
  for (const Motion& motion : suite.motions) {
    if (motion.horizontal_mps2[1].empty()) {
      problems.add({file, "record " + motion.id + " has no second horizontal component",
                    "a clearance study shakes both axes: add it, or leave the record out", ""});
    }
    if (requires_vertical(config.grid) && motion.vertical_mps2.empty()) {
      problems.add({file, "record " + motion.id + " has no vertical component",
                    "use vertical = \"if_available\", or leave the record out", ""});
    }
    if (horizontal_pga_mps2(motion, HorizontalCombination::srss) == 0.0) {
      problems.add({file, "record " + motion.id + " is zero throughout", "leave it out", ""});
    }
  }
}

double friction_along(const ClearanceConfig& config, SlopeAxis axis) {
  return config.friction[static_cast<std::size_t>(axis)].design();
}

bool same_histories(const ClearanceConfig& config, const GroundOrientation& a,
                    const GroundOrientation& b) {
  const bool alike =
      friction_along(config, SlopeAxis::e_w) == friction_along(config, SlopeAxis::n_s);
  return a.azimuth_deg == b.azimuth_deg && (a.slope_axis == b.slope_axis || alike);
}

std::vector<std::size_t> same_as(const ClearanceConfig& config,
                                 const std::vector<GroundOrientation>& all) {
  std::vector<std::size_t> first(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::size_t j = 0;
    while (!same_histories(config, all[j], all[i])) ++j;
    first[i] = j;
  }
  return first;
}

std::string hash_of(const ClearancePlan& plan) {
  Hasher hasher;
  hasher.text("clearance study").text(plan.config.source_text);
  for (const Suite& suite : plan.suites) {
    hasher.number(std::uint64_t{suite.motions.size()});
    for (const Motion& motion : suite.motions) {
      hasher.text(motion.id).number(motion.scale).number(motion.dt_s);
      hasher.numbers(motion.horizontal_mps2[0]).numbers(motion.horizontal_mps2[1]);
      hasher.numbers(motion.vertical_mps2);
    }
  }
  return to_hex(hasher.value());
}

std::string names_of(const std::vector<Suite>& suites) {
  std::vector<std::string> names;
  for (const Suite& suite : suites)
    names.push_back(fmt::format("{} ({} records)", suite.name, suite.motions.size()));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

double displacement_m(const ClearanceHistory& history, DisplacementMeasure measure) {
  return measure == DisplacementMeasure::vector
             ? history.peak_m
             : std::hypot(history.peak_along_m, history.peak_across_m);
}

double base_shear(const ClearanceHistory& history) {
  return std::hypot(history.shear_along, history.shear_across);
}

ClearancePlan make_plan(const ClearanceConfig& config, std::vector<Suite> suites) {
  GLISSADE_EXPECTS(suites.size() == config.suite_files.size() && !suites.empty());
  GLISSADE_EXPECTS(config.grid.count() > 0 && !config.slope_axes.empty());
  ClearancePlan plan{.config = config,
                     .suites = std::move(suites),
                     .records = {},
                     .orientations = orientations(config.orientation, config.slope_axes),
                     .same_as = {},
                     .run = {},
                     .hash = {}};
  ProblemList problems;
  for (std::size_t i = 0; i < plan.suites.size(); ++i) {
    keep_records({config.file, config.suite_files[i], config.records}, plan.suites[i]);
    check(config, plan.suites[i], config.suite_files[i].string(), problems);
    for (std::size_t j = 0; j < plan.suites[i].motions.size(); ++j) plan.records.push_back({i, j});
  }
  problems.throw_if_any();
  plan.same_as = same_as(config, plan.orientations);
  for (std::size_t i = 0; i < plan.orientations.size(); ++i) {
    if (plan.same_as[i] == i) plan.run.push_back(i);
  }
  plan.hash = hash_of(plan);
  return plan;
}

std::string to_string(const ClearancePlan& plan) {
  const ClearanceGrid& grid = plan.config.grid;
  std::string text = fmt::format("Clearance study {}\n", plan.config.name);
  text += fmt::format("Suites        {}\n", names_of(plan.suites));
  text += fmt::format("Model         {}\n", describe(Kernel::full));
  text += fmt::format("Shaking       {:.3g} of MCE\n", fmt::join(grid.fraction_of_mce, ", "));
  text +=
      fmt::format("Buildings     T {:g} s; m/M {:g}; R {:g}\n", fmt::join(grid.period_s, ", "),
                  fmt::join(grid.mass_ratio, ", "), fmt::join(grid.response_modification, ", "));
  text += fmt::format("Roofs         slope {:.3g} deg; friction E-W {:g}, N-S {:g}\n",
                      fmt::join(grid.slope_deg, ", "), friction_along(plan.config, SlopeAxis::e_w),
                      friction_along(plan.config, SlopeAxis::n_s));
  text += fmt::format("Orientations  {}, of which {} differ\n", plan.orientations.size(),
                      plan.run.size());
  text += fmt::format("Histories     {}, in {} units\n", plan.histories(), plan.units());
  return text + fmt::format("Plan hash     {}\n", plan.hash);
}

std::vector<char> pack(const std::vector<ClearanceUnit>& units) {
  ByteWriter out;
  out.put(units.size());
  for (const ClearanceUnit& unit : units) out.put(unit.unit).put(unit.histories);
  return out.take();
}

std::vector<ClearanceUnit> unpack_clearance_units(const std::vector<char>& bytes) {
  ByteReader in(bytes);
  std::size_t count = 0;
  in.get(count);
  std::vector<ClearanceUnit> units(count);
  for (ClearanceUnit& unit : units) in.get(unit.unit).get(unit.histories);
  return units;
}

}  // namespace glissade
