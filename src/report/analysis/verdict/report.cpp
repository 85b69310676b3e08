// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "analysis/analyses.hpp"
#include "analysis/verdict/kinds.hpp"
#include "glissade/report/format.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string text_of(const VerdictProbability& of) {
  return share_with_interval({of.probability, of.interval});
}

struct Tally {
  std::size_t rows = 0, exceeded = 0, certainly = 0, conservative = 0;
  const VerdictRow* governing = nullptr;
};

template <class Counts>
Tally tally(const VerdictResults& verdict, Counts counts) {
  Tally t;
  for (const VerdictRow& row : verdict.rows) {
    if (!counts(row)) continue;
    ++t.rows;
    const Judgement found = judgement(verdict, row);
    t.conservative += found == Judgement::conservative ? 1 : 0;
    if (t.governing == nullptr || row.dbe.probability > t.governing->dbe.probability)
      t.governing = &row;
    if (found != Judgement::exceeded) continue;
    ++t.exceeded;
    t.certainly += is_certain(verdict, row) ? 1 : 0;
  }
  return t;
}

/// ", at S_DS = 1 g with ..."; empty for a probability of zero, which is largest everywhere.
std::string place_of(const VerdictRow& row, const VerdictProbability& dbe) {
  if (dbe.probability == 0.0) return "";
  return fmt::format(", at S_DS = {:.3g} g with {}", row.sds_g, kind_text(row));
}

std::string sentence(const VerdictResults& verdict, Standard standard, const std::string& where,
                     const Tally& t) {
  return fmt::format(
      "{}, {}: of {} prescribed displacements {} are exceeded with more than {:g} % probability "
      "at DBE ({} with the whole 95 % interval above that), and {} are, by estimate, more than "
      "twice the displacement that {:g} % of the histories exceed. The largest probability is "
      "{}{}.",
      standard_name(standard), where, t.rows, t.exceeded, 100.0 * verdict.exceedance.front(),
      t.certainly, t.conservative, 100.0 * verdict.exceedance.back(), text_of(t.governing->dbe),
      place_of(*t.governing, t.governing->dbe));
}

/// Of a separation, the rows in which it is too small with more than the accepted probability.
struct Shortfall {
  std::size_t rows = 0, exceeded = 0;
  const VerdictSeparation* governing = nullptr;

  std::string words(const VerdictResults& verdict) const {
    const VerdictRow& row = verdict.rows[governing->row];
    return fmt::format("{} of {} (largest probability {}{}; {})", exceeded, rows,
                       text_of(governing->dbe), place_of(row, governing->dbe), governing->what);
  }
};

template <class Counts>
Shortfall shortfall(const VerdictResults& verdict, double factor, Counts counts) {
  Shortfall found;
  for (std::size_t i = 0; i < verdict.rows.size(); ++i) {
    const VerdictSeparation* governing = governing_of(separations_of(verdict, i), factor);
    if (governing == nullptr || !counts(verdict.rows[i])) continue;
    ++found.rows;
    found.exceeded += governing->dbe.probability > verdict.exceedance.front() ? 1 : 0;
    if (found.governing == nullptr || governing->dbe.probability > found.governing->dbe.probability)
      found.governing = governing;
  }
  return found;
}

/// Of the separations that are not the prescribed displacement itself.
template <class Counts>
std::string separations_sentence(const Results& results, Standard standard,
                                 const std::string& where, Counts counts) {
  const VerdictResults& verdict = *results.verdict;
  const Shortfall edge = shortfall(verdict, 2.0, counts), arrays = shortfall(verdict, 0.5, counts);
  if (edge.rows == 0) return "";
  const std::string accepted = fmt::format("{:g} %", 100.0 * verdict.exceedance.front());
  std::string text = fmt::format("{}, {}: ", standard_name(standard), where);
  if (arrays.rows > 0)
    text += fmt::format(
        "two similar arrays {}, each with a friction of its own, close a gap of half the "
        "prescribed displacement with more than {} probability at DBE in {}; ",
        neighbours_text(results), accepted, arrays.words(verdict));
  return text + fmt::format(
                    "twice the prescribed displacement is exceeded with more than {} probability "
                    "at DBE in {}.",
                    accepted, edge.words(verdict));
}

