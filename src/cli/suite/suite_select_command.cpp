// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/io/suite_writer.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/record_selection.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/report/table.hpp"
#include "shared/option_errors.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"
#include "suite/conditional_select.hpp"
#include "suite/selection_output.hpp"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SelectOptions {
  std::string library, out, figures, site, site_class, edition;
  std::vector<std::string> site_classes;
  std::optional<int> level;
  std::optional<double> ss_g, s1_g, max_scale;
  SelectionCriteria criteria;  ///< per_event and the limits that were given
  std::optional<std::size_t> count;
  ConditionalOptions conditional;
  std::optional<std::uint64_t> seed;
  bool keep_incomplete = false, json = false, overwrite = false;
};

/// The target spectrum, and the criteria for the records that match it.
struct Task {
  DesignTarget target;
  std::filesystem::path spectrum_file;  ///< of a target by points
  SelectionCriteria criteria;
};

/// Named by its option.
SiteClass site_class_of(const char* option, const std::string& name) {
  return of_option(option, [&] { return parse_site_class(name); });
}

SiteGroup group_of(const std::string& site_class) {
  if (site_class.empty()) return SiteGroup::a_to_d;
  if (site_class_of("--site-class", site_class) == SiteClass::e) return SiteGroup::e;
  throw InputError({"--site-class", "a level's suite is for class E, or for A to D together",
                    "give E, or leave it out for A to D", ""});
}

DesignTarget target_of_site(const SelectOptions& o) {
  ProblemList problems;
  const auto mapped = [&](const std::optional<double>& value, const char* option) {
    if (value && *value > most_possible_g) {
      problems.add({option,
                    fmt::format("{:g} g: no site has more than {:g} g", *value, most_possible_g),
                    fmt::format("if it is in percent of g, give {:g}", *value / 100.0), ""});
      return 1.0;
    }
    if (value && *value > 0.0) return *value;
    problems.add({option, value ? fmt::format("{} g is not above 0", *value) : "is missing",
                  "give the mapped accelerations of the site, --ss-g and --s1-g, or a --level",
                  ""});
    return 1.0;
  };
  if (o.edition.empty())
    problems.add({"--edition", "is missing",
                  "give asce7_10 or asce7_16: their site coefficients differ", ""});
  DesignTarget target{
      .edition = o.edition.empty() ? AsceEdition::asce7_16 : parse_asce_edition(o.edition),
      .ss_g = mapped(o.ss_g, "--ss-g"),
      .s1_g = mapped(o.s1_g, "--s1-g")};
  target.site_classes.clear();
  if (!o.site_class.empty())
    target.site_classes.push_back(site_class_of("--site-class", o.site_class));
  for (const std::string& name : o.site_classes)
    target.site_classes.push_back(site_class_of("--site-classes", name));
  if (target.site_classes.empty())
    target.site_classes = {SiteClass::a, SiteClass::b, SiteClass::c, SiteClass::d};
  problems.throw_if_any();
  return target;
}

/// Limits that are given take the place of the level's.
void override_with(Limits& limits, const Limits& given) {
  if (given.min) limits.min = given.min;
  if (given.max) limits.max = given.max;
}

Task task_of(const SelectOptions& o) {
  const bool of_a_site = o.ss_g || o.s1_g || !o.site_classes.empty();
  if (!o.site.empty() && (of_a_site || o.level || !o.site_class.empty() || !o.edition.empty()))
    throw InputError({"--site", "is a file that states the whole target",
                      "leave out --level, --edition, --ss-g, --s1-g and the site classes", ""});
  if (o.level && of_a_site)
    throw InputError({"--level", "has its own S_s, S_1 and site classes",
                      "leave out --ss-g, --s1-g and --site-classes, or the level", ""});
  if (!o.site_class.empty() && !o.site_classes.empty())
    throw InputError({"--site-class", "is given beside --site-classes", "give one of them", ""});
  if (o.level && !o.edition.empty())
    throw InputError({"--edition", "a level is of ASCE 7-10, after Walters et al. (2012)",
                      "leave it out, or give --ss-g and --s1-g in place of the level", ""});
  Task task;
  if (o.level) {
    const SiteGroup sites = group_of(o.site_class);
    task = {walters_target(*o.level, sites), {}, walters_criteria(*o.level, sites)};
  } else if (!o.site.empty()) {
    const StatedTarget stated = read_stated_target(o.site);
    task.target = stated.target;
    task.spectrum_file = stated.spectrum_file;
  } else {
    task.target = target_of_site(o);
  }
  SelectionCriteria& criteria = task.criteria;
  criteria.count = o.count.value_or(criteria.count);
  criteria.per_event = o.criteria.per_event;
  override_with(criteria.magnitude, o.criteria.magnitude);
  override_with(criteria.distance_km, o.criteria.distance_km);
  override_with(criteria.vs30_mps, o.criteria.vs30_mps);
  if (o.max_scale) criteria.max_scale = *o.max_scale;
  if (o.keep_incomplete) criteria.missing = MissingMetadata::keeps;
  return task;
}

