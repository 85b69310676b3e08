// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../src/io/study/grammar.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "glissade/core/file.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/study_grammar.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

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
    if (std::regex_match(line, match, std::regex(R"(\[(\w+)\].*)"))) {
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

/// Every word that stands in quotes in the reader's sources: its keys are among them.
std::set<std::string> words_of_the_reader() {
  std::vector<fs::path> files = {source / "src/study/cases/parameters.cpp",
                                 source / "src/study/intensity_measure.cpp"};
  for (const char* folder : {"src/io/study", "src/io/analysis"}) {
    for (const auto& entry : fs::directory_iterator(source / folder)) files.push_back(entry.path());
  }
  std::set<std::string> words;
  const std::regex word(R"re("([a-z][a-z0-9_]*)")re");
  for (const fs::path& file : files) {
    if (file.filename() == "grammar.cpp") continue;
    const std::string text = read_text_file(file);
    for (auto at = std::sregex_iterator(text.begin(), text.end(), word);
         at != std::sregex_iterator(); ++at)
      words.insert((*at)[1]);
  }
  return words;
}

TEST_F(Grammar, has_every_key_that_the_reader_knows) {
  const std::map<std::string, std::string> needed = {
      {"study", "name = \"s\"\n"},
      {"suite", "file = \"suite.toml\"\n"},
      {"intensity", "measure = \"sds_g\"\nlevels = [1]\n"},
      {"friction", "mu = 0.5\n"},
      {"fragility", "thresholds_m = [0.3]\n"}};
  const std::set<std::string> tables = names(true), keys = names(false),
                              words = words_of_the_reader();
  ASSERT_TRUE(words.contains("stop_at_largest") && words.contains("avg_sa_periods_s"));
  // What a study with these words in a table is refused with; "" is the root.
  const auto refusal = [&](const std::string& table, const std::set<std::string>& with) {
    std::string keys_given, text;
    for (const std::string& word : with) keys_given += word + " = 0\n";
    if (table.empty()) text = keys_given;
    for (const auto& [name, lines] : needed) {
      if (!table.empty() || !with.contains(name))
        text += "[" + name + "]\n" + lines + (name == table ? keys_given : "");
    }
    if (!table.empty() && !needed.contains(table)) text += "[" + table + "]\n" + keys_given;
    return error(text);
  };
  const auto known_in = [&](const std::string& table) {
    std::set<std::string> left = words;
    if (needed.contains(table))
      std::erase_if(left, [&](const std::string& word) {
        return ("\n" + needed.at(table)).find("\n" + word + " =") != std::string::npos;
      });
    const std::string before = table.empty() ? " " : " " + table + ".";
    const auto keep_known = [&](const std::string& message) {
      std::erase_if(left, [&](const std::string& word) {
        return message.find(before + word + " is not a known key") != std::string::npos;
      });
    };
    keep_known(refusal(table, left));
    // One at a time, where one of the others ended the reading of the table.
    for (const std::string& word : std::set<std::string>(left)) keep_known(refusal(table, {word}));
    return left;
  };
  std::size_t known = 0;
  for (const std::string& word : known_in("")) EXPECT_TRUE(tables.contains(word)) << word;
  for (const std::string& table : tables) {
    for (const std::string& word : known_in(table)) {
      EXPECT_TRUE(keys.contains(table + "." + word)) << table + "." + word;
      ++known;
    }
  }
  EXPECT_GT(known, 40u);
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

TEST_F(Grammar, every_key_with_a_need_is_a_key) {
  const std::set<std::string> keys = names(false);
  for (const KeyNeeds& n : key_needs())
    EXPECT_TRUE(keys.contains(std::string(n.table) + "." + n.key)) << n.key;
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
