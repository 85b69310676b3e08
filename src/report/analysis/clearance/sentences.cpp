// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/clearance/statements.hpp"
#include "analysis/clearance/view.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/format.hpp"

namespace glissade {
namespace {

std::string what_was_run(const ClearanceResults& r) {
  std::vector<std::string> suites;
  for (const ClearanceSuite& suite : r.suites) suites.push_back(suite.name);
  const auto without = std::ranges::count_if(
      r.records, [](const ClearanceRecord& record) { return !record.has_vertical; });
  std::string text = fmt::format("{} conditions, {} records of {}", r.grid.count(),
                                 r.records.size(), fmt::join(suites, ", "));
  if (r.orientations.size() > 1) text += fmt::format(", {}", orientations_text(r));
  text += fmt::format(". Shown, where nothing else is said: {}.", conditions_text(r, {}));
  if (without > 0) text += fmt::format(" {} of the records have no vertical component.", without);
  const double uplift = uplift_share(r);
  if (uplift > 0.0)
    text += fmt::format(" In {} of the histories the array lifts off, which is outside the model.",
                        format_share(uplift));
  return text;
}

}  // namespace

std::string answer_to(const ClearanceResults& results, const PaperStatement& statement) {
  if (std::isnan(statement.displacement_m)) return clearance_reading(results, statement.about);
  ClearancePosition at;
  Periods periods = Periods::largest;
  if (!std::isnan(statement.period_s)) {
    const auto& all = results.grid.period_s;
    at[ClearanceAxis::period] =
        static_cast<std::size_t>(std::ranges::find(all, statement.period_s) - all.begin());
    periods = Periods::one;
  }
  const std::string which = periods == Periods::one
                                ? fmt::format("at T = {:g} s", statement.period_s)
                                : "largest over the periods";
  std::vector<std::string> parts;
  for (const ClearancePosition& vertical : along(results.grid, ClearanceAxis::vertical, at)) {
    for (const ClearancePosition& place : along(results.grid, ClearanceAxis::mass, vertical)) {
      const std::vector<double> own = own_way_means(results, {}, place, periods);
      std::vector<double> alike = means_by_orientation(results, {}, place, periods);
      std::sort(alike.begin(), alike.end());
      const std::string label =
          distinguished(results.grid, place,
                        {ClearanceAxis::period, ClearanceAxis::support, ClearanceAxis::slope,
                         ClearanceAxis::level, ClearanceAxis::response_modification});
      std::string part = (label.empty() ? "" : label + ": ") +
                         range_text(results, over_orientations(results, {}, place, periods));
      if (alike.size() > 1) {
        part += fmt::format(
            "; {} of these are below it, and {} of the means in which each record "
            "lies its own way",
            format_share(share_below(alike, statement.displacement_m)),
            format_share(share_below(own, statement.displacement_m)));
      }
      parts.push_back(part);
    }
  }
  return fmt::format("The suite's mean {}. {}.", which, fmt::join(parts, ". "));
}

std::vector<std::string> clearance_sentences(const ClearanceResults& results) {
  std::vector<std::string> sentences{what_was_run(results)};
  const auto told_elsewhere = [&](ClearanceTopic topic) {
    return std::ranges::any_of(results.statements, [&](const PaperStatement& s) {
      return s.about == topic && std::isnan(s.displacement_m);
    });
  };
  for (const ClearanceTopic topic :
       {ClearanceTopic::period, ClearanceTopic::orientation, ClearanceTopic::mass,
        ClearanceTopic::level, ClearanceTopic::yielding, ClearanceTopic::base_shear,
        ClearanceTopic::slope, ClearanceTopic::mce, ClearanceTopic::vertical,
        ClearanceTopic::spectra}) {
    const std::string reading = clearance_reading(results, topic);
    if (!reading.empty() && !told_elsewhere(topic)) sentences.push_back(reading);
  }
  return sentences;
}

std::string clearance_summary(const ClearanceResults& results) {
  std::string text = results.study_name + "\n\n";
  for (const std::string& sentence : clearance_sentences(results)) text += wrapped(sentence);
  for (const PaperStatement& s : results.statements) {
    text += wrapped(fmt::format("{}: \"{}\"", s.where, s.says));
    text += wrapped("Here: " + answer_to(results, s));
  }
  return text;
}

}  // namespace glissade