RecordSelection select(const Suite& library, const Task& task) {
  const TargetSpectrum target(task.target);
  return with_changed_problems(by_option, [&] {
    return select_records(
        library, [&](double period_s) { return target.mce_sa_g(period_s); }, walters_periods_s(),
        task.criteria);
  });
}

std::vector<std::string> names(const DesignTarget& target) {
  std::vector<std::string> classes;
  for (const SiteClass site : target.site_classes) classes.push_back(to_string(site));
  return classes;
}

std::string target_line(const DesignTarget& target) { return "MCE, " + to_string(target); }

std::string average_line(const RecordSelection& s) {
  return fmt::format("{:.3f} (at {:g} s) to {:.3f} (at {:g} s) of the target from 0 to 2 s",
                     s.lowest.ratio, s.lowest.period_s, s.highest.ratio, s.highest.period_s);
}

std::string shortfall_line(const RecordSelection& s, double max_scale) {
  return fmt::format(
      "the average falls below the target: every record is at the largest factor {:g}; "
      "{:.3g} would lift these to it",
      max_scale, max_scale / s.lowest.ratio);
}

void print(const Suite& library, const Task& task, const RecordSelection& s) {
  std::string target = "target: " + target_line(task.target);
  if (task.target.is_mapped()) {
    const auto level = intensity_level({task.target.ss_g, task.target.s1_g});
    target += "; Intensity Level " + (level ? std::to_string(*level) : "above 4");
  }
  put_lines(target, 8);
  put_warnings(improbable_values(task.target));
  put("{} candidates of {} records\n\n", s.candidates, library.motions.size());
  put("{}", to_text(selected_table(library, s.records)));
  put("\n");
  put_lines("average of the SRSS spectra: " + average_line(s), 2);
  if (!s.reaches_target()) put_note(shortfall_line(s, task.criteria.max_scale));
  put_left_out(library, s.left_out);
}

Json to_json(const RatioAtPeriod& r) { return {{"ratio", r.ratio}, {"period_s", r.period_s}}; }

Json to_json(const Suite& library, const Task& task, const RecordSelection& s) {
  const DesignTarget& target = task.target;
  const bool mapped = target.is_mapped();
  const auto level = mapped ? intensity_level({target.ss_g, target.s1_g}) : std::nullopt;
  Json json{{"target",
             {{"edition", to_string(target.edition)},
              {"ss_g", or_null(mapped ? target.ss_g : 0.0)},
              {"s1_g", or_null(mapped ? target.s1_g : 0.0)},
              {"site_classes", mapped ? Json(names(target)) : Json()},
              {"intensity_level", level ? Json(*level) : Json()}}},
            {"warnings", improbable_values(target)},
            {"max_scale", task.criteria.max_scale},
            {"candidates", s.candidates},
            {"records", selected_json(library, s.records)},
            {"average",
             {{"lowest", to_json(s.lowest)},
              {"highest", to_json(s.highest)},
              {"reaches_target", s.reaches_target()}}},
            {"left_out", left_out_json(library, s.left_out)}};
  return json;
}

std::string suite_text(const SelectOptions& o, const Suite& library, const Task& task,
                       const RecordSelection& s) {
  namespace fs = std::filesystem;
  SuiteHead head{fs::path(o.out).stem().string(),
                 fmt::format("{} records of {}, scaled to the {}", s.records.size(), library.name,
                             target_line(task.target)),
                 StatedTarget{task.target, task.spectrum_file},
                 {"Made by: glissade suite select, from " + fs::path(o.library).filename().string(),
                  "average of the SRSS spectra: " + average_line(s)},
                 true};
  if (!s.reaches_target()) head.comments.push_back(shortfall_line(s, task.criteria.max_scale));
  std::vector<ScaledRecord> records;
  for (const SelectedRecord& r : s.records)
    records.push_back({library.motions[r.record].id, r.scale});
  return suite_of_records_toml(o.library, head, records, fs::path(o.out).parent_path());
}

