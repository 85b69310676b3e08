// SPDX-License-Identifier: GPL-3.0-or-later
// Other analyses of finished results: glissade report --study.
#include "cli/one_run.hpp"
#include "cli/small_study.hpp"
#include "facts.hpp"
#include "one_line.hpp"

namespace glissade::test {
namespace {

std::string without_standards() {
  const std::string text = small_study();
  return text.substr(0, text.find("[standards]"));
}

class ReportOfStudy : public OneRun<without_standards> {
 protected:
  Finished report(const std::string& study, const std::string& to) const {
    return run_program({"report", (out() / "results.h5").string(), "--study",
                        folder_->write("other.toml", study), "--out", folder_->path(to).string()});
  }
};

TEST_F(ReportOfStudy, gives_what_a_run_of_that_study_gives) {
  const std::string text = small_study() +
                           "[shape]\n[hazard]\nk0 = 1e-4\nk = 2.0\ndesign_life_years = 25.0\n",
                    study = folder_->write("whole.toml", text);
  ASSERT_EQ(run_program({"run", study, "--out", folder_->path("run").string()}).status, 0);
  const Finished child = report(text, "again");
  ASSERT_EQ(child.status, 0) << child.err;
  EXPECT_FALSE(std::filesystem::exists(out() / "tables/standards.csv"));
  for (const char* table : {"tables/standards.csv", "tables/fragility.csv", "tables/slip.csv",
                            "tables/shape.csv", "tables/shape_models.csv", "tables/hazard.csv",
                            "tables/design_life.csv", "tables/design_life_distribution.csv"}) {
    const std::string again = read_file(folder_->path("again") / table);
    EXPECT_EQ(again, read_file(folder_->path("run") / table));
    EXPECT_THAT(again, has_rows_as_wide_as_its_header()) << table;
  }
  succeeding({"report", (folder_->path("again") / "results.h5").string(), "--overwrite"});
}

// Notes of the plan (an assumed curve; cases outside of SEAOC PV1's range), warnings, and what was
// skipped ("the study has no [standards]"): there, and gone again, as in a run of each study.
TEST_F(ReportOfStudy, says_what_a_run_of_that_study_says) {
  const std::string text = small_study() +
                           "[hazard]\nsds_g = 1.0\nk = 2.0\ndesign_life_years = 25.0\n",
                    study = folder_->write("assumed.toml", text);
  const Finished run = run_program({"run", study, "--out", folder_->path("assumed").string()});
  ASSERT_EQ(run.status, 0);
  const auto summary = [](const Finished& child) {
    EXPECT_EQ(child.status, 0) << child.err;
    return child.out.substr(0, child.out.rfind("\nReport "));
  };
  const std::string with = summary(report(text, "with"));
  EXPECT_THAT(one_line(with), states("it is not that of the site",
                                     "outside the range of the prescribed value of SEAOC"));
  EXPECT_THAT(with, testing::Not(states("no [standards]")));
  EXPECT_THAT(run.out, testing::HasSubstr(with));
  const std::string without =
      summary(run_program({"report", folder_->path("assumed/results.h5").string(), "--study",
                           study_, "--out", folder_->path("without").string()}));
  EXPECT_THAT(finished_.out, testing::HasSubstr(without));
}

TEST_F(ReportOfStudy, refuses_a_study_of_other_histories) {
  const std::string before = read_file(out() / "results.h5");
  const auto refused = [&](const Finished& child) {
    EXPECT_EQ(child.status, 2);
    EXPECT_EQ(child.out, "");
    EXPECT_TRUE(read_file(out() / "results.h5") == before);
  };
  refused(report(replaced(small_study(), "mean = 0.3", "mean = 0.4"), "refused"));
  refused(report(replaced(small_study(), "[0.05, 0.2]", "[0.05, 0.3]"), "refused"));
  EXPECT_FALSE(std::filesystem::exists(folder_->path("refused")));
  refused(run_program({"report", (out() / "results.h5").string(), "--study",
                       folder_->write("other.toml", small_study())}));
}

}  // namespace
}  // namespace glissade::test
