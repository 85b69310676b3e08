// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path root = GLISSADE_SOURCE_DIR;

// src/README.md, the modules.
const std::map<std::string, std::set<std::string>> may_include = {
    {"core", {}},
    {"motion", {"core"}},
    {"building", {"core"}},
    {"block", {"core", "building"}},
    {"sampling", {"core"}},
    {"fragility", {"core"}},
    {"standards", {"core"}},
    {"study", {"core", "motion", "building", "block", "sampling", "fragility", "standards"}},
    {"design", {"core", "motion", "building", "sampling", "fragility", "standards", "study"}},
    {"parallel", {"core"}},
    {"io", {"core", "motion", "building", "sampling", "fragility", "standards", "study", "design"}},
    {"report", {"core", "motion", "sampling", "fragility", "standards", "study", "design"}},
    {"cli",
     {"core", "motion", "building", "block", "sampling", "fragility", "standards", "study",
      "design", "parallel", "io", "report"}},
};

struct Include {
  std::string file, module, header;
};

std::vector<fs::path> sources_below(const fs::path& folder) {
  std::vector<fs::path> found;
  if (!fs::exists(folder)) return found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
      found.push_back(entry.path());
  }
  return found;
}

std::vector<Include> includes() {
  std::vector<Include> found;
  const std::regex line_form(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  for (const auto& [module, allowed] : may_include) {
    for (const fs::path& folder : {root / "src" / module, root / "include" / "glissade" / module}) {
      for (const fs::path& file : sources_below(folder)) {
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);) {
          std::smatch match;
          if (std::regex_search(line, match, line_form))
            found.push_back({file.string(), module, match[1]});
        }
      }
    }
  }
  return found;
}

TEST(architecture, modules_include_only_what_lies_below_them) {
  int checked = 0;
  for (const Include& include : includes()) {
    if (!include.header.starts_with("glissade/")) continue;
    const std::string target = include.header.substr(9, include.header.find('/', 9) - 9);
    ++checked;
    EXPECT_TRUE(target == include.module || may_include.at(include.module).contains(target))
        << include.file << " includes " << include.header;
  }
  EXPECT_GT(checked, 100);
}

// src/README.md, the folders of src/block.
const std::vector<std::string> block_folders = {"contact", "polynomial", "slip_record", "events",
                                                "tables",  "full_model", "two_axes"};

TEST(architecture, folders_of_block_include_only_those_listed_before_them) {
  const auto place_of = [](const std::string& path) {
    const std::size_t at = path.find("block/") + 6;
    return std::ranges::find(block_folders, path.substr(at, path.find('/', at) - at));
  };
  int checked = 0;
  for (const Include& include : includes()) {
    if (!include.header.starts_with("block/")) continue;
    ASSERT_NE(place_of(include.header), block_folders.end()) << include.header;
    EXPECT_LE(place_of(include.header), place_of(include.file))
        << include.file << " includes " << include.header;
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(architecture, mpi_hdf5_and_toml_stay_in_their_rooms) {
  for (const Include& include : includes()) {
    const auto only_in = [&](const std::string& start, const std::string& module) {
      if (include.header.starts_with(start)) {
        EXPECT_EQ(include.module, module) << include.file << " includes " << include.header;
      }
    };
    only_in("mpi.h", "parallel");
    only_in("hdf5.h", "io");
    only_in("H5", "io");
    only_in("toml++", "io");
    only_in("CLI/", "cli");
  }
}

/// "1.2" and "Two axes" of a heading "## 1.2 Two axes".
std::set<std::string> theory_sections() {
  std::set<std::string> sections;
  std::ifstream in(root / "src" / "theory.md");
  const std::regex heading(R"re(^#+ (?:(\d+(?:\.\d+)?)\.? )?(.*)$)re");
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, heading)) continue;
    sections.insert(match[1]);
    sections.insert('"' + match[2].str() + '"');
  }
  return sections;
}

TEST(architecture, citations_of_theory_name_sections_that_exist) {
  const std::set<std::string> sections = theory_sections();
  const std::regex citation(R"re(theory\.md(?: section|,) (\d+(?:\.\d+)?|"[^"]*"))re");
  int checked = 0;
  for (const char* folder : {"src", "include", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp" && extension != ".md") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        for (std::sregex_iterator at(line.begin(), line.end(), citation), end; at != end; ++at) {
          ++checked;
          EXPECT_TRUE(sections.contains((*at)[1])) << entry.path() << ": " << at->str();
        }
      }
    }
  }
  EXPECT_GT(checked, 10);
}

// Two classes of one qualified name break the one-definition rule without a word from the linker,
// and differ in layout when it matters. Classes of namespaces begin a line (clang-format sees to
// it).
TEST(architecture, no_two_classes_have_one_name) {
  const std::regex definition(
      R"re(^(?:class|struct|union|enum|enum class) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: : [^;]*)?(?: \{.*)?$)re");
  std::map<std::string, std::string> file_of;
  for (const char* folder : {"src", "include"}) {
    for (const fs::path& file : sources_below(root / folder)) {
      std::ifstream in(file);
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, definition)) continue;
        const auto [other, is_new] = file_of.emplace(match[1], file.string());
        EXPECT_TRUE(is_new) << match[1] << " is defined in " << other->second << " and in " << file;
      }
    }
  }
  EXPECT_GT(file_of.size(), 300u);
}

// Names in files must not act on the terminal: cli/shared/put.hpp makes all that is written
// printable.
TEST(architecture, standard_output_is_written_in_one_place) {
  const std::regex print(R"re(fmt::print\(|std::cout|\bputs\(|write_result\()re");
  int found = 0;
  for (const fs::path& file : sources_below(root / "src")) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (file.stem() == "say" || !std::regex_search(text, print)) continue;
    ++found;
    EXPECT_EQ(file.filename(), "put.hpp") << file;
  }
  EXPECT_EQ(found, 1);
}

TEST(architecture, top_level_holds_the_agreed_folders_only) {
  const std::set<std::string> agreed = {"src",   "include", "suites", "studies",
                                        "tests", "cluster", "build",  "results"};
  for (const auto& entry : fs::directory_iterator(root)) {
    const std::string name = entry.path().filename();
    if (entry.is_directory() && !name.starts_with(".")) {
      EXPECT_TRUE(agreed.contains(name)) << name;
    }
  }
}

}  // namespace
