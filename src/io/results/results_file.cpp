// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/results_file.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/in_files.hpp"
#include "glissade/core/contract.hpp"
#include "results/envelope.hpp"
#include "results/schema.hpp"

namespace glissade {
namespace {

constexpr ResultsKind kind{"glissade results", results_format_version, "glissade results file"};

bool labels_are_distinct_names(const Results& results) {
  for (std::size_t i = 0; i < results.runs.size(); ++i) {
    const std::string& label = results.runs[i].label;
    if (!FileName::accepts(label) || label == "label") return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (results.runs[j].label == label) return false;
    }
  }
  return true;
}

void check_cases(const Results& results) {
  const CaseSet& set = results.cases;
  expect_fit(set.samples > 0 && set.orientations > 0 && set.size() > 0, "samples", "cases");
  std::size_t size = set.samples;
  const auto times = [&](std::size_t factor) {
    expect_fit(factor > 0 && size <= set.size() / factor, "axes", "cases");
    size *= factor;
  };
  times(set.orientations);
  for (const CaseAxis& axis : set.axes) {
    times(axis.size());
    expect_fit(axis.names.empty() || axis.names.size() == axis.size(), "names", "axis");
    for (const std::string& name : axis.names) expect_file_name(name);
    if (axis.key == "array.support" || axis.key == "vertical.use" || axis.key == "friction.value") {
      for (const double value : axis.values)
        expect_fit(value == 0.0 || value == 1.0 || value == 2.0, "values", "axis of choices");
    } else {
      expect_fit(std::ranges::any_of(parameters(),
                                     [&](const Parameter& p) {
                                       return axis.key == std::string(p.table) + "." + p.key;
                                     }),
                 "axes", "parameters of a case");
    }
  }
  expect_fit(size == set.size(), "axes", "cases");
  for (const Case& c : set.cases) {
    const double azimuth = c.orientation.ground_azimuth_deg;
    expect_fit(azimuth >= 0.0 && azimuth < 360.0, "ground_azimuth_deg", "circle");
    expect_fit(std::abs(c.orientation.across_sign) == 1, "across_sign", "two signs");
  }
}

void check_suites(const Results& results) {
  std::uint64_t suite = 0;
  expect_fit(!results.records.empty() && results.records.front().suite == 0, "records", "suites");
  for (const RecordSummary& record : results.records) {
    expect_fit(record.suite == suite || record.suite == suite + 1, "records", "suites");
    suite = record.suite;
    expect_fit(record.stronger <= 1, "stronger", "two components");
    expect_fit(record.sa_g.size() == results.record_periods_s.size() &&
                   record.roof_velocity_mps.size() == results.record_periods_s.size(),
               "sa_g", "period_s");
  }
  expect_fit(suite + 1 == results.suites.size(), "records", "suites");
  for (std::size_t i = 0; i < results.suites.size(); ++i) {
    const SuiteSpectra& s = results.suites[i].spectra;
    const std::size_t periods = s.periods_s.size();
    const auto is_whole = [&](const std::vector<double>& x) { return x.size() == periods; };
    const auto records = std::ranges::count(results.records, i, &RecordSummary::suite);
    expect_fit(s.srss_g.size() == static_cast<std::size_t>(records), "srss_g", "records");
    expect_fit(periods > 0 && std::ranges::all_of(s.srss_g, is_whole) &&
                   is_whole(s.average_srss_g) && (s.target_g.empty() || is_whole(s.target_g)),
               "spectra", "periods");
    const bool by_sds = results.measure == IntensityMeasure::sds_g;
    expect_fit(!by_sds || !s.target_g.empty(), "target_g", "intensity measure");
  }
}

/// The fields that the histories have go with each other; their shapes are checked where they are
/// read.
void check_histories(const Results& results) {
  const HistoryTable& table = results.histories;
  const HistoryFields& f = table.fields;
  const std::size_t size = table.records * table.cases * table.levels;
  const auto whole_or_none = [&](const auto& field) {
    return field.empty() || field.size() == size;
  };
  const auto is_not_rising = [](double a, double b) { return !(a < b); };
  if (!std::ranges::all_of(results.levels, [](double l) { return std::isfinite(l); }) ||
      std::ranges::adjacent_find(results.levels, is_not_rising) != results.levels.end())
    throw Hdf5Error("take levels that do not rise");
  if (std::ranges::any_of(f.peak_displacement_m, [](double d) { return std::isnan(d); }))
    throw Hdf5Error("take a displacement that is not a number");
  expect_fit(size > 0 && f.peak_displacement_m.size() == size, "peak_displacement_m",
             "records, cases and levels");
  expect_fit(f.uplift.size() == size && f.failed.size() == size, "uplift",
             "records, cases and levels");
  expect_fit(f.capacity.size() == table.records * table.cases * table.thresholds, "capacity",
             "thresholds");
  expect_fit(f.peak_vector_m.size() == (slides_on_two_axes(results) ? size : 0), "peak_vector_m",
             "axes");
  expect_fit(f.residual_along_m.size() == f.peak_vector_m.size() &&
                 f.residual_across_m.size() == f.peak_vector_m.size(),
             "residual_along_m", "axes");
  expect_fit(whole_or_none(f.peak_along_m) && f.peak_along_m.size() == f.peak_across_m.size() &&
                 f.peak_along_m.size() <= f.residual_along_m.size(),
             "peak_along_m", "other displacements");
  expect_fit(
      whole_or_none(f.closing_along_m) && f.closing_along_m.size() == f.closing_across_m.size(),
      "closing_along_m", "histories");
  expect_fit(whole_or_none(f.shear_along) && f.shear_along.size() == f.shear_across.size(),
             "shear_along", "histories");
  expect_fit(f.crossing_time_s.size() == f.crossing_speed_mps.size(), "crossing_time_s",
             "crossing_speed_mps");
}

/// Every part is there for each record, case, level and threshold that the others have, so that
/// readers of the results need no checks.
void check_shapes(Results& results) {
  check_cases(results);
  check_suites(results);
  check_histories(results);
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    if (analysis.check != nullptr) analysis.check(results);
  }
}

}  // namespace

void write_results(const std::filesystem::path& file, const Results& results) {
  GLISSADE_EXPECTS(labels_are_distinct_names(results));
  write_results_of(kind, file, [&](const Hdf5Writer& root) { exchange(root, results); });
}

Results read_results(const std::filesystem::path& file) {
  Results results;
  read_results_of(kind, file, [&](const Hdf5Reader& root) {
    exchange(root, results);
    check_shapes(results);
    if (!labels_are_distinct_names(results)) throw Hdf5Error("give its runs different labels");
  });
  return results;
}

ResultsOrigin read_origin(const std::filesystem::path& file) {
  ResultsOrigin origin;
  read_results_of(kind, file, [&](const Hdf5Reader& root) {
    root.attribute("study", origin.study_text);
    root.attribute("plan_hash", origin.plan_hash);
  });
  return origin;
}

}  // namespace glissade
