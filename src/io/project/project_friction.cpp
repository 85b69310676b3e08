// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project_friction.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/core/error.hpp"
#include "glissade/io/pull_test_file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/sampling/friction_statistics.hpp"
#include "keys/quantity_table.hpp"
#include "project/project_keys.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// As it is written; empty where absent or wrong.
std::string surface_of(const TomlTable& table) {
  const std::string surface = table.text("surface").value_or("");
  if (surface.empty() || surface == "dry" || surface == "wet" || surface == "both") return surface;
  table.report("surface",
               table.name_of("surface") + " = \"" + surface + "\" is not dry, wet or both",
               "give one of these, and the materials as surface_description");
  return "";
}

double design_of(const DirectionFriction& d) { return d.sliding.mean_minus_2_std; }

/// In the direction of the project, or the one with the lowest design value, as the array slides
/// in all; null where there is none, which is reported.
const DirectionFriction* tested_friction(const TomlTable& table, const PullTestSummary& summary) {
  const auto& directions = summary.directions;
  if (!table.has("direction")) return &*std::ranges::min_element(directions, {}, design_of);
  const std::string name = table.text("direction").value_or("");
  if (const DirectionFriction* found = find_direction(summary, name)) return found;
  std::string known;
  for (const DirectionFriction& d : directions) known += (known.empty() ? "" : ", ") + d.direction;
  table.report("direction", "the pull tests do not have the direction given",
               "give friction.direction as one of: " + known);
  return nullptr;
}

void take_tests(const TomlTable& table, const fs::path& folder, ProjectFriction& friction) {
  const std::string name = table.text("file").value_or("");
  for (const char* key : {"mu", "tests"})
    table.refuse_both(key, "file", "give the file of pull tests, or mu and source");
  try {
    const PullTestResults results = read_pull_test_results(folder / name, SlidingRule{});
    const DirectionFriction* found = tested_friction(table, results.summary);
    if (found == nullptr) return;
    const MuStatistics& statistics = found->sliding;
    friction.tested = results.summary.directions;
    friction.traces = results.summary.tests;
    friction.direction = found->direction;
    if (statistics.tests < 2) {
      table.report("file", "one pull test gives no standard deviation", "test more");
      return;
    }
    friction.tests = statistics.tests;
    friction.mean = statistics.mean;
    friction.std = statistics.std;
    for (const DirectionFriction& d : friction.tested) {
      if (d.sliding.tests < 2 || d.sliding.lower_bound_95 >= friction.lower_bound.value_or(2.0))
        continue;
      friction.lower_bound = d.sliding.lower_bound_95;
      friction.bound_direction = d.direction;
    }
    friction.source = fmt::format("{} pull tests, direction {}, {} (SHA-256 {})", statistics.tests,
                                  found->direction, name, sha256_of_file(folder / name));
    if (!friction.report.empty()) friction.source += ", " + friction.report;
  } catch (const InputError& error) {
    table.report("file", error);
    table.ignore_unknown();  // its direction was not looked for
  }
}

}  // namespace

void read_project_friction(const TomlTable& table, const fs::path& folder,
                           ProjectFriction& friction) {
  friction.surface = surface_of(table);
  friction.report = table.text("source").value_or("");
  if (table.has("file")) return take_tests(table, folder, friction);
  if (!table.has("mu")) return;
  const TomlTable mu = table.table("mu");
  if (!refuse_cov(mu, /*of_median=*/false)) {
    friction.mean = mu.required_number("mean", friction_rule);
    friction.std = mu.required_number("std", not_negative);
  }
  friction.source = friction.report;
  if (const auto tests = table.whole("tests", 2, 1000)) {
    friction.tests = *tests;
    friction.lower_bound = lower_bound_95(friction.mean, friction.std, *tests);
    friction.source += fmt::format(" ({} tests)", *tests);
  }
  if (table.has("source") && friction.report.empty())
    table.report("source", "friction.source is empty",
                 "for example: source = " + project_example_of("friction", "source"));
}

}  // namespace glissade
