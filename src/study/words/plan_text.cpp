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
    texts.push_back(suite.name + ": " + counted(suite.motions.size(), "motion"));
  return fmt::format("{}", fmt::join(texts, "; "));
}

/// What the study states, and what differs from a default case.
std::string cases_text(const Plan& plan) {
  const StudyConfig& c = plan.config;
  std::string text;
  const Quantities usual;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    const Quantity& quantity = c.quantities[i];
    if (!quantity.is_stated && !quantity.is_drawn() && quantity.values == usual[i].values) continue;
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
      "intensity   {}: {}, {}{}\n"
      "model       {}; because {}\n"
      "cases       {} x {} x {}, of which {} {}\n"
      "orientation {}\n{}",
      c.name, plan.hash, suites_text(plan), intensity_label(c.intensity),
      counted(levels.size(), "level"),
      levels.size() == 1 ? fmt::format("{:g}", levels.front())
                         : fmt::format("{:g} to {:g}", levels.front(), levels.back()),
      c.by_stripes ? "; multiple stripes, a suite for each" : "",
      describe(plan.kernel.kernel, plan.config), plan.kernel.reason,
      counted(plan.cases.combinations(), "combination"), counted(plan.cases.samples, "sample"),
      counted(plan.cases.orientations, "orientation"), plan.order.size(),
      plan.order.size() == 1 ? "differs" : "differ", describe(c.orientation.choice),
      cases_text(plan));
  std::string not_stated;
  for (const auto& [key, parameter] : c.not_stated)
    if (!(c.intensity.of_roof && parameter != nullptr && parameter->moves_roof()))
      not_stated += (not_stated.empty() ? "" : ", ") + key;
  if (!not_stated.empty()) text += fmt::format("not stated  {}\n", not_stated);
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
  text += fmt::format(
      "work        {} in {}{}\n",
      plan.histories() == 1 ? "1 history" : fmt::format("{} histories", plan.histories()),
      counted(plan.units.size(), "unit"),
      c.fragility && !c.by_stripes ? ", and the search for capacities on top" : "");
  for (const Skip& skip : plan.skips)
    text += fmt::format("not run     {}: {}\n", skip.what, skip.why);
  for (const std::string& warning : plan.warnings) text += fmt::format("warning     {}\n", warning);
  for (const std::string& note : plan.notes) text += fmt::format("note        {}\n", note);
  return in_terminal_width(text);
}

}  // namespace glissade
