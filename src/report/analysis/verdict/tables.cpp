// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

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

Estimate largest_of(VerdictKind kind, VerdictProbability VerdictRow::*at) {
  const auto probability = [&](const VerdictRow& row) { return (row.*at).probability; };
  const VerdictProbability& largest = (*std::ranges::max_element(kind, {}, probability)).*at;
  return {largest.probability, largest.interval};
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

const ColumnOf mu_column{
    Column{"mu", "", "Friction", ColumnKind::number,
           "coefficient of friction as stated: of what is drawn the mean of its distribution"},
    &VerdictRow::mu};
const ColumnOf conditions_column{
    text_column("conditions", "Conditions",
                "whether slope and friction meet the conditions of the standard"),
    [](const VerdictRow& row) { return row.within_conditions ? "within" : "outside"; }};

/// Which row of the verdict.
void put_row(auto& t, const Results& results) {
  t.put_all(condition_column, mu_column, slope_column, standard_column, conditions_column,
            sds_column);
  t.number("response_modification", "R", "R of the building; 0: it stays elastic",
           [&](const VerdictRow& row) { return response_modification(results, row); })
      .detail = true;
}

enum class Earthquake { dbe, mce };

/// The probability that more is needed in it.
void put_probability(auto& t, Earthquake at, const std::string& heading, auto value) {
  const bool is_dbe = at == Earthquake::dbe;
  t.share(is_dbe ? "dbe_probability" : "mce_probability",
          heading + (is_dbe ? " at DBE" : " at MCE"),
          std::string("probability that more is needed at ") + (is_dbe ? "S_DS" : "1.5 S_DS") +
              ", in the building whose period makes it largest",
          value);
}

/// Both, each with the period.
template <class Of>
void put_exceeded(auto& t) {
  for (const auto& [earthquake, at, stem] : {std::tuple{Earthquake::dbe, &Of::dbe, "dbe_period"},
                                             {Earthquake::mce, &Of::mce, "mce_period"}}) {
    put_probability(t, earthquake, "Exceeded", [at = at](const Of& of) {
      return Estimate{(of.*at).probability, (of.*at).interval};
    });
    t.number(
        stem, "Period", "building period that makes the probability largest",
        [at = at](const Of& of) { return (of.*at).period_s; }, "s");
  }
}

}  // namespace

Table verdict_table(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  using R = VerdictRow;
  TableOf<R> t("verdict",
               "Prescribed displacements, in the building whose period makes each number largest");
  put_row(t, results);
  t.put_all(prescribed_column, provision_column);
  put_exceeded<R>(t);
  for (std::size_t i = 0; i < verdict.exceedance.size(); ++i) {
    const double p = verdict.exceedance[i];
    t.put({fmt::format("displacement_{:g}_percent", 100.0 * p), "m",
           percent(p) + " exceed, m (in) [95 %]", ColumnKind::length,
           "displacement that is exceeded at S_DS with " + percent(p), true},
          [=](const R& row) -> Cell {
            return Estimate{row.displacement_m[i], row.displacement_interval[i]};
          });
  }
  t.number("ratio", percent(verdict.exceedance.front()) + " over prescribed",
           "displacement exceeded with the accepted probability over prescribed", [](const R& row) {
             const double prescribed_m = row.prescribed.value_m;
             const auto [low_m, high_m] = row.displacement_interval.front();
             return Estimate{row.displacement_m.front() / prescribed_m,
                             {low_m / prescribed_m, high_m / prescribed_m}};
           });
  t.text("judgement", "Judgement", "judgement at S_DS",
         [&](const R& row) { return judgement_text(judgement(verdict, row)); });
  t.text("certain", "Interval on one side of " + percent(verdict.exceedance.front()),
         "whether the interval lies on one side of the accepted probability",
         [&](const R& row) { return is_certain(verdict, row); });
  t.add_each(verdict.rows);
  t.notes = {"Intervals are over " + units_name(results) +
             ", in the building that makes the number largest: the choice of "
             "the building, friction tests and model are outside them."};
  return t;
}

Table verdict_summary_table(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  TableOf<VerdictRow, VerdictKind> t("verdict_summary",
                                     "The prescribed displacement at the S_DS of the study");
  t.put_all(slope_column, mu_column, standard_column);
  t.put(provision_column, provision_text);
  t.put_all(conditions_column);
  for (const auto& [stem, heading, wanted] :
       {std::tuple{"exceeded", "Exceeded", Judgement::exceeded},
        {"conservative", "Conservative", Judgement::conservative}})
    t.text(
        stem, heading + std::string(" at S_DS, g"),
        "ranges of S_DS (g) at which the judgement is " + std::string(stem),
        [&, wanted = wanted](const VerdictKind& kind) { return ranges_of(verdict, kind, wanted); });
  put_probability(t, Earthquake::dbe, "Largest",
                  [](const VerdictKind& kind) { return largest_of(kind, &VerdictRow::dbe); });
  put_probability(t, Earthquake::mce, "Largest",
                  [](const VerdictKind& kind) { return largest_of(kind, &VerdictRow::mce); });
  t.put_all(condition_column);
  for (const VerdictKind& kind : verdict_kinds(verdict)) t.add(kind.front(), kind);
  t.notes = {fmt::format(
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
  return lists_more ? t : t.without("condition");
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
  using S = VerdictSeparation;
  TableOf<VerdictRow, S> t("verdict_separations",
                           "Probability that more than a separation is needed");
  put_row(t, results);
  t.text("separation", "Separation", "what the separation is between", &S::what);
  t.number("factor", "x prescribed", "factor on the prescribed displacement", &S::factor);
  t.length("value", "Separation", "separation", &S::value_m);
  put_exceeded<S>(t);
  for (const S& s : verdict.separations) t.add(verdict.rows[s.row], s);
  return t;
}

Table verdict_separations_summary_table(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  TableOf<VerdictRow, VerdictKind> t(
      "verdict_separations_summary",
      "The separations: largest probability at DBE that more is needed");
  t.put_all(slope_column, mu_column, standard_column, conditions_column);
  std::set<double> factors;
  for (const VerdictSeparation& s : verdict.separations) factors.insert(s.factor);
  for (const double factor : factors)
    t.share(fmt::format("dbe_probability_{:g}", factor), fmt::format("{:g} x prescribed", factor),
            fmt::format("largest probability at S_DS that more than {:g} times the prescribed "
                        "displacement is needed",
                        factor),
            [&, factor](const VerdictKind& kind) {
              const VerdictSeparation* most = governing_of(all_of(verdict, kind), factor);
              return most ? Estimate{most->dbe.probability, most->dbe.interval}
                          : Estimate{std::nan(""), {}};
            });
  for (const VerdictKind& kind : verdict_kinds(verdict)) t.add(kind.front(), kind);
  t.notes = {fmt::format(
      "0.5: between similar arrays {}, each with a friction of its own, the larger of the gaps "
      "along and across the slope. 1: to a fixed object or an edge with a parapet. 2: to an edge "
      "without. Two arrays move under the same motion, each as if it were alone on the building.",
      neighbours_text(results))};
  return t;
}

}  // namespace glissade
