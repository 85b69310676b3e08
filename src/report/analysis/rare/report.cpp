// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/analyses.hpp"
#include "glissade/report/format.hpp"
#include "glissade/sampling/importance.hpp"
#include "page/page.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// The lowest probability that is drawn.
constexpr double least = 1e-7;

std::string small(double probability) { return fmt::format("{:.2g}", probability); }

/// "0.0012 to 0.0045"
auto range_of(Interval RareRow::*interval) {
  return [=](const RareRow& row) {
    const auto [low, high] = row.*interval;
    return std::isnan(low) ? "-" : small(low) + " to " + small(high);
  };
}

Table rare_table(const Results& results) {
  using R = RareRow;
  TableOf<R> t("rare", "Probability, given the level, that slip reaches the threshold");
  t.put_all(condition_column, threshold_column, level_column(results));
  t.text("estimate", "Probability", "probability, as text",
         [](const R& row) { return small(row.probability); });
  t.text("samples", "95 %, samples", "95 % interval of the samples, on these records, as text",
         range_of(&R::sampling_interval));
  t.text("records", "95 %, records", "95 % interval over records, as text",
         range_of(&R::record_interval));
  t.number("effective_samples", "Effective number of samples",
           "number of samples that carry the probability", &R::effective_samples)
      .detail = true;
  t.number("effective_records", "Effective number of records",
           "number of records, or events, that carry the probability", &R::effective_records);
  t.number("plain_samples", "Plain Monte Carlo samples",
           "samples of plain Monte Carlo with the same sampling error", &R::plain_samples)
      .detail = true;
  t.number("probability", "Probability",
           "probability that displacement reaches the threshold; interval over records",
           with_interval(&R::probability, &R::record_interval))
      .detail = true;
  t.number("sampled_probability", "the same, samples",
           "probability; interval of the samples, on these records",
           with_interval(&R::probability, &R::sampling_interval))
      .detail = true;
  t.add_each(results.rare->rows);
  t.notes = {
      "Samples: interval from independent scrambles, on these records. Records: interval over " +
          units_name(results) + ".",
      fmt::format("Effective number: (sum p)^2 / sum p^2 of the contributions p of the samples, of "
                  "the {}. With fewer than {:g} of the samples the error of the samples is "
                  "not known (-); with few of the {} the upper end over them may be too low.",
                  units_name(results), least_effective_samples, units_name(results)),
      "Plain Monte Carlo samples: as many would be required for the same sampling error."};
  return t;
}

Table weights_table(const Results& results) {
  TableOf<std::size_t> t("rare_weights",
                         "Weights of the samples, which are drawn from wider distributions");
  const std::vector<double>& weights = results.rare->weights;
  t.count("sample", "Sample", "position of the sample", [](std::size_t i) { return i; });
  t.number("weight", "Weight", "probability over that of the widened distributions",
           [&](std::size_t i) { return weights[i]; });
  for (std::size_t i = 0; i < weights.size(); ++i) t.add(i);
  return t;
}

/// The probability nearest 1e-5 that has an interval of the samples.
const RareRow* shown_row(const RareResults& rare) {
  const RareRow* found = nullptr;
  const auto distance = [](const RareRow& row) {
    return std::abs(std::log(row.probability) - std::log(1e-5));
  };
  for (const RareRow& row : rare.rows) {
    if (row.probability > 0.0 && row.sampling_interval.low > 0.0 &&
        (found == nullptr || distance(row) < distance(*found)))
      found = &row;
  }
  return found;
}

std::vector<std::string> sentences(const Results& results) {
  const RareRow* row = shown_row(*results.rare);
  if (row == nullptr) return {};
  return {fmt::format(
      "At {} slip reaches {} with a probability of {} (95 %: {} to {} of the samples, {} to {} of "
      "the {}; effective number of them {:.1f} of {}). Plain Monte Carlo would need {:.2g} "
      "samples for that sampling error; {} were run.",
      at_intensity(results, row->level), format_length(row->threshold_m), small(row->probability),
      small(row->sampling_interval.low), small(row->sampling_interval.high),
      small(row->record_interval.low), small(row->record_interval.high), units_name(results),
      row->effective_records, unit_count(results), row->plain_samples, results.cases.samples)};
}

std::string summary(const Results& results) {
  return to_text(rare_table(results)) + "\n" + paragraphs(sentences(results));
}

