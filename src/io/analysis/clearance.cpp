// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "analysis/in_files.hpp"
#include "analysis/suite_mean.hpp"

namespace glissade {
namespace {

// C is ClearanceResults or const ClearanceResults; so with the parts.
constexpr NumberRule factor_rule{"1 or more", [](double x) { return x >= 1.0; }};

void read_clearance(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("clearance");
  ClearanceConfig clearance;
  clearance.factor = table.number("factor", factor_rule).value_or(clearance.factor);
  clearance.orientation = table.choice<OrientationRule>("orientation", orientation_rule_names())
                              .value_or(clearance.orientation);
  clearance.without_target = table.flag("without_target").value_or(clearance.without_target);
  study.clearance = clearance;
}

void check_clearance(const ClearanceResults& clearance, Results& results) {
  need_conditions(results);
  const ConditionGrid& grid = results.conditions->grid;
  expect_fit(clearance.factor >= 1.0, "factor", "required clearance");
  check_suite_means(results, sliding_conditions(grid, Periods::largest), clearance.required,
                    &RequiredClearance::largest);
  check_suite_means(results, sliding_conditions(grid, Periods::one), clearance.by_period,
                    std::identity{});
}

}  // namespace

AnalysisInFiles ClearanceAnalysis::in_files() {
  return {
      .table = "clearance",
      .read = read_clearance,
      .keys =
          {{"factor", "number", fmt::format("{:g}", ClearanceConfig{}.factor),
            "required clearance: this factor on the suite's mean displacement, the largest over "
            "the periods (Walters et al. 2012); also of a [chart]"},
           {"orientation", one_of(orientation_rule_names()),
            quoted(orientation_rule_names(), ClearanceConfig{}.orientation),
            "which mean is the recommended clearance: the largest or the median of the suite's "
            "means, each "
            "with all records in one orientation; Walters et al. (2012) state neither, and call it "
            "conservative to put the stronger component downhill"},
           {"without_target", "true or false", "false",
            "a clearance also of a suite that does not meet a design spectrum: not for design"}},
      .key_needs = {{"clearance", "orientation", "several orientations",
                     [](const TomlTable&, const StudyConfig& s) {
                       return s.orientation.choice == OrientationChoice::all_permutations ||
                              s.orientation.choice == OrientationChoice::azimuths ||
                              s.orientation.slope_axis.size() > 1;
                     }},
                    {"clearance", "without_target",
                     "a measure other than \"sds_g\", which scales to the target, or a building "
                     "period above 2 s",
                     [](const TomlTable&, const StudyConfig& s) { return may_miss_target(s); }}},
      .uses = {"model.displacement"},
      .stands_alone = true,
      .needs_every_history = true,
      .design_friction = FrictionUse::required,
      .exchange = Exchange::in_group<&Results::clearance>([](const auto& archive, const auto& scale,
                                                             auto& clearance) {
        archive.attribute("factor", clearance.factor);
        name_attribute<OrientationRule>(archive, "orientation", orientation_rule_names(),
                                        clearance.orientation);
        const auto required = archive.group("required");
        exchange_suite_means(required, scale,
                             {"displacement_m", "m", "displacement, the largest over the periods"},
                             clearance.required, &RequiredClearance::largest);
        const Columns column(required, clearance.required);
        column("clearance_m",
               {"m", "required clearance, by the rule that is the attribute orientation"},
               &RequiredClearance::clearance_m);
        column("clearance_median_m", {"m", "the factor x median_displacement_m"},
               &RequiredClearance::median_m);
        column("clearance_highest_m", {"m", "the factor x highest_displacement_m"},
               &RequiredClearance::highest_m);
        exchange_suite_means(archive.group("by_period"), scale,
                             {"displacement_m", "m", "displacement"}, clearance.by_period,
                             std::identity{});
      }),
      .check = if_found<&Results::clearance, check_clearance>};
}

}  // namespace glissade
