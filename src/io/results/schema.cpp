// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/schema.hpp"

#include <fmt/format.h>

#include "enum_names.hpp"
#include "results/archive.hpp"
#include "results/envelope.hpp"

namespace glissade {
namespace {

// R is Results or const Results; so with the parts. What follows from the study is written, for
// users of the file, and not read.

/// How datasets of intensities are named, and their unit.
struct IntensityScale {
  std::string unit, suffix = unit_suffix(unit);  ///< "g", "_g"
  explicit IntensityScale(const Results& results) : unit(results.measure.unit()) {}
};

template <class Archive, class Cases>
void exchange_cases(const Archive& archive, const BuildingModel& building, Cases& cases) {
  const Columns column(archive, cases, "friction.mu");
  for (const Parameter& p : parameters()) {
    if (Archive::reads && p.is_of != nullptr && !p.is_of(building)) continue;
    const std::string description = p.description();
    converted(
        archive, p.name(), {p.unit, description.c_str()}, cases,
        [&](const Case& c) { return value_of(p, c, building); },
        [&](Case& c, double value) { p.of(c) = value; });
  }
  column("roof.neighbour_slope", {"-", "where the neighbour stands, where there is one"},
         &Case::neighbour_slope, neighbour_slope_names);
  column("array.support", {"-", "how the array stands on the building"}, &Case::support,
         support_names);
  column("vertical.use", {"-", "whether the vertical ground motion acts"}, &Case::vertical,
         vertical_names);
  column("friction.value", {"-", "as drawn, or mean - 2 std"}, &Case::friction_value,
         friction_value_names);
  column("slope_axis", {"-", "the array's axis along the slope"},
         member(&Case::orientation, &Orientation::slope_axis), slope_axis_names);
  column("ground_azimuth_deg",
         {"deg", "from the first component to the building's first axis, toward the second"},
         member(&Case::orientation, &Orientation::ground_azimuth_deg));
  column("across_sign", {"-", "-1: what acts along the second axis is mirrored"},
         member(&Case::orientation, &Orientation::across_sign));
}

/// What the study lists: a group for each axis, in order.
void write_grid(const Hdf5Writer& archive, const CaseGrid& grid) {
  archive.attribute("orientations", std::uint64_t{grid.orientations});
  const auto axes = archive.group("axes");
  const Columns column(axes, grid.axes);
  column("key", {"-", "what the study lists, the first varies slowest"}, &CaseAxis::key);
  column("unit", {"-", "unit of its values"}, &CaseAxis::unit);
  for (std::size_t i = 0; i < grid.axes.size(); ++i) {
    const auto group = axes.group("axis_" + std::to_string(i));
    list(group, "value", {"as in unit", "values"}, grid.axes[i].values);
    list(group, "name", {"-", "what the values are called; empty: numbers"}, grid.axes[i].names);
  }
}

template <class Archive, class R>
void exchange_histories(const Archive& archive, const IntensityScale& scale, R& results) {
  auto& table = results.histories;
  if constexpr (Archive::reads) {
    table.records = results.records.size();
    table.cases = results.cases.size();
    table.levels = results.by_stripes ? 1 : results.levels.size();
    for (const RecordSummary& record : results.records)
      if (results.by_stripes) table.stripe_of.push_back(record.suite);
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
    archive.array(name, {is_intensity ? scale.unit.c_str() : field.unit, description.c_str()}, dims,
                  values);
    if (dims != shape) throw Hdf5Error("fit " + name + " to records, cases, levels and thresholds");
  });
}

/// Files from before events were the units of intervals do not have it.
template <class Archive, class R>
void exchange_units(const Archive& archive, R& results) {
  auto& unit_of = results.histories.unit_of;
  if constexpr (Archive::reads) {
    if (archive.has("unit")) unit_of = event_units(results.records);
  } else if (!unit_of.empty()) {
    std::vector<std::uint64_t> units(unit_of.begin(), unit_of.end());
    list(archive, "unit", {"-", "number of its event, over which intervals are"}, units);
  }
}

/// Whether the file has, or is to have, what was done with the motions: nothing as a rule.
template <class Archive, class Records>
bool is_processed(const Archive& archive, const Records& records) {
  if constexpr (Archive::reads) return archive.has("processing");
  return std::ranges::any_of(records, [](const RecordSummary& r) { return !r.processing.empty(); });
}

template <class Archive, class Records, class Periods>
void exchange_records(const Archive& archive, Records& records, Periods& periods_s) {
  const Columns column(archive, records, "id");
  column("id", {"-", "name of the motion in its suite"}, &RecordSummary::id);
  column("event", {"-", "earthquake"}, &RecordSummary::event);
  column("station", {"-", "station"}, &RecordSummary::station);
  if (is_processed(archive, records))
    column("processing", {"-", "what the suite asked for and was done with the motion"},
           &RecordSummary::processing);
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
  column("pgd_m",
         {"m", "geometric mean of the horizontals' peak ground displacements, as recorded"},
         &RecordSummary::pgd_m);
  column("duration_s",
         {"s", "D5-95: from 5 to 95 % of the integral of a^2 of the horizontals together"},
         &RecordSummary::duration_s);
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

/// The rule of the scaling and what it asks for: not of Walters's, which most
/// suites are scaled by.
template <class Archive, class Spectra>
void exchange_rule(const Archive& archive, Spectra& spectra) {
  bool is_there = spectra.rule != ScalingRule::walters_2012;
  if constexpr (Archive::reads) is_there = archive.has("scaling_rule");
  if (!is_there) return;
  std::vector<std::string> rule{text_of(spectra.rule).key};
  list(archive, "scaling_rule", {"-", "the rule by which the suite is scaled"}, rule);
  std::vector<double> numbers{spectra.range.from_s, spectra.range.to_s, spectra.mean_ratio};
  list(archive, "scaling_range",
       {"-",
        "periods from and to which it is compared, s, and the mean of its average over the target "
        "between them"},
       numbers);
  if constexpr (Archive::reads) {
    expect_fit(rule.size() == 1 && numbers.size() == 3, "scaling_rule", "scaling_range");
    spectra.rule = value_of(scaling_rule_names, rule.front());
    spectra.range = {numbers[0], numbers[1]};
    spectra.mean_ratio = numbers[2];
  }
}

template <class Archive, class Spectra>
void exchange_spectra(const Archive& archive, Spectra& spectra) {
  exchange_rule(archive, spectra);
  const std::string combination = is_of_16_2(spectra.rule) ? "rotd100_g" : "srss_g";
  list(archive, "period_s", {"s", "periods of the spectra"}, spectra.periods_s);
  make_rows(archive, combination, spectra.records_g, 2);
  const std::string of_record = fmt::format(
      "5 % {} spectrum of each scaled record, by (record, period)", spectra.combination());
  matrix(
      archive, combination, {"g", of_record.c_str()}, spectra.records_g,
      [](auto& row) -> auto& { return row; });
  list(archive, "average_" + combination, {"g", "average over the records"}, spectra.average_g);
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
  column("of_roof", {"-", "1: motions of a roof, used without a building"}, &SuiteSummary::of_roof);
  column("target_is_envelope", {"-", "1: of the spectra of several site classes"},
         &SuiteSummary::target_is_envelope);
  column("intensity_level",
         {"-", "Intensity Level of Walters et al. (2012) by its design spectrum; -1: none"},
         &SuiteSummary::intensity_level);
  for (std::size_t i = 0; i < suites.size(); ++i) {
    const auto group = archive.group("spectra_" + std::to_string(i));
    group.attribute("reference_level" + scale.suffix, suites[i].spectra.reference_level);
    exchange_spectra(group, suites[i].spectra);
  }
}

/// What the results follow from, beside cases, records, suites and histories.
template <class Archive, class R>
void exchange_run(const Archive& archive, R& results) {
  archive.attribute("study", results.study_text);
  archive.attribute("plan_hash", results.plan_hash);
  archive.attribute("program_version", results.program_version);
  archive.attribute("model_kernel", results.model.kernel);
  archive.attribute("model_modes", results.model.modes);
  archive.attribute("model_building", results.model.building);
  archive.attribute("model_friction", results.model.friction);
  archive.attribute("model_displacement", results.model.displacement);
  archive.attribute("dbe_level", results.model.dbe_level);
}

template <class Archive, class Files>
void exchange_data_files(const Archive& archive, Files& files) {
  std::vector<std::string> names;
  if constexpr (!Archive::reads) {
    for (const auto& file : files) names.push_back(file.first);
  }
  list(archive, "name", {"-", "the files that the study names, in order"}, names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<std::uint8_t> bytes;
    if constexpr (!Archive::reads)
      bytes.assign(files.at(names[i]).begin(), files.at(names[i]).end());
    list(archive, "file_" + std::to_string(i), {"-", "bytes of the file"}, bytes);
    if constexpr (Archive::reads) files[names[i]] = std::string(bytes.begin(), bytes.end());
  }
}

/// Reading, those of the run alone: the others are those of the analyses.
template <class Archive, class R>
void exchange_remarks(const Archive& archive, R& results) {
  std::vector<std::string> warnings;
  if constexpr (!Archive::reads) warnings = texts_of(results.warnings);
  list(archive, "warning", {"-", "what is possible and not probable, or not for design"}, warnings);
  if constexpr (Archive::reads) results.warnings.assign(warnings.begin(), warnings.end());
  list(archive, "note", {"-", "remarks on the results"}, results.notes);
  std::vector<std::uint64_t> counts{results.warnings_of_run, results.notes_of_run};
  list(archive, "remarks_of_run",
       {"-", "how many warnings, and how many notes, are of the run: the first"}, counts);
  if constexpr (Archive::reads) {
    expect_fit(counts.size() == 2 && counts[0] <= results.warnings.size() &&
                   counts[1] <= results.notes.size(),
               "remarks_of_run", "warnings and notes");
    results.warnings_of_run = counts[0];
    results.notes_of_run = counts[1];
  }
}

void write_description(const Hdf5Writer& archive, const Results& results) {
  archive.attribute("study_name", results.study_name);
  archive.attribute("study_description", results.study_description);
  archive.attribute("seed", results.seed);
  archive.attribute("intensity_measure", std::string(results.measure.key()));
  archive.attribute("intensity_label", results.intensity_label);
  archive.attribute("units", name_of(unit_names, results.units));
  archive.attribute("axes", name_of(axes_names, results.axes));
  archive.attribute("displacement", name_of(displacement_names, results.displacement));
  const IntensityScale scale(results);
  list(archive, "level" + scale.suffix, {scale.unit.c_str(), "intensity levels"}, results.levels);
  list(archive, "threshold_m", {"m", "clearance thresholds"}, results.thresholds_m);
  write_grid(archive.group("cases"), results.cases);
}

template <class Archive, class R>
void exchange_all(const Archive& archive, R& results) {
  std::uint64_t samples = results.cases.samples;
  archive.group("cases").attribute("samples", samples);
  if constexpr (Archive::reads) results.cases.samples = samples;
  exchange_cases(archive.group("cases"), results.building, results.cases.cases);
  exchange_records(archive.group("records"), results.records, results.record_periods_s);
  exchange_suites(archive.group("suites"), IntensityScale(results), results.suites);
  exchange_histories(archive.group("histories"), IntensityScale(results), results);
  exchange_units(archive.group("records"), results);
}

void write_tables(const Hdf5Writer& archive, const std::vector<DataTable>& tables) {
  for (const DataTable& table : tables) {
    const Hdf5Writer group = archive.group(table.name);
    group.attribute("title", table.title);
    for (const DataColumn& column : table.columns) {
      const Label label{column.unit.c_str(), column.description.c_str()};
      std::visit(
          [&](const auto& values) { group.array(column.name, label, {values.size()}, values); },
          column.values);
    }
  }
}

}  // namespace

void write_content(const Hdf5Writer& archive, const Results& results,
                   const std::vector<DataTable>& tables) {
  exchange_run(archive, results);
  exchange_data_files(archive.group("study_files"), results.study_data_files);
  exchange_remarks(archive, results);
  write_description(archive, results);
  exchange_all(archive, results);
  write_tables(archive.group("tables"), tables);
}

void read_run(const Hdf5Reader& archive, Results& results) {
  exchange_run(archive, results);
  exchange_data_files(archive.group("study_files"), results.study_data_files);
  exchange_remarks(archive, results);
}

void read_histories(const Hdf5Reader& archive, Results& results) { exchange_all(archive, results); }

}  // namespace glissade