/// Of the first combination: a line for each threshold.
Figure rare_figure(const Results& results) {
  const RareResults& rare = *results.rare;
  Figure figure{"rare", "Probability that slip reaches the clearance",
                cases_below(results, {0, results.cases.size()}) + ", friction " + rare.friction +
                    "; 95 % intervals: bars of the samples, shaded over " + units_name(results),
                "Lines: estimate. Bars: 95 % interval of the samples, from independent scrambles. "
                "Shaded: 95 % interval over " +
                    units_name(results) +
                    ". Quantities without bounds are drawn from wider distributions, with "
                    "weights."};
  Panel panel{"",
              {results.intensity_label, 0.0, 1.05 * results.levels.back()},
              log_axis("Probability", least, 1.0,
                       [](double probability) { return fmt::format("{:g}", probability); })};
  View records{rare_table(results), "level", {}, {{"condition", rare.rows.front().condition}}};
  records.spread_name = "95 % over " + units_name(results);
  keep_rows(records.table, "probability", [](double probability) { return probability >= least; });
  View samples = records;
  samples.spread = DataSeries::Kind::bars;
  samples.spread_name = "95 % of the samples";
  std::set<double> thresholds;
  for (const RareRow& row : rare.rows)
    if (row.condition == rare.rows.front().condition) thresholds.insert(row.threshold_m);
  for (const double threshold_m : thresholds) {
    Look one = distinct_look(records.lines.size());
    one.symbol = 7;
    const Where where{{"threshold", threshold_m}};
    records.lines.push_back({format_length(threshold_m), one, as_line_and_points, "probability",
                             where, "probability_low95", "probability_high95"});
    samples.lines.push_back({format_length(threshold_m), one, as_line, "", where,
                             "sampled_probability_low95", "sampled_probability_high95"});
  }
  add_lines(panel, records);
  add_lines(panel, samples);
  figure.panels.push_back(std::move(panel));
  figure.labels_at_lines = true;
  return figure;
}

Html section(const Results& results) {
  return heading("Small probabilities") + wide_table(rare_table(results)) +
         paragraph(fmt::format(
             "Samples of quantities without bounds are from distributions whose standard normal "
             "numbers are {:g} times those of the study; weights (tables/rare_weights.csv) "
             "make up for it. Friction, slip and other numbers in results.h5 are those of the "
             "samples.",
             results.rare->widening));
}

std::vector<std::string> error_sentences(const Results& results) {
  const SamplingErrorRow& row = results.sampling_errors.front();
  if (!std::isfinite(row.record_error) || !std::isfinite(row.sampling_error))
    return {fmt::format("The median at {} has no standard error: too few histories reach it.",
                        format_length(row.threshold_m))};
  const bool records = row.record_error > row.sampling_error;
  std::vector<std::string> sentences{fmt::format(
      "The standard error of the median at {} is {:.1f} % from the number of records and {:.2f} % "
      "from the samples: {}.",
      format_length(row.threshold_m), 100.0 * row.record_error, 100.0 * row.sampling_error,
      records ? "more records would make the result more certain, more samples would not"
              : "more samples would make the result more certain")};
  if (results.reached_target) {
    const ReachedTarget& target = *results.reached_target;
    sentences.push_back(fmt::format(
        "Of at most {} scrambles {} were run, {}: half of the 95 % interval of a median, "
        "of the samples alone, is {:.3g} % of it or less (target {:g} %, {}).",
        target.most_scrambles, target.scrambles, counted(results.cases.samples, "sample"),
        100.0 * target.error, 100.0 * target.target_error,
        target.is_reached() ? "reached" : "not reached"));
  }
  return sentences;
}

/// Without rows where the study states no target_error.
Table reached_target_table(const Results& results) {
  using T = ReachedTarget;
  TableOf<T> t("sampling_target", "Where a run with sampling.target_error ended");
  t.share("target_error", "Target", "sampling.target_error", &T::target_error);
  t.share("error", "Reached",
          "largest half of the 95 % interval of a median, of the samples alone, over it",
          &T::error);
  t.count("scrambles", "Scrambles", "number of scrambles that were run", &T::scrambles);
  t.count("most_scrambles", "At most", "sampling.scrambles", &T::most_scrambles);
  if (results.reached_target) t.add(*results.reached_target);
  return t;
}

Table sampling_error_table(const Results& results) {
  using R = SamplingErrorRow;
  TableOf<R> t("sampling_error", "Standard errors of the median capacity");
  t.text("run", "Friction", "label of the combination", &R::label);
  t.put_all(threshold_column,
            intensity_column(results, "median", "Median",
                             "median of the fit on capacities; nan: not fitted", &R::median));
  t.share("record_error", "Of the records",
          "standard error of ln median from the number of records", &R::record_error);
  t.share("sampling_error", "Of the samples", "standard error of ln median from the samples",
          &R::sampling_error);
  t.add_each(results.sampling_errors);
  return t;
}

}  // namespace

AnalysisReport RareAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return results.rare.has_value(); },
          .summary = summary,
          .sentences = sentences,
          .figures = each<rare_figure>,
          .tables = each<rare_table, weights_table>,
          .section = section};
}

AnalysisReport SamplingErrorAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return !results.sampling_errors.empty(); },
          .summary =
              [](const Results& results) {
                return to_text(sampling_error_table(results)) + "\n" +
                       paragraphs(error_sentences(results));
              },
          .sentences = error_sentences,
          .tables = each<sampling_error_table, reached_target_table>,
          .section =
              [](const Results& results) {
                return heading("Error of the samples, error of the records") +
                       wide_table(sampling_error_table(results));
              }};
}

}  // namespace glissade
