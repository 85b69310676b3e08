// SPDX-License-Identifier: GPL-3.0-or-later
// Every analysis with every quantity listed, and with none: checked, run, written, read and
// reported.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "analysis/in_files.hpp"
#include "plot/script.hpp"
#include "run_results.hpp"
#include "text/study_text.hpp"
#include "whole_report.hpp"

namespace glissade {
namespace {

/// What an analysis must have in its table; nothing as a rule.
const std::map<std::string, std::string> required_keys = {
    {"fragility", "thresholds_m = [0.001, 0.01]"},
    {"hazard", "k0 = 1e-3\nk = 2\ndesign_life_years = 25"},
    {"rare", "thresholds_m = [0.001]"},
    {"standards", "compare = [\"seaoc_pv1_2012\", \"asce7_16\"]"},
    {"tipping", "centre_of_mass_height_m = 0.5\nbase_width_m = 0.3"}};

/// Tables of a study file and the lines in them.
using StudyText = std::map<std::string, std::string>;

void add_analysis(StudyText& text, const AnalysisInFiles& analysis) {
  const auto keys = required_keys.find(analysis.table);
  text[analysis.table] = keys == required_keys.end() ? "" : keys->second;
  for (const StudyNeed& need : analysis.needs)  // "[fragility]": another one
    for (const AnalysisInFiles& other : analyses_in_files())
      if (other.table != nullptr && need.what == "[" + std::string(other.table) + "]")
        add_analysis(text, other);
}

/// A key of a study file, and what a study lists of it.
struct Listed {
  std::string table, key, values;
};

std::vector<Listed> listed_quantities() {
  std::vector<Listed> all{{"", "", ""},  // nothing
                          {"array", "support", "[\"isolated\", \"anchored\"]"},
                          {"array", "support", "[\"isolated\", \"no_array\"]"},
                          {"vertical", "use", "[\"none\", \"required\"]"},
                          {"friction", "value", "[\"sampled\", \"design\"]"},
                          {"orientation", "slope_axis", "[\"e_w\", \"n_s\"]"},
                          {"suite", "files", "[\"suite.toml\", \"other.toml\"]"},
                          {"intensity", "levels", "[1.3, 1.3005, 1.95]"}};  // two of the DBE
  for (const Parameter& p : parameters())
    all.push_back({p.table, p.key,
                   p.range.min >= 1.0 || p.key == std::string("response_modification")
                       ? "[1, 2]"
                       : "[0.2, 0.4]"});
  return all;
}

enum class Friction { one_value, drawn };

/// Of a study without what is listed.
std::string study_text(const AnalysisInFiles& analysis, const Listed& listed, int axes,
                       Friction friction) {
  StudyText text{
      {"study", "name = \"cell\"\nseed = 1"},
      {"suite", "file = \"suite.toml\""},
      {"intensity", "measure = \"sds_g\"\nlevels = [1.3, 1.95]"},
      {"model", "axes = " + std::to_string(axes)},
      {"building", "period_s = 0.3"},
      {"roof", "slope_deg = 1"},
      {"friction", friction == Friction::drawn ? "mu = { mean = 0.2, std = 0.02 }" : "mu = 0.2"}};
  add_analysis(text, analysis);
  const auto given = [&](const AnalysisInFiles& a) {
    return a.table != nullptr && text.contains(a.table);
  };
  const auto& all = analyses_in_files();
  if (std::ranges::none_of(all, [&](auto& a) { return given(a) && a.stands_alone; }))
    text["fragility"] = required_keys.at("fragility");
  const bool resamples = std::ranges::any_of(all, [&](const AnalysisInFiles& a) {
    return given(a) && std::ranges::count(a.uses, std::string("sampling.bootstrap_replicates")) > 0;
  });
  if (friction == Friction::drawn) text["sampling"] = "samples = 8\nscrambles = 8\n";
  if (resamples) text["sampling"] += "bootstrap_replicates = 100";
  if (text.contains("chart")) text["roof"] = "slope_deg = [0, 1]";
  // A quantity that has no effect without another one has it.
  const auto give = [&](const std::string& table, const std::string& key,
                        const std::string& value) {
    std::string& lines = text[table];
    const std::size_t at = ("\n" + lines).find("\n" + key + " = ");
    if (at != std::string::npos) lines.erase(at, lines.find('\n', at) - at);
    lines += "\n" + key + " = " + value;
  };
  if (listed.key == "files") text["suite"] = "";
  for (const Parameter& p : parameters()) {
    if (p.table != listed.table || p.key != listed.key || p.needs == nullptr) continue;
    if (text[p.table].find(p.needs) == std::string::npos) give(p.table, p.needs, "0.5");
  }
  if (listed.key == "hardening_ratio") give("building", "yield_coefficient", "0.2");
  if (!listed.key.empty()) give(listed.table, listed.key, listed.values);
  std::string whole;
  for (const auto& [table, lines] : text) whole += "[" + table + "]\n" + lines + "\n";
  return whole;
}

Motion short_motion(unsigned seed) {
  Motion m;
  m.id = "motion" + std::to_string(seed);
  m.dt_s = 0.02;
  m.horizontal_mps2 = {test::made_up_record(100, 10 * seed + 1, 3.0),
                       test::made_up_record(100, 10 * seed + 2, 2.0)};
  m.vertical_mps2 = test::made_up_record(100, 10 * seed + 3, 1.0);
  return m;
}

/// Whose S_DS is 1.3 g, so that levels may be the DBE.
Suite short_suite(unsigned first, unsigned records) {
  Suite suite;
  suite.name = "suite" + std::to_string(first);
  for (unsigned i = 0; i < records; ++i) suite.motions.push_back(short_motion(first + i));
  suite.target = DesignTarget{.edition = AsceEdition::asce7_16, .sds_g = 1.3, .sd1_g = 0.7};
  return suite;
}

void expect_unique(const std::vector<std::string>& names) {
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size())
      << testing::PrintToString(names);
}

void expect_unique_names(const Results& results) {
  std::vector<std::string> tables, figures;
  for (const Table& table : csv_tables(results)) {
    tables.emplace_back(table.name.text());
    std::vector<std::string> columns;
    for (const Column& column : table.columns)
      for (const std::string& name : file_names(column)) columns.push_back(name);
    expect_unique(columns);
  }
  for (const Figure& figure : make_figures(results)) {
    figures.emplace_back(figure.name.text());
    EXPECT_NE(gnuplot::script_of(figure), "");
  }
  expect_unique(tables);
  expect_unique(figures);
}

/// Whether it is not refused: then it can be run, written, read and reported.
bool goes_through(const std::string& text, const TemporaryFolder& folder) {
  const unsigned records = text.find("[intensity_measures]") == text.npos ? 3 : 5;
  std::optional<Plan> plan;
  try {
    const StudyConfig study = test::study_of(text);
    std::vector<Suite> suites;
    for (std::size_t i = 0; i < study.suite_files.size(); ++i)
      suites.push_back(short_suite(static_cast<unsigned>(5 * i), records));
    plan = make_plan(study, suites);
  } catch (const InputError&) {
    return false;
  }
  EXPECT_NE(to_string(*plan), "");
  const auto file = folder.path() / "results.h5";
  write_results(file, test::run(*plan));
  const Results results = read_results(file);
  EXPECT_NE(report_of(results).page, "");
  expect_unique_names(results);
  return true;
}

TEST(listed_quantities, are_run_and_reported_with_every_analysis) {
  const TemporaryFolder folder;
  const std::vector<Listed> quantities = listed_quantities();
  std::set<std::string> taken;
  for (const AnalysisInFiles& analysis : analyses_in_files()) {
    if (analysis.table == nullptr) continue;
    std::size_t cells = 0;
    for (const Listed& listed : quantities) {
      // The first of these studies that is not refused.
      for (const auto& [axes, friction] : {std::pair{2, Friction::one_value},
                                           {2, Friction::drawn},
                                           {1, Friction::one_value},
                                           {1, Friction::drawn}}) {
        const std::string text = study_text(analysis, listed, axes, friction);
        SCOPED_TRACE(text);
        bool is_taken = false;
        EXPECT_NO_THROW(is_taken = goes_through(text, folder));
        if (!is_taken) continue;
        ++cells;
        taken.insert(listed.table + "." + listed.key);
        break;
      }
    }
    EXPECT_GE(cells, quantities.size() / 3) << "[" << analysis.table << "] refuses nearly all";
  }
  for (const Listed& listed : quantities)
    EXPECT_TRUE(taken.contains(listed.table + "." + listed.key))
        << listed.table << "." << listed.key << " is refused with every analysis";
}

/// Two listed quantities of one name are two columns.
TEST(listed_quantities, have_columns_of_their_own) {
  std::vector<std::string> names;
  for (const Parameter& p : parameters()) names.push_back(file_names(listed_column(p)).front());
  expect_unique(names);
}

}  // namespace
}  // namespace glissade
