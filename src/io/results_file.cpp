// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/results_file.hpp"

#include "glissade/core/contract.hpp"
#include "glissade/core/file_name.hpp"
#include "results_envelope.hpp"
#include "results_schema.hpp"

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

/// Every part is there for each record, sample, level and threshold that the others have: whoever
/// goes through the results need not look.
void check_shapes(const Results& results) {
  const std::size_t records = results.records.size(), samples = results.samples.size(),
                    levels = results.levels.size(), thresholds = results.thresholds_m.size();
  const auto is_cube = [&](const auto& cube, std::size_t depth) {
    return cube.rows == records && cube.columns == samples && cube.depth == depth;
  };
  for (const RunResults& run : results.runs) {
    expect_fit(is_cube(run.peak_displacement_m, levels), "peak_displacement_m",
               "records, samples and levels");
    expect_fit(run.peak_vector_m.data.empty() || is_cube(run.peak_vector_m, levels),
               "peak_vector_m", "records, samples and levels");
    expect_fit(is_cube(run.uplift, levels), "uplift", "records, samples and levels");
    expect_fit(run.tips.data.empty() || is_cube(run.tips, levels), "tips",
               "records, samples and levels");
    expect_fit(is_cube(run.capacity, thresholds), "capacity_g", "records, samples and thresholds");
    expect_fit(run.slip.size() == (results.chart ? 0 : levels), "slip", "levels");
    expect_fit(run.fragilities.size() == thresholds, "fragility", "thresholds");
    const bool tells_impact = !run.impact.empty() || !run.crossing_time_s.empty();
    const std::size_t crossings = tells_impact ? records * samples * levels * thresholds : 0;
    expect_fit(run.crossing_time_s.size() == crossings, "crossing_time_s",
               "records, samples, levels and thresholds");
    expect_fit(run.crossing_speed_mps.size() == crossings, "crossing_speed_mps",
               "records, samples, levels and thresholds");
    expect_fit(run.impact.size() == (tells_impact ? levels * thresholds : 0), "impact",
               "levels and thresholds");
    for (const ThresholdFragility& f : run.fragilities) {
      expect_fit(f.probability.size() == levels, "probability", "levels");
      expect_fit(f.probability_interval.size() == levels, "probability_low", "levels");
      expect_fit(f.record_recross.size() == records, "record_recross", "records");
      expect_fit(f.band.empty() || f.band.size() == run.band_intensities.size(), "band_low",
                 "band's intensities");
    }
  }
  const SuiteSpectra& spectra = results.spectra;
  const std::size_t periods = spectra.periods_s.size();
  expect_fit(spectra.srss_g.size() == records, "srss_g", "records");
  for (const std::vector<double>& srss : spectra.srss_g)
    expect_fit(srss.size() == periods, "srss_g", "periods");
  expect_fit(spectra.average_srss_g.size() == periods, "average_srss_g", "periods");
  expect_fit(spectra.target_g.empty() || spectra.target_g.size() == periods, "target_g", "periods");
}

void check_shape(const Chart& chart, std::size_t levels) {
  expect_fit(chart.slope_deg.size() > 1 && chart.mu.size() > 1 && !chart.period_s.empty(), "axes",
             "chart");
  expect_fit(chart.points.size() == levels * chart.slope_deg.size() * chart.mu.size(), "points",
             "chart's axes");
  for (const ChartPoint& point : chart.points)
    expect_fit(point.by_period.size() == chart.period_s.size(), "by_period", "chart's periods");
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
    if (results.chart) check_shape(*results.chart, results.levels.size());
    if (!labels_are_distinct_names(results)) throw Hdf5Error("tell the runs apart by their labels");
  });
  return results;
}

}  // namespace glissade
