// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

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

template <class Archive, class Run>
void exchange_run(const Archive& archive, const IntensityScale& scale, Run& run) {
  archive.attribute("friction", run.friction_description);
  archive.attribute("first_case", run.first_case);
  archive.attribute("cases", run.cases);
  list(archive, "band_intensity" + scale.suffix, {scale.unit, "intensities of the fragility bands"},
       run.band_intensities);
  exchange_fragilities(archive.group("fragility"), scale, run.fragilities);
  exchange_slip(archive.group("slip"), scale, run.slip);
}

void read_fragility(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("fragility");
  FragilityConfig fragility;
  fragility.thresholds_m = read_increasing(table, "thresholds_m", above_zero);
  fragility.stop_at_largest = table.flag("stop_at_largest").value_or(false);
  study.fragility = fragility;
}

void check_fragility(Results& results) {
  const std::size_t records = results.records.size(), levels = results.levels.size(),
                    thresholds = results.thresholds_m.size();
  for (const RunResults& run : results.runs) {
    expect_fit(run.cases > 0 && run.cases <= results.cases.size() &&
                   run.first_case <= results.cases.size() - run.cases,
               "first_case", "cases");
    expect_fit(run.slip.size() == levels, "slip", "levels");
    expect_fit(run.fragilities.size() == thresholds && thresholds > 0, "fragility", "thresholds");
    for (const ThresholdFragility& f : run.fragilities) {
      expect_fit(f.probability.size() == levels, "probability", "levels");
      expect_fit(f.probability_interval.size() == levels, "probability_low", "levels");
      expect_fit(f.record_recross.size() == records, "record_recross", "records");
      expect_fit(f.band.empty() || f.band.size() == run.band_intensities.size(), "band_low",
                 "band's intensities");
    }
  }
}

}  // namespace

AnalysisInFiles FragilityAnalysis::in_files() {
  return {
      .table = "fragility",
      .read = read_fragility,
      .keys = {{"thresholds_m", list_value, "required",
                "clearances, m: probability that displacement exceeds each"},
               {"stop_at_largest", "true or false", "false",
                "levels above the one that reaches the largest threshold are not run"}},
      .uses = {"model.displacement", "sampling.target_error", "sampling.scrambles",
               "sampling.bootstrap_replicates", "standards.compare"},
      .stands_alone = true,
      .sampled_friction = FrictionUse::usual,
      .design_friction = FrictionUse::usual,
      .exchange = Exchange::of([](const auto& root, const char*, const auto& scale, auto& results) {
        const auto archive = root.group(runs_group);
        const Columns column(archive, results.runs, "label");
        column("label", {"-", "the combinations, in order; each is a group"}, &RunResults::label);
        for (auto& run : results.runs) {
          expect_file_name(run.label);
          exchange_run(archive.group(run.label), scale, run);
        }
      }),
      .check = check_fragility};
}

}  // namespace glissade
