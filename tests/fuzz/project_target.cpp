// SPDX-License-Identifier: GPL-3.0-or-later
// Project files. Pull tests named "pull_tests.csv" and "data/pull_tests.csv", and a spectrum named
// "site.csv", are there.
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/study_file.hpp"

namespace {

using glissade::fuzz::check;

bool increases(const std::vector<double>& values) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(values[i] > values[i - 1])) return false;
  }
  return !values.empty() && std::isfinite(values.back());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto tests =
      glissade::fuzz::folder().write("pull_tests.csv", "mu\n0.50\n0.54\n0.58\n");
  static const auto more =
      glissade::fuzz::folder().write("data/pull_tests.csv", "mu\n0.50\n0.54\n0.58\n");
  static const auto spectrum = glissade::fuzz::folder().write(
      "site.csv", "period_s,design_sa_g\n0.01,0.4\n0.2,1.0\n1,0.6\n5,0.12\n");
  static const auto suite = glissade::fuzz::folder().write("suite.toml", "");
  const auto file = glissade::fuzz::input_file(data, size, "project.toml");
  glissade::fuzz::may_refuse([&] {
    const glissade::Project project = glissade::read_project(file);
    check(increases(project.building.period_s) && project.building.period_s.front() > 0.0,
          "periods increase");
    check(increases(project.slope_deg) && project.slope_deg.front() >= 0.0, "slopes increase");
    check(increases(project.building.mass_ratio), "mass ratios increase");
    check(project.friction.design() > std::tan(project.slope_deg.back() * std::numbers::pi / 180.0),
          "friction stops the array");
    check(project.round_up_m > 0.0 && project.available_m.size() == 4, "the rest is there");
    const auto folder = file.parent_path();
    for (const std::string& study :
         {glissade::demand_study(project, folder), glissade::uncertainty_study(project, folder),
          glissade::probability_study(project, folder, {0.1})})
      glissade::read_study(glissade::fuzz::folder().write("made.toml", study));
  });
  return 0;
}
