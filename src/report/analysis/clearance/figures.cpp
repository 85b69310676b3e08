// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/clearance/orientation_figures.hpp"
#include "analysis/conditions/family.hpp"
#include "analysis/conditions/view.hpp"
#include "analysis/suite/spectra_figure.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

using enum ConditionAxis;

/// Walters et al. (2012), Fig. 8.
Figure suite_figure(const Results& results) {
  const SuiteSummary& suite = results.suites.front();
  const SuiteSpectra& spectra = suite.spectra;
  const std::string as_scaled =
      spectra.reference_level > 0.0
          ? results.intensity_symbol + " = " + level_number(spectra.reference_level)
      : suite.target.empty() ? "as given"
                             : "scaled to MCE";
  return spectra_figure(
      suite.spectra, {suite.name, as_scaled,
                      suite.target_is_envelope ? "target spectrum, envelope over the site classes"
                                               : "target spectrum"});
}

std::string after_walters(const Results& results, int figure, const std::string& more = "") {
  return fmt::format("After Walters et al. (2012), Fig. {}. {}{}.", figure,
                     what_is_averaged(results), more);
}

/// Fig. 13: displacement over the building's period, by m/M and vertical.
Figure period_figure(const Results& results) {
  const ConditionGrid grid(results);
  constexpr std::size_t most_lines = 3;  // beside the clearance
  Places members = places_of(grid, vertical, mass);
  const auto mean_m = [&](const Condition& at) {
    return mean_by(results.clearance->orientation,
                   means_by_orientation(results, {}, at, Periods::largest));
  };
  const Condition governing = *std::ranges::max_element(members, {}, mean_m);
  const double largest_m = mean_m(governing);
  std::vector<ConditionAxis> same{slope, level, response_modification, support, period, listed};
  std::string below = below_text(results, {mass, vertical});
  if (members.size() > most_lines) {  // with the vertical motion of the largest
    members = along(grid, mass, governing);
    same.push_back(vertical);
    below += ", " + label_of(grid, vertical, governing);
  }
  const View view = medians_over(results, period, clearance_periods_table(results), members,
                                 [&](const Condition& at) {
                                   const std::string label = distinguished(grid, at, same);
                                   return label.empty() ? "median of the orientations" : label;
                                 });
  const double clearance_m = results.clearance->factor * largest_m;
  Look rule = look(Role::clearance);
  rule.width = 2.5;
  rule.dash = 2;
  const std::string clearance_label =
      fmt::format("clearance, {:g} x the largest mean{}: {}", results.clearance->factor,
                  rule_text(results), format_length(clearance_m));
  return {"period",
          "Mean displacement over the building's period at " +
              label_of(grid, level, shown_condition(grid)) + ", and the clearance",
          below,
          after_walters(
              results, 13,
              ". All records have the same orientation: the median over the orientations is drawn, "
              "and the clearance is of the mass ratio and vertical motion with the largest"),
          {means_panel(results, {view}, period_label,
                       {{Rule::Kind::horizontal, clearance_m, rule, clearance_label}})}};
}

std::string left_out_text(const Results& results, std::size_t most) {
  const std::size_t periods = ConditionGrid(results).size(period);
  if (periods <= most) return "";
  return fmt::format(" Of {} building periods {} are drawn; all are in tables/by_period.csv.",
                     periods, most);
}

/// A line over an axis for each of the building periods, or of as many as a panel takes.
View by_building(const Results& results, ConditionAxis x, const Table& table,
                 std::size_t most = 99) {
  const ConditionGrid grid(results);
  const Places all = shown_along(grid, period);
  Places drawn;
  for (const std::size_t i : evenly(all.size(), most)) drawn.push_back(all[i]);
  return medians_over(results, x, table, drawn, [&](const Condition& at) {
    if (results.suites.front().of_roof) return std::string("mean");
    return "building of " + label_of(grid, period, at);
  });
}

