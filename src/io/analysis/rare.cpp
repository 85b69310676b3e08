// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "analysis/in_files.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

void read_rare(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("rare");
  constexpr NumberRule widening_rule{"from 1 to 10",
                                     [](double x) { return x >= 1.0 && x <= 10.0; }};
  RareConfig& rare = study.rare.emplace();
  rare.thresholds_m = read_increasing(table, "thresholds_m", above_zero);
  rare.widening = table.number("widening", widening_rule).value_or(rare.widening);
  for (const AnalysisInFiles& other : analyses_in_files()) {
    if (other.table != nullptr && other.table != std::string("rare") && root.has(other.table))
      root.report("rare",
                  std::string("[rare] draws from wider distributions, and [") + other.table +
                      "] would count its samples as drawn",
                  "divide the study into two");
  }
}

}  // namespace

AnalysisInFiles RareAnalysis::in_files() {
  return {
      .table = "rare",
      .read = read_rare,
      .keys = {{"thresholds_m", list_value, "required",
                "clearances, m: small probabilities that displacement reaches each, at each level; "
                "drawn quantities without bounds are drawn from wider distributions, with weights; "
                "stands alone"},
               {"widening", "number", fmt::format("{:g}", RareConfig{}.widening),
                "factor on the standard normal numbers of these quantities, 1 to 10"}},
      .needs = {{"a drawn quantity without bounds (normal or lognormal)",
                 [](const TomlTable&, const StudyConfig& s) {
                   return s.samples_friction() && !unbounded_dimensions(s).empty();
                 }},
                {"sampling.scrambles of 8 or more, which give its sampling error",
                 [](const TomlTable&, const StudyConfig& s) {
                   return s.sampling.scrambles >= least_scrambles;
                 }}},
      .uses = {"model.displacement", "sampling.scrambles"},
      .stands_alone = true,
      .needs_every_history = true,
      .sampled_friction = FrictionUse::usual};
}

}  // namespace glissade
