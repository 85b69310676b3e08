// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/results_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/motion/suite_scaling.hpp"
#include "plan/length_unit.hpp"

namespace glissade {
namespace {

std::string percent(double share) {
  return share < 5e-4 ? "fewer than 0.1 %" : fmt::format("{:.1f} %", 100.0 * share);
}

/// Where a flag of the histories is set.
struct Flagged {
  std::vector<std::string> records;
  std::size_t first_level = std::numeric_limits<std::size_t>::max();
  double share_at_highest_level = 0.0;

  Flagged(const Results& results, const HistoryValues<std::uint8_t>& flag) {
    const HistoryTable& table = results.histories;
    if (flag.empty()) return;
    double highest = 0.0;
    for (std::size_t record = 0; record < table.records; ++record) {
      bool any = false;
      for (std::size_t i = 0; i < table.cases; ++i) {
        for (std::size_t level = 0; level < table.levels; ++level) {
          if (flag[table.at(record, i, level)] == 0) continue;
          any = true;
          first_level = std::min(first_level, level);
          if (level + 1 == table.levels) ++highest;
        }
      }
      if (any) records.push_back(results.records[record].id);
    }
    share_at_highest_level = highest / static_cast<double>(table.records * table.cases);
  }

  std::string names() const {
    constexpr std::size_t most = 8;
    const std::size_t shown = std::min(most, records.size());
    return fmt::format(
        "{}{}",
        fmt::join(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
        records.size() > most ? ", ..." : "");
  }
};

std::string level_text(const Results& results, const StudyConfig& config, std::size_t level) {
  const std::string unit = results.measure.unit();
  return fmt::format("{} = {:.3g}{}", results.measure.symbol(config.intensity),
                     results.levels[level], unit == "-" ? "" : " " + unit);
}

/// Uplift is outside the model: which records, from which level, and how much of the study.
void note_uplift(const Results& results, const StudyConfig& config,
                 std::vector<std::string>& notes) {
  const Flagged lifts(results, results.histories.fields.uplift);
  if (lifts.records.empty()) return;
  notes.push_back(fmt::format(
      "UPLIFT: {} of {} records ({}) lift the array off its roof in some histories, from {} on; at "
      "the highest level in {} of all. Uplift is outside the model: slip there is that of a block "
      "without friction while lifted (shares: tables)",
      lifts.records.size(), results.records.size(), lifts.names(),
      level_text(results, config, lifts.first_level), percent(lifts.share_at_highest_level)));
}

void note_failed(const Results& results, std::vector<std::string>& notes) {
  const auto& failed = results.histories.fields.failed;
  const auto count = std::ranges::count(failed, 1);
  if (count == 0) return;
  notes.push_back(fmt::format(
      "NOT CONVERGED: {} of {} histories, of the records {}. Their slip is unknown and counted as "
      "above every clearance; please report the study",
      count, failed.size(), Flagged(results, failed).names()));
}

/// Where the suite's average touches the design spectrum, and by how much it exceeds it elsewhere.
void note_suite(const SuiteSummary& suite, const IntensityConfig& intensity,
                std::vector<std::string>& notes) {
  const SuiteSpectra& spectra = suite.spectra;
  if (std::isnan(spectra.to_target.lowest.ratio)) return;  // no shaking at the level shown
  const auto& [lowest, highest] = spectra.to_target;
  notes.push_back(
      fmt::format("The suite {} is scaled so that its average SRSS spectrum is not below the "
                  "design spectrum at the periods of the scaling rule, 0 to {:g} s{}; between them "
                  "it is from {:.3g} times it, at {:.3g} s, to {:.3g} times, at {:.3g} s",
                  suite.name, longest_scaled_period_s,
                  intensity.scaled_to_s > longest_scaled_period_s
                      ? fmt::format(", nor below {:g} times it from there to {:g} s (scaled_to_s)",
                                    least_over_target_beyond, intensity.scaled_to_s)
                      : "",
                  lowest.ratio, lowest.period_s, highest.ratio, highest.period_s));
}

/// A record that is more than half of the average to which the suite is scaled: the others are then
/// far below the target.
void warn_of_dominance(const Results& results, std::vector<std::string>& warnings) {
  constexpr double most_share = 0.5;
  constexpr std::size_t least_records = 4;
  std::size_t first = 0;
  for (const SuiteSummary& suite : results.suites) {
    const SuiteSpectra& spectra = suite.spectra;
    const std::size_t records = spectra.srss_g.size();
    for (std::size_t i = 0; i < records && records >= least_records; ++i) {
      double share = 0.0;
      for (std::size_t p = 0; p < spectra.periods_s.size(); ++p)
        share += spectra.srss_g[i][p] / spectra.average_srss_g[p];
      share /= static_cast<double>(records * spectra.periods_s.size());
      if (share > most_share)
        warnings.push_back(fmt::format(
            "record {} is {:.0f} % of the suite's average spectrum, the other {} records the rest: "
            "check its scale and units",
            results.records[first + i].id, 100.0 * share, records - 1));
    }
    first += records;
  }
}

/// Three significant digits, in the unit of the report.
std::vector<std::string> in_unit(const std::vector<double>& lengths_m, const StudyConfig& config) {
  std::vector<std::string> texts;
  for (const double length_m : lengths_m)
    texts.push_back(fmt::format("{:.3g}", length_value(length_m, config.units)));
  return texts;
}

/// Annual rates that rest on shaking above the highest level.
void warn_of_rates_beyond(const Results& results, const StudyConfig& config,
                          std::vector<std::string>& warnings) {
  constexpr double notable_share = 0.2;
  if (!results.hazard) return;
  double largest = 0.0;
  std::vector<double> concerned_m;
  for (const HazardRun& run : results.hazard->runs) {
    for (const ThresholdRate& row : run.thresholds) {
      if (!(row.beyond_share >= notable_share)) continue;
      largest = std::max(largest, row.beyond_share);
      concerned_m.push_back(row.threshold_m);
    }
  }
  if (concerned_m.empty()) return;
  std::ranges::sort(concerned_m);
  concerned_m.erase(std::unique(concerned_m.begin(), concerned_m.end()), concerned_m.end());
  warnings.push_back(fmt::format(
      "annual rates: up to {:.0f} % of the rate of clearance {} {} is the assumption that any "
      "shaking above the highest level exceeds it. The rate is an upper estimate; add higher "
      "levels (intensity.levels)",
      100.0 * largest, fmt::join(in_unit(concerned_m, config), ", "), length_unit(config.units)));
}

/// Fragilities that are not lognormal.
void warn_of_shape(const Results& results, const StudyConfig& config,
                   std::vector<std::string>& warnings) {
  std::size_t fitted = 0, refused = 0;
  const ThresholdFragility* worst = nullptr;
  const RunResults* worst_run = nullptr;
  std::vector<double> refused_m;
  for (const RunResults& run : results.runs) {
    for (const ThresholdFragility& fragility : run.fragilities) {
      const GoodnessOfFit& fit = fragility.lognormal;
      if (std::isnan(fit.p_value)) continue;
      ++fitted;
      if (!departs_from_lognormal(fit)) continue;
      ++refused;
      refused_m.push_back(fragility.threshold_m);
      if (worst == nullptr || std::abs(fit.largest_gap) > std::abs(worst->lognormal.largest_gap))
        worst = &fragility, worst_run = &run;
    }
  }
  if (worst == nullptr) return;
  std::ranges::sort(refused_m);
  refused_m.erase(std::unique(refused_m.begin(), refused_m.end()), refused_m.end());
  const std::string unit = results.measure.unit(),
                    length = std::string(" ") + length_unit(config.units);
  const std::string at_run =
      results.runs.size() > 1
          ? results.cases.describe(worst_run->first_case / results.cases.per_combination()) + ", "
          : "";
  warnings.push_back(fmt::format(
      "{} of {} fragility curves {} not lognormal (p < {:g} and a gap of {:g} or more): of "
      "clearance {}{}. The largest gap is at {}clearance {}{}: at {} = {:.3g}{} the share of the "
      "histories that exceed it is {:.2f} {} the curve. Probabilities and annual rates are of the "
      "histories, not of the curve; medians are of the curve; [shape] compares other curves",
      refused, fitted, refused == 1 ? "is" : "are", goodness_of_fit_level, goodness_of_fit_gap,
      fmt::join(in_unit(refused_m, config), ", "), length, at_run,
      in_unit({worst->threshold_m}, config).front(), length,
      results.measure.symbol(config.intensity), worst->lognormal.gap_intensity,
      unit == "-" ? "" : " " + unit, std::abs(worst->lognormal.largest_gap),
      worst->lognormal.largest_gap > 0.0 ? "above" : "below"));
}

/// The samples that the target would take: plain Monte Carlo, on the safe side.
void warn_of_target(const Results& results, std::vector<std::string>& warnings) {
  if (!results.reached_target || results.reached_target->is_reached()) return;
  const ReachedTarget& target = *results.reached_target;
  const std::string reached =
      std::isinf(target.error)
          ? "some scrambles have no fit: give higher levels, or more samples"
          : fmt::format("the error of the samples is {:.2g}; some {:.0f} samples would be required",
                        target.error,
                        static_cast<double>(results.cases.samples) *
                            std::pow(target.error / target.target_error, 2));
  warnings.push_back(
      fmt::format("sampling.target_error = {:g} is not reached after all {} scrambles: {}",
                  target.target_error, target.scrambles, reached));
}

}  // namespace

std::vector<std::string> warnings_on(const Results& results, const StudyConfig& config) {
  std::vector<std::string> warnings;
  warn_of_target(results, warnings);
  warn_of_dominance(results, warnings);
  warn_of_shape(results, config, warnings);
  warn_of_rates_beyond(results, config, warnings);
  return warnings;
}

std::vector<std::string> notes_on(const Results& results, const StudyConfig& config) {
  std::vector<std::string> notes;
  note_uplift(results, config, notes);
  note_failed(results, notes);
  if (results.measure == IntensityMeasure::sds_g) {
    for (const SuiteSummary& suite : results.suites) note_suite(suite, config.intensity, notes);
  }
  if (config.verdict && std::ranges::any_of(results.cases.cases, [](const Case& c) {
        return c.response_modification > 0.0;
      }))
    notes.push_back(
        results.model.dbe_level > 0.0
            ? fmt::format("Verdict: R gives a building the strength for the design target, {:.3g} "
                          "g; buildings with R are judged at that S_DS alone",
                          results.model.dbe_level)
            : "Verdict: buildings with R are not judged, since there is no single design target "
              "whose S_DS gives their strength");
  return notes;
}

}  // namespace glissade
