// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/schema.hpp"

#include "analysis/in_files.hpp"
#include "enum_names.hpp"
#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {
namespace {

// R is Results or const Results; so with the parts.

template <class Archive, class Cases>
void exchange_case_columns(const Archive& archive, Cases& cases) {
  const Columns column(archive, cases, "friction.mu");
  // Written before there was this key: it is as usual.
  const auto is_there = [&](const std::string& name) {
    if constexpr (Archive::reads)
      return archive.has(name);
    else
      return true;
  };
  for (const Parameter& p : parameters()) {
    const std::string name = std::string(p.table) + "." + p.key;
    if (!is_there(name)) continue;
    column(
        name, {p.unit, p.meaning}, [&](auto& c) -> auto& { return p.of(const_cast<Case&>(c)); });
  }
  if (is_there("roof.neighbour_slope"))
    column("roof.neighbour_slope", {"-", "where the neighbour stands, where there is one"},
           &Case::neighbour_slope, neighbour_slope_names());
  column("array.support", {"-", "how the array stands on the building"}, &Case::support,
         support_names());
  column("vertical.use", {"-", "whether the vertical ground motion acts"}, &Case::vertical,
         vertical_names());
  column("friction.value", {"-", "as drawn, or mean - 2 std"}, &Case::friction_value,
         friction_value_names());
  column("slope_axis", {"-", "the array's axis along the slope"},
         member(&Case::orientation, &Orientation::slope_axis), slope_axis_names());
  column("ground_azimuth_deg",
         {"deg", "from the first component to the building's first axis, toward the second"},
         member(&Case::orientation, &Orientation::ground_azimuth_deg));
  column("across_sign", {"-", "-1: what acts along the second axis is mirrored"},
         member(&Case::orientation, &Orientation::across_sign));
}

/// What the study lists: a group for each axis, in order.
template <class Archive, class Axes>
void exchange_axes(const Archive& archive, Axes& axes) {
  const Columns column(archive, axes, "key");
  column("key", {"-", "what the study lists, the first varies slowest"}, &CaseAxis::key);
  column("unit", {"-", "unit of its values"}, &CaseAxis::unit);
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

template <class Archive, class Records, class Periods>
void exchange_records(const Archive& archive, Records& records, Periods& periods_s) {
  const Columns column(archive, records, "id");
  column("id", {"-", "name of the motion in its suite"}, &RecordSummary::id);
  column("event", {"-", "earthquake"}, &RecordSummary::event);
  column("station", {"-", "station"}, &RecordSummary::station);
  column("dt_s", {"s", "time step"}, &RecordSummary::dt_s);
  column("magnitude", {"-", "moment magnitude; 0 where not given"}, &RecordSummary::magnitude);
  column("distance_km", {"km", "rupture distance; 0 where not given"}, &RecordSummary::distance_km);
  column("suite", {"-", "position of its suite"}, &RecordSummary::suite);
  column("stronger", {"-", "the horizontal with the larger integral of a^2: 0 or 1"},
         &RecordSummary::stronger);
  column("vs30_mps", {"m/s", "mean shear-wave velocity of the upper 30 m; 0 where not given"},
         &RecordSummary::vs30_mps);
  column("suite_scale", {"-", "the suite file's factor"}, &RecordSummary::suite_scale);
  column("factor_at_unit_level",
         {"-", "factor on the record at intensity 1; 0 where it depends on the roof"},
         &RecordSummary::factor_at_unit_level);
  column("pga_g",
         {"g", "geometric mean of the horizontals' peak ground accelerations, as recorded"},
         &RecordSummary::pga_g);
  column("pgv_mps",
         {"m/s", "geometric mean of the horizontals' peak ground velocities, as recorded"},
         &RecordSummary::pgv_mps);
  column("samples", {"-", "number of samples"}, &RecordSummary::samples);
  column("has_second", {"-", "1 where there is a second horizontal"}, &RecordSummary::has_second);
  column("has_vertical", {"-", "1 where there is a vertical"}, &RecordSummary::has_vertical);
  if constexpr (Archive::reads) {
    if (!archive.has("pgd_m")) return;  // written before these were known
  }
  column("pgd_m",
         {"m", "geometric mean of the horizontals' peak ground displacements, as recorded"},
         &RecordSummary::pgd_m);
  column("duration_s",
         {"s", "D5-95: from 5 to 95 % of the integral of a^2 of the horizontals together"},
         &RecordSummary::duration_s);
  if constexpr (Archive::reads) {
    if (!archive.has("arias_mps")) return;  // likewise
  }
  column("arias_mps", {"m/s", "geometric mean of the horizontals' Arias intensities, as recorded"},
         &RecordSummary::arias_mps);
  list(archive, "period_s", {"s", "periods of the spectra"}, periods_s);
  matrix(
      archive, "sa_g",
      {"g", "geometric mean of the horizontals' 5 % spectra, as recorded, by (record, period)"},
      records, [](auto& record) -> auto& { return record.sa_g; });
  matrix(
      archive, "roof_velocity_mps",
      {"m/s", "the same of the largest absolute velocity of the oscillator"}, records,
      [](auto& record) -> auto& { return record.roof_velocity_mps; });
}

template <class Archive, class Spectra>
void exchange_spectra(const Archive& archive, Spectra& spectra) {
  list(archive, "period_s", {"s", "periods of the spectra"}, spectra.periods_s);
  make_rows(archive, "srss_g", spectra.srss_g, 2);
  matrix(
      archive, "srss_g", {"g", "5 % SRSS spectrum of each scaled record, by (record, period)"},
      spectra.srss_g, [](auto& row) -> auto& { return row; });
  list(archive, "average_srss_g", {"g", "average over the records"}, spectra.average_srss_g);
  list(archive, "target_g", {"g", "target spectrum; empty without a target"}, spectra.target_g);
  // The average over the target from 0 to 2 s, between the periods above too; nan without a target.
  archive.attribute("lowest_ratio_to_target", spectra.to_target.lowest.ratio);
  archive.attribute("lowest_ratio_at_period_s", spectra.to_target.lowest.period_s);
  archive.attribute("highest_ratio_to_target", spectra.to_target.highest.ratio);
  archive.attribute("highest_ratio_at_period_s", spectra.to_target.highest.period_s);
}

template <class Archive, class Suites>
void exchange_suites(const Archive& archive, const IntensityScale& scale, Suites& suites) {
  const Columns column(archive, suites, "name");
  column("name", {"-", "name of the suite"}, &SuiteSummary::name);
  column("description", {"-", "what it is"}, &SuiteSummary::description);
  column("target", {"-", "edition, site and class of its design spectrum; empty without one"},
         &SuiteSummary::target);
  for (std::size_t i = 0; i < suites.size(); ++i) {
    const auto group = archive.group("spectra_" + std::to_string(i));
    group.attribute("reference_level" + scale.suffix, suites[i].spectra.reference_level);
    exchange_spectra(group, suites[i].spectra);
  }
}

template <class Archive, class R>
void exchange_head(const Archive& archive, R& results) {
  archive.attribute("program_version", results.program_version);
  archive.attribute("plan_hash", results.plan_hash);
  archive.attribute("seed", results.seed);
  std::uint64_t units = static_cast<std::uint64_t>(results.units);
  archive.attribute("us_customary", units);
  if constexpr (Archive::reads)
    results.units = units == 0 ? UnitSystem::si : UnitSystem::us_customary;
  archive.attribute("study", results.study_text);
  archive.attribute("study_name", results.study_name);
  archive.attribute("study_description", results.study_description);
  archive.attribute("intensity_label", results.intensity_label);
  archive.attribute("model_kernel", results.model.kernel);
  archive.attribute("model_building", results.model.building);
  archive.attribute("model_friction", results.model.friction);
  archive.attribute("model_displacement", results.model.displacement);
  archive.attribute("dbe_level", results.model.dbe_level);
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

template <class Archive, class R>
void exchange_remarks_of_run(const Archive& archive, R& results) {
  std::vector<std::uint64_t> counts{results.warnings_of_run, results.notes_of_run};
  list(
      archive, "remarks_of_run",
      {"-", "how many warnings, and how many notes, are of the run: the first; others of analyses"},
      counts);
  if constexpr (Archive::reads) {
    if (counts.size() != 2 || counts[0] > results.warnings.size() ||
        counts[1] > results.notes.size())
      throw Hdf5Error("fit remarks_of_run to the warnings and notes");
    results.warnings_of_run = counts[0];
    results.notes_of_run = counts[1];
  }
}

template <class Archive, class R>
void exchange_all(const Archive& archive, R& results) {
  exchange_head(archive, results);
  const std::string unit = results.measure.unit();
  const IntensityScale scale{unit.c_str(), unit_suffix(unit)};
  list(archive, scale.level, {scale.unit, "intensity levels"}, results.levels);
  list(archive, "threshold_m", {"m", "clearance thresholds"}, results.thresholds_m);
  list(archive, "warning", {"-", "what is possible and not probable, or not for design"},
       results.warnings);
  list(archive, "note", {"-", "remarks on the results"}, results.notes);
  exchange_remarks_of_run(archive, results);
  exchange_cases(archive.group("cases"), results.cases);
  exchange_records(archive.group("records"), results.records, results.record_periods_s);
  exchange_suites(archive.group("suites"), scale, results.suites);
  exchange_histories(archive.group("histories"), scale, results);
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    if (analysis.exchange.write == nullptr) continue;
    if constexpr (Archive::reads)
      analysis.exchange.read(archive, analysis.table, scale, results);
    else
      analysis.exchange.write(archive, analysis.table, scale, results);
  }
}

}  // namespace

void exchange(const Hdf5Writer& archive, const Results& results) { exchange_all(archive, results); }
void exchange(const Hdf5Reader& archive, Results& results) { exchange_all(archive, results); }

}  // namespace glissade
