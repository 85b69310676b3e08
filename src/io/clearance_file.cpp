// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/clearance_file.hpp"

#include <algorithm>
#include <cmath>

#include "clearance_names.hpp"
#include "hdf5_file.hpp"
#include "results_archive.hpp"
#include "results_envelope.hpp"
#include "shared_schema.hpp"

namespace glissade {
namespace {

constexpr ResultsKind kind{"glissade clearance study", clearance_format_version,
                           "results file of a clearance study"};

// R is ClearanceResults or const ClearanceResults; so with the parts.

/// A name as an attribute.
template <class E, class Archive, class Value>
void name_attribute(const Archive& archive, const std::string& name, EnumNames<E> names,
                    Value& value) {
  std::string text;
  if constexpr (!Archive::reads) text = name_of<E>(names, value);
  archive.attribute(name, text);
  if constexpr (Archive::reads) value = value_of<E>(names, text);
}

template <class Archive, class Grid>
void exchange_grid(const Archive& archive, Grid& grid) {
  make_rows(archive, "support", grid.support);
  name_column<ArraySupport>(
      archive, "support", {"-", "how the array stands on the building"}, grid.support,
      support_names(), [](auto& s) -> auto& { return s; });
  make_rows(archive, "vertical", grid.vertical);
  name_column<VerticalChoice>(
      archive, "vertical", {"-", "whether the vertical motion is used"}, grid.vertical,
      vertical_names(), [](auto& v) -> auto& { return v.use; });
  column(
      archive, "vertical_period_s", {"s", "period of the roof's vertical; 0: rigid"}, grid.vertical,
      [](auto& v) -> auto& { return v.period_s; });
  list(archive, "response_modification",
       {"-", "R: yield force = elastic demand under the design spectrum / R; 1: elastic"},
       grid.response_modification);
  list(archive, "mass_ratio", {"-", "mass of the array over that of the building"},
       grid.mass_ratio);
  list(archive, "slope_deg", {"deg", "roof slope"}, grid.slope_deg);
  list(archive, "fraction_of_mce", {"-", "factor on the suite as scaled to MCE"},
       grid.fraction_of_mce);
  list(archive, "period_s", {"s", "period of the building along both axes"}, grid.period_s);
}

template <class Archive, class R>
void exchange_orientations(const Archive& archive, R& results) {
  auto& all = results.orientations;
  make_rows(archive, "slope_axis", all);
  name_column<SlopeAxis>(
      archive, "slope_axis", {"-", "the array's axis along which the roof falls"}, all,
      slope_axis_names(), [](auto& o) -> auto& { return o.slope_axis; });
  column(
      archive, "azimuth_deg",
      {"deg", "from the first component to where the roof falls, toward the second"}, all,
      [](auto& o) -> auto& { return o.azimuth_deg; });
  column(
      archive, "across_sign", {"-", "-1: what acts across the slope is turned round"}, all,
      [](auto& o) -> auto& { return o.across_sign; });
  list(archive, "same_as", {"-", "the first orientation whose histories are the same"},
       results.same_as);
}

template <class Archive, class Suites>
void exchange_suites(const Archive& archive, Suites& suites) {
  make_rows(archive, "name", suites);
  column(
      archive, "name", {"-", "name of the suite"}, suites, [](auto& s) -> auto& { return s.name; });
  column(
      archive, "description", {"-", "what it is"}, suites,
      [](auto& s) -> auto& { return s.description; });
  for (std::size_t i = 0; i < suites.size(); ++i) {
    const auto group = archive.group("spectra_" + std::to_string(i));
    exchange_curves(group, suites[i].spectra,
                    {"5 % SRSS spectrum of each record as scaled to MCE",
                     "target MCE spectrum; empty without a target"});
  }
}

template <class Archive, class Records>
void exchange_records(const Archive& archive, Records& records) {
  exchange_identity(archive, records);
  exchange_source(archive, records);
  column(
      archive, "suite", {"-", "position of its suite"}, records,
      [](auto& r) -> auto& { return r.suite; });
  column(
      archive, "scale", {"-", "factor to MCE"}, records, [](auto& r) -> auto& { return r.scale; });
  column(
      archive, "has_vertical", {"-", "1 where there is a vertical component"}, records,
      [](auto& r) -> auto& { return r.has_vertical; });
  column(
      archive, "stronger", {"-", "the horizontal with the larger integral of a^2: 0 or 1"}, records,
      [](auto& r) -> auto& { return r.stronger; });
}

template <class Archive, class Statements>
void exchange_statements(const Archive& archive, Statements& statements) {
  make_rows(archive, "about", statements);
  name_column<ClearanceTopic>(
      archive, "about", {"-", "what of the study it is about"}, statements, topic_names(),
      [](auto& s) -> auto& { return s.about; });
  column(
      archive, "where", {"-", "where it stands"}, statements,
      [](auto& s) -> auto& { return s.where; });
  column(
      archive, "says", {"-", "what it says"}, statements, [](auto& s) -> auto& { return s.says; });
  column(
      archive, "displacement_m", {"m", "the displacement it states; nan: none"}, statements,
      [](auto& s) -> auto& { return s.displacement_m; });
  column(
      archive, "period_s", {"s", "the building's; nan: the largest over the periods"}, statements,
      [](auto& s) -> auto& { return s.period_s; });
}

/// One field of every (record, orientation, condition).
template <class Archive, class R, class Field>
void field_of_histories(const Archive& archive, const std::string& name, const Label& label,
                        R& results, Field field) {
  std::vector<std::remove_cvref_t<decltype(field(results.histories.front()))>> values;
  if constexpr (!Archive::reads) {
    for (auto& history : results.histories) values.push_back(field(history));
  }
  const Dims shape{results.records.size(), results.orientations.size(), results.grid.count()};
  Dims dims = shape;
  archive.array(name, label, dims, values);
  if constexpr (Archive::reads) {
    expect_fit(dims == shape, name.c_str(), "records, orientations and conditions");
    results.histories.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) field(results.histories[i]) = values[i];
  }
}

template <class Archive, class R>
void exchange_histories(const Archive& archive, R& r) {
  field_of_histories(
      archive, "peak_m", {"m", "largest length of the displacement vector, in plan"}, r,
      [](auto& h) -> auto& { return h.peak_m; });
  field_of_histories(
      archive, "peak_along_m", {"m", "largest |displacement| along the slope"}, r,
      [](auto& h) -> auto& { return h.peak_along_m; });
  field_of_histories(
      archive, "peak_across_m", {"m", "largest |displacement| across the slope"}, r,
      [](auto& h) -> auto& { return h.peak_across_m; });
  field_of_histories(
      archive, "residual_along_m", {"m", "where it comes to rest, positive down the slope"}, r,
      [](auto& h) -> auto& { return h.residual_along_m; });
  field_of_histories(
      archive, "residual_across_m", {"m", "the same across the slope"}, r,
      [](auto& h) -> auto& { return h.residual_across_m; });
  field_of_histories(
      archive, "shear_along", {"-", "peak base shear along the slope, over the building's weight"},
      r, [](auto& h) -> auto& { return h.shear_along; });
  field_of_histories(
      archive, "shear_across", {"-", "the same across the slope"}, r,
      [](auto& h) -> auto& { return h.shear_across; });
  field_of_histories(
      archive, "uplift", {"-", "1 where the array lifts off"}, r,
      [](auto& h) -> auto& { return h.uplift; });
}

/// Every part fits the others, and no axis is empty: whoever goes through the results need not
/// look.
template <class R>
void check_shapes(const R& r) {
  for (const ClearanceAxis axis : clearance_axes)
    expect_fit(r.grid.size(axis) > 0, "an empty axis", "grid");
  expect_fit(!r.records.empty() && !r.suites.empty() && !r.orientations.empty(), "nothing",
             "results");
  expect_fit(r.friction.size() == 2, "friction", "two directions");
  expect_fit(r.same_as.size() == r.orientations.size(), "same_as", "orientations");
  for (const std::uint64_t same : r.same_as)
    expect_fit(same < r.orientations.size(), "same_as", "orientations");
  std::uint64_t suite = 0;
  for (const ClearanceRecord& record : r.records) {
    expect_fit(record.suite == suite || record.suite == suite + 1, "records", "suites");
    suite = record.suite;
    expect_fit(record.stronger <= 1, "stronger", "two components");
  }
  expect_fit(suite + 1 == r.suites.size() && r.records.front().suite == 0, "records", "suites");
  for (std::size_t i = 0; i < r.suites.size(); ++i) {
    const SuiteSpectra& s = r.suites[i].spectra;
    const auto is_whole = [&](const std::vector<double>& x) {
      return x.size() == s.periods_s.size();
    };
    expect_fit(is_whole(s.average_srss_g) && (s.target_g.empty() || is_whole(s.target_g)) &&
                   std::ranges::all_of(s.srss_g, is_whole) && !s.periods_s.empty(),
               "spectra", "periods");
  }
  for (const PaperStatement& s : r.statements) {
    expect_fit(std::isnan(s.period_s) ||
                   std::ranges::find(r.grid.period_s, s.period_s) != r.grid.period_s.end(),
               "statements", "periods");
  }
}

template <class Archive, class R>
void exchange_all(const Archive& archive, R& results) {
  archive.attribute("program_version", results.program_version);
  archive.attribute("plan_hash", results.plan_hash);
  archive.attribute("study", results.study_text);
  archive.attribute("study_name", results.study_name);
  archive.attribute("study_description", results.study_description);
  archive.attribute("seed", results.seed);
  archive.attribute("clearance_factor", results.clearance_factor);
  name_attribute<DisplacementMeasure>(archive, "displacement", displacement_names(),
                                      results.displacement);
  list(archive, "friction", {"-", "design coefficient of friction along E-W, N-S"},
       results.friction);
  exchange_grid(archive.group("grid"), results.grid);
  exchange_orientations(archive.group("orientations"), results);
  exchange_suites(archive.group("suites"), results.suites);
  exchange_records(archive.group("records"), results.records);
  exchange_statements(archive.group("statements"), results.statements);
  if constexpr (Archive::reads) check_shapes(results);
  exchange_histories(archive.group("histories"), results);
}

}  // namespace

void write_clearance(const std::filesystem::path& file, const ClearanceResults& results) {
  write_results_of(kind, file, [&](const Hdf5Writer& root) { exchange_all(root, results); });
}

bool is_clearance_results(const std::filesystem::path& file) { return is_results_of(kind, file); }

ClearanceResults read_clearance(const std::filesystem::path& file) {
  ClearanceResults results;
  read_results_of(kind, file, [&](const Hdf5Reader& root) { exchange_all(root, results); });
  return results;
}

}  // namespace glissade
