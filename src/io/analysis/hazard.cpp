// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/in_files.hpp"
#include "study/analysis_tables.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

EnumNames<LifeQuantity> life_quantity_names() {
  static constexpr EnumNames<LifeQuantity> names = {
      {"largest_single_peak", LifeQuantity::single},
      {"accumulated_at_end", LifeQuantity::accumulated},
      {"farthest_from_first_place", LifeQuantity::farthest}};
  return names;
}

template <class Archive, class Rows>
void exchange_threshold_rates(const Archive& archive, Rows& rows) {
  const Columns column(archive, rows, "threshold_m");
  column("threshold_m", {"m", "clearance threshold"}, &ThresholdRate::threshold_m);
  column("annual_rate", {"1/year", "annual rate of exceeding it; inf: slides freely"},
         &ThresholdRate::annual_rate);
  column("beyond_share",
         {"-", "part of the rate from histories that the highest level does not bring to it"},
         &ThresholdRate::beyond_share);
  column("fit_rate", {"1/year", "annual rate by the lognormal fit; nan: no fit"},
         &ThresholdRate::fit_rate);
  column("life_probability", {"-", "probability of one exceedance or more in the design life"},
         &ThresholdRate::life_probability);
}

constexpr Label below_share{
    "-", "share of histories that exceed it at the lowest level; above 0: a lower bound"};

template <class Archive, class Rows>
void exchange_displacement_rates(const Archive& archive, Rows& rows) {
  const Columns column(archive, rows, "displacement_m");
  column("displacement_m", {"m", "displacement in plan"}, &DisplacementRate::displacement_m);
  column("annual_rate", {"1/year", "annual rate of exceeding it"}, &DisplacementRate::annual_rate);
  column("below_share", below_share, &DisplacementRate::below_share);
}

template <class Archive, class Rows>
void exchange_targets(const Archive& archive, const IntensityScale& scale, Rows& rows) {
  const Columns column(archive, rows, "annual_rate");
  column("annual_rate", {"1/year", "target rate"}, &TargetDisplacement::annual_rate);
  column("displacement_m",
         {"m",
          "displacement exceeded at that rate; inf: beyond the levels, nan: below them; the lowest "
          "of the curve: that or less"},
         &TargetDisplacement::displacement_m);
  column("below_share", below_share, &TargetDisplacement::below_share);
  column("intensity" + scale.suffix, {scale.unit, "intensity that shaking exceeds at that rate"},
         &TargetDisplacement::intensity);
}

template <class Archive, class Rows>
void exchange_life(const Archive& archive, Rows& rows) {
  const Columns column(archive, rows, "quantity");
  column("quantity", {"-", "what of a design life"}, &LifeDisplacement::quantity,
         life_quantity_names());
  column("median_m", {"m", "median over design lives"}, &LifeDisplacement::median_m);
  column("p84_m", {"m", "84th percentile"}, &LifeDisplacement::p84_m);
  column("p95_m", {"m", "95th percentile"}, &LifeDisplacement::p95_m);
}

template <class Archive, class Rows>
void exchange_life_distribution(const Archive& archive, Rows& rows) {
  const Columns column(archive, rows, "quantity");
  column("quantity", {"-", "what of a design life"}, &LifeQuantile::quantity,
         life_quantity_names());
  column("probability", {"-", "part of the design lives"}, &LifeQuantile::probability);
  column("displacement_m", {"m", "displacement that it stays below in so many"},
         &LifeQuantile::displacement_m);
}

template <class Archive, class Rows>
void exchange_prescribed_rates(const Archive& archive, Rows& rows) {
  exchange_prescriptions(archive, rows);
  const Columns column(archive, rows, "standard");
  column("annual_rate", {"1/year", "annual rate of exceeding it; inf: slides freely"},
         &PrescribedRate::annual_rate);
  column("below_share", below_share, &PrescribedRate::below_share);
}

constexpr NumberRule annual_rate_rule{"above 0, at most 1",
                                      [](double x) { return x > 0.0 && x <= 1.0; },
                                      "a return period of 475 years is a rate of 1/475 = 0.0021"};

