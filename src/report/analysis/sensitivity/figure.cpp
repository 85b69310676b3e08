// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/sensitivity/sensitivity.hpp"
#include "glissade/report/format.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr std::size_t most_panels = 3;
constexpr Colour ink{0x222222};

/// Known of every factor: total indices, or of given data those of first order.
const std::vector<double>& shown_indices(const SensitivityResults& found, const SpreadRow& row) {
  return found.matrices == 1 ? row.first : row.total;
}

/// The records and each drawn quantity, the largest first.
std::vector<std::size_t> by_size(const SensitivityResults& found, const SpreadRow& row) {
  std::vector<std::size_t> factors(found.factors.size());
  std::iota(factors.begin(), factors.end(), 0);
  std::erase(factors, all_drawn_factor);
  const std::vector<double>& size = shown_indices(found, row);
  std::ranges::stable_sort(factors,
                           [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
  return factors;
}

double percent(double share) { return 100.0 * std::clamp(share, 0.0, 1.0); }

/// Beyond 100 % stand the numbers.
constexpr double right_end_percent = 138.0;

Panel bars_of(const SensitivityResults& found, const SpreadRow& row,
              const std::vector<std::size_t>& factors) {
  const Look wide_light{{0xb9dcf0}, 18.0}, wide_dark{{0x0072b2}, 9.0}, above{{0x56b4e9}, 2.5},
      below{ink, 2.5};
  constexpr double aside = 0.3;  // of an interval from its bar, on white
  Panel panel{fmt::format("{}, log std {:.2f}", format_length(row.threshold_m), row.std),
              {"Share of the variance (%)", 0.0, right_end_percent},
              {"", 0.4, static_cast<double>(factors.size()) + 0.6}};
  for (int at = 0; at <= 100; at += 50)  // closer ones touch beside long names
    panel.x.ticks.push_back({static_cast<double>(at), fmt::format("{}", at)});
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::size_t f = factors[i];
    const double y = static_cast<double>(factors.size() - i);
    const std::string& name = found.factors[f];
    panel.y.ticks.push_back({y, name});
    const double first = percent(row.first[f]), total = percent(row.total[f]);
    if (!std::isfinite(first)) continue;
    const bool has_total = std::isfinite(total);
    const auto add = [&](const Look& look, const std::string& what, double at, double low,
                         double high, const std::string& text) {
      panel.series.push_back({DataSeries::Kind::line,
                              look,
                              name + ", " + what + ": " + text,
                              what,
                              {low, high},
                              {at, at},
                              {},
                              {}});
    };
    const auto add_bar = [&](const Look& look, const char* what, double share) {
      add(look, what, y, 0.0, share, fmt::format("{:.0f} %", share));
    };
    const auto add_interval = [&](const Look& look, const char* what, double at,
                                  const Interval& of) {
      const double low = percent(of.low), high = percent(of.high);
      add(look, what, at, low, high, fmt::format("{:.0f} to {:.0f} %", low, high));
    };
    if (has_total) {
      add_bar(wide_light, "with interactions (in brackets)", total);
      add_interval(above, "95 % interval with interactions", y + aside, row.total_interval[f]);
    }
    add_bar(wide_dark, "alone", first);
    add_interval(below, "95 % interval of alone", y - aside, row.first_interval[f]);
    panel.notes.push_back(
        {104.0, y,
         fmt::format("{:.0f}", first) + (has_total ? fmt::format(" ({:.0f})", total) : ""), ink,
         Note::Align::left});
  }
  return panel;
}

}  // namespace

Figure spread_figure(const Results& results) {
  const SensitivityResults& found = *results.sensitivity;
  const std::vector<const SpreadRow*> rows = first_capacity_rows(found, most_panels);
  const bool has_error = std::ranges::any_of(rows, [](const SpreadRow* row) {
    return !std::ranges::equal(row->first, row->total,
                               [](double first, double total) { return !(first > total); });
  });
  Figure figure{
      "sensitivity", "Where the variance of ln capacity comes from, by clearance",
      "capacity: the " + results.intensity_label + " at which slip reaches the clearance; " +
          run_below(results, results.runs.front()) +
          (has_error ? "; more alone than with interactions: error of the samples" : ""),
      "Log std: logarithmic standard deviation of the capacity. Bars: Sobol indices of ln "
      "capacity. Alone: the reduction of the variance if the factor is known (first-order index). "
      "With interactions: total index."};
  const std::vector<std::size_t> factors = by_size(found, *rows.front());
  for (const SpreadRow* row : rows) figure.panels.push_back(bars_of(found, *row, factors));
  return figure;
}

Figure spread_over_intensity_figure(const Results& results) {
  // Below and above these probabilities few histories decide.
  constexpr double least = 0.05, most = 0.95;
  const SensitivityResults& found = *results.sensitivity;
  const std::vector<const SpreadRow*> rows = first_capacity_rows(found, most_panels);
  const SpreadRow& shown = *rows[rows.size() / 2];
  const bool given = found.matrices == 1;
  Figure figure{
      "sensitivity_levels",
      fmt::format("What decides whether slip reaches {}, by intensity",
                  format_length(shown.threshold_m)),
      cases_below(results, {0, results.cases.size()}),
      fmt::format(
          "{} of whether slip reaches the clearance (0 or 1). Levels at which {:g} to {:g} % of "
          "the histories exceed. Other clearances, and intervals: tables/sensitivity_levels.csv.",
          given ? "The reduction of the variance if the quantity is known (first-order Sobol index)"
                : "The share of the variance that remains if all other quantities are known, "
                  "including interactions (total Sobol index; these add to more than 100 %)",
          100.0 * least, 100.0 * most)};
  View view{exceedance_spread_table(results),
            "level",
            {},
            {{"condition", shown.condition}, {"threshold", shown.threshold_m}}};
  keep_rows(view.table, "probability", [](double p) { return p >= least && p <= most; });
  const std::vector<std::size_t> factors = by_size(found, *rows.front());
  for (const std::size_t factor : factors)
    view.lines.push_back({found.factors[factor],
                          family_look(view.lines.size(), factors.size()),
                          as_line_and_points,
                          given ? "first" : "total",
                          {{"factor", found.factors[factor]}}});
  Panel panel = panel_of(view, results.intensity_label);
  panel.x.low *= 0.97;
  panel.x.high *= 1.03;
  panel.y = share_axis(given ? "Share of the variance, alone"
                             : "Share of the variance, with interactions");
  for (const DataSeries& line : panel.series)
    for (const double share : line.y) {
      panel.y.low = std::fmin(panel.y.low, share);
      panel.y.high = std::fmax(panel.y.high, 1.05 * share);
    }
  figure.panels.push_back(std::move(panel));
  figure.key_columns = 2;
  return figure;
}

}  // namespace glissade
