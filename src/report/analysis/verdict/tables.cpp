// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/verdict/kinds.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string judgement_text(Judgement judgement) {
  if (judgement == Judgement::exceeded) return "exceeded";
  return judgement == Judgement::sufficient ? "sufficient" : "conservative";
}

/// "0.8 to 1.5": the S_DS at which the judgement is one, as ranges of neighbouring levels.
std::string ranges_of(const VerdictResults& verdict, VerdictKind kind, Judgement wanted) {
  std::string text;
  for (std::size_t i = 0; i < kind.size(); ++i) {
    if (judgement(verdict, kind[i]) != wanted) continue;
    const std::size_t first = i;
    while (i + 1 < kind.size() && judgement(verdict, kind[i + 1]) == wanted) ++i;
    text += fmt::format("{}{:g}", text.empty() ? "" : ", ", kind[first].sds_g);
    if (i > first) text += fmt::format(" to {:g}", kind[i].sds_g);
  }
  return text.empty() ? "-" : text;
}

VerdictProbability largest_of(VerdictKind kind, VerdictProbability VerdictRow::*at) {
  return (*std::ranges::max_element(kind, {},
                                    [&](const VerdictRow& row) { return (row.*at).probability; })).*
         at;
}

const char* conditions_text(const VerdictRow& row) {
  return row.within_conditions ? "within" : "outside";
}

/// Where the prescribed displacements come from.
std::string provision_text(VerdictKind kind) {
  const auto recalled = std::ranges::count_if(kind, [](const VerdictRow& row) {
    return row.prescribed.provenance == Provenance::recalled;
  });
  if (recalled == 0) return "checked";
  return recalled == std::ssize(kind) ? "recalled" : "partly recalled";
}

std::string percent(double probability) { return fmt::format("{:g} %", 100.0 * probability); }

}  // namespace

std::vector<VerdictKind> verdict_kinds(const VerdictResults& verdict) {
  return groups_of(verdict.rows, [](const VerdictRow& a, const VerdictRow& b) {
    return a.first_case == b.first_case && a.standard == b.standard;
  });
}

std::span<const VerdictSeparation> separations_of(const VerdictResults& verdict, std::size_t row) {
  return std::ranges::equal_range(verdict.separations, row, {}, &VerdictSeparation::row);
}

const VerdictSeparation* governing_of(std::span<const VerdictSeparation> separations,
                                      double factor) {
  const VerdictSeparation* governing = nullptr;
  for (const VerdictSeparation& s : separations) {
    if (s.factor == factor &&
        (governing == nullptr || s.dbe.probability > governing->dbe.probability))
      governing = &s;
  }
  return governing;
}

std::string kind_text(const VerdictRow& row) {
  return fmt::format("friction {:.3g}, slope {:.3g} degrees", row.mu, row.slope_deg);
}

std::string neighbours_text(const Results& results) {
  return results.cases.cases.front().neighbour_slope == NeighbourSlope::same
             ? "on one slope"
             : "on two slopes that fall towards each other";
}

double response_modification(const Results& results, const VerdictRow& row) {
  return results.cases.cases[row.first_case].response_modification;
}

