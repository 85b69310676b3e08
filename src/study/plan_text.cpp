// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "glissade/study/plan.hpp"

namespace glissade {
namespace {

std::string drawn_by(const StudyConfig& config) {
  return fmt::format(
      " ({}), seed {}",
      config.sampling.method == SamplingMethod::sobol ? "scrambled Sobol" : "Monte Carlo",
      config.seed);
}

}  // namespace

std::string to_string(const Plan& plan) {
  const StudyConfig& c = plan.config;
  std::string text = fmt::format(
      "study       {} (plan {})\n"
      "suite       {}: {} motions\n"
      "intensity   {}: {} levels, {:g} to {:g}\n"
      "model       {}; because {}\n"
      "samples     {}{}\n"
      "runs        ",
      c.name, plan.hash, plan.suite.name, plan.suite.motions.size(), intensity_label(c.intensity),
      c.intensity.levels.size(), c.intensity.levels.front(), c.intensity.levels.back(),
      describe(plan.kernel.kernel), plan.kernel.reason, plan.samples.size(),
      c.chart ? ", the chart's grid in every orientation" : drawn_by(c));
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    text +=
        fmt::format("{}{}: {}", i > 0 ? "; " : "", plan.runs[i].label, plan.runs[i].description);
  }
  text += c.chart ? fmt::format(
                        "\nbuilding    period {:g} s, damping {}\n"
                        "roof        slope {:g} deg\n"
                        "work        {} histories in {} units\n",
                        fmt::join(c.chart->period_s, ", "), describe(c.building.damping),
                        fmt::join(c.chart->slope_deg, ", "), plan.histories(), plan.units.size())
                  : fmt::format(
                        "\nbuilding    period {} s, damping {}\n"
                        "roof        slope {} deg\n"
                        "thresholds  {:g} m\n"
                        "work        {} histories in {} units, and the search for capacities on "
                        "top\n",
                        describe(c.building.period_s), describe(c.building.damping),
                        describe(c.roof.slope_deg), fmt::join(c.thresholds_m, ", "),
                        plan.histories(), plan.units.size());
  for (const Skip& skip : plan.skips)
    text += fmt::format("not run     {}: {}\n", skip.what, skip.why);
  for (const std::string& note : plan.notes) text += fmt::format("note        {}\n", note);
  return text;
}

}  // namespace glissade