void read_hazard_of_study(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("hazard");
  study.hazard =
      read_hazard(table, study.intensity.measure.key(),
                  table.number("sds_g", above_zero).value_or(0.0), study.file.parent_path());
  std::vector<double> targets = {rate_of(0.01, 50.0), 1.0 / 2475.0, 1.0 / 700.0};
  if (table.has("target_rates_per_year"))
    targets = read_increasing(table, "target_rates_per_year", annual_rate_rule);
  std::ranges::reverse(targets);
  if (!study.hazard) return;
  study.hazard->target_rates_per_year = targets;
  if (study.intensity.levels.empty()) return;
  check_events(
      table, *study.hazard, study.intensity.levels.front(),
      "check the curve's unit, which is that of intensity.measure, or begin the levels higher");
}

}  // namespace

AnalysisInFiles HazardAnalysis::in_files() {
  return {
      .table = "hazard",
      .read = read_hazard_of_study,
      .keys =
          {{"curve", "path", "none",
            "hazard curve: annual rate of exceedance; CSV with the columns annual_rate and the key "
            "of the study's intensity measure"},
           {"k0", "number", "none", "in place of a curve: annual rate of exceeding x = k0 x^-k"},
           {"k", "number", "none", "the exponent of that"},
           {"sds_g", "number", "none",
            "S_DS of the site, g: rates of the prescribed displacements; with k and without k0 the "
            "curve is assumed from it, by the risk target of ASCE 7"},
           {"design_life_years", "number", "required",
            "years over which slip is accumulated and probabilities are given"},
           {"target_rates_per_year", list_value, "1/700, 1/2475 and 1 % in 50 years",
            "the displacement exceeded at each of these annual rates is found"}},
      .needs = {needs_fragility},
      .key_needs = {{"hazard", "sds_g", "measure = \"sds_g\"",
                     [](const TomlTable&, const StudyConfig& study) {
                       return study.intensity.measure == IntensityMeasure::sds_g;
                     }}},
      .needs_every_history = true,
      .of_any_run = true,
      .exchange = Exchange::in_group<&Results::hazard>([](const auto& archive, const auto& scale,
                                                          auto& hazard) {
        archive.attribute("source", hazard.source);
        archive.attribute("design_life_years", hazard.design_life_years);
        archive.attribute("beyond_rate", hazard.beyond_rate);
        std::uint64_t vectors = hazard.residual_vectors ? 1 : 0;
        archive.attribute("residual_vectors", vectors);
        if constexpr (std::remove_cvref_t<decltype(archive)>::reads)
          hazard.residual_vectors = vectors != 0;
        list(archive, "curve_intensity" + scale.suffix, {scale.unit, "points of the hazard curve"},
             hazard.intensity);
        list(archive, "curve_annual_rate", {"1/year", "annual rate of shaking above that"},
             hazard.intensity_rate);
        const Columns column(archive, hazard.runs, "label");
        column("label", {"-", "the combinations, as in /runs; each is a group"}, &HazardRun::label);
        column("events", {"-", "expected earthquakes of a design life above from_intensity"},
               &HazardRun::events);
        column("from_intensity" + scale.suffix, {scale.unit, "below it no earthquake is counted"},
               &HazardRun::from_intensity);
        column("moving_share",
               {"-", "share of histories that slide there already; above 0: slip is a lower bound"},
               &HazardRun::moving_share);
        for (auto& run : hazard.runs) {
          expect_file_name(run.label);
          const auto group = archive.group(run.label);
          exchange_threshold_rates(group.group("thresholds"), run.thresholds);
          exchange_displacement_rates(group.group("curve"), run.curve);
          exchange_targets(group.group("targets"), scale, run.targets);
          exchange_life(group.group("design_life"), run.life);
          exchange_life_distribution(group.group("design_life_distribution"),
                                     run.life_distribution);
          exchange_prescribed_rates(group.group("standards"), run.prescribed);
        }
      })};
}

}  // namespace glissade
