// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/chart/report.hpp"
#include "analysis/chart/view.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string shown_sentence(const Results& results) {
  const ChartPoint& p = shown_point(results);
  const std::string where = fmt::format("At {}, {}", at_intensity(results, p.level),
                                        at_slope_and_friction(p.slope_deg, p.mu));
  if (p.free_sliding) return where + ", friction cannot stop the array: no clearance is enough.";
  const std::string period =
      results.chart->period_s.size() > 1
          ? fmt::format(" A building period of {} s governs.", brief(p.governing_period_s))
          : "";
  if (is_one_record(results)) {
    return fmt::format("{}, the peak slip under the one record is {}.{}", where,
                       format_length(p.largest.envelope_m), period);
  }
  const std::string target = target_text(results),
                    of_target = target.empty() ? "" : " Design target: " + target + ".";
  const std::string open = open_percentile(results);
  const std::string interval =
      std::isnan(p.mean_interval.low)
          ? ""
          : " (95 % interval of the mean " + format_length_interval(p.mean_interval) + ")";
  return fmt::format(
      "{}, the {} is {}: {:g} x the mean over {}, {}{}. Over {} the 84th "
      "percentile is {}, the 95th {}, the largest {}.{}{}{}",
      where, design_name(results), format_length(p.clearance_m), clearance_factor(results),
      counted_records(results), format_length(p.largest.mean_m), interval,
      results.cases.samples > 1 ? "records and samples pooled" : "the records",
      format_length(p.largest.p84_m), format_length(p.largest.p95_m),
      format_length(p.largest.envelope_m), open.empty() ? "" : " " + open, period, of_target);
}

std::string standard_sentence(const Results& results, const ChartPrescription& prescription) {
  const ChartPoint& p = shown_point(results);
  const double design_m = design_statistic(results).slip_m(p);
  const bool applies = applies_at(prescription.standard, p.slope_deg, p.mu);
  std::string sentence =
      fmt::format("{} prescribes {}{}{}", standard_name(prescription.standard),
                  format_length(prescription.prescribed.value_m), applies ? " there" : "",
                  recalled_in_brackets(prescription.prescribed.provenance));
  if (!applies) sentence += ", but not there: it is for " + limits_of(prescription.standard);
  if (std::isfinite(design_m) && design_m > 0.0) {
    sentence += fmt::format("{} {} x {}", applies ? "," : ". That is",
                            format_number(prescription.prescribed.value_m / design_m),
                            is_one_record(results) ? "this slip" : "the " + design_name(results));
  }
  return sentence + ".";
}

std::string reading_sentence(const Results& results, const ChartReading& reading) {
  std::string answers;
  for (const ChartStatistic& s : chart_statistics(results)) {
    const std::string answer = answer_text(*results.chart, reading.question, reading.*s.reading);
    if (is_one_record(results))
      return question_text(results, reading.question) + ": " + answer + ".";
    answers += (answers.empty() ? "" : ", ") + s.name + " " + answer;
  }
  return question_text(results, reading.question) + ": " + answers + ".";
}

std::string free_sliding_sentence(const Results& results) {
  const Chart& chart = *results.chart;
  const auto free = std::count_if(chart.points.begin(), chart.points.end(),
                                  [](const ChartPoint& p) { return p.free_sliding; });
  if (free == 0) return "";
  return fmt::format(
      "At {} of the chart's {} combinations of slope and friction the array slides freely: "
      "friction cannot stop it (tan(slope) >= mu).",
      free / static_cast<long>(results.levels.size()), chart.slope_deg.size() * chart.mu.size());
}

/// "At S_DS = 1.30 g the array lifts off in up to 3.0 % of the histories at a point; in up to 12 %
/// at S_DS = 1.95 g."; "" where it never does.
std::string uplift_sentence(const Results& results) {
  const Chart& chart = *results.chart;
  double here = 0.0, elsewhere = 0.0, where = 0.0;
  for (const ChartPoint& p : chart.points) {  // NaN is not larger
    if (p.level == chart.shown_level) {
      if (p.uplift_share > here) here = p.uplift_share;
    } else if (p.uplift_share > elsewhere) {
      elsewhere = p.uplift_share;
      where = p.level;
    }
  }
  if (here == 0.0 && elsewhere == 0.0) return "";
  std::string text = fmt::format(
      "At {} the array lifts off (outside the model) in {}",
      at_intensity(results, chart.shown_level),
      here > 0.0 ? "up to " + format_share(here) + " of the histories at a point of the chart"
                 : std::string("no history"));
  if (elsewhere > 0.0) {
    text += fmt::format("; in up to {}{} at {}", format_share(elsewhere),
                        here > 0.0 ? "" : " of those at a point", at_intensity(results, where));
  }
  return text + ".";
}

std::string confidence_sentence(const Results& results) {
  const double n = static_cast<double>(unit_count(results));
  return fmt::format(
      "The largest of {3} is above the 84th percentile of all motions of this kind with a "
      "confidence of {0} (1 - 0.84^{2}) and above their 95th with {1} (1 - 0.95^{2}), whatever "
      "their distribution, if the {4} are drawn from them at random.",
      format_share(1.0 - std::pow(0.84, n)), format_share(1.0 - std::pow(0.95, n)),
      unit_count(results), counted_records(results), units_name(results));
}

}  // namespace

std::string question_text(const Results& results, const ChartQuestion& question) {
  const std::string where = fmt::format("{}, slope {}", at_intensity(results, question.level),
                                        degrees(question.slope_deg));
  if (question.mu)
    return fmt::format("Displacement at {}, friction {}", where, brief(*question.mu));
  return fmt::format("Friction needed for {} at {}", format_length(question.displacement_m.value()),
                     where);
}

std::string answer_text(const Chart& chart, const ChartQuestion& question, double answer) {
  if (question.mu) return std::isinf(answer) ? "slides freely" : format_length(answer);
  if (std::isinf(answer)) return "more than " + brief(chart.mu.back());
  if (answer == chart.mu.front()) return brief(answer) + " or less";
  return format_number(answer);
}

std::vector<std::string> chart_sentences(const Results& results) {
  const Chart& chart = *results.chart;
  std::vector<std::string> sentences = {shown_sentence(results)};
  if (!is_one_record(results))
    sentences.push_back(design_title(results) + ": " + clearance_rule(results) + ".");
  for (const ChartPrescription& p : chart.standards) {
    if (p.sds_g == chart.shown_level) sentences.push_back(standard_sentence(results, p));
  }
  for (const ChartReading& reading : chart.readings)
    sentences.push_back(reading_sentence(results, reading));
  sentences.push_back(free_sliding_sentence(results));
  sentences.push_back(uplift_sentence(results));
  if (!is_one_record(results) && results.cases.samples == 1)
    sentences.push_back(confidence_sentence(results));
  std::erase(sentences, "");
  return sentences;
}

std::string chart_summary(const Results& results) {
  constexpr std::size_t most = 9;
  return wrapped("Design chart: " + chart_size(results), terminal_width, 2) + "\n" +
         wrapped(how_counted(results)) + "\n" + to_text(chart_matrix_table(results, most)) + "\n" +
         paragraphs(chart_sentences(results));
}

}  // namespace glissade
