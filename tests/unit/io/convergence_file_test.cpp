// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/convergence_file.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "glissade/core/file.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::HasSubstr;

const std::string grid = R"([study]
name = "c"
[suite]
file = "suite.toml"
[convergence]
slope_deg = [-7, 0, 7]
mu = [0, 0.5]
ppa_g = { from = 0.5, to = 1.5, count = 3 }
substeps = [1, 16, 256]
component = "second"
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

class ConvergenceStudy : public testing::Test {
 protected:
  ConvergenceStudy() { folder_.write("suite.toml", "[suite]\nname = \"s\"\n"); }
  std::string problems_of(const std::string& text) const {
    try {
      read_convergence_study(folder_.write("study.toml", text));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  TemporaryFolder folder_;
};

TEST_F(ConvergenceStudy, is_read_as_it_is_written) {
  const auto file = folder_.write("study.toml", grid);
  EXPECT_TRUE(is_convergence_study(file));
  const ConvergenceConfig c = read_convergence_study(file);
  EXPECT_EQ(c.slope_deg, (std::vector<double>{-7, 0, 7}));
  EXPECT_EQ(c.mu, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(c.ppa_g, (std::vector<double>{0.5, 1.0, 1.5}));
  EXPECT_EQ(c.substeps, (std::vector<int>{1, 16, 256}));
  EXPECT_EQ(c.component, HorizontalComponent::second);
  EXPECT_EQ(c.source_text, grid);
  EXPECT_TRUE(c.records.empty());
}

TEST_F(ConvergenceStudy, other_studies_are_not_one) {
  EXPECT_FALSE(is_convergence_study(folder_.write("study.toml", "[study]\nname = \"x\"\n")));
  EXPECT_THROW(is_convergence_study(folder_.path() / "none.toml"), InputError);
  EXPECT_THROW(is_convergence_study(folder_.write("study.toml", "[study")), InputError);
}

TEST_F(ConvergenceStudy, what_is_wrong_is_told_with_its_line) {
  struct Case {
    const char *from, *to, *told;
  };
  for (const Case& c : {
           Case{"[1, 16, 256]", "[]", "study.toml:9: convergence.substeps is empty"},
           Case{"[1, 16, 256]", "[64]", "study.toml:9: convergence.substeps has one value"},
           Case{"[1, 16, 256]", "[1, 2.5]", "substeps = 2.5 is not a whole number"},
           Case{"[1, 16, 256]", "[0, 1]", "substeps = 0 is not a whole number, 1 to"},
           Case{"[1, 16, 256]", "[16, 1]", "substeps is not increasing"},
           Case{"[1, 16, 256]", "64", "not a list of numbers"},
           Case{"[-7, 0, 7]", "[]", "study.toml:6: convergence.slope_deg is empty"},
           Case{"[-7, 0, 7]", "[-95, 0]", "slope_deg = -95 is not in degrees"},
           Case{"[0, 0.5]", "[-0.5]", "mu = -0.5 is not from 0 to 10"},
           Case{"mu =", "# mu =", "convergence.mu is missing"},
           Case{"mu =", "friction =", "convergence.friction is not a known key"},
           Case{"{ from = 0.5, to = 1.5, count = 3 }", "[0]", "no value above 0"},
           Case{"\"second\"", "\"third\"", "component = \"third\" is not known"},
           Case{"suite.toml", "sweet.toml", "there is no suite"},
           Case{"\"suite.toml\"", "\"suite.toml\"\nrecords = []", "suite.records is empty"},
           Case{"[convergence]", "[friction]\nmean = 0.5\n[convergence]",
                "study.toml:5: friction is not a known key"},
       }) {
    EXPECT_THAT(problems_of(replaced(grid, c.from, c.to)), HasSubstr(c.told)) << c.to;
  }
}

TEST(convergence_studies, that_come_with_glissade_are_the_papers_540_runs_a_record) {
  for (const char* name :
       {"04_rodriguez_nikl_convergence", "05_rodriguez_nikl_convergence_recorded"}) {
    const ConvergenceConfig c = read_convergence_study(std::filesystem::path(GLISSADE_SOURCE_DIR) /
                                                       "studies" / (std::string(name) + ".toml"));
    EXPECT_EQ(c.slope_deg, (std::vector<double>{-7, -4, 0, 4, 7}));  // the paper, "Convergence"
    EXPECT_EQ(c.mu, (std::vector<double>{0, 0.1, 0.5}));
    EXPECT_EQ(c.ppa_g, (std::vector<double>{0, 0.18, 1.0, 1.44}));
    EXPECT_EQ(c.substeps, (std::vector<int>{1, 2, 4, 8, 16, 32, 64, 128, 256}));
  }
}

ConvergenceResults made_up() {
  ConvergenceResults r;
  r.study_name = "made up";
  r.study_description = "a description";
  r.program_version = "0.0";
  r.plan_hash = "abc";
  r.study_text = grid;
  r.suite_name = "s";
  r.suite_description = "two records";
  r.component = HorizontalComponent::second;
  r.substeps = {1, 64, 256};
  r.scenes = {{-7.0, 0.1, 0.18}, {0.0, 0.0, 1.44}};
  r.records = {{"a", "event", "station", 0.01, 100, 0.25}, {"b", "", "", 0.005, 7, 1.0 / 3}};
  r.residual_m = Array3<double>(2, 2, 3);
  for (std::size_t i = 0; i < r.residual_m.data.size(); ++i)
    r.residual_m.data[i] = std::sqrt(static_cast<double>(i)) - 1.0;
  r.exact = {{0.1, 0.2, 0}, {-1.0 / 3, 0.5, 1}, {0.0, 0.0, 0}, {1e-9, 2.0, 0}};
  return r;
}

TEST(convergence_file, gives_back_every_bit) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "results.h5";
  const ConvergenceResults written = made_up();
  write_convergence(file, written);
  EXPECT_TRUE(is_convergence_results(file));
  const ConvergenceResults read = read_convergence(file);
  EXPECT_EQ(read.residual_m.data, written.residual_m.data);
  EXPECT_EQ(read.substeps, written.substeps);
  EXPECT_EQ(read.component, written.component);
  EXPECT_EQ(read.study_text, written.study_text);
  EXPECT_EQ(read.records[1].samples, 7u);
  EXPECT_EQ(read.scenes[1].ppa_g, 1.44);
  ASSERT_EQ(read.exact.size(), written.exact.size());
  for (std::size_t i = 0; i < read.exact.size(); ++i) {
    EXPECT_EQ(read.exact[i].residual_m, written.exact[i].residual_m);
    EXPECT_EQ(read.exact[i].peak_m, written.exact[i].peak_m);
    EXPECT_EQ(read.exact[i].uplift, written.exact[i].uplift);
  }
  write_convergence(folder.path() / "again.h5", read);
  EXPECT_EQ(read_text_file(folder.path() / "again.h5"), read_text_file(file));
}

TEST(convergence_file, other_files_are_no_such_results) {
  const TemporaryFolder folder;
  EXPECT_FALSE(is_convergence_results(folder.path() / "none.h5"));
  EXPECT_FALSE(is_convergence_results(folder.path()));
  EXPECT_FALSE(is_convergence_results(folder.write("text.h5", "text")));
  EXPECT_THROW(read_convergence(folder.path() / "none.h5"), InputError);
  EXPECT_THROW(read_convergence(folder.path() / "text.h5"), InputError);
}

TEST(convergence_file, results_whose_parts_do_not_fit_are_refused) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "results.h5";
  ConvergenceResults results = made_up();
  results.substeps = {1, 64, 64};
  write_convergence(file, results);
  EXPECT_THROW(read_convergence(file), InputError);
  results = made_up();
  results.scenes.pop_back();
  results.exact.resize(2);
  write_convergence(file, results);
  EXPECT_THROW(read_convergence(file), InputError);
}

TEST(convergence_file, cut_anywhere_is_refused) {
  const TemporaryFolder folder;
  write_convergence(folder.path() / "results.h5", made_up());
  const std::string whole = read_text_file(folder.path() / "results.h5");
  for (std::size_t length = 0; length < whole.size(); length += whole.size() / 50)
    EXPECT_THROW(read_convergence(folder.write("cut.h5", whole.substr(0, length))), InputError);
}

}  // namespace
}  // namespace glissade