/// Twenty records at a level: Baker (2015) fits fragilities of so many and more.
constexpr std::size_t records_of_a_stripe = 20;

void run_conditional(const SelectOptions& o) {
  if (o.level || o.ss_g || o.s1_g || !o.site.empty() || !o.edition.empty() ||
      !o.site_class.empty() || !o.site_classes.empty())
    throw InputError({"--period-s", "states a conditional spectrum, beside a design spectrum",
                      "leave out --level, --site, --edition, --ss-g, --s1-g and the site classes, "
                      "or the options of the conditional spectrum",
                      ""});
  ConditionalRequest request{.library = o.library,
                             .out = o.out,
                             .figures = o.figures,
                             .target = o.conditional,
                             .criteria = o.criteria,
                             .json = o.json,
                             .overwrite = o.overwrite};
  request.criteria.count = o.count.value_or(records_of_a_stripe);
  request.criteria.max_scale = o.max_scale.value_or(request.criteria.max_scale);
  if (o.keep_incomplete) request.criteria.missing = MissingMetadata::keeps;
  request.seed = o.seed.value_or(request.seed);
  select_to_conditional(request);
}

void run(const SelectOptions& o) {
  if (o.conditional.are_given()) return run_conditional(o);
  for (const auto& [is_given, option] :
       {std::pair{!o.figures.empty(), "--figures"}, {o.seed.has_value(), "--seed"}})
    if (is_given)
      throw InputError({option, "is of a selection to a conditional spectrum",
                        "leave it out, or state the spectrum: --period-s, --sa-g, --magnitude ...",
                        ""});
  const Task task = task_of(o);
  check_output_file(o.out, "--out", o.overwrite);
  const Suite library = load_library(o.library);
  const RecordSelection selection = select(library, task);
  if (!o.out.empty()) write_text_file(o.out, suite_text(o, library, task, selection));
  if (o.json) return put_json(to_json(library, task, selection));
  print(library, task, selection);
  if (!o.out.empty()) put("\nsuite file   {}\n", o.out);
}

}  // namespace

void add_suite_select(CLI::App& suite) {
  auto o = std::make_shared<SelectOptions>();
  CLI::App* command = suite.add_subcommand(
      "select",
      "Select and scale records of a library to an MCE spectrum, by Walters's rule, or to a "
      "conditional spectrum");
  command->add_option("library", o->library, "suite file with the records to select from")
      ->required();
  command->add_option("--count", o->count, "how many records [7; of a conditional spectrum 20]");
  command->add_option("--level", o->level,
                      "Walters's Seismic Intensity Level, 0 to 4: its target and its limits");
  command->add_option("--site-class", o->site_class, "class of the site; of a level: E [A to D]");
  command->add_option(
      "--site", o->site,
      "project or suite file whose site or target is taken: also by S_DS and S_D1 or a spectrum");
  command->add_option("--ss-g", o->ss_g, "the site's own mapped S_s");
  command->add_option("--s1-g", o->s1_g, "the site's own mapped S_1");
  command->add_option("--edition", o->edition, "asce7_10 or asce7_16; required with --ss-g");
  command->add_option("--site-classes", o->site_classes, "classes to envelope [A,B,C,D]")
      ->delimiter(',');
  const auto takes_limits = [&](const std::string& name, Limits& limits, const char* what) {
    command->add_option("--min-" + name, limits.min, fmt::format("smallest {}", what));
    command->add_option("--max-" + name, limits.max, fmt::format("largest {}", what));
  };
  takes_limits("magnitude", o->criteria.magnitude, "magnitude [the level's]");
  takes_limits("distance-km", o->criteria.distance_km, "distance [the level's]");
  takes_limits("vs30-mps", o->criteria.vs30_mps, "V_S30 [the level's]");
  command->add_option("--max-scale", o->max_scale,
                      "largest factor on a record [the level's, or 4]");
  command->add_option("--per-event", o->criteria.per_event, "most records of one earthquake");
  command->add_flag("--keep-incomplete", o->keep_incomplete,
                    "keep records that lack a limited parameter");
  o->conditional.add_to(*command);
  command->add_option("--seed", o->seed, "of the spectra drawn from a conditional spectrum [1]");
  command->add_option("--figures", o->figures,
                      "new folder for the figure of a conditional spectrum [none is drawn]");
  command->add_option("--out", o->out, "new suite file [none is written]");
  add_overwrite(*command, o->overwrite);
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] { run(*o); });
}

}  // namespace glissade::cli
