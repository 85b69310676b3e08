// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "glissade/core/wrap.hpp"
#include "glissade/study/analysis/sampling_error.hpp"
#include "glissade/study/plan/plan.hpp"
#include "words/length_unit.hpp"

namespace glissade {
namespace {

std::string suites_text(const Plan& plan) {
  std::vector<std::string> texts;
  for (const Suite& suite : plan.suites)
    texts.push_back(fmt::format("{}: {} motions", suite.name, suite.motions.size()));
  return fmt::format("{}", fmt::join(texts, "; "));
}

/// What is listed and what is drawn; what is as a default case has it is left out.
std::string cases_text(const Plan& plan) {
  const StudyConfig& c = plan.config;
  std::string text;
  const Quantities usual;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    const Quantity& quantity = c.quantities[i];
    if (!quantity.is_drawn() && quantity.values == usual[i].values) continue;
    text += fmt::format("{:<12}{}.{} {}{}\n", "", p.table, p.key, describe(quantity),
                        p.unit == std::string("-") ? "" : std::string(" ") + p.unit);
  }
  return text;
}

/// Every line within the terminal; what goes on in the next begins below its value.
std::string in_terminal_width(const std::string& text) {
  constexpr std::size_t values_at = 12;
  std::string all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > terminal_width)
      line = line.substr(0, values_at) + wrapped(line.substr(values_at), terminal_width, values_at);
    all += line + "\n";
  }
  return all;
}

}  // namespace

std::string to_string(const Plan& plan) {
  const StudyConfig& c = plan.config;
  const std::vector<double>& levels = c.intensity.levels;
  std::string text = fmt::format(
      "study       {} (plan {})\n"
      "suite       {}\n"
      "intensity   {}: {} levels, {:g} to {:g}{}\n"
      "model       {}; because {}\n"
      "cases       {} combinations x {} samples x {} orientation{}, of which {} differ\n"
      "orientation {}\n{}",
      c.name, plan.hash, suites_text(plan), intensity_label(c.intensity), levels.size(),
      levels.front(), levels.back(), c.by_stripes ? "; multiple stripes, a suite for each" : "",
      describe(plan.kernel.kernel, plan.config), plan.kernel.reason, plan.cases.combinations(),
      plan.cases.samples, plan.cases.orientations, plan.cases.orientations == 1 ? "" : "s",
      plan.order.size(), describe(c.orientation.choice), cases_text(plan));
  if (c.draws()) {
    text += fmt::format(
        "samples     {}, seed {}\n",
        c.sampling.method == SamplingMethod::sobol ? "scrambled Sobol" : "Monte Carlo", c.seed);
    if (c.sampling.target) {
      text += fmt::format(
          "            fewer where {} to {} scrambles of {} give an error of {:g} (target_error)\n",
          c.sampling.scrambles_to_target, c.sampling.scrambles, c.sampling.blocks().size,
          c.sampling.target->error);
    }
  }
  if (c.fragility) {
    std::vector<double> thresholds;
    for (const double length_m : c.thresholds_m())
      thresholds.push_back(length_value(length_m, c.units));
    text += fmt::format("thresholds  {:g} {}\n", fmt::join(thresholds, ", "), length_unit(c.units));
  }
  text +=
      fmt::format("work        {} histories in {} units{}\n", plan.histories(), plan.units.size(),
                  c.fragility && !c.by_stripes ? ", and the search for capacities on top" : "");
  for (const Skip& skip : plan.skips)
    text += fmt::format("not run     {}: {}\n", skip.what, skip.why);
  for (const std::string& warning : plan.warnings) text += fmt::format("warning     {}\n", warning);
  for (const std::string& note : plan.notes) text += fmt::format("note        {}\n", note);
  return in_terminal_width(text);
}

}  // namespace glissade
