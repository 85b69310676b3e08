// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "enum_names.hpp"
#include "results/analysis/impact.hpp"
#include "results/archive.hpp"
#include "results/envelope.hpp"
#include "results/shared_schema.hpp"

// The runs of a study with [fragility], with [standards] and [impact].
namespace glissade {

/// One of the two fits of every threshold.
template <class Archive, class Fragilities>
void exchange_fits(const Archive& archive, const IntensityScale& scale, Fragilities& rows,
                   FitSummary ThresholdFragility::*fit) {
  const Columns column(archive, rows);
  const auto curve = [fit](double FragilityCurve::*value) {
    return member(member(fit, &FitSummary::curve), value);
  };
  column("status", {"-", "how the fit came out"}, member(fit, &FitSummary::status),
         fit_status_names());
  column("floor", {"-", "share that exceeds without shaking"}, curve(&FragilityCurve::floor));
  column("median", {scale.unit, "median of the lognormal fragility of the rest"},
         curve(&FragilityCurve::median));
  column("log_std", {"-", "logarithmic standard deviation of the rest"},
         curve(&FragilityCurve::log_std));
  column("median", {scale.unit, "95 % interval of the median"},
         member(fit, &FitSummary::median_interval));
  column("floor", {"-", "95 % interval of the floor; nan: none"},
         member(fit, &FitSummary::floor_interval));
  column("p50", {scale.unit, "95 % interval of the intensity at which half of all exceed"},
         member(fit, &FitSummary::p50_interval));
  column("log_std", {"-", "95 % interval of log_std"}, member(fit, &FitSummary::log_std_interval));
  column("log_likelihood", {"-", "logarithm of the likelihood"},
         member(fit, &FitSummary::log_likelihood));
  column("method", {"-", "how it was fitted"}, member(fit, &FitSummary::method));
  column("interval_method", {"-", "how the intervals were found"},
         member(fit, &FitSummary::interval_method));
  column("note", {"-", "remarks on the results"}, member(fit, &FitSummary::note));
}

template <class Archive, class Fragilities>
void exchange_fragilities(const Archive& archive, const IntensityScale& scale, Fragilities& rows) {
  const Columns column(archive, rows, "threshold_m");
  column("threshold_m", {"m", "clearance threshold"}, &ThresholdFragility::threshold_m);
  exchange_fits(archive.group("stripes"), scale, rows, &ThresholdFragility::stripes);
  exchange_fits(archive.group("capacities"), scale, rows, &ThresholdFragility::capacities);
  column("probability", {"-", "observed share exceeding, by (threshold, level)"},
         &ThresholdFragility::probability);
  column("probability", {"-", "95 % interval of the share, by (threshold, level)"},
         &ThresholdFragility::probability_interval);
  column("band", {"-", "95 % band of the capacity fit, by (threshold, band intensity)"},
         &ThresholdFragility::band);
  column("recross_share",
         {"-",
          "share of histories that reach the threshold and fall below it again at a higher level"},
         &ThresholdFragility::recross_share);
  column("record_recross",
         {"-", "1 where any sample of the record recrosses, by (threshold, record)"},
         &ThresholdFragility::record_recross);
  column("censored_share", {"-", "share of histories that never reach the threshold"},
         &ThresholdFragility::censored_share);
  column("free_sliding_share", {"-", "share of histories that slide with no shaking"},
         &ThresholdFragility::free_sliding_share);
  const auto lognormal = [](double GoodnessOfFit::*value) {
    return member(&ThresholdFragility::lognormal, value);
  };
  column("lognormal_p_value", {"-", "goodness of fit of the lognormal; nan: no test"},
         lognormal(&GoodnessOfFit::p_value));
  column("lognormal_distance", {"-", "Cramer-von Mises distance of capacities and curve"},
         lognormal(&GoodnessOfFit::distance));
  column("record_correlation", {"-", "of the normal scores of a record's capacities"},
         lognormal(&GoodnessOfFit::correlation));
  column("largest_gap", {"-", "largest difference of observed share and curve"},
         lognormal(&GoodnessOfFit::largest_gap));
  column("gap_intensity", {scale.unit, "where that is"}, lognormal(&GoodnessOfFit::gap_intensity));
}

template <class Archive, class Slip>
void exchange_slip(const Archive& archive, const IntensityScale& scale, Slip& rows) {
  const Columns column(archive, rows, scale.level);
  column(scale.level, {scale.unit, "intensity level"}, &SlipStatistics::level);
  column("median_m", {"m", "median peak displacement in plan"}, &SlipStatistics::median_m);
  column("p84_m", {"m", "84th percentile"}, &SlipStatistics::p84_m);
  column("p95_m", {"m", "95th percentile"}, &SlipStatistics::p95_m);
  column("mean_m", {"m", "mean"}, &SlipStatistics::mean_m);
  column("mean_m", {"m", "95 % interval of the mean"}, &SlipStatistics::mean_interval);
  column("median_m", {"m", "95 % interval of the median"}, &SlipStatistics::median_interval);
  column("p84_m", {"m", "95 % interval of the 84th percentile"}, &SlipStatistics::p84_interval);
  column("uplift_share", {"-", "share of histories with uplift"}, &SlipStatistics::uplift_share);
  column("mean_vector_m",
         {"m", "two axes: mean of the longest displacement vectors; nan: one axis"},
         &SlipStatistics::mean_vector_m);
}

template <class Archive, class Comparisons>
void exchange_standards(const Archive& archive, Comparisons& rows) {
  exchange_prescriptions(archive, rows);
  const Columns column(archive, rows);
  column("exceedance_probability", {"-", "share of histories with slip above it"},
         &StandardComparison::exceedance_probability);
  column("exceedance", {"-", "95 % interval of that share"},
         &StandardComparison::exceedance_interval);
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
  const Columns column(archive, runs, "label");
  column("label", {"-", "the combinations, in order; each is a group"}, &RunResults::label);
  if constexpr (Archive::reads) {
    for (const auto& run : runs) expect_file_name(run.label);
  }
  for (auto& run : runs) exchange_run(archive.group(run.label), scale, run);
}

}  // namespace glissade
