// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "report.hpp"

namespace glissade::convergence {
namespace {

std::string percent(double share) {
  return std::isnan(share) ? "" : fmt::format("{}", 100.0 * share);
}

/// The largest error of each record that has any, by the paper's measure.
std::vector<double> largest_by_record(const std::vector<Case>& cases, std::size_t step) {
  std::map<std::string, double> largest;
  for (const Case& c : cases) {
    const double error = error_of(c, step, Measure::finest);
    if (!std::isnan(error)) largest[c.record] = std::max(largest[c.record], error);
  }
  std::vector<double> values;
  for (const auto& [record, error] : largest) values.push_back(error);
  return values;
}

using Fields = std::vector<std::pair<const char*, std::string>>;

void add_errors(const std::vector<Case>& cases, std::size_t step, Fields& fields) {
  const ErrorSummary finest = error_summary(cases, step, Measure::finest),
                     residual = error_summary(cases, step, Measure::exact_residual),
                     peak = error_summary(cases, step, Measure::exact_peak);
  const auto clear = [&](ClearBy by) {
    return percent(error_summary(cases, step, Measure::finest, by).largest);
  };
  const std::vector<double> by_record = largest_by_record(cases, step);
  const auto within =
      std::ranges::count_if(by_record, [](double error) { return error <= paper_largest_error; });
  const Case* worst = finest.worst;
  fields.insert(
      fields.end(),
      {{"cases_counted", std::to_string(finest.counted)},
       {"largest_of_finest_percent", percent(finest.largest)},
       {"median_of_finest_percent", percent(finest.median)},
       {"largest_of_finest_clear_by_exact_percent", clear(ClearBy::exact)},
       {"largest_of_finest_clear_by_finest_percent", clear(ClearBy::finest)},
       {"largest_of_exact_residual_percent", percent(residual.largest)},
       {"median_of_exact_residual_percent", percent(residual.median)},
       {"largest_of_exact_peak_percent", percent(peak.largest)},
       {"median_of_exact_peak_percent", percent(peak.median)},
       {"smallest_of_records_largest_of_finest_percent",
        by_record.empty() ? "" : percent(std::ranges::min(by_record))},
       {"records_within_0.48_percent", std::to_string(within)},
       {"worst_of_finest", worst == nullptr ? ""
                                            : fmt::format("{} slope {} deg mu {} at {} g",
                                                          worst->record, worst->scene.slope_deg,
                                                          worst->scene.mu, worst->scene.ppa_g)},
       {"worst_exact_residual_m",
        worst == nullptr ? "" : fmt::format("{}", worst->exact_residual_m)},
       {"worst_exact_peak_m", worst == nullptr ? "" : fmt::format("{}", worst->exact_peak_m)}});
}

void add_times(const std::vector<Case>& cases, std::size_t step, Fields& fields) {
  std::vector<double> scheme, exact;
  for (const Case& c : cases) {
    scheme.push_back(c.scheme_s[step]);
    exact.push_back(c.exact_s);
  }
  fields.insert(fields.end(),
                {{"scheme_longest_s", fmt::format("{:.3g}", std::ranges::max(scheme))},
                 {"scheme_median_s", fmt::format("{:.3g}", median(scheme))},
                 {"exact_longest_s", fmt::format("{:.3g}", std::ranges::max(exact))},
                 {"exact_median_s", fmt::format("{:.3g}", median(exact))}});
}

}  // namespace

std::string table_csv(const std::vector<Group>& groups) {
  std::string csv;
  for (const Group& group : groups) {
    for (std::size_t step = 0; step < paper_substeps.size(); ++step) {
      Fields fields{{"motions", group.name}, {"substeps", std::to_string(paper_substeps[step])}};
      add_errors(group.cases, step, fields);
      add_times(group.cases, step, fields);
      std::vector<std::string> names, values;
      for (const auto& [name, value] : fields) {
        names.emplace_back(name);
        values.push_back(value);
      }
      if (csv.empty()) csv = fmt::format("{}\n", fmt::join(names, ","));
      csv += fmt::format("{}\n", fmt::join(values, ","));
    }
  }
  return csv;
}

}  // namespace glissade::convergence
