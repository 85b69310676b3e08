// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "glissade/io/pull_test_file.hpp"
#include "glissade/report/friction_report.hpp"
#include "shared/option_errors.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

struct FrictionOptions {
  std::string tests, out;
  SlidingRule rule;
  bool json = false, overwrite = false;
};

/// NaN, of one test, becomes null.
Json to_json(const MuStatistics& s) {
  Json json{{"tests", s.tests},
            {"mean", s.mean},
            {"std", s.std},
            {"mean_minus_2_std", s.mean_minus_2_std},
            {"lower_bound_95", s.lower_bound_95}};
  json["shapiro_wilk"] =
      s.normality ? Json{{"w", s.normality->w}, {"p_value", s.normality->p_value}} : Json();
  return json;
}

Json to_json(const TraceFriction& t) {
  return {{"test", t.test},
          {"direction", t.direction},
          {"breakaway_mu", t.breakaway_mu},
          {"sliding_mu", t.sliding_mu},
          {"sliding_std", t.sliding_std},
          {"min_mu", t.min_mu},
          {"max_mu", t.max_mu},
          {"mu_by_displacement", t.mu_by_displacement},
          {"travel_m", t.travel_m},
          {"speed_mps", std::isnan(t.speed_mps) ? Json() : Json(t.speed_mps)},
          {"sliding_samples", t.sliding_end - t.sliding_begin}};
}

Json to_json(const PullTestSummary& summary) {
  Json json{{"slip_m", summary.rule.slip_m},
            {"sliding_from_m", summary.rule.sliding_from_m},
            {"directions", Json::array()},
            {"tests", Json::array()},
            {"notes", summary.notes}};
  for (const DirectionFriction& d : summary.directions) {
    json["directions"].push_back(
        {{"direction", d.direction},
         {"sliding", to_json(d.sliding)},
         {"breakaway", d.breakaway.tests > 0 ? to_json(d.breakaway) : Json()}});
  }
  for (const TraceFriction& test : summary.tests) json["tests"].push_back(to_json(test));
  return json;
}

void print(const PullTestSummary& summary) {
  if (!summary.tests.empty()) put("{}\n", to_text(pull_tests_table(summary)));
  put("{}", to_text(friction_table(summary)));
  if (!summary.notes.empty()) put("\n");
  for (const std::string& note : summary.notes) put_note(note);
}

void run(const FrictionOptions& o) {
  with_changed_problems(
      [](Problem& p) { p.where = p.where == "slip_m" ? "--slip-m" : "--sliding-from-m"; },
      [&] { validate(o.rule); });
  if (!o.out.empty()) check_output_folder(o.out, o.overwrite);
  const auto [tests, summary] = read_pull_test_results(o.tests, o.rule);
  if (!o.out.empty()) {
    const auto taken = take_folder(o.out);
    write_friction_report(tests, summary, o.out);
    taken->give_back();
  }
  if (o.json) {
    put_json(to_json(summary));
    return;
  }
  print(summary);
  if (!o.out.empty()) put("\nTables and figure   {}\n", o.out);
}

}  // namespace

void add_friction(CLI::App& program) {
  auto o = std::make_shared<FrictionOptions>();
  CLI::App* command = program.add_subcommand("friction", "Effective friction from pull tests");
  command
      ->add_option("tests", o->tests,
                   "CSV of pull tests as logged, or a sheet with a column mu (studies/README.md)")
      ->required();
  command->add_option("--slip-m", o->rule.slip_m,
                      "displacement up to which the rig stretches and the array does not slip");
  command->add_option("--sliding-from-m", o->rule.sliding_from_m,
                      "displacement from which the array counts as sliding");
  command->add_option("--out", o->out, "new folder for tables and figure [none are written]");
  add_overwrite(*command, o->overwrite);
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] { run(*o); });
}

}  // namespace glissade::cli
