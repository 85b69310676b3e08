// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/results_file.hpp"

#include <algorithm>
#include <cmath>

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
  expect_fit(whole_or_none(f.peak_along_m) && f.peak_along_m.size() == f.peak_across_m.size() &&
                 f.residual_along_m.size() == f.peak_along_m.size() &&
                 f.residual_across_m.size() == f.peak_along_m.size(),
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
void check_shapes(const Results& results) {
  const std::size_t records = results.records.size(), levels = results.levels.size(),
                    thresholds = results.thresholds_m.size();
  check_cases(results);
  check_suites(results);
  check_histories(results);
  for (const RunResults& run : results.runs) {
    expect_fit(run.cases > 0 && run.cases <= results.cases.size() &&
                   run.first_case <= results.cases.size() - run.cases,
               "first_case", "cases");
    expect_fit(run.slip.size() == levels, "slip", "levels");
    expect_fit(run.fragilities.size() == thresholds && thresholds > 0, "fragility", "thresholds");
    expect_fit(run.impact.empty() || (run.impact.size() == levels * thresholds &&
                                      !results.histories.fields.crossing_time_s.empty()),
               "impact", "levels and thresholds");
    for (const ThresholdFragility& f : run.fragilities) {
      expect_fit(f.probability.size() == levels, "probability", "levels");
      expect_fit(f.probability_interval.size() == levels, "probability_low", "levels");
      expect_fit(f.record_recross.size() == records, "record_recross", "records");
      expect_fit(f.band.empty() || f.band.size() == run.band_intensities.size(), "band_low",
                 "band's intensities");
    }
  }
}

void check_shape(const Chart& chart, std::size_t levels) {
  expect_fit(chart.slope_deg.size() > 1 && !chart.mu.empty() && !chart.period_s.empty(), "axes",
             "chart");
  expect_fit(chart.points.size() == levels * chart.slope_deg.size() * chart.mu.size(), "points",
             "chart's axes");
  for (const ChartPoint& point : chart.points)
    expect_fit(point.by_period.size() == chart.period_s.size(), "by_period", "chart's periods");
}

void check_means(const Results& results, const std::vector<Condition>& places, auto& rows,
                 auto mean) {
  const ConditionTable& conditions = *results.conditions;
  expect_fit(rows.size() == results.suites.size() * places.size(), "suite", "conditions");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SuiteMean& row = std::invoke(mean, rows[i]);
    expect_fit(row.suite == i / places.size(), "suite", "conditions");
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
    expect_fit(row.by_orientation.size() == conditions.orientations.size(), "by_orientation",
               "orientations");
  }
}

void check_shape(const ClearanceResults& clearance, const Results& results) {
  const ConditionGrid& grid = results.conditions->grid;
  expect_fit(clearance.factor >= 1.0, "factor", "required clearance");
  check_means(results, sliding_conditions(grid, Periods::largest), clearance.required,
              &RequiredClearance::largest);
  check_means(results, sliding_conditions(grid, Periods::one), clearance.by_period,
              std::identity{});
}

void check_shape(const BaseShearResults& base_shear, const Results& results) {
  expect_fit(!results.histories.fields.shear_along.empty(), "base_shear", "histories");
  check_means(results, all_conditions(results.conditions->grid), base_shear.means, std::identity{});
}

void check_shape(const TippingResults& tipping, const Results& results) {
  expect_fit(tipping.shares.size() == results.cases.combinations() * results.levels.size(),
             "tipping", "combinations and levels");
  for (const TippingShare& row : tipping.shares) {
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
    expect_fit(row.by_record.size() == results.records.size(), "share_by_record", "records");
  }
}

void check_shape(const std::vector<RankedMeasure>& ranked, const Results& results) {
  for (const RankedMeasure& row : ranked)
    expect_fit(row.run < results.runs.size(), "run", "intensity_measures");
}

void check_shape(const VerdictResults& verdict, const Results& results) {
  expect_fit(!verdict.exceedance.empty(), "exceedance", "verdict");
  for (const VerdictRow& row : verdict.rows) {
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
    expect_fit(row.displacement_m.size() == verdict.exceedance.size() &&
                   row.displacement_interval.size() == verdict.exceedance.size(),
               "displacement_m", "exceedance");
  }
  for (const VerdictSeparation& separation : verdict.separations)
    expect_fit(separation.row < verdict.rows.size(), "row", "verdict");
}

void check_shape(const SensitivityResults& found, const Results& results) {
  const std::size_t factors = found.factors.size();
  expect_fit(factors > 2, "factor", "sensitivity");
  expect_fit(!found.rows.empty(), "spread", "sensitivity");
  for (const SpreadRow& row : found.rows) {
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
    expect_fit(row.first.size() == factors && row.first_interval.size() == factors &&
                   row.total.size() == factors && row.total_interval.size() == factors,
               "first and total", "factor");
  }
  for (const DesignFrictionRow& row : found.design_friction)
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
}

void check_shape(const ShapeResults& shape, const Results& results) {
  expect_fit(shape.runs.size() == results.runs.size(), "shape", "runs");
  for (const ShapeRun& run : shape.runs) {
    expect_fit(run.thresholds.size() == results.thresholds_m.size(), "shape", "thresholds");
    for (const ThresholdShape& t : run.thresholds) {
      const std::size_t models = t.status == ComparisonStatus::compared ? shape_model_count : 0;
      expect_fit(t.score.size() == models && t.difference.size() == models &&
                     t.standard_error.size() == models,
                 "score", "models");
      expect_fit(t.probability.size() == models * results.levels.size() &&
                     t.recrossed.size() == results.levels.size(),
                 "probability", "models and levels");
    }
  }
}

void check_shape(const RareResults& rare, const Results& results) {
  expect_fit(!rare.rows.empty(), "rows", "rare");
  for (const RareRow& row : rare.rows)
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
}

void check_shape(const ReachedTarget& target, const Results& results) {
  expect_fit(target.scrambles > 0 && target.scrambles <= target.most_scrambles &&
                 results.cases.samples % target.scrambles == 0,
             "scrambles", "samples");
}

/// With the conditions, which are made of the histories again.
void check_analyses(Results& results) {
  if (results.chart) check_shape(*results.chart, results.levels.size());
  if (results.clearance || results.base_shear) results.conditions = condition_table(results);
  if (results.clearance) check_shape(*results.clearance, results);
  if (results.base_shear) check_shape(*results.base_shear, results);
  if (results.tipping) check_shape(*results.tipping, results);
  if (results.verdict) check_shape(*results.verdict, results);
  if (results.sensitivity) check_shape(*results.sensitivity, results);
  if (results.shape) check_shape(*results.shape, results);
  if (results.rare) check_shape(*results.rare, results);
  if (results.reached_target) check_shape(*results.reached_target, results);
  if (results.intensity_measures) check_shape(*results.intensity_measures, results);
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
    check_analyses(results);
    if (!labels_are_distinct_names(results)) throw Hdf5Error("give its runs different labels");
  });
  return results;
}

}  // namespace glissade
