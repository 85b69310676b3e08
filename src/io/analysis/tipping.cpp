// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {
namespace {

void read_tipping(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("tipping");
  RigidBase& base = study.tipping.emplace();
  base.centre_of_mass_height_m = table.required_number("centre_of_mass_height_m", above_zero);
  base.width_m = table.required_number("base_width_m", above_zero);
}

void check_tipping(const TippingResults& tipping, const Results& results) {
  expect_fit(tipping.shares.size() == results.cases.combinations() * results.levels.size(),
             "tipping", "combinations and levels");
  for (const TippingShare& row : tipping.shares) {
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
    expect_fit(row.by_record.size() == results.records.size(), "share_by_record", "records");
  }
}

}  // namespace

AnalysisInFiles TippingAnalysis::in_files() {
  return {
      .table = "tipping",
      .read = read_tipping,
      .keys =
          {{"centre_of_mass_height_m", "number", "required",
            "height of the array's centre of mass above the roof, m: onset of tipping is checked"},
           {"base_width_m", "number", "required", "width of the array's base along the slope, m"}},
      .sampled_friction = FrictionUse::read,
      .design_friction = FrictionUse::read,
      .exchange = Exchange::in_group<&Results::tipping>([](const auto& archive, const auto& scale,
                                                           auto& tipping) {
        archive.attribute("centre_of_mass_height_m", tipping.body.centre_of_mass_height_m);
        archive.attribute("base_width_m", tipping.body.width_m);
        archive.attribute("least_friction", tipping.least_friction);
        const Columns column(archive, tipping.shares, "first_case");
        column(
            "first_case",
            {"-",
             "position in `cases` of the combination's first; one for each sample and orientation"},
            &TippingShare::first_case);
        column("condition", {"-", "what the study lists of it"}, &TippingShare::condition);
        column(scale.level, {scale.unit, "intensity level"}, &TippingShare::level);
        column("share", {"-", "share of histories in which the body begins to tip"},
               &TippingShare::share);
        column("share_by_record", {"-", "the same of each record, by (row, record)"},
               &TippingShare::by_record);
      }),
      .check = if_found<&Results::tipping, check_tipping>};
}

}  // namespace glissade
