// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/results_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "glissade/core/wrap.hpp"
#include "glissade/motion/suite_scaling.hpp"

namespace glissade {
namespace {

std::string percent(double share) {
  return share < 5e-4 ? "fewer than 0.1 %" : fmt::format("{:.1f} %", 100.0 * share);
}

using Flags = HistoryValues<std::uint8_t>;

/// Whether a flag is set for any history of a record.
bool is_set(const Results& results, const Flags& flags, std::size_t record) {
  const std::size_t of_each = flags.size() / results.records.size();
  const auto of_record = std::span(flags).subspan(record * of_each, of_each);
  return std::ranges::find(of_record, 1) != of_record.end();
}

/// The records for which one of the flags is set.
struct Flagged {
  std::vector<std::string> records;

  Flagged(const Results& results, std::initializer_list<const Flags*> flags) {
    for (std::size_t record = 0; record < results.records.size(); ++record)
      if (std::ranges::any_of(flags, [&](const Flags* of) { return is_set(results, *of, record); }))
        records.push_back(results.records[record].id);
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
  const Flags& uplift = results.histories.fields.uplift;
  const Flagged lifts(results, {&uplift});
  if (lifts.records.empty()) return;
  const HistoryTable& table = results.histories;
  const auto share_at = [&](std::size_t level) {
    return mean_of(table, uplift, {0, table.cases}, level);
  };
  std::size_t first = 0;
  while (share_at(first) == 0.0) ++first;
  notes.push_back(fmt::format(
      "UPLIFT: under {} of {} ({}) the array lifts off its roof in some histories, from {} on; at "
      "the highest level in {} of all. Uplift is outside the model: slip there is that of a block "
      "without friction while lifted (shares: tables)",
      lifts.records.size(), counted(results.records.size(), "record"), lifts.names(),
      level_text(results, config, first), percent(share_at(results.levels.size() - 1))));
}

void note_failed(const Results& results, std::vector<std::string>& notes) {
  const Flags &failed = results.histories.fields.failed,
              &in_search = results.histories.fields.search_failed;
  const Flagged fails(results, {&failed, &in_search});
  if (fails.records.empty()) return;
  notes.push_back(fmt::format(
      "NOT CONVERGED: {} of {} histories, and some in search of {} of {} capacities, of the "
      "records "
      "{}. Their slip is unknown and counted as above every clearance; please report the study",
      std::ranges::count(failed, 1), failed.size(), std::ranges::count(in_search, 1),
      in_search.size(), fails.names()));
}

/// Where the suite's average touches the design spectrum, and by how much it exceeds it elsewhere.
void note_suite(const SuiteSummary& suite, const IntensityConfig& intensity,
                std::vector<std::string>& notes) {
  const SuiteSpectra& spectra = suite.spectra;
  if (std::isnan(spectra.to_target.lowest.ratio)) return;  // no shaking at the level shown
  const auto& [lowest, highest] = spectra.to_target;
  if (spectra.rule != ScalingRule::walters_2012) {
    notes.push_back(
        fmt::format("The suite {} is scaled by {}: {}, here from {:.3g} to {:.3g} s. The lowest is "
                    "{:.3g} times the design spectrum, at {:.3g} s, the highest {:.3g} times, at "
                    "{:.3g} s, the mean {:.3g}",
                    suite.name, text_of(spectra.rule).clause, text_of(spectra.rule).spectrum,
                    spectra.range.from_s, spectra.range.to_s, lowest.ratio, lowest.period_s,
                    highest.ratio, highest.period_s, spectra.mean_ratio));
    return;
  }
  notes.push_back(
      fmt::format("The suite {} is scaled so that its average SRSS spectrum is the design spectrum "
                  "or more at the periods of the scaling rule, 0 to {:g} s{}; between them the "
                  "lowest is {:.3g} times it, at {:.3g} s, the highest {:.3g} times, at {:.3g} s",
                  suite.name, longest_scaled_period_s,
                  intensity.scaled_to_s > longest_scaled_period_s
                      ? fmt::format(", nor below {:g} times it from there to {:g} s (scaled_to_s)",
                                    least_over_target_beyond, intensity.scaled_to_s)
                      : "",
                  lowest.ratio, lowest.period_s, highest.ratio, highest.period_s));
}

/// A record that is more than half of the average to which the suite is scaled: the others are then
/// far below the target.
void warn_of_dominance(const Results& results, std::vector<Warning>& warnings) {
  constexpr double most_share = 0.5;
  constexpr std::size_t least_records = 4;
  std::size_t first = 0;
  for (const SuiteSummary& suite : results.suites) {
    const SuiteSpectra& spectra = suite.spectra;
    const std::size_t records = spectra.records_g.size();
    for (std::size_t i = 0; i < records && records >= least_records; ++i) {
      double share = 0.0;
      for (std::size_t p = 0; p < spectra.periods_s.size(); ++p)
        share += spectra.records_g[i][p] / spectra.average_g[p];
      share /= static_cast<double>(records * spectra.periods_s.size());
      if (share > most_share)
        warnings.emplace_back(fmt::format(
            "record {} is {:.0f} % of the suite's average spectrum, the other {} the rest: "
            "check its scale and units",
            results.records[first + i].id, 100.0 * share, counted(records - 1, "record")));
    }
    first += records;
  }
}

}  // namespace

Remarks remarks_on_run(const Results& results, const StudyConfig& config) {
  Remarks remarks;
  warn_of_dominance(results, remarks.warnings);
  note_uplift(results, config, remarks.notes);
  note_failed(results, remarks.notes);
  if (results.measure == IntensityMeasure::sds_g) {
    for (const SuiteSummary& suite : results.suites)
      note_suite(suite, config.intensity, remarks.notes);
  }
  return remarks;
}

Remarks remarks_on_analyses(const Results& results, const StudyConfig& config) {
  const bool has_target = std::ranges::any_of(
      results.suites, [](const SuiteSummary& suite) { return !suite.target.empty(); });
  Remarks remarks = remarks_on(StudyOutline{
      config, results.cases.size(), [&](std::size_t i) { return results.cases.cases[i]; },
      mce_level(results.measure, results.model.dbe_level, has_target)});
  for_each_analysis(Analyses(), [&](auto analysis) {
    if constexpr (requires { analysis.warnings(results, config); })
      std::ranges::move(analysis.warnings(results, config), std::back_inserter(remarks.warnings));
    if constexpr (requires { analysis.warnings_of_curves(results, config); })
      for (std::string& text : analysis.warnings_of_curves(results, config))
        remarks.warnings.emplace_back(std::move(text), true);
    if constexpr (requires { analysis.notes(results, config); })
      std::ranges::move(analysis.notes(results, config), std::back_inserter(remarks.notes));
  });
  return remarks;
}

}  // namespace glissade
