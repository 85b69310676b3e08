// SPDX-License-Identifier: GPL-3.0-or-later
#include "suite/conditional_select.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "glissade/core/file.hpp"
#include "glissade/io/suite_writer.hpp"
#include "glissade/report/conditional_figure.hpp"
#include "shared/option_errors.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"
#include "suite/selection_output.hpp"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

/// What was asked for and what was found.
struct ConditionalOutcome {
  const ConditionalRequest& request;
  const Suite& library;
  const ConditionalTarget& target;
  const ConditionalSelection& selection;
};

std::string errors_line(const ConditionalOutcome& o) {
  const SpectrumDistribution& spectrum = o.target.spectrum;
  return fmt::format(
      "from {:.3g} to {:.3g} s the mean of ln Sa is within {:.3f} of the target's, its standard "
      "deviation within {:.0f} %",
      spectrum.periods_s.front(), spectrum.periods_s.back(), o.selection.mean_error(spectrum),
      100.0 * o.selection.sigma_error(spectrum));
}

std::vector<std::string> warnings_of(const ConditionalOutcome& o) {
  constexpr double tolerance = 0.1;  // of Baker & Lee (2018)
  constexpr std::size_t least_of_one = 3;
  std::vector<std::string> warnings = o.request.target.warnings(o.target);
  const std::size_t count = o.selection.records.size(), candidates = o.selection.candidates;
  const auto by_factor = static_cast<std::size_t>(
      std::ranges::count_if(o.selection.left_out, [](const LeftOutRecord& record) {
        return record.reasons == std::vector{LeftOutFor::factor};
      }));
  if (by_factor > candidates)
    warnings.push_back(fmt::format(
        "{} of {} records need a factor above {:g} or below 1/{:g}: the library is of other "
        "intensities",
        by_factor, by_factor + candidates, o.request.criteria.max_scale,
        o.request.criteria.max_scale));
  if (candidates < least_of_one * count)
    warnings.push_back(
        fmt::format("{} candidates for {} records are few: give a larger library, or select fewer",
                    candidates, count));
  const double mean_error = o.selection.mean_error(o.target.spectrum),
               sigma_error = o.selection.sigma_error(o.target.spectrum);
  if (mean_error > tolerance || sigma_error > tolerance)
    warnings.push_back(fmt::format(
        "the records match the target loosely: the mean of ln Sa is up to {:.2f} from it, its "
        "standard deviation up to {:.0f} % (10 % is usual: Baker & Lee 2018)",
        mean_error, 100.0 * sigma_error));
  if (o.library.nearest_to_target)
    warnings.push_back(
        "the library is of records selected as the nearest to a target spectrum, which scatter "
        "less");
  return warnings;
}

/// What the best of all starts reached.
std::string objective_line(const ConditionalOutcome& o) {
  return fmt::format(
      "objective {:.4f}, the least of {} starts (seed {}): the sum over {} periods of "
      "the squares of the error of the mean and, twice, of the standard deviation",
      o.selection.objective, conditional_starts, o.request.seed, o.target.spectrum.size());
}

/// Means and standard deviations of records and target by period.
Table comparison_table(const ConditionalOutcome& o) {
  Table table{"comparison",
              "Mean (exp of that of ln Sa) and standard deviation of ln Sa, RotD50",
              {{"period", "s", "period, s", ColumnKind::number},
               {"target_sa", "g", "target, g", ColumnKind::number},
               {"records_sa", "g", "records, g", ColumnKind::number},
               {"target_sigma", "", "target std", ColumnKind::number, "", false, 3},
               {"records_sigma", "", "records std", ColumnKind::number, "", false, 3}},
              {}};
  const SpectrumDistribution& spectrum = o.target.spectrum;
  for (std::size_t p = 0; p < spectrum.size(); ++p)
    table.add({spectrum.periods_s[p], spectrum.sa_g(p), std::exp(o.selection.mean[p]),
               spectrum.sigma(p), o.selection.sigma[p]});
  return table;
}

