// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/in_files.hpp"
#include "enum_names.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "keys/grammar.hpp"
#include "keys/target_table.hpp"
#include "study/analysis_tables.hpp"
#include "study/case_tables.hpp"
#include "study/published_table.hpp"
#include "study/study_document.hpp"
#include "study/study_keys.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

/// Keys that go with one measure only.
void refuse_other_keys(const TomlTable& table, IntensityMeasure measure) {
  const auto key_of = [](IntensityMeasure of) {
    return std::string(of.own_key() != nullptr ? of.own_key() : "");
  };
  std::map<std::string, std::string> owners;
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i) {
    const IntensityMeasure owner = IntensityMeasure::number(i);
    std::string& names = owners[key_of(owner)];
    names += (names.empty() ? "" : " or ") + std::string(owner.key());
  }
  for (const auto& [key, names] : owners) {
    // A target also gives the strength of a building.
    if (key.empty() || key == key_of(measure) || key == "target" || !table.has(key.c_str()))
      continue;
    table.report(key.c_str(), table.name_of(key.c_str()) + " needs measure = " + names,
                 "leave it out, or measure by " + names);
  }
}

void check_scaling_rule(const TomlTable& table, const IntensityConfig& intensity) {
  if (!intensity.measure.is_of_design_spectrum())
    for (const char* key : {"scaling_rule", "to_1_5_t"})
      if (table.has(key))
        table.report(key,
                     fmt::format("{} is of a suite that is scaled to a design spectrum, and levels "
                                 "are of {}",
                                 table.name_of(key), intensity.measure.key()),
                     "leave it out, or measure by sds_g or mce_fraction");
  if (intensity.to_one_and_a_half && !is_of_16_2(intensity.scaling_rule))
    table.report("to_1_5_t", "intensity.to_1_5_t is of asce7_16 and asce7_22 (16.2.3.1)",
                 "leave it out: rules are not mixed");
}

void read_intensity(const TomlTable& table, const NumberRule& level_rule,
                    IntensityConfig& intensity) {
  std::string known;
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i)
    known += (i > 0 ? ", " : "") + std::string(IntensityMeasure::number(i).key());
  const auto name = table.text("measure");
  if (!table.has("measure")) table.report_missing("measure", "known are " + known);
  const auto measure = IntensityMeasure::named(name.value_or(""));
  NumberRule rule = level_rule;
  if (measure) rule.unit_key = measure->key();
  if (table.exists()) intensity.levels = read_increasing(table, "levels", rule);
  if (!measure) {
    if (name)
      table.report("measure", "intensity.measure = \"" + *name + "\" is not known",
                   "known are " + known);
    return table.ignore_unknown();
  }
  intensity.measure = *measure;
  if (measure == IntensityMeasure::sds_g && !intensity.levels.empty() &&
      intensity.levels.back() > most_possible_g)
    table.report(
        "levels",
        fmt::format("levels of S_DS are in g: no site has more than {:g} g", most_possible_g),
        fmt::format("if they are in percent of g, give {:g} for {:g}",
                    intensity.levels.back() / 100.0, intensity.levels.back()));
  const auto is_own = [&](const char* key) {
    return measure->own_key() != nullptr && measure->own_key() == std::string(key);
  };
  if (is_own("sa_period_s"))
    intensity.sa_period_s = table.required_number("sa_period_s", not_negative);
  if (is_own("avg_sa_periods_s"))
    intensity.avg_sa_periods_s = read_increasing(table, "avg_sa_periods_s", not_negative);
  check_scaling_rule(table, intensity);
  if (table.has("target")) intensity.target = read_target(table.table("target"));
  refuse_other_keys(table, *measure);
}

/// One suite by `file`, several by `files`, or one for each level by `stripes`.
void read_suites(const TomlTable& table, StudyConfig& study) {
  std::vector<std::string> names;
  for (const char* path : {"file", "files", "stripes"}) table.hash_without_folders(path);
  const char* key = table.has("stripes") ? "stripes" : table.has("files") ? "files" : "file";
  for (const char* other : {"file", "files"})
    if (key != std::string(other))
      table.refuse_both(
          key, other, "name one suite by file, several by files, or one for each level by stripes");
  if (key == std::string("file")) {
    names = {table.required_text("file", "several suites are suite.files = [...]")};
  } else {
    names = table.texts(key).value_or(names);
    if (table.is_empty_array(key))
      table.report(key, fmt::format("suite.{} is empty", key), "name at least one suite");
  }
  study.by_stripes = table.has("stripes");
  for (const std::string& name : names) {
    study.suite_files.push_back((study.file.parent_path() / name).lexically_normal());
    if (!name.empty() && !table.is_there(study.suite_files.back())) {
      table.report(key, "there is no suite " + study.suite_files.back().string(),
                   "give its path relative to the study file");
    }
  }
  study.normalise_by_pgv = table.choice<bool>("normalise", {{"pgv", true}}).value_or(false);
  study.records = table.texts("records").value_or(study.records);
  if (table.is_empty_array("records"))
    table.report("records", "suite.records is empty", "name at least one record, or leave it out");
}

