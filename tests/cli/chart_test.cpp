// SPDX-License-Identifier: GPL-3.0-or-later
// `glissade run` of a study with [chart].
#include <gmock/gmock.h>

#include <sstream>

#include "cli/one_run.hpp"
#include "cli/small_study.hpp"
#include "facts.hpp"
#include "one_line.hpp"

namespace glissade::test {
namespace {

using testing::Not;

class ChartRun : public OneRun<small_chart> {
 protected:
  static std::string read(const std::string& name) { return read_file((out() / name).string()); }
};

TEST_F(ChartRun, leaves_a_table_to_read_clearances_from) {
  const std::string table = read("tables/chart.csv");
  EXPECT_THAT(table, states("clearance_m"));
  int rows = 0;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) rows += line.empty() ? 0 : 1;
  EXPECT_EQ(rows, 1 + 2 * 3 * 4);  // header; levels x slopes x frictions
}

TEST_F(ChartRun, leaves_figures_report_and_readings) {
  for (const char* name :
       {"figures/chart_contours.svg", "figures/chart_friction.svg", "figures/chart_period.svg",
        "figures/chart_intensity.svg", "tables/chart_readings.csv", "tables/chart_by_period.csv",
        "report.html", "results.h5", "run.json"})
    EXPECT_FALSE(read(name).empty()) << name;
  EXPECT_FALSE(std::filesystem::exists(out() / "tables/fragility.csv"));
}

TEST_F(ChartRun, reports_free_sliding_and_tipping_as_results) {
  // tan(6 deg) = 0.105 is more than the friction of 0.1: legal, and reported.
  EXPECT_THAT(read("tables/chart.csv"), states("inf"));
  EXPECT_THAT(read("run.json"), Not(testing::HasSubstr("error")));
  EXPECT_THAT(finished_.out, testing::ContainsRegex("[Tt]ip"));
}

TEST_F(ChartRun, is_made_again_from_its_results_file) {
  expect_report_gives_again({"tables/chart.csv", "figures/chart_contours.svg"});
}

TEST_F(ChartRun, a_chart_axis_of_one_value_is_refused_and_leaves_nothing) {
  const ScratchFolder folder;
  const std::string study =
      folder.write("chart.toml", replaced(small_chart(), "slope_deg = [0, 2, 6]", "slope_deg = 2"));
  const Finished child = run_program({"run", study, "--out", folder.path("out").string()});
  EXPECT_EQ(child.status, 2);
  EXPECT_THAT(child.err, states("roof.slope_deg"));
  EXPECT_EQ(folder.contents(), std::vector<std::string>{"chart.toml"});
}

TEST_F(ChartRun, prints_its_grid_when_asked_for_the_plan) {
  const Finished child = succeeding({"run", study_, "--dry-run"});
  // 2 periods x 3 slopes x 4 frictions, each under both signs of both components; of the flat roof
  // the signs do not differ.
  EXPECT_THAT(child.out, states("24 combinations", "4 orientations", "80 differ"));
}

TEST_F(ChartRun, says_that_one_component_acts) {
  EXPECT_THAT(read("tables/columns.csv"), states("one horizontal component"));
}

/// The small chart without what one axis alone has.
std::string small_chart_on_two_axes() {
  const std::string text = small_chart().substr(0, small_chart().find("[tipping]"));
  return replaced(text, "axes = 1\n\n[building]", "axes = 2\n\n[building]\nmass_ratio = 0.05");
}
using ChartOnTwoAxes = OneRun<small_chart_on_two_axes>;

TEST_F(ChartOnTwoAxes, says_that_both_components_act) {
  const std::string both = "both horizontal components";
  EXPECT_THAT(read_file((out() / "tables/columns.csv").string()), states(both));
  EXPECT_THAT(one_line(finished_.out), states(both));
  EXPECT_THAT(read_file((out() / "report.html").string()),
              testing::AllOf(testing::HasSubstr("full model"), testing::HasSubstr("mass 0.05")));
}

}  // namespace
}  // namespace glissade::test
