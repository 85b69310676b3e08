// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/schema.hpp"

#include "enum_names.hpp"
#include "results/archive.hpp"
#include "results/chart_schema.hpp"
#include "results/envelope.hpp"
#include "results/impact_schema.hpp"
#include "results/shared_schema.hpp"

namespace glissade {
namespace {

// R is Results or const Results; so with the parts.

template <class Archive, class Cases>
void exchange_case_columns(const Archive& archive, Cases& cases) {
  const auto whole = [](auto& c) -> auto& { return c; };
  make_rows(archive, "friction.mu", cases);
  for (const Parameter& p : parameters()) {
    column(
        archive, std::string(p.table) + "." + p.key, {p.unit, p.meaning},
        cases, [&](auto& c) -> auto& { return p.of(const_cast<Case&>(whole(c))); });
  }
  name_column<ArraySupport>(
      archive, "array.support", {"-", "how the array stands on the building"}, cases,
      support_names(), [](auto& c) -> auto& { return c.support; });
  name_column<VerticalChoice>(
      archive, "vertical.use", {"-", "whether the vertical ground motion acts"}, cases,
      vertical_names(), [](auto& c) -> auto& { return c.vertical; });
  name_column<FrictionValue>(
      archive, "friction.value", {"-", "as drawn, or mean - 2 std"}, cases, friction_value_names(),
      [](auto& c) -> auto& { return c.friction_value; });
  name_column<SlopeAxis>(
      archive, "slope_axis", {"-", "the array's axis along the slope"}, cases, slope_axis_names(),
      [](auto& c) -> auto& { return c.orientation.slope_axis; });
  column(
      archive, "ground_azimuth_deg",
      {"deg", "from the first component to the building's first axis, toward the second"}, cases,
      [](auto& c) -> auto& { return c.orientation.ground_azimuth_deg; });
  column(
      archive, "across_sign", {"-", "-1: what acts along the second axis is mirrored"}, cases,
      [](auto& c) -> auto& { return c.orientation.across_sign; });
}

/// What the study lists: a group for each axis, in order.
template <class Archive, class Axes>
void exchange_axes(const Archive& archive, Axes& axes) {
  make_rows(archive, "key", axes);
  column(
      archive, "key", {"-", "what the study lists, the first varies slowest"}, axes,
      [](auto& a) -> auto& { return a.key; });
  column(
      archive, "unit", {"-", "unit of its values"}, axes, [](auto& a) -> auto& { return a.unit; });
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto group = archive.group("axis_" + std::to_string(i));
    list(group, "value", {"as in unit", "values"}, axes[i].values);
    list(group, "name", {"-", "what the values are called; empty: numbers"}, axes[i].names);
  }
}

template <class Archive, class Set>
void exchange_cases(const Archive& archive, Set& set) {
  std::uint64_t samples = set.samples, orientations = set.orientations;
  archive.attribute("samples", samples);
  archive.attribute("orientations", orientations);
  if constexpr (Archive::reads) {
    set.samples = samples;
    set.orientations = orientations;
  }
  exchange_axes(archive.group("axes"), set.axes);
  exchange_case_columns(archive, set.cases);
}

template <class Archive, class R>
void exchange_histories(const Archive& archive, const IntensityScale& scale, R& results) {
  auto& table = results.histories;
  if constexpr (Archive::reads) {
    table.records = results.records.size();
    table.cases = results.cases.size();
    table.levels = results.levels.size();
    table.thresholds = results.thresholds_m.size();
  }
  for_each_history_field([&](auto field) {
    const bool is_intensity = field.unit[0] == '\0';
    const std::string name = field.name + (is_intensity ? scale.suffix : "");
    auto& values = table.fields.*field.of;
    if constexpr (Archive::reads) {
      if (!archive.has(name)) return;
    } else {
      if (values.empty()) return;
    }
    std::string description = std::string(field.description) + ", by (record, case, ";
    Dims shape{table.records, table.cases};
    if (field.depth != Depth::thresholds) shape.push_back(table.levels);
    if (field.depth != Depth::levels) shape.push_back(table.thresholds);
    description += field.depth == Depth::levels       ? "level)"
                   : field.depth == Depth::thresholds ? "threshold)"
                                                      : "level, threshold)";
    Dims dims = shape;
    archive.array(name, {is_intensity ? scale.unit : field.unit, description.c_str()}, dims,
                  values);
    if (dims != shape) throw Hdf5Error("fit " + name + " to records, cases, levels and thresholds");
  });
}

template <class Archive, class Records>
void exchange_records(const Archive& archive, Records& records) {
  exchange_identity(archive, records);
  exchange_source(archive, records);
  column(
      archive, "suite", {"-", "position of its suite"}, records,
      [](auto& r) -> auto& { return r.suite; });
  column(
      archive, "stronger", {"-", "the horizontal with the larger integral of a^2: 0 or 1"}, records,
      [](auto& r) -> auto& { return r.stronger; });
  column(
      archive, "vs30_mps", {"m/s", "mean shear-wave velocity of the upper 30 m; 0 where not given"},
      records, [](auto& r) -> auto& { return r.vs30_mps; });
  column(
      archive, "suite_scale", {"-", "the suite file's factor"}, records,
      [](auto& r) -> auto& { return r.suite_scale; });
  column(
      archive, "factor_at_unit_level",
      {"-", "factor on the record at intensity 1; 0 where it depends on the roof"}, records,
      [](auto& r) -> auto& { return r.factor_at_unit_level; });
  column(
      archive, "pga_g",
      {"g", "geometric mean of the horizontals' peak ground accelerations, as recorded"}, records,
      [](auto& r) -> auto& { return r.pga_g; });
  column(
      archive, "pgv_mps",
      {"m/s", "geometric mean of the horizontals' peak ground velocities, as recorded"}, records,
      [](auto& r) -> auto& { return r.pgv_mps; });
  column(
      archive, "samples", {"-", "number of samples"}, records,
      [](auto& r) -> auto& { return r.samples; });
  column(
      archive, "has_second", {"-", "1 where there is a second horizontal"}, records,
      [](auto& r) -> auto& { return r.has_second; });
  column(
      archive, "has_vertical", {"-", "1 where there is a vertical"}, records,
      [](auto& r) -> auto& { return r.has_vertical; });
}

template <class Archive, class Suites>
void exchange_suites(const Archive& archive, const IntensityScale& scale, Suites& suites) {
  make_rows(archive, "name", suites);
  column(
      archive, "name", {"-", "name of the suite"}, suites, [](auto& s) -> auto& { return s.name; });
  column(
      archive, "description", {"-", "what it is"}, suites,
      [](auto& s) -> auto& { return s.description; });
  for (std::size_t i = 0; i < suites.size(); ++i) {
    const auto group = archive.group("spectra_" + std::to_string(i));
    group.attribute("reference_level" + scale.suffix, suites[i].spectra.reference_level);
    exchange_curves(group, suites[i].spectra,
                    {"5 % SRSS spectrum of each scaled record, by (record, period)",
                     "target spectrum; empty without a target"});
  }
}

/// One of the two fits of every threshold.
template <class Archive, class Fragilities, class Fit>
void exchange_fits(const Archive& archive, const IntensityScale& scale, Fragilities& rows,
                   Fit fit) {
  name_column<FitStatus>(
      archive, "status", {"-", "how the fit came out"}, rows,
      fit_status_names(), [&](auto& f) -> auto& { return fit(f).status; });
  column(
      archive, "floor", {"-", "share that exceeds without shaking"},
      rows, [&](auto& f) -> auto& { return fit(f).curve.floor; });
  column(
      archive, "median", {scale.unit, "median of the lognormal fragility of the rest"},
      rows, [&](auto& f) -> auto& { return fit(f).curve.median; });
  column(
      archive, "log_std", {"-", "logarithmic standard deviation of the rest"},
      rows, [&](auto& f) -> auto& { return fit(f).curve.log_std; });
  interval_column(
      archive, "median", {scale.unit, "95 % interval of the median"},
      rows, [&](auto& f) -> auto& { return fit(f).median_interval; });
  interval_column(
      archive, "floor", {"-", "95 % interval of the floor; nan: none"},
      rows, [&](auto& f) -> auto& { return fit(f).floor_interval; });
  interval_column(
      archive, "p50", {scale.unit, "95 % interval of the intensity at which half of all exceed"},
      rows, [&](auto& f) -> auto& { return fit(f).p50_interval; });
  interval_column(
      archive, "log_std", {"-", "95 % interval of log_std"},
      rows, [&](auto& f) -> auto& { return fit(f).log_std_interval; });
  column(
      archive, "log_likelihood", {"-", "logarithm of the likelihood"},
      rows, [&](auto& f) -> auto& { return fit(f).log_likelihood; });
  column(
      archive, "method", {"-", "how it was fitted"},
      rows, [&](auto& f) -> auto& { return fit(f).method; });
  column(
      archive, "interval_method", {"-", "how the intervals were found"},
      rows, [&](auto& f) -> auto& { return fit(f).interval_method; });
  column(
      archive, "note", {"-", "remarks on the results"},
      rows, [&](auto& f) -> auto& { return fit(f).note; });
}

template <class Archive, class Fragilities>
void exchange_fragilities(const Archive& archive, const IntensityScale& scale, Fragilities& rows) {
  make_rows(archive, "threshold_m", rows);
  column(
      archive, "threshold_m", {"m", "clearance threshold"}, rows,
      [](auto& f) -> auto& { return f.threshold_m; });
  exchange_fits(
      archive.group("stripes"), scale, rows, [](auto& f) -> auto& { return f.stripes; });
  exchange_fits(
      archive.group("capacities"), scale, rows, [](auto& f) -> auto& { return f.capacities; });
  matrix(
      archive, "probability", {"-", "observed share exceeding, by (threshold, level)"}, rows,
      [](auto& f) -> auto& { return f.probability; });
  interval_matrix(
      archive, "probability", {"-", "95 % interval of the share, by (threshold, level)"}, rows,
      [](auto& f) -> auto& { return f.probability_interval; });
  interval_matrix(
      archive, "band", {"-", "95 % band of the capacity fit, by (threshold, band intensity)"}, rows,
      [](auto& f) -> auto& { return f.band; });
  column(
      archive, "recross_share",
      {"-",
       "share of histories that reach the threshold and fall below it again at a higher level"},
      rows, [](auto& f) -> auto& { return f.recross_share; });
  matrix(
      archive, "record_recross",
      {"-", "1 where any sample of the record recrosses, by (threshold, record)"}, rows,
      [](auto& f) -> auto& { return f.record_recross; });
  column(
      archive, "censored_share", {"-", "share of histories that never reach the threshold"}, rows,
      [](auto& f) -> auto& { return f.censored_share; });
  column(
      archive, "free_sliding_share", {"-", "share of histories that slide with no shaking"}, rows,
      [](auto& f) -> auto& { return f.free_sliding_share; });
}

template <class Archive, class Slip>
void exchange_slip(const Archive& archive, const IntensityScale& scale, Slip& rows) {
  make_rows(archive, scale.level, rows);
  column(
      archive, scale.level, {scale.unit, "intensity level"}, rows,
      [](auto& s) -> auto& { return s.level; });
  column(
      archive, "median_m", {"m", "median peak displacement in plan"}, rows,
      [](auto& s) -> auto& { return s.median_m; });
  column(
      archive, "p84_m", {"m", "84th percentile"}, rows, [](auto& s) -> auto& { return s.p84_m; });
  column(
      archive, "p95_m", {"m", "95th percentile"}, rows, [](auto& s) -> auto& { return s.p95_m; });
  column(
      archive, "mean_m", {"m", "mean"}, rows, [](auto& s) -> auto& { return s.mean_m; });
  interval_column(
      archive, "mean_m", {"m", "95 % interval of the mean"}, rows,
      [](auto& s) -> auto& { return s.mean_interval; });
  interval_column(
      archive, "median_m", {"m", "95 % interval of the median"}, rows,
      [](auto& s) -> auto& { return s.median_interval; });
  interval_column(
      archive, "p84_m", {"m", "95 % interval of the 84th percentile"}, rows,
      [](auto& s) -> auto& { return s.p84_interval; });
  column(
      archive, "uplift_share", {"-", "share of histories with uplift"}, rows,
      [](auto& s) -> auto& { return s.uplift_share; });
  column(
      archive, "tip_share",
      {"-", "share of histories in which the body begins to tip; nan: not computed"}, rows,
      [](auto& s) -> auto& { return s.tip_share; });
  column(
      archive, "mean_vector_m",
      {"m", "two axes: mean of the longest displacement vectors; nan: one axis"}, rows,
      [](auto& s) -> auto& { return s.mean_vector_m; });
}

template <class Archive, class Comparisons>
void exchange_standards(const Archive& archive, Comparisons& rows) {
  exchange_prescriptions(archive, rows);
  column(
      archive, "exceedance_probability", {"-", "share of histories with slip above it"}, rows,
      [](auto& c) -> auto& { return c.exceedance_probability; });
  interval_column(
      archive, "exceedance", {"-", "95 % interval of that share"}, rows,
      [](auto& c) -> auto& { return c.exceedance_interval; });
}

template <class Archive, class Run>
void exchange_run(const Archive& archive, const IntensityScale& scale, Run& run) {
  archive.attribute("friction", run.friction_description);
  archive.attribute("first_case", run.first_case);
  archive.attribute("cases", run.cases);
  list(archive, "band_intensity" + scale.suffix, {scale.unit, "intensities of the fragility bands"},
       run.band_intensities);
  exchange_fragilities(archive.group("fragility"), scale, run.fragilities);
  exchange_slip(archive.group("slip"), scale, run.slip);
  exchange_standards(archive.group("standards"), run.standards);
  exchange_impact(archive, scale, run);
}

template <class Archive, class Runs>
void exchange_runs(const Archive& archive, const IntensityScale& scale, Runs& runs) {
  make_rows(archive, "label", runs);
  column(
      archive, "label", {"-", "the combinations, in order; each is a group"}, runs,
      [](auto& run) -> auto& { return run.label; });
  if constexpr (Archive::reads) {
    for (const auto& run : runs) expect_file_name(run.label);
  }
  for (auto& run : runs) exchange_run(archive.group(run.label), scale, run);
}

template <class Archive, class R>
void exchange_head(const Archive& archive, R& results) {
  archive.attribute("program_version", results.program_version);
  archive.attribute("plan_hash", results.plan_hash);
  archive.attribute("seed", results.seed);
  archive.attribute("study", results.study_text);
  archive.attribute("study_name", results.study_name);
  archive.attribute("study_description", results.study_description);
  archive.attribute("intensity_label", results.intensity_label);
  archive.attribute("model_kernel", results.model.kernel);
  archive.attribute("model_building", results.model.building);
  archive.attribute("model_friction", results.model.friction);
  archive.attribute("model_displacement", results.model.displacement);
  name_attribute<SlidingAxes>(archive, "axes", axes_names(), results.axes);
  name_attribute<DisplacementMeasure>(archive, "displacement", displacement_names(),
                                      results.displacement);
  std::string measure = results.measure.key();
  archive.attribute("intensity_measure", measure);
  if constexpr (Archive::reads) {
    const auto known = IntensityMeasure::named(measure);
    if (!known) throw Hdf5Error("understand the intensity measure " + measure);
    results.measure = *known;
  }
}

/// The factor of a study with [clearance]; 0: it has none.
template <class Archive, class R>
void exchange_clearance(const Archive& archive, R& results) {
  double factor = results.clearance ? results.clearance->factor : 0.0;
  archive.attribute("clearance_factor", factor);
  if constexpr (Archive::reads) {
    if (factor > 0.0) results.clearance = ClearanceConfig{factor};
  }
}

template <class Archive, class R>
void exchange_all(const Archive& archive, R& results) {
  exchange_head(archive, results);
  exchange_clearance(archive, results);
  const std::string unit = results.measure.unit();
  const IntensityScale scale{unit.c_str(), unit_suffix(unit)};
  list(archive, scale.level, {scale.unit, "intensity levels"}, results.levels);
  list(archive, "threshold_m", {"m", "clearance thresholds"}, results.thresholds_m);
  list(archive, "note", {"-", "remarks on the results"}, results.notes);
  exchange_cases(archive.group("cases"), results.cases);
  exchange_records(archive.group("records"), results.records);
  exchange_suites(archive.group("suites"), scale, results.suites);
  exchange_histories(archive.group("histories"), scale, results);
  exchange_runs(archive.group("runs"), scale, results.runs);
  if constexpr (Archive::reads) {
    if (archive.has("chart")) results.chart.emplace();
  }
  if (results.chart) exchange_chart(archive.group("chart"), scale, *results.chart);
}

}  // namespace

void exchange(const Hdf5Writer& archive, const Results& results) { exchange_all(archive, results); }
void exchange(const Hdf5Reader& archive, Results& results) { exchange_all(archive, results); }

}  // namespace glissade
