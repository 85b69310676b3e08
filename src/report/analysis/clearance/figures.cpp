// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/clearance/orientation_figures.hpp"
#include "analysis/conditions/family.hpp"
#include "analysis/conditions/view.hpp"
#include "analysis/suite/spectra_figure.hpp"
#include "glissade/core/units.hpp"
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
          ? results.conditions->grid.level_symbol + " = " + level_number(spectra.reference_level)
      : suite.target.empty() ? "as given"
                             : "scaled to MCE";
  const bool of_classes = suite.target.find("site classes") != std::string::npos;
  return spectra_figure(
      suite.spectra,
      {suite.name, as_scaled,
       of_classes ? "target spectrum, envelope over the site classes" : "target spectrum"});
}

std::string after_walters(const Results& results, int figure, const std::string& more = "") {
  return fmt::format("After Walters et al. (2012), Fig. {}. {}{}.", figure,
                     what_is_averaged(results), more);
}

/// Fig. 13: displacement over the building's period, by m/M and vertical.
Figure period_figure(const Results& results) {
  const ConditionGrid& grid = results.conditions->grid;
  constexpr std::size_t most_lines = 3;  // beside the clearance
  Places members = places_of(grid, vertical, mass);
  double largest_m = 0.0;  // of all, drawn or not
  for (const Condition& at : members)
    largest_m =
        std::max(largest_m, mean_by(results.clearance->orientation,
                                    means_by_orientation(results, {}, at, Periods::largest)));
  std::vector<ConditionAxis> same{slope, level, response_modification, support, period, listed};
  if (members.size() > most_lines) {
    members = shown_along(grid, mass);
    same.push_back(vertical);
  }
  Family family(results, period_label, grid.period_s);
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::string label = distinguished(grid, members[i], same);
    family.add(label.empty() ? "median of the orientations" : label, family_look(i, members.size()),
               along(grid, period, members[i]));
  }
  const double clearance_m = results.clearance->factor * largest_m;
  Look rule = look(Role::clearance);
  rule.width = 2.5;
  rule.dash = 2;
  family.add_level(
      clearance_m,
      fmt::format("clearance, {:g} x the largest mean{}: {}", results.clearance->factor,
                  rule_text(results), format_length(clearance_m)),
      rule);
  return {"period",
          "Displacement over the building's period at " +
              label_of(grid, level, shown_condition(grid)) + ", and the clearance",
          below_text(results, {mass, vertical}),
          after_walters(
              results, 13,
              ". All records have the same orientation: the median over the orientations is drawn, "
              "and the clearance is of the mass ratio and vertical motion with the largest"),
          family.displacements()};
}

/// Of the building periods as many as a panel takes, from the shortest to the longest.
Places drawn_buildings(const Results& results, std::size_t most) {
  Places all = shown_along(results.conditions->grid, period);
  Places drawn;
  for (const std::size_t i : evenly(all.size(), most)) drawn.push_back(all[i]);
  return drawn;
}

std::string left_out_text(const Results& results, std::size_t most) {
  const std::size_t periods = results.conditions->grid.period_s.size();
  if (periods <= most) return "";
  return fmt::format(" Of {} building periods {} are drawn; all are in tables/by_period.csv.",
                     periods, most);
}

/// A line for each of these periods over the places of another axis.
void add_buildings(const Results& results, ConditionAxis axis, std::size_t most, Family& family) {
  const Places buildings = drawn_buildings(results, most);
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    family.add("building of " + label_of(results.conditions->grid, period, buildings[i]),
               family_look(i, buildings.size()),
               along(results.conditions->grid, axis, buildings[i]));
  }
}

/// S_DS of the design spectrum that the suite is scaled to the MCE of; 0: it is not.
double sds_of(const SuiteSummary& suite) {
  const bool is_mce = suite.spectra.reference_level == 0.0;
  return is_mce ? largest(suite.spectra.target_g) / mce_over_dbe : 0.0;
}

/// Fig. 14: displacement over the suites.
Figure level_figure(const Results& results) {
  std::vector<double> sds_g, place;
  std::vector<std::string> names;
  for (const SuiteSummary& suite : results.suites) {
    sds_g.push_back(sds_of(suite));
    place.push_back(static_cast<double>(place.size()));
    names.push_back(suite.name);
  }
  const bool by_sds = std::ranges::min(sds_g) > 0.0;
  Family family(results, by_sds ? "S_DS of the suite's design spectrum (g)" : "Suite",
                by_sds ? sds_g : place);
  if (!by_sds) family.name_ticks(names);
  const Places buildings = shown_along(results.conditions->grid, period);
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    std::vector<std::vector<double>> by_suite;
    for (std::size_t suite = 0; suite < results.suites.size(); ++suite) {
      by_suite.push_back(
          means_by_orientation(results, {.suite = suite}, buildings[i], Periods::one));
      std::ranges::sort(by_suite.back());
    }
    family.add_numbers("building of " + label_of(results.conditions->grid, period, i),
                       family_look(i, buildings.size()), by_suite);
  }
  return {"level", "Displacement over the design spectral acceleration",
          conditions_text(results, shown_condition(results.conditions->grid), {period, support}),
          after_walters(results, 14), family.displacements()};
}

