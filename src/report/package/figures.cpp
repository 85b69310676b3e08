// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/suite/spectra_figure.hpp"
#include "glissade/design/of_project.hpp"
#include "glissade/fragility/share.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/report/figures.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// The displacements alone give the height where the governing one is far above them.
Figure demand_figure(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  struct Line {
    double PeriodDemand::*value;
    Role role;
    const char* label;
  };
  const PeriodDemand &first = design.demand.front(), &last = design.demand.back();
  const Side side = first.largest_m >= last.largest_m ? Side::left : Side::right;
  const PeriodDemand& labelled = side == Side::left ? first : last;
  Panel panel{"", {"Building period (s)", first.period_s, last.period_s}, {}};
  std::vector<Note> labels;
  double top_m = 0.0;
  for (const Line& line : {Line{&PeriodDemand::largest_m, Role::largest, "largest record"},
                           Line{&PeriodDemand::p95_m, Role::p95, "95th percentile"},
                           Line{&PeriodDemand::mean_m, Role::median, "mean"}}) {
    DataSeries series{DataSeries::Kind::line_and_points, look(line.role), line.label};
    for (const PeriodDemand& d : design.demand) {
      series.add(d.period_s, d.*line.value);
      top_m = std::max(top_m, d.*line.value);
    }
    labels.push_back({0.0, labelled.*line.value, line.label, look(line.role).colour});
    panel.series.push_back(std::move(series));
  }
  const bool is_above = top_m > 0.0 && design.governing_m > 2.0 * top_m;
  if (!is_above) {
    Look governing = look(Role::clearance);
    governing.width = 3.0;
    panel.rules.push_back(
        {Rule::Kind::horizontal, design.governing_m, governing, "", first.period_s, last.period_s});
    labels.push_back(
        {0.0, design.governing_m, "governing: " + length_in(design.governing_m), governing.colour});
    top_m = std::max(top_m, design.governing_m);
  }
  panel.y = length_axis("Displacement in plan", 1.2 * top_m);
  add_side_labels(panel, std::move(labels), {side, 0.34, 0.11});
  return {"demand",
          "Displacement at DBE over the building's period",
          fmt::format("friction {:.3g}; largest over slope, {}, with and without vertical motion; "
                      "{}{}",
                      package.project.friction.design(), varied_of_building(package.project),
                      counted_records(package.demand),
                      is_above ? "; governing displacement above the figure: " +
                                     length_in_both(design.governing_m)
                               : ""),
          "Largest: of any orientation. Mean and 95th percentile: all records have the orientation "
          "that governs at the period.",
          {panel}};
}

/// To the periods that the suite is scaled for, with those of the building.
Figure site_spectra_figure(const CalculationPackage& package) {
  const SuiteSummary& suite = package.demand.suites.front();
  const std::vector<double>& periods_s = package.project.building.period_s;
  Figure figure = spectra_figure(
      suite.spectra, {suite.name, "scaled to DBE", "target (design spectrum)",
                      std::max(longest_scaled_period_s, judged_to_s(periods_s.back()))});
  for (const double period_s : {periods_s.front(), periods_s.back()})
    figure.panels.front().rules.push_back({Rule::Kind::vertical, period_s, look(Role::reference)});
  figure.panels.front().rules.front().label =
      periods_s.front() == periods_s.back() ? "building period" : "building periods: from, to";
  return figure;
}

/// Of the governing displacement, at the building period where it is exceeded most at DBE, or at
/// MCE where none exceeds it at DBE: the observed shares, as in the table.
Figure exceedance_figure(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  const Results& results = package.probability;
  const DisplacementExceedance& governing = design.compared.front();
  const bool at_dbe = governing.dbe.probability > 0.0, of_roof = package.project.of_roof;
  const double period_s = at_dbe ? governing.dbe.period_s : governing.mce.period_s;
  const RunResults& run =
      found_in(results.runs, period_s, "the period that governs",
               [&](const RunResults& r) { return results.cases.cases[r.first_case].period_s; });
  const ThresholdFragility& exceeded =
      found_in(run.fragilities, design.governing_m, "the displacement that is compared",
               &ThresholdFragility::threshold_m);
  DataSeries shares{DataSeries::Kind::line_and_points, look(Role::median), "share"},
      intervals{DataSeries::Kind::bars, look(Role::median), "interval"};
  const double dbe = dbe_level(package.project);
  for (std::size_t i = 0; i < results.levels.size(); ++i) {
    const double level = results.levels[i] / dbe, share = exceeded.probability[i];
    shares.add(level, share);
    intervals.add(level,
                  widened(exceeded.probability_interval[i], share, effective_units(results)));
  }
  Panel panel{"",
              {"Shaking, in parts of that of the DBE", 0.0, results.levels.back() / dbe},
              share_axis("Probability"),
              {intervals, shares}};
  for (const auto& [name, intensity] : {std::pair{"DBE", 1.0}, std::pair{"MCE", mce_over_dbe}}) {
    panel.rules.push_back({Rule::Kind::vertical, intensity, look(Role::reference)});
    panel.notes.push_back(
        {intensity - 0.03, 0.93, name, look(Role::reference).colour, Note::Align::right});
  }
  const ProjectFriction& mu = package.project.friction;
  return {
      "exceedance",
      fmt::format("Probability that the displacement exceeds the governing one, {}",
                  length_in(design.governing_m)),
      fmt::format("{}{}; friction {:.3g}, std {:.2g}",
                  of_roof ? "" : fmt::format("building period {:.3g} s; ", period_s),
                  counts_of(results), mu.mean, mu.std),
      fmt::format("{}Points: share of the histories that exceed it at a level, as in the "
                  "tables; bars: its 95 % interval. {}",
                  of_roof ? ""
                          : fmt::format("The building period is that of the largest "
                                        "probability at {}. ",
                                        at_dbe ? "DBE" : "MCE"),
                  of_roof ? fmt::format("DBE is a factor of {:g} on the motions of the roof.", dbe)
                          : fmt::format("DBE is S_DS = {:.3f} g.", dbe)),
      {panel}};
}

}  // namespace

std::vector<Figure> package_figures(const CalculationPackage& package) {
  std::vector<Figure> figures;
  if (!package.project.of_roof) figures.push_back(site_spectra_figure(package));
  if (package.design.demand.size() > 1) figures.push_back(demand_figure(package));
  figures.push_back(exceedance_figure(package));
  for (Figure& figure : figures) figure.plot_height_px = 520;
  return figures;
}

}  // namespace glissade
