// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/study_file.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "chart_table.hpp"
#include "distribution_table.hpp"
#include "enum_names.hpp"
#include "model_table.hpp"
#include "number_list.hpp"
#include "suite_choice.hpp"
#include "target_table.hpp"
#include "toml_table.hpp"

namespace glissade {
namespace {

/// `key` belongs to one measure only: there it is needed, elsewhere it contradicts.
bool is_key_of(const TomlTable& table, const char* key, IntensityMeasure measure,
               IntensityMeasure owner, const char* owner_name) {
  if (measure != owner && table.has(key)) {
    table.report(
        key, std::string("intensity.") + key + " goes with measure = \"" + owner_name + "\" only",
        std::string("leave it out, or measure by ") + owner_name);
  }
  return measure == owner;
}

/// @param level_rule a chart may begin at no shaking; a fragility cannot
IntensityConfig read_intensity(const TomlTable& table, const NumberRule& level_rule) {
  IntensityConfig intensity;
  if (!table.has("measure"))
    table.report_missing("measure", "known are sds_g, pga_g, sa_g, avg_sa_g, ppa_g");
  const auto measure = table.choice<IntensityMeasure>("measure", measure_names());
  if (table.exists()) intensity.levels = read_increasing(table, "levels", level_rule);
  if (!measure) {
    table.ignore_unknown();
    return intensity;
  }
  intensity.measure = *measure;
  if (is_key_of(table, "sa_period_s", *measure, IntensityMeasure::sa_g, "sa_g")) {
    intensity.sa_period_s = table.required_number("sa_period_s", not_negative);
  }
  if (is_key_of(table, "avg_sa_periods_s", *measure, IntensityMeasure::avg_sa_g, "avg_sa_g")) {
    intensity.avg_sa_periods_s = read_increasing(table, "avg_sa_periods_s", not_negative);
  }
  if (is_key_of(table, "target", *measure, IntensityMeasure::sds_g, "sds_g") &&
      table.has("target")) {
    intensity.target = read_target(table.table("target"));
  }
  return intensity;
}

OrientationConfig read_orientation(const TomlTable& table, SlidingAxes axes) {
  OrientationConfig orientation;
  orientation.component =
      table
          .choice<ComponentChoice>("component", {{"first", ComponentChoice::first},
                                                 {"second", ComponentChoice::second},
                                                 {"random", ComponentChoice::random}})
          .value_or(orientation.component);
  orientation.sign = table
                         .choice<SignChoice>("sign", {{"positive", SignChoice::positive},
                                                      {"negative", SignChoice::negative},
                                                      {"random", SignChoice::random}})
                         .value_or(orientation.sign);
  orientation.second_sign =
      table
          .choice<SignChoice>("second_sign", {{"positive", SignChoice::positive},
                                              {"negative", SignChoice::negative},
                                              {"random", SignChoice::random}})
          .value_or(orientation.second_sign);
  needs_two_axes(table, "second_sign", axes);
  return orientation;
}

/// A chart takes every orientation there is, unless told otherwise: slopes of either sign already
/// are both signs of the motion.
OrientationConfig read_chart_orientation(const TomlTable& table, const ChartConfig& chart) {
  const bool mirrored = !chart.slope_deg.empty() && chart.slope_deg.front() < 0.0;
  OrientationConfig orientation;
  orientation.component =
      table
          .choice<ComponentChoice>("component", {{"first", ComponentChoice::first},
                                                 {"second", ComponentChoice::second},
                                                 {"both", ComponentChoice::both}})
          .value_or(ComponentChoice::both);
  orientation.sign = table
                         .choice<SignChoice>("sign", {{"positive", SignChoice::positive},
                                                      {"negative", SignChoice::negative},
                                                      {"both", SignChoice::both}})
                         .value_or(mirrored ? SignChoice::positive : SignChoice::both);
  if (mirrored && orientation.sign == SignChoice::both) {
    table.report(
        "sign",
        "orientation.sign = \"both\" and negative slopes run everything twice: a slope and "
        "its mirror image under one motion are one slope under both signs of it",
        "leave out one of the two");
  }
  return orientation;
}

std::optional<RigidBase> read_base(const TomlTable& table) {
  if (!table.exists()) return std::nullopt;
  RigidBase base;
  base.centre_of_mass_height_m = table.required_number("centre_of_mass_height_m", above_zero);
  base.width_m = table.required_number("base_width_m", above_zero);
  return base;
}

VerticalConfig read_vertical(const TomlTable& table) {
  VerticalConfig vertical;
  vertical.use = table
                     .choice<VerticalChoice>("use", {{"none", VerticalChoice::none},
                                                     {"if_available", VerticalChoice::if_available},
                                                     {"required", VerticalChoice::required}})
                     .value_or(vertical.use);
  vertical.period_s = table.number("period_s", not_negative).value_or(vertical.period_s);
  vertical.damping = table.number("damping", damping_ratio).value_or(vertical.damping);
  for (const char* key : {"period_s", "damping"}) {
    if (vertical.use == VerticalChoice::none && table.has(key)) {
      table.report(key, std::string("vertical.") + key + " has no effect with use = \"none\"",
                   "leave it out");
    }
  }
  return vertical;
}

SamplingConfig read_sampling(const TomlTable& table) {
  SamplingConfig sampling;
  sampling.method =
      table
          .choice<SamplingMethod>("method", {{"sobol", SamplingMethod::sobol},
                                             {"monte_carlo", SamplingMethod::monte_carlo}})
          .value_or(sampling.method);
  const auto samples = table.whole("samples", 1, std::numeric_limits<std::uint32_t>::max());
  sampling.samples = samples.value_or(sampling.samples);
  if (sampling.method == SamplingMethod::sobol && samples && !std::has_single_bit(*samples)) {
    table.report("samples",
                 "sampling.samples = " + std::to_string(*samples) +
                     " is not a power of two, as Sobol points need",
                 "take " + std::to_string(std::bit_floor(*samples)) + " or " +
                     std::to_string(std::bit_ceil(*samples)) + ", or method = \"monte_carlo\"");
  }
  sampling.bootstrap_replicates =
      static_cast<int>(table.whole("bootstrap_replicates", 100, 1000000)
                           .value_or(static_cast<std::uint64_t>(sampling.bootstrap_replicates)));
  return sampling;
}

StandardsConfig read_standards(const TomlTable& table, IntensityMeasure measure) {
  constexpr NumberRule importance_rule{"from 1 to 1.5",
                                       [](double x) { return x >= 1.0 && x <= 1.5; }};
  StandardsConfig standards;
  standards.compare =
      table.choices<Standard>("compare", standard_names()).value_or(standards.compare);
  standards.importance = table.number("importance", importance_rule).value_or(standards.importance);
  using Sdc = SeismicDesignCategory;
  standards.category = table
                           .choice<Sdc>("seismic_design_category", {{"A", Sdc::a},
                                                                    {"B", Sdc::b},
                                                                    {"C", Sdc::c},
                                                                    {"D", Sdc::d},
                                                                    {"E", Sdc::e},
                                                                    {"F", Sdc::f}})
                           .value_or(standards.category);
  if (!standards.compare.empty() && measure != IntensityMeasure::sds_g) {
    table.report(
        "compare",
        "standards.compare needs intensity.measure = \"sds_g\": the standards prescribe by S_DS",
        "measure by sds_g, or leave [standards] out");
  }
  return standards;
}

/// Friction, slope and period are sampled, clearances are asked for.
void read_samples(const TomlTable& root, StudyConfig& study) {
  study.intensity = read_intensity(root.required_table("intensity"), above_zero);
  const SlidingAxes axes = study.model.axes;
  study.building = read_building(root.table("building"), axes);
  study.roof = read_roof(root.table("roof"), axes);
  study.friction = read_friction(root.required_table("friction"), axes, study.file);
  study.orientation = read_orientation(root.table("orientation"), axes);
  study.sampling = read_sampling(root.table("sampling"));
  const TomlTable clearance = root.required_table("clearance");
  if (clearance.exists()) {
    study.thresholds_m = read_increasing(clearance, "thresholds_m", above_zero);
    study.stop_at_largest_threshold = clearance.flag("stop_at_largest").value_or(false);
    study.impact = clearance.flag("impact").value_or(false);
  }
  study.standards = read_standards(root.table("standards"), study.intensity.measure);
  if (study.stop_at_largest_threshold && !study.standards.compare.empty()) {
    clearance.report(
        "stop_at_largest",
        "clearance.stop_at_largest = true leaves slip beyond the largest threshold unknown, which "
        "the comparison with standards needs",
        "leave it out, or leave [standards] out");
  }
  if (study.stop_at_largest_threshold && study.impact) {
    clearance.report("impact",
                     "clearance.impact needs every level, and clearance.stop_at_largest leaves "
                     "levels out",
                     "leave out one of them");
  }
}

/// Friction, slope and period are the axes of a chart.
void read_grid(const TomlTable& root, StudyConfig& study) {
  for (const char* other : {"roof", "friction", "sampling", "clearance"}) {
    if (!root.has(other)) continue;
    root.report(other,
                std::string("[") + other + "] does not go with [chart], whose axes it would double",
                "leave it out, or leave [chart] out");
    root.table(other).ignore_unknown();
  }
  study.intensity = read_intensity(root.required_table("intensity"), not_negative);
  const std::vector<double>& levels = study.intensity.levels;
  if (levels.size() == 1 && levels.front() == 0.0) {
    root.table("intensity").report("levels", "intensity.levels has no level above 0");
  }
  const TomlTable building = root.table("building");
  if (building.has("period_s")) {
    building.report("period_s", "building.period_s does not go with [chart]",
                    "give chart.period_s, a list");
  }
  study.building = read_building(building, study.model.axes);
  if (!is_fixed(study.building.damping))
    building.report("damping", "a chart has one damping", "give a number");
  if (!is_fixed(study.building.mass_ratio))
    building.report("mass_ratio", "a chart has one mass ratio", "give a number");
  study.chart = read_chart(root.table("chart"), levels);
  study.orientation = read_chart_orientation(root.table("orientation"), *study.chart);
  study.friction.design_run = false;
  study.standards = read_standards(root.table("standards"), study.intensity.measure);
}

/// The convergence of the published scheme is no study: throws.
void refuse_convergence(TomlDocument& document, const TomlTable& root) {
  root.report("convergence", "convergence is not a known table",
              "the convergence of the published scheme is computed by "
              "build/dev/tests/convergence/convergence");
  root.ignore_unknown();
  document.finish();
}

}  // namespace

StudyConfig read_study(const std::filesystem::path& file) {
  TomlDocument document(file);
  const TomlTable root = document.root();
  if (root.has("convergence")) refuse_convergence(document, root);
  const TomlTable head = root.required_table("study"), suite = root.required_table("suite");
  StudyConfig study;
  study.file = file;
  study.source_text = document.text();
  study.name = head.required_text("name");
  study.description = head.text("description").value_or("");
  study.seed = head.whole("seed", 0, std::numeric_limits<std::int64_t>::max()).value_or(0);
  const SuiteChoice chosen = read_suite_choice(suite, file);
  study.suite_file = chosen.file;
  study.records = chosen.records;
  study.vertical = read_vertical(root.table("vertical"));
  study.model = read_model(root.table("model"));
  study.base = read_base(root.table("array"));
  if (root.has("chart")) {
    read_grid(root, study);
  } else {
    read_samples(root, study);
  }
  document.finish();
  return study;
}

}  // namespace glissade