/// Fig. 15: displacement over R, relative to that of the reference strength.
Figure yielding_figure(const Results& results) {
  const ConditionGrid& grid = results.conditions->grid;
  Family family(results, "Response modification R (0: elastic)", grid.response_modification);
  const Places buildings = shown_along(grid, period);
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    std::vector<std::vector<double>> ratios;
    for (const Condition& at : along(grid, response_modification, buildings[i]))
      ratios.push_back(
          ratios_by_orientation(results, {}, at, with_reference_strength(grid, buildings[i])));
    family.add_numbers("building of " + label_of(grid, period, i), family_look(i, buildings.size()),
                       ratios);
  }
  const std::string reference = reference_strength_text(grid);
  family.add_level(1.0, reference, look(Role::reference));
  return {"yielding", "Effect of a yielding building on the displacement",
          below_text(results, {response_modification}),
          after_walters(
              results, 15,
              ", over the same on " + reference +
                  ". At R the building yields where the design spectrum requires an elastic force "
                  "R times as large; 0 is elastic"),
          family.ratios("Displacement over that on " + reference)};
}

/// Fig. 17: displacement over slope by period.
Figure slope_figure(const Results& results) {
  const ConditionGrid& grid = results.conditions->grid;
  std::vector<double> x;
  std::vector<std::string> ticks;
  for (const double slope_deg : grid.slope_deg) {
    x.push_back(12.0 * std::tan(slope_deg * rad_per_deg));
    ticks.push_back(slope_name(slope_deg));
  }
  Family family(results, "Roof slope (rise in 12)", x);
  family.name_ticks(ticks);
  Look thick = look(Role::median);
  thick.width = 3.5;
  family.add("largest over the periods", thick, shown_along(grid, slope), {}, Periods::largest);
  constexpr std::size_t most = 3;  // beside the largest
  if (has_several(grid, period)) add_buildings(results, slope, most, family);
  return {"slope", "Displacement over the roof's slope", below_text(results, {slope}),
          after_walters(results, 17) + left_out_text(results, most), family.displacements()};
}

/// Fig. 18: displacement over the period by level.
Figure mce_figure(const Results& results) {
  const ConditionGrid& grid = results.conditions->grid;
  Family family(results, period_label, grid.period_s);
  const Places levels = shown_along(grid, level);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    family.add(label_of(grid, level, i), family_look(i, levels.size()),
               along(grid, period, levels[i]));
  }
  const Condition shown = shown_condition(grid);
  const OrientationRange largest = over_orientations(results, {}, shown, Periods::largest);
  Look rule = family_look(shown[level], levels.size());
  rule.dash = 2;
  family.add_level(largest.highest,
                   fmt::format("largest over periods and orientations at {}: {}",
                               label_of(grid, level, shown), format_length(largest.highest)),
                   rule);
  return {"mce", "Displacement at several levels of shaking", below_text(results, {level}),
          after_walters(results, 18), family.displacements()};
}

/// Displacement over the roof's vertical period by the building's.
Figure vertical_figure(const Results& results) {
  std::vector<double> x;
  std::vector<std::string> ticks;
  for (const VerticalCondition& condition : results.conditions->grid.vertical) {
    x.push_back(static_cast<double>(x.size()));
    ticks.push_back(condition.use == VerticalChoice::none ? "none"
                    : condition.period_s == 0.0           ? "rigid"
                                                : fmt::format("{:g} s", condition.period_s));
  }
  Family family(results, "Vertical motion of the roof", x, Spread::bars);
  family.name_ticks(ticks);
  constexpr std::size_t most = 4;
  add_buildings(results, vertical, most, family);
  return {"vertical", "Effect of the roof's vertical motion on the displacement",
          below_text(results, {vertical}),
          "None: no vertical motion. Rigid: the roof moves vertically with the ground, as Walters "
          "et al. (2012) assume. Else: with its own vertical period, with the study's damping. " +
              what_is_averaged(results) + "." + left_out_text(results, most),
          family.displacements()};
}

}  // namespace

std::vector<Figure> clearance_figures(const Results& results) {
  std::vector<Figure> figures;
  const auto add = [&](ClearanceTopic topic, Figure (*draw)(const Results&)) {
    if (!covers(results, topic)) return;
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