namespace {

const Column mu_column = {"mu", "", "Friction", ColumnKind::number,
                          "coefficient of friction as stated: of what is drawn the mean of its "
                          "distribution"},
             conditions_column =
                 text_column("conditions", "Conditions",
                             "whether slope and friction meet the conditions of the standard");

enum class Earthquake { dbe, mce };

/// The probability that more is needed in it.
Column exceeded_column(Earthquake at, const std::string& heading) {
  const bool is_dbe = at == Earthquake::dbe;
  return {is_dbe ? "dbe_probability" : "mce_probability",
          "",
          heading + (is_dbe ? " at DBE [95 %]" : " at MCE [95 %]"),
          ColumnKind::share,
          std::string("probability that more is needed at ") + (is_dbe ? "S_DS" : "1.5 S_DS") +
              ", in the building whose period makes it largest",
          true};
}

Column period_column(const char* stem) {
  return {stem, "s", "Period, s", ColumnKind::number,
          "building period that makes the probability largest"};
}

/// Which row of the verdict: the first columns of its tables, and their cells.
std::vector<Column> row_columns(std::initializer_list<Column> others) {
  std::vector<Column> columns{condition_column,
                              mu_column,
                              slope_column,
                              standard_column,
                              conditions_column,
                              sds_column,
                              detail({"response_modification", "", "R", ColumnKind::number,
                                      "R of the building; 0: it stays elastic"})};
  columns.insert(columns.end(), others);
  return columns;
}

std::vector<Cell> row_cells(const Results& results, const VerdictRow& row,
                            std::initializer_list<Cell> others) {
  std::vector<Cell> cells{row.condition,
                          row.mu,
                          row.slope_deg,
                          standard_name(row.standard),
                          std::string(conditions_text(row)),
                          row.sds_g,
                          response_modification(results, row)};
  cells.insert(cells.end(), others);
  return cells;
}

Estimate estimate(const VerdictProbability& of) { return {of.probability, of.interval}; }

}  // namespace

Table verdict_table(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  Table table{
      "verdict",
      "Prescribed displacements, in the building whose period makes each number largest",
      row_columns({prescribed_column, provision_column,
                   exceeded_column(Earthquake::dbe, "Exceeded"), period_column("dbe_period"),
                   exceeded_column(Earthquake::mce, "Exceeded"), period_column("mce_period")}),
      {}};
  for (const double p : verdict.exceedance)
    table.columns.push_back({fmt::format("displacement_{:g}_percent", 100.0 * p), "m",
                             percent(p) + " exceed, m (in) [95 %]", ColumnKind::length,
                             "displacement that is exceeded at S_DS with " + percent(p), true});
  table.columns.push_back(
      {"ratio", "", percent(verdict.exceedance.front()) + " over prescribed [95 %]",
       ColumnKind::number, "displacement exceeded with the accepted probability over prescribed",
       true});
  table.columns.push_back(text_column("judgement", "Judgement", "judgement at S_DS"));
  table.columns.push_back(
      text_column("certain", "Interval on one side of " + percent(verdict.exceedance.front()),
                  "whether the interval lies on one side of the accepted probability"));
  for (const VerdictRow& row : verdict.rows) {
    std::vector<Cell> cells =
        row_cells(results, row,
                  {row.prescribed.value_m, std::string(provision_text({&row, 1})),
                   estimate(row.dbe), row.dbe.period_s, estimate(row.mce), row.mce.period_s});
    for (std::size_t i = 0; i < row.displacement_m.size(); ++i)
      cells.emplace_back(Estimate{row.displacement_m[i], row.displacement_interval[i]});
    const double prescribed_m = row.prescribed.value_m;
    const auto [low_m, high_m] = row.displacement_interval.front();
    cells.emplace_back(Estimate{row.displacement_m.front() / prescribed_m,
                                {low_m / prescribed_m, high_m / prescribed_m}});
    cells.emplace_back(judgement_text(judgement(verdict, row)));
    cells.emplace_back(std::string(is_certain(verdict, row) ? "yes" : "no"));
    table.add(std::move(cells));
  }
  return table;
}