/// S_DS of the design spectrum that the suite is scaled to the MCE of; 0: it is not.
double sds_of(const SuiteSummary& suite) {
  const bool is_mce = suite.spectra.reference_level == 0.0;
  return is_mce ? largest(suite.spectra.target_g) / mce_over_dbe : 0.0;
}

/// Of the names of the suites: "site_" of "site_a", "site_b".
std::string common_begin(const std::vector<SuiteSummary>& suites) {
  std::string common = suites.front().name;
  for (const SuiteSummary& suite : suites)
    common.erase(std::ranges::mismatch(common, suite.name).in1, common.end());
  return common;
}

/// Of Walters et al. (2012), each of another.
bool are_intensity_levels(const std::vector<SuiteSummary>& suites) {
  std::set<int> levels;
  for (const SuiteSummary& suite : suites) levels.insert(suite.intensity_level);
  return levels.size() == suites.size() && !levels.contains(-1);
}

/// Fig. 14: displacement over the suites.
Figure level_figure(const Results& results) {
  View view = by_building(results, support, clearance_periods_table(results));
  view.x = "suite";
  view.where.clear();
  const bool by_level = are_intensity_levels(results.suites);
  const bool by_sds = std::ranges::all_of(
      results.suites, [](const SuiteSummary& suite) { return sds_of(suite) > 0.0; });
  const std::string common = common_begin(results.suites);
  for (const SuiteSummary& suite : results.suites) {
    const auto place = static_cast<double>(view.places.size());
    const std::string name =
        by_level ? fmt::format("{}", suite.intensity_level) : suite.name.substr(common.size());
    view.places.push_back(
        {suite.name,
         {place, name + (by_sds ? fmt::format(" (S_DS {:.3g} g)", sds_of(suite)) : "")}});
  }
  return {"level",
          by_level ? "Mean displacement over the Intensity Level" : "Mean displacement by suite",
          conditions_text(results, shown_condition(ConditionGrid(results)), {period, support}),
          after_walters(results, 14),
          {means_panel(results, {view},
                       (by_level         ? "Intensity Level"
                        : common.empty() ? "Suite"
                                         : "Suite " + common + "...") +
                           std::string(by_sds ? " (S_DS of its design spectrum)" : ""))}};
}

/// Fig. 15: displacement over R, relative to that of the reference strength.
Figure yielding_figure(const Results& results) {
  const std::string reference = reference_strength_text(ConditionGrid(results));
  View view = by_building(results, response_modification, clearance_yielding_table(results));
  keep_rows(view.table, view.x, [](double r) { return r > 0.0; });  // 0 is elastic
  return {"yielding",
          "Mean displacement on a yielding building over that on " + reference,
          below_text(results, {response_modification}),
          after_walters(
              results, 15,
              ", over the same on " + reference +
                  ". At R the building yields where the design spectrum requires an elastic force "
                  "R times as large"),
          {means_panel(results, {view}, "Response modification R",
                       {{Rule::Kind::horizontal, 1.0, look(Role::reference), reference}},
                       {"Displacement over that on " + reference, ColumnKind::number})}};
}

/// Fig. 17: displacement over slope by period.
Figure slope_figure(const Results& results) {
  const ConditionGrid grid(results);
  View largest = medians_over(
      results, slope, clearance_table(results), {shown_condition(grid)}, [&](const Condition&) {
        return results.suites.front().of_roof ? "mean" : "largest over the periods";
      });
  largest.lines[0].look = look(Role::median);
  largest.lines[0].look.width = 3.5;
  for (std::size_t i = 0; i < grid.size(slope); ++i) {
    const double slope_deg = grid.value(slope, i);
    largest.places.push_back({slope_deg, {slope_deg, slope_name(slope_deg)}});
  }
  std::vector<View> views{largest};
  constexpr std::size_t most = 3;  // beside the largest
  if (grid.has_several(period))
    views.push_back(by_building(results, slope, clearance_periods_table(results), most));
  return {"slope",
          "Mean displacement over the roof's slope",
          below_text(results, {slope}),
          after_walters(results, 17) + left_out_text(results, most),
          {means_panel(results, views, "Roof slope (rise in 12)")}};
}