/// On which buildings the arrays stand: a verdict holds for these.
std::string buildings_sentence(const Results& results) {
  const bool yields =
      std::ranges::any_of(results.cases.cases, [](const Case& c) { return c.yields(); });
  return fmt::format(
      "Buildings: one mass on one spring along each axis, period {} s (the governing "
      "one counts), damping {} %, mass of the array {} % of theirs; {}",
      range_of(results.cases.cases, &Case::period_s),
      range_of(results.cases.cases, &Case::damping, 100.0),
      range_of(results.cases.cases, &Case::mass_ratio, 100.0),
      yields ? "those with R yield at the design spectrum over R, without overstrength."
             : "they stay elastic. On a building that yields the array slides less "
               "(building.response_modification): there these probabilities are too large.");
}

/// Of buildings with one R, in short.
std::string sentence_of(const Results& results, double r, bool within) {
  const VerdictResults& verdict = *results.verdict;
  std::string text;
  for (const Standard standard : {Standard::seaoc_pv1_2012, Standard::asce7_16}) {
    const Tally t = tally(verdict, [&](const VerdictRow& row) {
      return row.standard == standard && row.within_conditions == within &&
             response_modification(results, row) == r;
    });
    if (t.rows == 0) continue;
    text += fmt::format(
        "{} {}: {} of {} exceeded (largest probability {}), {} by estimate conservative",
        text.empty() ? "" : ";", standard_name(standard), t.exceeded, t.rows,
        text_of(t.governing->dbe), t.conservative);
  }
  return text.empty() ? ""
                      : fmt::format("Buildings with R = {:g}, {} the conditions.{}.", r,
                                    within ? "within" : "outside", text);
}

std::vector<std::string> sentences(const Results& results) {
  const VerdictResults& verdict = *results.verdict;
  std::vector<double> strengths;
  for (const VerdictRow& row : verdict.rows) {
    const double r = response_modification(results, row);
    if (std::ranges::find(strengths, r) == strengths.end()) strengths.push_back(r);
  }
  std::vector<std::string> texts = {buildings_sentence(results)};
  for (const Standard standard : {Standard::seaoc_pv1_2012, Standard::asce7_16}) {
    for (const bool within : {true, false}) {
      const auto counts = [&](const VerdictRow& row) {
        return row.standard == standard && row.within_conditions == within &&
               response_modification(results, row) == strengths.front();
      };
      const Tally t = tally(verdict, counts);
      if (t.rows == 0) continue;
      std::string where = within ? "within its conditions of slope and friction"
                                 : "outside its conditions of slope and friction";
      if (strengths.size() > 1)
        where += strengths.front() == 0.0 ? ", elastic buildings"
                                          : fmt::format(", R = {:g}", strengths.front());
      texts.push_back(sentence(verdict, standard, where, t));
      texts.push_back(separations_sentence(results, standard, where, counts));
    }
  }
  for (std::size_t i = 1; i < strengths.size(); ++i) {
    for (const bool within : {true, false})
      texts.push_back(sentence_of(results, strengths[i], within));
  }
  std::erase(texts, "");
  return texts;
}

std::string summary(const Results& results) {
  return paragraphs(sentences(results)) + "\n" +
         to_text(verdict_summary_table(results).without("mce_probability"));
}

std::vector<Figure> figures(const Results& results) {
  std::vector<Figure> all = {verdict_figure(results)};
  if (governing_of(results.verdict->separations, 0.5) != nullptr)
    all.push_back(verdict_separations_figure(results));
  return all;
}

Html section(const Results& results) {
  return heading("Prescribed displacements: exceeded, sufficient or conservative") +
         wide_table(verdict_summary_table(results)) +
         wide_table(verdict_separations_summary_table(results)) +
         paragraph(
             "Probabilities are over records, samples and orientations, in the building whose "
             "period makes each largest. An interval is never narrower than that of a binomial "
             "with one trial for each of the " +
             units_name(results) +
             ". That of a displacement that 10 % of the histories exceed has an upper end with 36 "
             "of them or more, that of 1 % with 368 or more.");
}

}  // namespace

AnalysisReport VerdictAnalysis::in_report() {
  return {
      .is_in =
          [](const Results& results) { return results.verdict && !results.verdict->rows.empty(); },
      .summary = summary,
      .sentences = sentences,
      .figures = figures,
      .tables = each<verdict_summary_table, verdict_table, verdict_separations_summary_table,
                     verdict_separations_table>,
      .section = section};
}

}  // namespace glissade
