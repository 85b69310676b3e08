// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/analyses.hpp"
#include "analysis/conditions/family.hpp"
#include "analysis/conditions/means.hpp"
#include "analysis/conditions/view.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/base_shear_report.hpp"
#include "glissade/report/format.hpp"
#include "page/page.hpp"

namespace glissade {
namespace {

/// Of the isolated array beside the other supports; "" where there are none.
std::string comparison(const Results& r) {
  const ConditionGrid grid(r);
  const auto isolated = place_of(grid, ArraySupport::isolated);
  if (!isolated || !grid.has_several(ConditionAxis::support)) return "";
  const MeanQuestion question{.number = HistoryNumber::base_shear};
  std::vector<std::string> parts;
  for (const ArraySupport other : {ArraySupport::anchored, ArraySupport::no_array}) {
    const auto place = place_of(grid, other);
    if (!place) continue;
    std::size_t below = 0;
    double low = INFINITY, high = 0.0;
    for (const Condition& at : shown_along(grid, ConditionAxis::period)) {
      const double ratio =
          quantile_of(ratios_by_orientation(r, question, at.with(ConditionAxis::support, *isolated),
                                            at.with(ConditionAxis::support, *place)),
                      0.5);
      below += ratio < 1.0;
      low = std::min(low, ratio);
      high = std::max(high, ratio);
    }
    const char* other_text =
        other == ArraySupport::anchored ? "with the array anchored" : "without an array";
    parts.push_back(grid.has_several(ConditionAxis::period)
                        ? fmt::format("{} to {} of that {}, below it at {} of {} periods",
                                      format_number(low), format_number(high), other_text, below,
                                      grid.size(ConditionAxis::period))
                        : format_number(low) + " times that " + other_text);
  }
  const std::string level =
      grid.has_several(ConditionAxis::level)
          ? "At " + label_of(grid, ConditionAxis::level, shown_condition(grid)) + ", with"
          : "With";
  return fmt::format("{} the array isolated the base shear is {}.", level,
                     fmt::join(parts, "; and "));
}

/// The smallest and the largest of the means, and the largest history.
std::string range_of_conditions(const Results& results) {
  const std::vector<SuiteMean>& means = results.base_shear->means;
  const ConditionGrid grid(results);
  const auto median = [](const SuiteMean& mean) { return mean.range.median; };
  const auto [least, most] = std::ranges::minmax_element(means, {}, median);
  const auto largest = std::ranges::max_element(means, {}, &SuiteMean::largest);
  const auto at = [&](auto mean) {
    const auto place = static_cast<std::size_t>(mean - means.begin()) % grid.count();
    const std::string text = distinguished(grid, grid.position(place));
    return text.empty() ? "" : " (" + text + ")";
  };
  return fmt::format(
      "The peak base shear over the weight of the building without the array, as the suite's mean, "
      "is from {}{} to {}{}; in one history at most {}{}.",
      format_number(median(*least)), at(least), format_number(median(*most)), at(most),
      format_number(largest->largest), at(largest));
}

std::string summary(const Results& results) {
  constexpr std::size_t most_rows = 24;
  const Table table = base_shear_table(results);
  return "Base shear\n" + paragraphs(base_shear_sentences(results)) +
         (table.rows.size() <= most_rows ? "\n" + to_text(table) : "");
}

constexpr const char* what =
    "Base shear over the building's weight without the array: the suite's mean of the SRSS of the "
    "peaks along both axes, ";

MeansByCondition means_of(const Results& results) {
  return {results, ConditionColumns(results), nullptr, results.base_shear->means,
          ColumnKind::number};
}

std::vector<Table> tables(const Results& results) {
  return {base_shear_table(results), base_shear_ratio_table(results),
          means_by_orientation_table(means_of(results), "base_shear_by_orientation",
                                     what + std::string("in each orientation"))};
}

Html section(const Results& results) {
  return heading("Base shear of the building") + table_or_file(base_shear_table(results));
}

/// Lines over the period, one for each support; of one period the supports side by side.
/// @param shown supports of the figure that this one stands beside, which have the same looks
Panel shears_panel(const Results& results, const Table& table, const Places& supports,
                   std::size_t shown, const std::vector<Rule>& rules, const MeansAxis& y) {
  using enum ConditionAxis;
  const ConditionGrid grid(results);
  const auto name = [&](const Condition& at) { return label_of(grid, support, at); };
  if (grid.has_several(period)) {
    View view = medians_over(results, period, table, supports, name);
    for (std::size_t i = 0; i < view.lines.size(); ++i) view.lines[i].look = family_look(i, shown);
    return means_panel(results, {view}, period_label, rules, y);
  }
  View view = medians_over(results, support, table, {supports.front()},
                           [](const Condition&) { return "mean"; });
  view.spread = DataSeries::Kind::bars;
  view.lines[0].kind = as_points;  // names have nothing between them
  for (const Condition& at : supports)
    view.places.push_back({condition_cell(grid, support, at[support]),
                           {static_cast<double>(view.places.size()), name(at)}});
  return means_panel(results, {view}, "Array", rules, y);
}

/// Fig. 16: base shear over the period by support.
Figure by_support_figure(const Results& results, const Places& supports) {
  return {"base_shear",
          supports.size() > 1 ? "Base shear of the building: array isolated, anchored, none"
                              : "Base shear of the building",
          below_text(results),
          "After Walters et al. (2012), Fig. 16. Mean over the suite of each history's SRSS of the "
          "peak base shears along both axes, over the weight of the building without the array.",
          {shears_panel(
              results, base_shear_table(results), supports, supports.size(), {},
              {"Base shear over the building's weight without the array", ColumnKind::number})}};
}

/// The same over that without an array, which must be among the supports.
Figure ratio_figure(const Results& results, const Places& with_array) {
  const std::size_t shown = with_array.size() + 1;
  return {"base_shear_ratio",
          "Effect of the array on the base shear of its building",
          below_text(results),
          "The same relative to the building without an array: below 1 the array reduces the base "
          "shear. An anchored array adds its mass.",
          {shears_panel(results, base_shear_ratio_table(results), with_array, shown,
                        {{Rule::Kind::horizontal, 1.0, look(Role::reference), "no array"}},
                        {"Base shear over that without an array", ColumnKind::number, false})}};
}

}  // namespace

Table base_shear_table(const Results& results) {
  return means_table(means_of(results), "base_shear", what + std::string("over the orientations"));
}

Table base_shear_ratio_table(const Results& results) {
  const ConditionGrid grid(results);
  const auto bare = place_of(grid, ArraySupport::no_array);
  std::vector<Condition> places = all_conditions(grid);
  std::erase_if(places,
                [&](const Condition& at) { return !bare || at[ConditionAxis::support] == *bare; });
  return ratios_table({results,
                       {.number = HistoryNumber::base_shear},
                       ConditionColumns(results),
                       places,
                       [&](const Condition& at) { return at.with(ConditionAxis::support, *bare); }},
                      "base_shear_ratio",
                      "Base shear: the suite's mean over that without an array, over the "
                      "orientations");
}

std::vector<Figure> base_shear_figures(const Results& results) {
  const ConditionGrid grid(results);
  const Places supports = shown_along(grid, ConditionAxis::support);
  Places with_array = supports;
  std::erase_if(with_array, [&](const Condition& at) {
    return grid.case_at(at).support == ArraySupport::no_array;
  });
  const bool over_period = grid.has_several(ConditionAxis::period);
  std::vector<Figure> figures;
  if (over_period || supports.size() > 1) figures.push_back(by_support_figure(results, supports));
  if (with_array.size() < supports.size() && (over_period || with_array.size() > 1))
    figures.push_back(ratio_figure(results, with_array));
  for (Figure& figure : figures) {
    figure.labels_at_lines = true;
    figure.suite = 0;
  }
  return figures;
}

std::vector<std::string> base_shear_sentences(const Results& results) {
  std::vector<std::string> sentences{comparison(results), range_of_conditions(results)};
  std::erase(sentences, "");
  return sentences;
}

AnalysisReport BaseShearAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return results.base_shear.has_value(); },
          .summary = summary,
          .sentences = base_shear_sentences,
          .figures = base_shear_figures,
          .tables = tables,
          .section = section};
}

}  // namespace glissade
