// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/convergence_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "one_line.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Two records, three scenes (the first at rest), P = 1, 64, 256. The second scene of b comes back
/// near to where it began.
ConvergenceResults made_up() {
  ConvergenceResults r;
  r.study_name = "made <up>";
  r.study_text = "[convergence]";
  r.suite_name = "s";
  r.substeps = {1, 64, 256};
  r.scenes = {{0.0, 0.5, 0.1}, {0.0, 0.5, 1.0}, {7.0, 0.1, 1.0}};
  r.records = {{"a", "event", "", 0.01, 10, 0.3}, {"b", "", "", 0.01, 10, 0.3}};
  r.residual_m = Array3<double>(2, 3, 3);
  r.residual_m.data = {0, 0, 0, 1.5, 1.002, 1.0,  -2.2, -2.004, -2.0,
                       0, 0, 0, 0.5, 0.02,  0.01, 1.2,  1.001,  1.0};
  r.exact = {{0, 0, 0}, {0.999, 1.0, 0}, {-1.998, 2.0, 0},
             {0, 0, 0}, {0.008, 2.0, 0}, {1.0, 1.0, 0}};
  return r;
}

ConvergenceTimes made_up_times() {
  return {
      {{0.001, 0.0005}, {0.064, 0.032}, {0.256, 0.128}}, {2e-4, 1e-4}, {2e-5, 1e-5}, {4e-4, 3e-4}};
}

std::string line_of(const std::string& csv, const std::string& start) {
  const std::size_t begin = csv.find("\n" + start + ",") + 1;
  return csv.substr(begin, csv.find('\n', begin) - begin);
}

TEST(convergence_report, the_table_tells_errors_and_times_by_p) {
  const std::string csv = to_csv(convergence_table(made_up(), made_up_times()));
  EXPECT_THAT(csv, HasSubstr("largest_error_of_finest_percent"));
  EXPECT_THAT(csv, HasSubstr("longest_time_s"));
  const std::string at_64 = line_of(csv, "64");
  // By hand: |0.02 / 0.01 - 1| = 100 % is the largest, of b's second scene; four histories count.
  EXPECT_THAT(at_64, HasSubstr("64,100,"));
  EXPECT_THAT(at_64, HasSubstr(",4,\"b, slope 0 deg, mu 0.5, 1 g\""));
  EXPECT_THAT(at_64, testing::EndsWith(",0.064,0.032"));
}

TEST(convergence_report, unknown_times_are_empty_fields) {
  EXPECT_THAT(line_of(to_csv(convergence_table(made_up(), {})), "64"), testing::EndsWith(",,"));
}

TEST(convergence_report, the_scenes_table_tells_what_each_did) {
  const std::string csv = to_csv(convergence_scenes_table(made_up()));
  EXPECT_THAT(csv, HasSubstr("residual_p256_m"));
  EXPECT_THAT(csv, HasSubstr("a,0,0.5,0.1,rests,0,0,0,0,0,0\n"));
  EXPECT_THAT(csv, HasSubstr("a,0,0.5,1,slips,0,1,0.999,1.5,1.002,1\n"));
  EXPECT_THAT(csv, HasSubstr("a,7,0.1,1,slides freely,"));  // tan 7 deg = 0.123
}

TEST(convergence_report, sentences_tell_what_the_paper_states_beside_what_came_out) {
  const std::string text = test::one_line(convergence_summary(made_up(), made_up_times()));
  for (const char* part :
       {"In 2 of the 6 cases nothing slides", "Largest error at P = 64 against P = 256: 100 %",
        "The paper states 0.48 % at P = 64", "Tokachi-Oki 2003, which is not available here",
        // a: 0.2 % and 0.2 %; b: 100 % and 0.1 %
        "75 % of the cases are within that", "is from 0.200 % to 100 %",
        "0.48 % or less on 1 of 2 records",
        // |0.02 - 0.008| of 0.008, and the largest of the peak, |-2.004 + 1.998| / 2
        "it is 150 % of the residual", "its residual is 0.00800 m where the peak is 2.00 m",
        "P = 64: 64.0 ms (median 32.0 ms); the paper states less than 0.09 s"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(convergence_summary(made_up(), {}), Not(HasSubstr("less than 0.09 s")));
}

TEST(convergence_report, the_figure_leaves_zero_errors_out_of_its_logarithms) {
  const Figure figure = convergence_figure(made_up(), made_up_times());
  EXPECT_THAT(figure.data, HasSubstr("\n256 nan "));  // P = 256 against itself
  EXPECT_THAT(figure.data, HasSubstr("64 0.48 0.09"));
  EXPECT_THAT(convergence_figure(made_up(), {}).body, Not(HasSubstr("x1y2")));
}

fs::path fresh(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / name;
  fs::remove_all(folder);
  return folder;
}

TEST(convergence_report, leaves_a_page_tables_and_a_figure) {
  const fs::path folder = fresh("glissade_convergence_whole");
  write_convergence_report(made_up(), made_up_times(), folder);
  for (const char* name : {"tables/convergence.csv", "tables/records.csv", "tables/scenes.csv",
                           "figures/convergence.pdf", "figures/convergence.svg"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  const std::string html = read_text_file(folder / "report.html");
  EXPECT_THAT(html, HasSubstr("made &lt;up&gt;"));
  EXPECT_THAT(html, HasSubstr("id=\"figure_convergence\""));
  EXPECT_THAT(html, HasSubstr("The paper states 0.48 %"));
}

TEST(convergence_report, where_nothing_slides_there_is_still_a_report) {
  ConvergenceResults r = made_up();
  r.scenes.resize(1);
  r.residual_m = Array3<double>(2, 1, 3, 0.0);
  r.exact.assign(2, ExactSlip{});
  const fs::path folder = fresh("glissade_convergence_at_rest");
  write_convergence_report(r, made_up_times(), folder);
  EXPECT_TRUE(fs::exists(folder / "figures/convergence.svg"));
  EXPECT_THAT(test::one_line(convergence_summary(r, {})),
              HasSubstr("In 2 of the 2 cases nothing slides"));
}

TEST(convergence_report, uplift_is_told) {
  ConvergenceResults r = made_up();
  r.exact[2].uplift = 1;
  EXPECT_THAT(convergence_summary(r, {}), HasSubstr("In 1 of 6 cases the array lifts off"));
}

TEST(convergence_report, throws_an_input_error_where_it_cannot_write) {
  EXPECT_THROW(write_convergence_report(made_up(), {}, "/dev/null/report"), InputError);
}

}  // namespace
}  // namespace glissade
