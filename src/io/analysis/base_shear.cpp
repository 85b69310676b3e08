// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"
#include "analysis/suite_mean.hpp"

namespace glissade {
namespace {

void check_base_shear(const BaseShearResults& base_shear, Results& results) {
  need_conditions(results);
  expect_fit(!results.histories.fields.shear_along.empty(), "base_shear", "histories");
  check_suite_means(results, all_conditions(results.conditions->grid), base_shear.means,
                    std::identity{});
}

}  // namespace

AnalysisInFiles BaseShearAnalysis::in_files() {
  return {.table = "base_shear",
          .read = [](const TomlTable&, StudyConfig& study) { study.base_shear = true; },
          .keys = {{"", "an empty table", "absent", "peak base shear"}},
          .needs = {{"[model] axes = 2",
                     [](const TomlTable&, const StudyConfig& s) { return s.two_axes(); }}},
          .key_needs = {{"array", "support", "[base_shear], where it is a list",
                         [](const TomlTable& root, const StudyConfig& s) {
                           return s.support.size() == 1 || root.has("base_shear");
                         }}},
          .stands_alone = true,
          .needs_every_history = true,
          .design_friction = FrictionUse::read,
          .exchange = Exchange::in_group<&Results::base_shear>(
              [](const auto& archive, const auto& scale, auto& base_shear) {
                exchange_suite_means(
                    archive, scale,
                    {"base_shear", "-",
                     "SRSS of the peak base shears, over the building's weight without the array"},
                    base_shear.means, std::identity{});
              }),
          .check = if_found<&Results::base_shear, check_base_shear>};
}

}  // namespace glissade