/// A stripe is a suite and its level.
void check_stripes(const TomlTable& table, const StudyConfig& study) {
  const std::size_t suites = study.suite_files.size(), levels = study.intensity.levels.size();
  if (!study.by_stripes || suites == levels || suites == 0 || levels == 0) return;
  table.report("stripes",
               fmt::format("suite.stripes has {}, and intensity.levels {}",
                           counted(suites, "suite"), counted(levels, "level")),
               "name the suite of each level, in the order of the levels");
}

/// More than anybody can run, or hold the results of.
void check_size(const TomlTable& root, const StudyConfig& study) {
  constexpr double most = 5e7;
  double cases = static_cast<double>(study.intensity.levels.size()) *
                 static_cast<double>(study.support.size() * study.vertical.size()) *
                 static_cast<double>(SamplePoints(study).count());
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    if (!study.quantities[i].is_drawn())
      cases *= static_cast<double>(study.quantities[i].values.size());
  }
  if (cases > most)
    root.report("",
                "the study has more than fifty million combinations, samples and levels a record",
                "list fewer values, draw fewer samples, or divide the study");
}

}  // namespace

StudyConfig read_study(const std::filesystem::path& file) {
  TextFiles files;
  return read_study(file, files);
}

StudyConfig read_study(const std::filesystem::path& file, TextFiles& files) {
  TomlDocument document(file, &files);
  return read_study(document, file, files);
}

StudyConfig read_study(TomlDocument& document, const std::filesystem::path& file,
                       const TextFiles& files) {
  const TomlTable root = document.root();
  if (!root.has("study") && (root.has("project") || root.has("product")))
    throw InputError(
        {file.string(),
         root.has("project") ? "is a project file, not a study" : "is a product file, not a study",
         "run it with: glissade clearance " + quoted_for_shell(file.string()), ""});
  if (!root.has("study") && !root.has("suite"))
    throw InputError({file.string(), "is neither a study, [study], nor a project, [project]",
                      "`glissade init` writes either", ""});
  document.read_only([](const std::string& name) { return has_key(grammar(), name); });
  StudyConfig study;
  study.file = file;
  study.source_text = document.text();
  const auto read = [&](std::initializer_list<const char*> tables) {
    read_keys(study_tables(), tables, root, study);
  };
  root.required_table("study");
  read({"study"});
  read_suites(root.required_table("suite"), study);
  const bool fragility = root.has("fragility");
  read({"intensity"});
  read_intensity(root.required_table("intensity"), fragility ? above_zero : not_negative,
                 study.intensity);
  check_stripes(root.table("suite"), study);
  read({"model", "building", "vertical", "friction", "roof"});
  check_quantities(root, study);
  read_friction(root.required_table("friction"), usual_friction_values(root), study);
  read({"array", "sampling"});
  check_support(root.table("array"), study);
  check_sampling(root.table("sampling"), study.sampling);
  read({"orientation"});
  study.orientation.choice = OrientationChoice::as_recorded;
  // A chart and a clearance take the worst of all orientations, whatever else the study has.
  const bool is_worst = root.has("chart") || root.has("clearance");
  const bool drawn = fragility || root.has("sampling") || study.draws();
  study.orientation.choice =
      root.table("orientation")
          .choice<OrientationChoice>("choice", orientation_names)
          .value_or(is_worst || !drawn ? OrientationChoice::all_permutations
                    : study.intensity.measure == IntensityMeasure::factor
                        ? OrientationChoice::as_recorded  // with all else that is as given
                        : OrientationChoice::random);
  read_analyses(root, study);
  study.published = read_published(root);
  refuse_idle_keys(root, study);
  study.not_stated = keys_not_stated(root, study);
  check_size(root, study);
  document.finish();
  if (study.units == UnitSystem::us_customary) study.unmarked_numbers = document.unmarked_numbers();
  study.hashed_text = document.text_to_hash();
  study.data_files = files.texts();
  study.data_files.erase(file.filename().string());
  return study;
}

StudyConfig read_study_again(const std::filesystem::path& file, const Results& run) {
  auto tables = tables_where([](const AnalysisInFiles& a) { return a.of_any_run; });
  tables.emplace_back(published_table().name);
  StudyConfig study = read_study(file);
  if (toml_without(study.source_text, tables) != toml_without(run.study_text, tables))
    throw InputError({file.string(),
                      "differs from the study that was run in more than " + listed(tables),
                      "change or add these tables only, or run the study again", ""});
  for (const auto& [name, text] : study.data_files) {
    const auto of_run = run.study_data_files.find(name);
    const bool is_of_analysis = study.hazard && study.hazard->source == name;
    if (is_of_analysis || of_run == run.study_data_files.end() || of_run->second == text) continue;
    throw InputError({(file.parent_path() / name).string(),
                      "is not as it was when the study was run",
                      "restore it, or run the study again", ""});
  }
  return study;
}

}  // namespace glissade
