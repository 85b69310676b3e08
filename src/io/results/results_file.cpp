// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/results_file.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/printable.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "glissade/study/run/reduce.hpp"
#include "results/archive.hpp"
#include "results/envelope.hpp"
#include "results/schema.hpp"

namespace glissade {
namespace {

constexpr ResultsKind kind{"glissade results", results_format_version, "glissade results file"};

/// The study that is stored, with the files that it names.
StudyConfig study_of(const Results& results, const std::filesystem::path& file) {
  constexpr const char* name = "study.toml";
  std::map<std::string, std::string> texts = results.study_data_files;
  texts[name] = results.study_text;
  TextFiles files(std::move(texts));
  try {
    return read_study(name, files);
  } catch (const InputError& error) {
    throw InputError({file.string(),
                      std::string("has a study that cannot be read: ") + error.what(),
                      "give a results file of `glissade run`, or run the study again", ""});
  }
}

/// With sampling.target_error those of the first scrambles, with a [sensitivity] that was added to
/// finished results those of one matrix.
bool are_samples_of(const StudyConfig& study, std::uint64_t samples) {
  const std::uint64_t all = SamplePoints(study).count(), of_block = study.sampling.blocks().size;
  return samples == all || (study.sensitivity && samples == study.sampling.samples) ||
         (study.sampling.target && samples > 0 && samples < all && samples % of_block == 0);
}

void check_cases(const CaseSet& set, const StudyConfig& study) {
  expect_fit(are_samples_of(study, set.samples), "samples", "study");
  expect_fit(set.cases.size() == set.CaseGrid::size(), "cases", "study");
  for (const Case& c : set.cases) {
    const double azimuth = c.orientation.ground_azimuth_deg;
    expect_fit(azimuth >= 0.0 && azimuth < 360.0, "ground_azimuth_deg", "circle");
    expect_fit(std::abs(c.orientation.across_sign) == 1, "across_sign", "two signs");
  }
}

void check_suites(const Results& results) {
  std::uint64_t suite = 0;
  expect_usable("dbe_level", {results.model.dbe_level});
  expect_usable("period_s", results.record_periods_s);
  expect_fit(!results.records.empty() && results.records.front().suite == 0, "records", "suites");
  for (const RecordSummary& record : results.records) {
    expect_fit(record.suite == suite || record.suite == suite + 1, "records", "suites");
    suite = record.suite;
    expect_fit(record.stronger <= 1, "stronger", "two components");
    for (const std::string& name : {record.id, record.event, record.station})
      expect_fit(printable(name) == name, "records", "names without control characters");
    expect_fit(record.sa_g.size() == results.record_periods_s.size() &&
                   record.roof_velocity_mps.size() == results.record_periods_s.size(),
               "sa_g", "period_s");
  }
  expect_fit(suite + 1 == results.suites.size(), "records", "suites");
  for (std::size_t i = 0; i < results.suites.size(); ++i) {
    const SuiteSpectra& s = results.suites[i].spectra;
    const std::size_t periods = s.periods_s.size();
    expect_usable("period_s", s.periods_s);
    expect_usable("average_srss_g", s.average_g);
    expect_usable("target_g", s.target_g);
    const auto is_whole = [&](const std::vector<double>& x) { return x.size() == periods; };
    const auto records = std::ranges::count(results.records, i, &RecordSummary::suite);
    expect_fit(s.records_g.size() == static_cast<std::size_t>(records), "srss_g", "records");
    expect_fit(periods > 0 && std::ranges::all_of(s.records_g, is_whole) && is_whole(s.average_g) &&
                   (s.target_g.empty() || is_whole(s.target_g)),
               "spectra", "periods");
    const bool by_sds = results.measure == IntensityMeasure::sds_g;
    expect_fit(!by_sds || !s.target_g.empty(), "target_g", "intensity measure");
  }
}

bool is_possible(const HistoryField<std::uint8_t>&, double x, double) { return x <= 1.0; }

bool is_possible(const HistoryField<double>& field, double x, double highest_level) {
  if (field.of == &HistoryFields::residual_along_m || field.of == &HistoryFields::residual_across_m)
    return !std::isnan(x);
  if (field.of == &HistoryFields::capacity)
    return x >= 0.0 && (x <= highest_level || std::isinf(x));
  return x >= 0.0 || (field.depth == Depth::levels_and_thresholds && std::isnan(x));
}

/// Each field that the study keeps is there, with numbers that a history can have.
void check_histories(const Results& results, const KeptFields& kept) {
  const HistoryTable& table = results.histories;
  for_each_history_field([&]<class T>(const HistoryField<T>& field) {
    const auto& values = table.fields.*field.of;
    const std::size_t size = table.records * table.cases * table.depth(field.depth);
    expect_fit(values.size() == (kept.has(field) ? size : 0), field.name, "study");
    const auto is = [&](double x) { return is_possible(field, x, results.levels.back()); };
    expect_fit(std::ranges::all_of(values, is), field.name, "numbers of a history");
  });
}

/// What was read is of its study, so that analyses need no checks.
void check_shapes(const Results& results, const StudyConfig& study) {
  check_cases(results.cases, study);
  check_suites(results);
  check_histories(results, KeptFields(study));
}

/// @param study set to that of the results
Results read_parts(const std::filesystem::path& file, StudyConfig& study) {
  Results results;
  read_results_of(kind, file, [&](const Hdf5Reader& root) {
    read_run(root, results);
    study = study_of(results, file);
    put_study(study, results);
    static_cast<CaseGrid&>(results.cases) = PlannedCases(study);
    read_histories(root, results);
    check_shapes(results, study);
  });
  return results;
}

}  // namespace

void write_results(const std::filesystem::path& file, const Results& results,
                   const std::vector<DataTable>& tables) {
  write_results_of(kind, file,
                   [&](const Hdf5Writer& root) { write_content(root, results, tables); });
}

Results read_histories(const std::filesystem::path& file) {
  StudyConfig study;
  return read_parts(file, study);
}

Results read_results(const std::filesystem::path& file) {
  StudyConfig study;
  Results results = read_parts(file, study);
  analyse_again(std::move(study), results);
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
