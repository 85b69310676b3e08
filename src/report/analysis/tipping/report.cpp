// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/analyses.hpp"
#include "glissade/report/format.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// The records that tip in any history of some rows.
std::vector<std::string> records_that_tip(const Results& results,
                                          const std::vector<TippingShare>& rows) {
  std::vector<std::string> names;
  for (std::size_t record = 0; record < results.records.size(); ++record) {
    if (std::ranges::any_of(rows, [&](const auto& row) { return row.by_record[record] > 0.0; }))
      names.push_back(results.records[record].id);
  }
  return names;
}

Table tipping_table(const Results& results) {
  using S = TippingShare;
  const auto names = [&](const S& row) { return records_that_tip(results, {row}); };
  TableOf<S> t("tipping",
               "Share of the histories in which the body begins to tip. Intensity "
               "measure: " +
                   results.intensity_label + ".");
  t.put_all(condition_column, level_column(results));
  t.share("tip_share", "Begins to tip", "share of histories in which the body begins to tip",
          &S::share);
  t.count("record_count", "Records that tip", "number of records in any of whose histories it tips",
          [&](const S& row) { return names(row).size(); });
  t.text("records", "They are", "ids of the records in which it tips",
         [&](const S& row) { return fmt::format("{}", fmt::join(names(row), ", ")); });
  t.add_each(results.tipping->shares);
  return results.cases.combinations() > 1 ? t : t.without("condition");
}

std::vector<std::string> sentences(const Results& results) {
  const TippingResults& tipping = *results.tipping;
  const std::string body =
      fmt::format("a body {:g} m wide with its centre of mass {:g} m above the roof",
                  tipping.body.width_m, tipping.body.centre_of_mass_height_m);
  const double friction =
      std::ranges::max_element(results.cases.cases, {}, &Case::friction)->friction;
  if (friction <= tipping.least_friction) {
    return {
        fmt::format("Tipping: {} cannot tip: no friction is above {:.3g}, its width over twice "
                    "that height, so it slides first.",
                    body, tipping.least_friction)};
  }
  const std::vector<std::string> names = records_that_tip(results, tipping.shares);
  if (names.empty()) return {"Tipping: " + body + " does not begin to tip in any history."};
  double first = results.levels.back(), sum = 0.0, largest = 0.0, rows = 0.0;
  for (const TippingShare& row : tipping.shares) {
    if (row.share > 0.0) first = std::min(first, row.level);
    if (row.level != results.levels.back()) continue;
    sum += row.share;
    largest = std::max(largest, row.share);
    ++rows;
  }
  return {fmt::format(
      "TIPPING: {} begins to tip in some histories of {} of {}, from {} on; at the highest "
      "level in {} of all{}. Tipping is outside the model: slip there is that of a body that does "
      "not tip.",
      body, names.size(), counted(results.records.size(), "record"), at_intensity(results, first),
      format_share(sum / rows),
      rows > 1 ? ", up to " + format_share(largest) + " of one combination" : "")};
}

std::string summary(const Results& results) {
  constexpr std::size_t most_rows = 24;
  const Table table = tipping_table(results).without("records");
  return paragraphs(sentences(results)) +
         (table.rows.size() <= most_rows ? "\n" + to_text(table) : "");
}

Table tipping_records_table(const Results& results) {
  using S = TippingShare;
  TableOf<S, std::size_t> t(
      "tipping_by_record",
      "Share of the histories of each record in which the body begins to tip. Intensity measure: " +
          results.intensity_label + ".");
  t.put_all(condition_column, level_column(results));
  t.text("record", "Record", "id of the record",
         [&](const S&, std::size_t record) { return results.records[record].id; });
  t.share("tip_share", "Begins to tip",
          "share of the histories of the record in which the body begins to tip",
          [](const S& row, std::size_t record) { return row.by_record[record]; });
  for (const S& row : results.tipping->shares)
    for (std::size_t r = 0; r < row.by_record.size(); ++r) t.add(row, r);
  return t;
}

Html section(const Results& results) {
  return heading("Onset of tipping") + table_or_file(tipping_table(results));
}

}  // namespace

AnalysisReport TippingAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return results.tipping.has_value(); },
          .summary = summary,
          .sentences = sentences,
          .tables = each<tipping_table, tipping_records_table>,
          .section = section};
}

}  // namespace glissade
