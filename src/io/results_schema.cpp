// SPDX-License-Identifier: GPL-3.0-or-later
#include "results_schema.hpp"

#include "chart_schema.hpp"
#include "enum_names.hpp"
#include "glissade/core/file_name.hpp"
#include "impact_schema.hpp"
#include "results_archive.hpp"
#include "shared_schema.hpp"

namespace glissade {
namespace {

// R is Results or const Results; so with the parts.

template <class Archive, class Samples>
void exchange_samples(const Archive& archive, Samples& samples) {
  make_rows(archive, "friction", samples);
  column(
      archive, "friction", {"-", "coefficient of friction"}, samples,
      [](auto& s) -> auto& { return s.friction; });
  column(
      archive, "slope_deg", {"deg", "roof slope"}, samples,
      [](auto& s) -> auto& { return s.slope_deg; });
  column(
      archive, "period_s", {"s", "building period; 0 is rigid"}, samples,
      [](auto& s) -> auto& { return s.period_s; });
  column(
      archive, "damping", {"-", "building damping ratio"}, samples,
      [](auto& s) -> auto& { return s.damping; });
  column(
      archive, "component",
      {"-",
       "horizontal component along the slope, of two axes along the building's first axis: 0 the "
       "first, 1 the second"},
      samples, [](auto& s) -> auto& { return s.component; });
  column(
      archive, "sign", {"-", "sign of that component: 1 or -1"}, samples,
      [](auto& s) -> auto& { return s.sign; });
  column(
      archive, "mass_ratio", {"-", "array mass over building mass"}, samples,
      [](auto& s) -> auto& { return s.mass_ratio; });
  column(
      archive, "friction_across",
      {"-", "two axes: coefficient of friction across the slope; 0 on one axis"}, samples,
      [](auto& s) -> auto& { return s.friction_across; });
  column(
      archive, "azimuth_deg",
      {"deg", "two axes: from the building's first axis to where the roof falls"}, samples,
      [](auto& s) -> auto& { return s.azimuth_deg; });
  column(
      archive, "second_sign", {"-", "two axes: sign of the other component: 1 or -1"}, samples,
      [](auto& s) -> auto& { return s.second_sign; });
}

template <class Archive, class Records>
void exchange_records(const Archive& archive, Records& records) {
  exchange_identity(archive, records);
  exchange_source(archive, records);
  column(
      archive, "vs30_mps", {"m/s", "mean shear-wave velocity of the upper 30 m; 0 where not told"},
      records, [](auto& r) -> auto& { return r.vs30_mps; });
  column(
      archive, "suite_scale", {"-", "the suite file's factor"}, records,
      [](auto& r) -> auto& { return r.suite_scale; });
  column(
      archive, "factor_at_unit_level_per_g",
      {"-", "factor on the record at intensity 1; 0 where it depends on the sample"}, records,
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

template <class Archive, class Spectra>
void exchange_spectra(const Archive& archive, Spectra& spectra) {
  archive.attribute("reference_level_g", spectra.reference_level);
  exchange_curves(archive, spectra,
                  {"5 % SRSS spectrum of each scaled record, by (record, period)",
                   "target spectrum; empty without a target"});
}

/// One of the two fits of every threshold.
template <class Archive, class Fragilities, class Fit>
void exchange_fits(const Archive& archive, Fragilities& rows, Fit fit) {
  name_column<FitStatus>(
      archive, "status", {"-", "how the fit came out"}, rows,
      fit_status_names(), [&](auto& f) -> auto& { return fit(f).status; });
  column(
      archive, "floor", {"-", "share that exceeds without shaking"},
      rows, [&](auto& f) -> auto& { return fit(f).curve.floor; });
  column(
      archive, "median", {"g", "median of the lognormal fragility of the rest"},
      rows, [&](auto& f) -> auto& { return fit(f).curve.median; });
  column(
      archive, "log_std", {"-", "logarithmic standard deviation of the rest"},
      rows, [&](auto& f) -> auto& { return fit(f).curve.log_std; });
  interval_column(
      archive, "floor", {"-", "95 % interval of the floor; nan: none"},
      rows, [&](auto& f) -> auto& { return fit(f).floor_interval; });
  interval_column(
      archive, "p50", {"g", "95 % interval of the intensity at which half of all exceed"},
      rows, [&](auto& f) -> auto& { return fit(f).p50_interval; });
  interval_column(
      archive, "median", {"g", "95 % interval of the median"},
      rows, [&](auto& f) -> auto& { return fit(f).median_interval; });
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
      archive, "note", {"-", "what a reader must know"},
      rows, [&](auto& f) -> auto& { return fit(f).note; });
}

template <class Archive, class Fragilities>
void exchange_fragilities(const Archive& archive, Fragilities& rows) {
  make_rows(archive, "threshold_m", rows);
  column(
      archive, "threshold_m", {"m", "clearance threshold"}, rows,
      [](auto& f) -> auto& { return f.threshold_m; });
  exchange_fits(
      archive.group("stripes"), rows, [](auto& f) -> auto& { return f.stripes; });
  exchange_fits(
      archive.group("capacities"), rows, [](auto& f) -> auto& { return f.capacities; });
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
void exchange_slip(const Archive& archive, Slip& rows) {
  make_rows(archive, "level_g", rows);
  column(
      archive, "level_g", {"g", "intensity level"}, rows, [](auto& s) -> auto& { return s.level; });
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
      {"-", "share of histories in which the body begins to tip; nan: not asked for"}, rows,
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
void exchange_run(const Archive& archive, Run& run) {
  archive.attribute("friction", run.friction_description);
  cube(archive, "peak_displacement_m",
       {"m",
        "peak displacement in plan, by (record, sample, level); inf: beyond the largest threshold, "
        "not run (stop_at_largest)"},
       run.peak_displacement_m);
  cube(archive, "peak_vector_m",
       {"m",
        "two axes: longest displacement vector in plan, by (record, sample, level); empty: one "
        "axis"},
       run.peak_vector_m);
  cube(archive, "uplift", {"-", "1 where the array lifted off, by (record, sample, level)"},
       run.uplift);
  cube(archive, "tips",
       {"-", "1 where the body begins to tip, by (record, sample, level); empty: not asked for"},
       run.tips);
  cube(archive, "capacity_g",
       {"g",
        "lowest intensity reaching the threshold, by (record, sample, threshold); inf: not "
        "reached; 0: slides freely"},
       run.capacity);
  list(archive, "band_intensity_g", {"g", "intensities of the fragility bands"},
       run.band_intensities);
  exchange_fragilities(archive.group("fragility"), run.fragilities);
  exchange_slip(archive.group("slip"), run.slip);
  exchange_standards(archive.group("standards"), run.standards);
  exchange_impact(archive, run);
}

template <class Archive, class Runs>
void exchange_runs(const Archive& archive, Runs& runs) {
  make_rows(archive, "label", runs);
  column(
      archive, "label", {"-", "the runs, in order; each is a group"}, runs,
      [](auto& run) -> auto& { return run.label; });
  for (const auto& run : runs) {
    if (!FileName::accepts(run.label))
      throw Hdf5Error("take the label of a run: it is not of a to z, 0 to 9, _ and - only");
  }
  for (auto& run : runs) exchange_run(archive.group(run.label), run);
}

template <class Archive, class R>
void exchange_all(const Archive& archive, R& results) {
  archive.attribute("program_version", results.program_version);
  archive.attribute("plan_hash", results.plan_hash);
  archive.attribute("seed", results.seed);
  archive.attribute("study", results.study_text);
  archive.attribute("study_name", results.study_name);
  archive.attribute("suite_name", results.suite_name);
  archive.attribute("suite_description", results.suite_description);
  archive.attribute("intensity_label", results.intensity_label);
  archive.attribute("model_kernel", results.model.kernel);
  archive.attribute("model_building", results.model.building);
  archive.attribute("model_friction", results.model.friction);
  archive.attribute("model_displacement", results.model.displacement);
  std::string measure;
  if constexpr (!Archive::reads)
    measure = name_of<IntensityMeasure>(measure_names(), results.measure);
  archive.attribute("intensity_measure", measure);
  if constexpr (Archive::reads)
    results.measure = value_of<IntensityMeasure>(measure_names(), measure);

  list(archive, "level_g", {"g", "intensity levels"}, results.levels);
  list(archive, "threshold_m", {"m", "clearance thresholds"}, results.thresholds_m);
  list(archive, "note", {"-", "what a reader must know"}, results.notes);
  exchange_samples(archive.group("samples"), results.samples);
  exchange_records(archive.group("records"), results.records);
  exchange_spectra(archive.group("spectra"), results.spectra);
  exchange_runs(archive.group("runs"), results.runs);
  if constexpr (Archive::reads) {
    if (archive.has("chart")) results.chart.emplace();
  }
  if (results.chart) exchange_chart(archive.group("chart"), *results.chart);
}

}  // namespace

void exchange(const Hdf5Writer& archive, const Results& results) { exchange_all(archive, results); }
void exchange(const Hdf5Reader& archive, Results& results) { exchange_all(archive, results); }

}  // namespace glissade