/// Fig. 18: displacement over the period by level.
Figure mce_figure(const Results& results) {
  const ConditionGrid grid(results);
  const Places levels = shown_along(grid, level);
  const View view = medians_over(results, period, clearance_periods_table(results), levels,
                                 [&](const Condition& at) { return label_of(grid, level, at); });
  const Condition shown = shown_condition(grid);
  const OrientationRange largest = over_orientations(results, {}, shown, Periods::largest);
  Look rule = family_look(shown[level], levels.size());
  rule.dash = 2;
  const std::string label =
      fmt::format("largest over the periods at {}, median of the orientations: {}",
                  label_of(grid, level, shown), format_length(largest.median));
  return {"mce",
          "Mean displacement over the building's period, by level of shaking",
          below_text(results, {level}),
          after_walters(results, 18),
          {means_panel(results, {view}, period_label,
                       {{Rule::Kind::horizontal, largest.median, rule, label}})}};
}

/// Displacement over the roof's vertical period by the building's.
Figure vertical_figure(const Results& results) {
  const bool of_roof = results.suites.front().of_roof;
  constexpr std::size_t most = 4;
  View view = by_building(results, vertical, clearance_periods_table(results), most);
  view.spread = DataSeries::Kind::bars;
  view.apart = 0.16;
  for (ViewLine& line : view.lines) {  // names have nothing between them
    line.kind = as_points;
    line.look.symbol_size = 0.9;
  }
  const ConditionGrid grid(results);
  for (std::size_t i = 0; i < grid.size(vertical); ++i) {
    const Case& c = grid.case_at(Condition().with(vertical, i));
    const std::string name = c.vertical == VerticalChoice::none ? "none"
                             : of_roof                          ? "with"
                             : c.vertical_period_s == 0.0
                                 ? "rigid"
                                 : fmt::format("{:g} s", c.vertical_period_s);
    view.places.push_back({condition_cell(grid, vertical, i), {static_cast<double>(i), name}});
  }
  return {"vertical",
          std::string("Mean displacement by vertical motion of the roof") +
              (of_roof ? "" : ", on several buildings"),
          below_text(results, {vertical}),
          std::string(of_roof ? "None: no vertical motion. With: that of the suite. "
                              : "None: no vertical motion. Rigid: the roof moves vertically with "
                                "the ground, as Walters et al. (2012) assume. Else: with its own "
                                "vertical period, with the study's damping. ") +
              what_is_averaged(results) + "." + left_out_text(results, most),
          {means_panel(results, {view}, "Vertical motion of the roof")}};
}

}  // namespace

std::vector<Figure> clearance_figures(const Results& results) {
  std::vector<Figure> figures;
  const auto add = [&](ClearanceTopic topic, Figure (*draw)(const Results&)) {
    const bool is_over_period = topic == ClearanceTopic::period || topic == ClearanceTopic::mce;
    if (!covers(results, topic) || (is_over_period && results.suites.front().of_roof)) return;
    figures.push_back(draw(results));
    figures.back().labels_at_lines = topic != ClearanceTopic::spectra;
  };
  add(ClearanceTopic::spectra, suite_figure);
  add(ClearanceTopic::period, period_figure);
  if (covers(results, ClearanceTopic::orientation)) {
    if (const auto figure = orientation_figure(results)) figures.push_back(*figure);
  }
  add(ClearanceTopic::level, level_figure);
  add(ClearanceTopic::yielding, yielding_figure);
  add(ClearanceTopic::slope, slope_figure);
  add(ClearanceTopic::mce, mce_figure);
  add(ClearanceTopic::vertical, vertical_figure);
  return figures;
}

}  // namespace glissade