Table verdict_summary_table(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  Table table{"verdict_summary",
              "The prescribed displacement at the S_DS of the study",
              {slope_column, mu_column, standard_column, provision_column, conditions_column,
               text_column("exceeded", "Exceeded at S_DS, g",
                           "ranges of S_DS (g) at which the judgement is exceeded"),
               text_column("conservative", "Conservative at S_DS, g",
                           "ranges of S_DS (g) at which the judgement is conservative"),
               exceeded_column(Earthquake::dbe, "Largest"),
               exceeded_column(Earthquake::mce, "Largest"), condition_column},
              {}};
  for (const VerdictKind kind : verdict_kinds(verdict)) {
    const VerdictProbability dbe = largest_of(kind, &VerdictRow::dbe),
                             mce = largest_of(kind, &VerdictRow::mce);
    table.add({kind.front().slope_deg, kind.front().mu, standard_name(kind.front().standard),
               provision_text(kind), std::string(conditions_text(kind.front())),
               ranges_of(verdict, kind, Judgement::exceeded),
               ranges_of(verdict, kind, Judgement::conservative), estimate(dbe), estimate(mce),
               kind.front().condition});
  }
  table.notes = {fmt::format(
      "Exceeded: with more than {} probability at DBE. Conservative: more than twice the "
      "displacement that {} of the histories exceed at DBE. Conditions: slope and friction of the "
      "standard. Provision: reproduced from a source (checked), or from memory of the standard "
      "(recalled: verify it); least values are recalled. ASCE 7-22 is not judged apart: its "
      "13.6.12 has the equation of ASCE 7-16 (recalled), with an S_DS of its own.",
      percent(verdict.exceedance.front()), percent(verdict.exceedance.back()))};
  const bool lists_more = std::ranges::any_of(results.cases.axes, [](const CaseAxis& axis) {
    return axis.key != "friction.mu" && axis.key != "roof.slope_deg" &&
           axis.key != "building.period_s";
  });
  return lists_more ? table : table.without("condition");
}

namespace {

/// Those of all rows of a kind.
std::span<const VerdictSeparation> all_of(const VerdictResults& verdict, VerdictKind kind) {
  const auto first = static_cast<std::size_t>(kind.data() - verdict.rows.data());
  const auto begin = separations_of(verdict, first),
             end = separations_of(verdict, first + kind.size() - 1);
  return {begin.data(), end.data() + end.size()};
}

}  // namespace

Table verdict_separations_table(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  Table table{
      "verdict_separations",
      "Probability that more than a separation is needed",
      row_columns({text_column("separation", "Separation", "what the separation is between"),
                   {"factor", "", "x prescribed", ColumnKind::number,
                    "factor on the prescribed displacement"},
                   {"value", "m", "Separation, m (in)", ColumnKind::length, "separation"},
                   exceeded_column(Earthquake::dbe, "Exceeded"),
                   period_column("dbe_period"),
                   exceeded_column(Earthquake::mce, "Exceeded"),
                   period_column("mce_period")}),
      {}};
  for (const VerdictSeparation& s : verdict.separations) {
    const VerdictRow& row = verdict.rows[s.row];
    table.add(row_cells(results, row,
                        {s.what, s.factor, s.value_m, estimate(s.dbe), s.dbe.period_s,
                         estimate(s.mce), s.mce.period_s}));
  }
  return table;
}

Table verdict_separations_summary_table(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  Table table{"verdict_separations_summary",
              "The separations: largest probability at DBE that more is needed",
              {slope_column, mu_column, standard_column, conditions_column},
              {}};
  std::vector<double> factors;
  for (const VerdictSeparation& s : verdict.separations) {
    if (std::ranges::find(factors, s.factor) == factors.end()) factors.push_back(s.factor);
  }
  std::ranges::sort(factors);
  for (const double factor : factors)
    table.columns.push_back({fmt::format("dbe_probability_{:g}", factor), "",
                             fmt::format("{:g} x prescribed [95 %]", factor), ColumnKind::share,
                             fmt::format("largest probability at S_DS that more than {:g} times "
                                         "the prescribed displacement is needed",
                                         factor),
                             true});
  for (const VerdictKind kind : verdict_kinds(verdict)) {
    std::vector<Cell> cells{kind.front().slope_deg, kind.front().mu,
                            standard_name(kind.front().standard),
                            std::string(conditions_text(kind.front()))};
    for (const double factor : factors) {
      const VerdictSeparation* governing = governing_of(all_of(verdict, kind), factor);
      cells.emplace_back(governing != nullptr ? estimate(governing->dbe)
                                              : Estimate{std::nan(""), {}});
    }
    table.add(std::move(cells));
  }
  table.notes = {fmt::format(
      "0.5: between similar arrays {}, each with a friction of its own, the larger of the gaps "
      "along and across the slope. 1: to a fixed object or an edge with a parapet. 2: to an edge "
      "without. Two arrays move under the same motion, each as if it were alone on the building.",
      neighbours_text(results))};
  return table;
}

}  // namespace glissade
