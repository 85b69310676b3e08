// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "glissade/io/suite_file.hpp"
#include "glissade/study/run/execute.hpp"
#include "glissade/study/run/reduce.hpp"

namespace glissade::verification {

inline Plan plan_of(const StudyConfig& config) {
  std::vector<Suite> suites;
  for (const std::filesystem::path& file : config.suite_files) suites.push_back(load_suite(file));
  return make_plan(config, std::move(suites));
}

inline Results run_study(const Plan& plan) {
  RoofStore roofs(plan, Skipping::all);
  std::vector<UnitResult> units;
  for (std::size_t unit = 0; unit < plan.units.size(); ++unit)
    units.push_back(execute(plan, unit, roofs));
  return reduce(plan, units);
}

}  // namespace glissade::verification