void print(const ConditionalOutcome& o) {
  put_lines("target: " + o.request.target.sentence(o.target), 8);
  put_warnings(warnings_of(o));
  put("{} candidates of {} records\n\n", o.selection.candidates, o.library.motions.size());
  put("{}\n{}", to_text(selected_table(o.library, o.selection.records)),
      to_text(comparison_table(o)));
  put("\n");
  put_lines(errors_line(o), 2);
  put_lines(objective_line(o), 2);
  put_left_out(o.library, o.selection.left_out);
}

Json to_json(const ConditionalOutcome& o) {
  const SpectrumDistribution& spectrum = o.target.spectrum;
  Json json{{"target", o.request.target.sentence(o.target)},
            {"epsilon", o.target.epsilon()},
            {"warnings", warnings_of(o)},
            {"max_scale", o.request.criteria.max_scale},
            {"candidates", o.selection.candidates},
            {"records", selected_json(o.library, o.selection.records)},
            {"mean_error", o.selection.mean_error(spectrum)},
            {"sigma_error", o.selection.sigma_error(spectrum)},
            {"objective", o.selection.objective},
            {"starts", conditional_starts},
            {"spectrum", Json::array()},
            {"left_out", left_out_json(o.library, o.selection.left_out)}};
  for (std::size_t p = 0; p < spectrum.size(); ++p)
    json["spectrum"].push_back({{"period_s", spectrum.periods_s[p]},
                                {"target_sa_g", spectrum.sa_g(p)},
                                {"records_sa_g", std::exp(o.selection.mean[p])},
                                {"target_sigma", spectrum.sigma(p)},
                                {"records_sigma", o.selection.sigma[p]}});
  return json;
}

std::string suite_text(const ConditionalOutcome& o) {
  namespace fs = std::filesystem;
  const ConditionalRequest& request = o.request;
  const std::string target = request.target.sentence(o.target);
  SuiteHead head{
      fs::path(request.out).stem().string(),
      fmt::format("{} records of {} with the {}", o.selection.records.size(), o.library.name,
                  target),
      std::nullopt,
      {"Made by: glissade suite select, from " + fs::path(request.library).filename().string() +
           fmt::format(", seed {}", request.seed),
       target, errors_line(o), objective_line(o)},
      o.library.nearest_to_target};
  for (const std::string& warning : warnings_of(o)) head.comments.push_back("WARNING: " + warning);
  std::vector<ScaledRecord> records;
  for (const SelectedRecord& r : o.selection.records)
    records.push_back({o.library.motions[r.record].id, r.scale});
  return suite_of_records_toml(request.library, head, records, fs::path(request.out).parent_path());
}

}  // namespace

void select_to_conditional(const ConditionalRequest& request) {
  const ConditionalTarget target = request.target.target();
  check_output_file(request.out, "--out", request.overwrite);
  if (!request.figures.empty()) check_output_folder(request.figures, request.overwrite);
  const Suite library = load_library(request.library);
  const ConditionalSelection selection = with_changed_problems(by_option, [&] {
    return select_conditional(library, target, request.criteria, request.seed);
  });
  const ConditionalOutcome outcome{request, library, target, selection};
  if (!request.out.empty()) write_text_file(request.out, suite_text(outcome));
  if (!request.figures.empty()) {
    std::filesystem::create_directories(request.figures);
    render_figure(conditional_figure(target, selection, request.target.sentence(target)),
                  request.figures);
  }
  if (request.json) return put_json(to_json(outcome));
  print(outcome);
  if (!request.out.empty()) put("\nsuite file   {}\n", request.out);
  if (!request.figures.empty())
    put("figure       {}\n",
        (std::filesystem::path(request.figures) / "conditional_spectrum.svg").string());
}

}  // namespace glissade::cli
