// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/analyses.hpp"
#include "analysis/sensitivity/sensitivity.hpp"
#include "glissade/report/format.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr std::size_t most_sentences = 3;
/// From this share of limited capacities on a reader must know of it.
constexpr double notable_share = 0.05;

std::string spread_sentence(const SensitivityResults& found, const SpreadRow& row) {
  const std::string clearance = format_length(row.threshold_m);
  if (!(row.std > 0.0)) return "The capacity at " + clearance + " does not vary.";
  std::vector<std::size_t> drawn;
  double alone = row.first[records_factor];
  for (std::size_t f = first_drawn_factor; f < found.factors.size(); ++f) {
    drawn.push_back(f);
    alone += std::max(0.0, row.first[f]);
  }
  std::ranges::stable_sort(
      drawn, [&](std::size_t a, std::size_t b) { return row.first[a] > row.first[b]; });
  const auto part = [&](const std::string& name, std::size_t f) {
    const std::string alone =
        name + " " + share_with_interval({row.first[f], row.first_interval[f]});
    return std::isnan(row.total[f]) ? alone : alone + " and " + format_share(row.total[f]);
  };
  std::string text = fmt::format(
      "Spread of the capacity at {} (log std {:.2f}), shares of its variance alone and with "
      "interactions: {}",
      clearance, row.std, part("the record", records_factor));
  for (const std::size_t f : drawn) text += ", " + part(found.factors[f], f);
  text += fmt::format(
      ". Interactions together: {}. Standard error of the mean ln capacity: "
      "{:.3f} from the number of records, {:.3f} from as many independent samples.",
      format_share(std::max(0.0, 1.0 - alone)), row.record_error, row.sample_error);
  if (row.share_below + row.share_above > notable_share)
    text += fmt::format(
        " {} of the capacities are outside the range of the levels and count as its ends: the "
        "spread is that within the range.",
        format_share(row.share_below + row.share_above));
  return text;
}

/// At the level where the mean is nearest the smallest threshold: neither all rest nor all slide
/// far.
std::string design_sentence(const Results& results) {
  const SensitivityResults& found = *results.sensitivity;
  const DesignFrictionRow* row = &found.design_friction.front();
  const auto distance = [&](const DesignFrictionRow& r) {
    return std::abs(std::log(std::max(r.design_mean_m, 1e-9) / results.thresholds_m.front()));
  };
  for (const DesignFrictionRow& other : found.design_friction) {
    if (other.first_case == row->first_case && distance(other) < distance(*row)) row = &other;
  }
  return fmt::format(
      "Design friction (mean - 2 std) at {}: slip with drawn friction exceeds that with design "
      "friction, of the same motion and building, with a probability of {} (standard error of the "
      "samples {}). The mean slip with design friction, {}, is exceeded with a probability of {} "
      "(samples {}).",
      at_intensity(results, row->level), share_with_interval(row->same_motion),
      format_share(row->same_motion_error), format_length(row->design_mean_m),
      share_with_interval(row->above_mean), format_share(row->above_mean_error));
}

std::vector<std::string> sentences(const Results& results) {
  const SensitivityResults& found = *results.sensitivity;
  std::vector<std::string> all;
  for (const SpreadRow* row : first_capacity_rows(found, most_sentences))
    all.push_back(spread_sentence(found, *row));
  if (!found.design_friction.empty()) all.push_back(design_sentence(results));
  return all;
}

std::string summary(const Results& results) { return paragraphs(sentences(results)); }

Html section(const Results& results) {
  Html html =
      heading("Where the spread comes from") + wide_table(spread_table(results)) +
      paragraph(
          "Of ln capacity, because its variance is the square of the log standard deviation "
          "that a fragility has. Shares at each level: tables/sensitivity_levels.csv. "
          "Intervals are jackknife intervals over " +
          units_name(results) +
          " and over groups of samples; the shares take the records as drawn, each by itself, from "
          "a population of records.");
  if (!results.sensitivity->design_friction.empty())
    html += heading("The design value of friction") + wide_table(design_friction_table(results));
  return html;
}

}  // namespace

AnalysisReport SensitivityAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return results.sensitivity.has_value(); },
          .summary = summary,
          .sentences = sentences,
          .figures = each<spread_figure, spread_over_intensity_figure>,
          .tables = each<spread_table, exceedance_spread_table, design_friction_table>,
          .section = section};
}

}  // namespace glissade
