// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/analyses.hpp"
#include "analysis/model_uncertainty/model_uncertainty.hpp"
#include "glissade/report/format.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {

Table model_uncertainty_table(const std::vector<ModelUncertainty>& all, const std::string& title,
                              const std::vector<NumberAtEnds>& numbers) {
  using P = PremiseEffect;
  TableOf<ModelUncertainty, P> t("model_uncertainty", title);
  t.put_all(threshold_column);
  t.text("premise", "Premise", "what is varied, all else as calculated; or the records",
         [](const P& of) { return of.name(); });
  t.text("ends", "Ends", "what low and high are", &P::ends);
  t.number("low", "Low", "low end of the premise, in its unit; nan: no number", &P::low);
  t.number("high", "High", "high end of the premise, in its unit; nan: no number", &P::high);
  for (const NumberAtEnds& number : numbers)
    for (const auto& [stem, where, end] : {std::tuple{"low_", "Low end: ", &AtEnds::low},
                                           {"calculated_", "As calculated: ", &AtEnds::calculated},
                                           {"high_", "High end: ", &AtEnds::high}}) {
      Column column = number.column;
      column.description =
          where + (column.description.empty() ? column.heading : column.description);
      column.heading = where + column.heading;
      column.stem = stem + column.stem;
      t.put(column, [number, end](const P& of) { return number.cell(of.*number.numbers.*end); });
    }
  t.share("change", "Change",
          "largest less smallest of the first three numbers, over that as "
          "calculated",
          [](const P& of) { return of.result.change(); });
  t.add_each(all, &ModelUncertainty::effects);
  if (!all.empty() && !all.front().not_varied.empty())
    t.notes.push_back("Not varied: " + all.front().not_varied + ".");
  return t;
}

std::string deciding_text(const ModelUncertainty& uncertainty) {
  const auto found = [&](bool of_records) {
    const auto effect =
        std::ranges::find(uncertainty.effects, of_records, &PremiseEffect::is_of_records);
    return effect == uncertainty.effects.end() ? nullptr : &*effect;
  };
  const PremiseEffect *records = found(true), *premise = found(false);
  const auto change = [](const PremiseEffect* of) { return of ? of->result.change() : nan; };
  const auto text = [](double of) { return std::isinf(of) ? "without limit" : format_share(of); };
  if (premise == nullptr) return "no premise is varied";
  const std::string largest = fmt::format("{}: {}", premise->premise, text(change(premise)));
  if (std::isnan(change(premise)) || std::isnan(change(records)))
    return "not known (" + largest + ")";
  return fmt::format("{} decide ({}; records, 95 % interval: {})",
                     change(records) < change(premise) ? "premises" : "records", largest,
                     text(change(records)));
}

namespace {

Table of_fragility(const Results& results) {
  const auto as_it_is = [](double value) -> Cell { return value; };
  Table table = model_uncertainty_table(
      results.uncertainties,
      "What the records and the premises change: all else as in the fragility of " +
          governing_text(results),
      {{intensity_column(results, "p50", "50 % at", "intensity at which half of all exceed"),
        &PremiseEffect::result, as_it_is},
       {{"dbe_probability", "", "P at DBE", ColumnKind::share,
         "share of the histories that exceed the threshold at the DBE"},
        &PremiseEffect::probability,
        as_it_is}});
  if (results.model.dbe_level > 0.0) return table;
  for (const char* end : {"low_", "calculated_", "high_"})
    table = table.without(std::string(end) + "dbe_probability");
  return table;
}

std::vector<std::string> sentences(const Results& results) {
  std::string text;
  for (const ModelUncertainty& uncertainty : results.uncertainties)
    text += (text.empty() ? "" : "; ") + short_length(uncertainty.threshold_m) + ": " +
            deciding_text(uncertainty);
  return {"Largest change of the intensity with a 50 % chance of exceedance, by clearance: " +
          text + "."};
}

}  // namespace

AnalysisReport ModelUncertaintyAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return !results.uncertainties.empty(); },
          .summary = [](const Results& results) { return paragraphs(sentences(results)); },
          .sentences = sentences,
          .tables = each<of_fragility>,
          .section =
              [](const Results& results) {
                return heading("Records and premises") + wide_table(of_fragility(results));
              }};
}

}  // namespace glissade
