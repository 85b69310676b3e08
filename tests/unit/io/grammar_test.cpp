// SPDX-License-Identifier: GPL-3.0-or-later
#include "keys/grammar.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "glissade/core/file.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/study_grammar.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"
#include "toml/toml_table.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const fs::path source = GLISSADE_SOURCE_DIR;

std::set<std::string> names(bool tables) {
  std::set<std::string> all;
  for (const GrammarKey& key : grammar()) all.insert(tables ? key.table : key.name());
  return all;
}

class Grammar : public testing::Test {
 protected:
  Grammar() {
    folder_.write("suite.toml", "");
    fs::copy_file(source / "studies/data/pull_tests.csv", folder_.path() / "tests.csv");
    folder_.write("hazard.csv", "sds_g,annual_rate\n0.1,0.02\n0.5,0.002\n2,1e-5\n");
  }
  std::string error(const std::string& text) const {
    return message_of([&] { read_study(folder_.write("study.toml", text)); });
  }
  TemporaryFolder folder_;
};

/// "building.period_s" of each line of a study's tables, and "impact." of one with no keys.
std::set<std::string> keys_of(const std::string& text) {
  std::set<std::string> keys;
  std::istringstream lines(text);
  std::string table;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, std::regex(R"(\[+(\w+)\]+.*)"))) {
      table = match[1];
      keys.insert(table + ".");
    } else if (std::regex_match(line, match, std::regex(R"(\[+(\w+\.\w+)\]+.*)"))) {
      keys.insert(match[1]);
      table = "";
    } else if (!table.empty() && std::regex_match(line, match, std::regex(R"((\w+) *=.*)"))) {
      keys.insert(table + "." + match[1].str());
    }
  }
  return keys;
}

TEST_F(Grammar, has_an_example_of_every_key_that_is_accepted) {
  std::set<std::string> used;
  for (const char* name :
       {"all_keys", "avg_sa", "building_modes", "building_storeys", "chart", "clearance", "hazard",
        "intensity_measures", "pga_normal", "ppa", "pull_tests", "rare", "sa", "sensitivity",
        "stripes", "verdict", "verdict_valley"}) {
    const std::string text =
        read_text_file(source / "tests/fuzz/corpus/study" / (std::string(name) + ".toml"));
    EXPECT_EQ(error(text), "") << name;
    used.merge(keys_of(text));
  }
  const std::set<std::string> known = names(false);
  for (const std::string& name : known) EXPECT_TRUE(used.contains(name)) << name;
  for (const std::string& name : used)
    EXPECT_TRUE(name.ends_with(".") || known.contains(name)) << name;
}

TEST_F(Grammar, has_every_key_that_can_be_read_at_all) {
  TomlDocument document(folder_.write(
      "study.toml", "[friction]\nmu = { mean = 0.5, std = 0.1, colour = 1 }\ncolour = 1\n"));
  document.read_only([](const std::string& name) { return has_key(grammar(), name); });
  const TomlTable root = document.root(), friction = root.table("friction"),
                  mu = friction.table("mu");
  EXPECT_EQ(mu.required_number("mean"), 0.5);
  EXPECT_FALSE(mu.has("log_std"));
  EXPECT_THROW(static_cast<void>(root.has("paint")), std::logic_error);
  EXPECT_THROW(static_cast<void>(friction.number("colour")), std::logic_error);
  EXPECT_THROW(static_cast<void>(mu.number("colour")), std::logic_error);
  EXPECT_THROW(static_cast<void>(root.table("chart").table("read").number("ss_g")),
               std::logic_error);
}

TEST_F(Grammar, begins_each_table_with_what_is_required) {
  EXPECT_EQ(grammar().front().name(), "study.name");
  const auto first_of = [](const std::string& table) {
    const auto all = grammar();
    return std::ranges::find(all, table, &GrammarKey::table)->key;
  };
  EXPECT_EQ(first_of("friction"), "mu");
  EXPECT_EQ(first_of("standards"), "compare");
}

TEST_F(Grammar, page_is_the_one_in_the_studies_folder) {
  EXPECT_EQ(read_text_file(source / "studies/GRAMMAR.md"), grammar_page())
      << "glissade explain --markdown > studies/GRAMMAR.md";
}

TEST(grammar_text, of_a_table_or_a_key_is_that_alone) {
  EXPECT_THAT(grammar_text("building"), HasSubstr("period_ratio"));
  EXPECT_THAT(grammar_text("building"), Not(HasSubstr("[friction]")));
  EXPECT_THAT(grammar_text("building.damping"), Not(HasSubstr("period_ratio")));
  EXPECT_EQ(grammar_text("bulding"), "");
  EXPECT_THAT(grammar_text("triangular"), HasSubstr("min, mode, max"));
  for (const GrammarKey& key : grammar()) {
    EXPECT_THAT(grammar_text(""), HasSubstr("[" + key.table + "]"));
    // In lines of a terminal.
    std::string text, value;
    for (const std::string& word : wrapped(grammar_text(key.name()), 1)) text += word + " ";
    for (const std::string& word : wrapped(key.value, 1)) value += word + " ";
    EXPECT_THAT(text, HasSubstr(value));
  }
}

}  // namespace
}  // namespace glissade
