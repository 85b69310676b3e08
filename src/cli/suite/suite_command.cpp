// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/recipe_writer.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/io/suite_writer.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/scaling_rule.hpp"
#include "glissade/motion/simulation/suite_design.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/motion/walters_level.hpp"
#include "glissade/report/table.hpp"
#include "shared/option_errors.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"
#include "suite/conditional_options.hpp"
#include "suite/import_output.hpp"
#include "suite/motions_table.hpp"

namespace glissade::cli {
namespace {

struct SuiteOptions {
  std::string suite, out;
  std::string target = "mce", rule = "walters_2012";
  std::vector<double> periods_s;  ///< first ones of the building
  bool to_one_and_a_half = false;
  double damping = 0.05, max_factor = 4.0;
  int level = 2;
  std::uint64_t seed = 20260101;
  bool overwrite = false;
  MissingOptions missing;
};

/// To the file, else to standard output.
void deliver(const std::string& out, const std::string& text) {
  if (out.empty()) {
    put("{}", text);
  } else {
    write_text_file(out, text);
  }
}

/// The CSV alone; its title and notes go to standard error.
void deliver_csv(const std::string& out, const Table& table) {
  deliver(out, to_csv(table));
  say("{}\n", printable(table.title));
  for (const std::string& note : table.notes) say("{}\n", printable(note));
}

double in_g(double acceleration_mps2) { return acceleration_mps2 / standard_gravity_mps2; }

const DesignTarget& target_of(const Suite& suite, const std::string& file) {
  if (suite.of_roof)
    throw InputError({file, "has motions of a roof, which are used as they are",
                      "scale the ground motions of the model that gave them", ""});
  if (!suite.target)
    throw InputError({file, "names no design target",
                      "add [target] with edition, ss_g, s1_g and site_classes", ""});
  return *suite.target;
}

void deliver_table(const SuiteOptions& o, const Table& table, const char* what) {
  put("{}", to_text(table));
  if (o.out.empty()) {
    put("{}: --out FILE.csv\n", what);
  } else {
    write_text_file(o.out, to_csv(table));
    put("Table   {}\n", o.out);
  }
}

/// The components of a record file, or of all below a folder.
void show_files(const SuiteOptions& o) {
  const SuiteImport found = import_suite(
      {.inputs = {o.suite}, .report = {}, .missing = o.missing.of_files(), .keep_single = true});
  if (found.components.empty() && found.left_out.size() == 1)
    throw InputError({found.left_out.front().what, found.left_out.front().reason, "", ""});
  deliver_table(o, components_table(found), "Event, station, magnitude and notes of each");
  put_warnings(found);
  put_left_out(found);
  put("{}: glissade suite import {} --out SUITE.toml\n", counted(found.records.size(), "record"),
      quoted_for_shell(o.suite));
}

void show(const SuiteOptions& o) {
  if (!is_suite_file(o.suite)) return show_files(o);
  const Suite suite = load_suite(o.suite);
  put_lines(suite.name + ": " + suite.description, 0);
  if (suite.target) {
    const TargetSpectrum target(*suite.target);
    put("target: {}\n        S_DS {:.3f} g, S_D1 {:.3f} g", to_string(*suite.target),
        target.sds_g(), target.sd1_g());
    if (suite.target->is_mapped()) {
      const auto level = intensity_level({suite.target->ss_g, suite.target->s1_g});
      put("; Intensity Level {}", level ? std::to_string(*level) : "above 4");
    }
    put("\n");
    put_warnings(improbable_values(*suite.target));
  }
  if (suite.of_roof) put("motions of a roof: used as they are, without a building\n");
  if (suite.nearest_to_target)
    put("selected as the nearest to a target spectrum: the motions scatter less\n");
  for (const Motion& motion : suite.motions) {
    for (const std::string& value : improbable_values(motion, suite.of_roof))
      put_warning(motion.id + ": " + value);
  }
  for (const Motion& motion : suite.motions) {
    for (const std::string& note : notes_on(motion)) put_note(motion.id + ": " + note);
  }
  deliver_table(o, motions_table(suite), "Each component, earthquake and station");
}

void spectra(const SuiteOptions& o) {
  const Suite suite = load_suite(o.suite);
  std::vector<double> periods{0.0};
  for (int i = 0; i < 100; ++i) periods.push_back(0.02 * std::pow(200.0, i / 99.0));
  Table table{
      "spectra",
      fmt::format("pseudo-spectral acceleration, damping {:g}, the suite's scale factors applied",
                  o.damping),
      {{"period", "s", "Period, s"}},
      {}};
  for (const double period : periods) table.rows.push_back({period});
  const auto add = [&](const std::string& stem, const std::vector<double>& values) {
    table.columns.push_back({stem, "g", stem + ", g"});
    for (std::size_t i = 0; i < values.size(); ++i) table.rows[i].emplace_back(values[i]);
  };
  std::vector<double> average(periods.size(), 0.0);
  for (const Motion& m : suite.motions) {
    for (const auto combination :
         {HorizontalCombination::geometric_mean, HorizontalCombination::srss}) {
      const bool srss = combination == HorizontalCombination::srss;
      std::vector<double> sa = horizontal_spectrum_mps2(m, periods, combination, o.damping);
      for (std::size_t i = 0; i < sa.size(); ++i) {
        sa[i] = in_g(m.scale * sa[i]);
        if (srss) average[i] += sa[i] / static_cast<double>(suite.motions.size());
      }
      add(m.id + (srss ? "_srss" : "_geometric_mean"), sa);
    }
  }
  add("average_srss", average);
  if (suite.target) {
    const TargetSpectrum target(*suite.target);
    std::vector<double> mce_g;
    for (const double period : periods) mce_g.push_back(target.mce_sa_g(period));
    add("target_mce", mce_g);
  }
  deliver_csv(o.out, table);
}

ScalingRule rule_of(const SuiteOptions& o) {
  return of_option("--rule", [&] { return parse_scaling_rule(o.rule); });
}

/// Throws InputError where options are given that the rule does not have.
FirstPeriods building_of(const SuiteOptions& o, ScalingRule rule) {
  if (o.to_one_and_a_half && !is_of_16_2(rule))
    throw InputError({"--to-1.5t", "is of asce7_16 and asce7_22 (16.2.3.1)",
                      "leave it out: rules are not mixed", ""});
  if (!o.periods_s.empty() && rule == ScalingRule::walters_2012)
    throw InputError({"--period-s", "Walters's rule is from 0 to 2 s for every building",
                      "leave it out, or give another --rule", ""});
  if (rule == ScalingRule::walters_2012) return {};
  if (o.periods_s.empty())
    throw InputError({"--period-s", "is missing: the rule is of the building's first periods",
                      "give that of both axes, or both: --period-s 0.4 0.6", ""});
  const auto [shortest, longest] = std::ranges::minmax(o.periods_s);
  if (!(shortest > 0.0) || !(longest <= longest_probable_period_s))
    throw InputError({"--period-s",
                      fmt::format("{:g} and {:g} s are not above 0, up to {:g} s", shortest,
                                  longest, longest_probable_period_s),
                      "give the first periods of the building in s", ""});
  return {shortest, longest, o.to_one_and_a_half};
}

/// The suite with the factors of a rule, for MCE as all suite files.
void write_scaled(const SuiteOptions& o, const Suite& suite, const Table& table,
                  const RuleScaling& scaling) {
  SuiteHead head{
      suite.name,
      suite.description,
      read_stated_target(o.suite),
      {"Made by: glissade suite scale, from " + std::filesystem::path(o.suite).filename().string(),
       table.title},
      suite.nearest_to_target};
  head.comments.insert(head.comments.end(), table.notes.begin(), table.notes.end());
  std::vector<ScaledRecord> records;
  for (std::size_t i = 0; i < suite.motions.size(); ++i)
    records.push_back({suite.motions[i].id, scaling.factors[i]});
  write_text_file(o.out, suite_of_records_toml(o.suite, head, records,
                                               std::filesystem::path(o.out).parent_path()));
}

void scale(const SuiteOptions& o) {
  if (o.target != "mce" && o.target != "dbe")
    throw InputError({"--target", o.target + " is not a target", "give mce or dbe", ""});
  if (!o.out.empty() && o.target != "mce")
    throw InputError({"--out", "a suite file has the factors for MCE",
                      "leave out --target: a study scales them by mce_fraction", ""});
  const Suite suite = load_suite(o.suite);
  const TargetSpectrum target(target_of(suite, o.suite));
  const auto wanted = [&](double period) {
    return o.target == "mce" ? target.mce_sa_g(period) : target.design_sa_g(period);
  };
  const ScalingRule rule = rule_of(o);
  const RuleScaling scaling =
      scale_by_rule(suite, rule, building_of(o, rule), wanted, o.max_factor);
  const ScalingRuleText& text = text_of(rule);
  Table table{
      "scale",
      fmt::format("one factor per record for its three components, to the {} target: {}, {}",
                  o.target, text.clause, text.spectrum),
      {{"id", "", "id", ColumnKind::text}, {"scale", "", "scale"}},
      {},
      {fmt::format("average over the target from {:.3g} to {:.3g} s: lowest {:.4g} at {:.3g} "
                   "s, mean {:.4g}; largest factor {:.3f}; factors to "
                   "four decimals, in the suite of --out with all digits",
                   scaling.range.from_s, scaling.range.to_s, scaling.lowest.ratio,
                   scaling.lowest.period_s, scaling.mean_ratio, scaling.largest_factor)}};
  for (const std::string& warning : scaling.warnings) table.notes.push_back("WARNING: " + warning);
  for (std::size_t i = 0; i < suite.motions.size(); ++i)  // as suite files keep them
    table.add({suite.motions[i].id, std::round(1e4 * scaling.factors[i]) / 1e4});
  if (!o.out.empty()) write_scaled(o, suite, table, scaling);
  deliver_csv("", table);
}

void put_target(const SuiteOptions& o, const ConditionalOptions& conditional) {
  const ConditionalTarget target = conditional.target();
  Table table = target_table(target);
  table.title = conditional.sentence(target);
  for (const std::string& warning : conditional.warnings(target))
    table.notes.push_back("WARNING: " + warning);
  deliver_csv(o.out, table);
}

void design(const SuiteOptions& o) {
  const std::string origin =
      fmt::format("Made by: glissade suite design --level {} --seed {}", o.level, o.seed);
  deliver(o.out, recipe_toml(design_suite(o.level, o.seed), {origin}));
}

}  // namespace

void add_suite(CLI::App& program) {
  auto o = std::make_shared<SuiteOptions>();
  CLI::App* command = program.add_subcommand(
      "suite", "Import, show, scale, design or select a ground-motion suite");
  command->require_subcommand(1);
  const auto verb = [&](const char* name, const char* what, auto act) {
    CLI::App* sub = command->add_subcommand(name, what);
    sub->callback([o, act] {
      check_output_file(o->out, "--out", o->overwrite);
      act(*o);
    });
    return sub;
  };
  const auto takes_suite = [&](CLI::App* sub) {
    sub->add_option("suite", o->suite, "suite file (TOML); see suites/")->required();
  };
  CLI::App* show_verb =
      verb("show", "List the motions of a suite, or the components of record files", show);
  show_verb
      ->add_option("suite", o->suite,
                   "suite file (TOML), record file, or folder or archive of them")
      ->required();
  o->missing.add_to(*show_verb);
  show_verb->add_option("--out", o->out, "new CSV file with each component [none is written]");
  add_overwrite(*show_verb, o->overwrite);
  CLI::App* spectra_verb = verb("spectra", "Response spectra as CSV", spectra);
  takes_suite(spectra_verb);
  spectra_verb->add_option("--damping", o->damping, "damping ratio")->check(CLI::Range(0.0, 0.99));
  spectra_verb->add_option("--out", o->out, "file [standard output]");
  add_overwrite(*spectra_verb, o->overwrite);
  CLI::App* scale_verb =
      verb("scale", "Scale factors to the suite's target spectrum, by a rule", scale);
  takes_suite(scale_verb);
  scale_verb->add_option("--target", o->target, "mce or dbe (2/3 of it)");
  scale_verb->add_option("--rule", o->rule,
                         "walters_2012, asce7_10 (16.1.3.2), asce7_16, asce7_22 (16.2.3), or "
                         "single_period (RotD50 of each record)");
  scale_verb
      ->add_option("--period-s", o->periods_s,
                   "first period of the building, or those of both axes; not of walters_2012")
      ->expected(1, 2);
  scale_verb->add_flag("--to-1.5t", o->to_one_and_a_half,
                       "up to 1.5 T in place of 2 T, where an analysis justifies it (16.2.3.1)");
  scale_verb->add_option("--max-factor", o->max_factor, "largest factor allowed");
  scale_verb->add_option("--out", o->out, "new suite file with the factors [none is written]");
  add_overwrite(*scale_verb, o->overwrite);
  CLI::App* design_verb = verb(
      "design", "Design a built-in suite: recipe of seven simulated motions for an Intensity Level",
      design);
  design_verb->add_option("--level", o->level, "Walters's Seismic Intensity Level, 0 to 4")
      ->required();
  design_verb->add_option("--seed", o->seed, "seed of the simulation");
  design_verb->add_option("--out", o->out, "file [standard output]");
  add_overwrite(*design_verb, o->overwrite);
  auto conditional = std::make_shared<ConditionalOptions>();
  CLI::App* target_verb =
      verb("target", "The conditional spectrum of an earthquake and site at a known Sa, as CSV",
           [conditional](const SuiteOptions& options) { put_target(options, *conditional); });
  conditional->add_to(*target_verb);
  target_verb->add_option("--out", o->out, "file [standard output]");
  add_overwrite(*target_verb, o->overwrite);
  add_suite_import(*command);
  add_suite_select(*command);
}

}  // namespace glissade::cli
