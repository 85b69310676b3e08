// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include "analysis/in_files.hpp"

namespace glissade {
namespace {

template <class Column, class Row>
void exchange_probability(const Column& column, const std::string& at, const char* what,
                          VerdictProbability Row::*of) {
  column(at + "_probability", {"-", what}, member(of, &VerdictProbability::probability));
  column(at + "_probability", {"-", "95 % interval of that"},
         member(of, &VerdictProbability::interval));
  column(at + "_period_s", {"s", "building period where it is largest"},
         member(of, &VerdictProbability::period_s));
}

template <class Archive, class Rows>
void exchange_separations(const Archive& archive, Rows& separations) {
  const Columns column(archive, separations, "row");
  column("row", {"-", "position of the prescribed displacement in `verdict`"},
         &VerdictSeparation::row);
  column("what", {"-", "between what"}, &VerdictSeparation::what);
  column("factor", {"-", "on the prescribed displacement"}, &VerdictSeparation::factor);
  column("value_m", {"m", "the separation"}, &VerdictSeparation::value_m);
  exchange_probability(column, "dbe", "that more is needed at S_DS", &VerdictSeparation::dbe);
  exchange_probability(column, "mce", "the same at 1.5 S_DS", &VerdictSeparation::mce);
}

void read_verdict(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("verdict");
  constexpr NumberRule share_rule{"above 0 and below 1",
                                  [](double x) { return x > 0.0 && x < 1.0; }};
  std::vector<double>& exceedance = study.verdict.emplace().exceedance;
  exceedance = table.numbers("exceedance", share_rule).value_or(exceedance);
  if (exceedance.empty() || !std::ranges::is_sorted(exceedance, std::greater_equal<>()))
    table.report("exceedance", "verdict.exceedance is not a falling list of probabilities",
                 "for example exceedance = [0.1, 0.05, 0.01]");
}

bool draws_neither_slope_nor_period(const TomlTable&, const StudyConfig& study) {
  return !study.quantities.at("roof", "slope_deg").is_drawn() &&
         !study.quantities.at("building", "period_s").is_drawn();
}

bool has_level_of_mce(const TomlTable&, const StudyConfig& study) {
  const std::vector<double>& levels = study.intensity.levels;
  return std::ranges::any_of(
      levels, [&](double l) { return level_at(levels, mce_over_dbe * l) < levels.size(); });
}

void check_verdict(const VerdictResults& verdict, const Results& results) {
  expect_fit(!verdict.exceedance.empty(), "exceedance", "verdict");
  for (const VerdictRow& row : verdict.rows) {
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
    expect_fit(row.displacement_m.size() == verdict.exceedance.size() &&
                   row.displacement_interval.size() == verdict.exceedance.size(),
               "displacement_m", "exceedance");
  }
  for (const VerdictSeparation& separation : verdict.separations)
    expect_fit(separation.row < verdict.rows.size(), "row", "verdict");
}

}  // namespace

AnalysisInFiles VerdictAnalysis::in_files() {
  return {
      .table = "verdict",
      .read = read_verdict,
      .keys = {{"exceedance", "list", "[0.1, 0.05, 0.01]",
                "probabilities of exceedance, falling: prescribed displacements are compared with "
                "the first, which is accepted at S_DS; the displacement of each is found"}},
      .needs =
          {{"[standards]",
            [](const TomlTable& root, const StudyConfig&) { return root.has("standards"); }},
           {"a slope and a building period that are numbers or lists, not drawn (the conditions of "
            "the standards are on the slope, and the least favourable period counts)",
            draws_neither_slope_nor_period},
           {"intensity.levels with 1.5 times one of them (the MCE of a design earthquake)",
            has_level_of_mce}},
      .uses = {"model.displacement", "friction.neighbour_mu", "friction.neighbour_over_mu",
               "standards.compare"},
      .stands_alone = true,
      .needs_every_history = true,
      .of_any_run = true,
      .sampled_friction = FrictionUse::read,
      .design_friction = FrictionUse::read,
      .exchange = Exchange::in_group<&Results::verdict>([](const auto& archive, const auto&,
                                                           auto& verdict) {
        list(
            archive, "exceedance",
            {"-", "probabilities of exceedance, the first accepted at the design earthquake (DBE)"},
            verdict.exceedance);
        exchange_prescriptions(archive, verdict.rows);
        const Columns column(archive, verdict.rows);
        column("first_case", {"-", "position in `cases` of the first building period's first"},
               &VerdictRow::first_case);
        column("condition", {"-", "what the study lists of it but the building period"},
               &VerdictRow::condition);
        column("mu", {"-", "coefficient of friction, mean over the samples"}, &VerdictRow::mu);
        column("slope_deg", {"deg", "slope of the roof, mean over the samples"},
               &VerdictRow::slope_deg);
        column("within_conditions", {"-", "1: slope and friction meet the standard's conditions"},
               &VerdictRow::within_conditions);
        exchange_probability(column, "dbe", "that the prescribed displacement is exceeded at S_DS",
                             &VerdictRow::dbe);
        exchange_probability(column, "mce", "the same at 1.5 S_DS", &VerdictRow::mce);
        column("displacement_m",
               {"m", "exceeded at S_DS with each probability, by (row, probability)"},
               &VerdictRow::displacement_m);
        column("displacement_m", {"m", "95 % intervals of these"},
               &VerdictRow::displacement_interval);
        exchange_separations(archive.group("separations"), verdict.separations);
      }),
      .check = if_found<&Results::verdict, check_verdict>};
}

}  // namespace glissade
