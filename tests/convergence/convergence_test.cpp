// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "cases.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/suite_file.hpp"
#include "report.hpp"
#include "unit/block/reference.hpp"

namespace glissade::convergence {
namespace {

constexpr std::array few_substeps{1, 2, 64, 128};

Motion motion(const std::string& id, std::vector<double> first) {
  Motion m;
  m.id = id;
  m.dt_s = 0.01;
  m.horizontal_mps2[0] = std::move(first);
  return m;
}

Case at_scene(const std::vector<Case>& cases, const Scene& wanted) {
  for (const Case& c : cases)
    if (c.scene.slope_deg == wanted.slope_deg && c.scene.mu == wanted.mu &&
        c.scene.ppa_g == wanted.ppa_g)
      return c;
  ADD_FAILURE() << "no such scene";
  return {};
}

TEST(convergence, the_papers_grid_is_540_runs) {
  EXPECT_EQ(paper_scenes().size() * paper_substeps.size(), 540u);
  EXPECT_EQ(paper_substeps[chosen_step], 64);
  EXPECT_EQ(paper_substeps[finest_step], 256);
}

TEST(convergence, a_free_slider_on_a_roof_at_rest_moves_by_half_a_t_squared) {
  // Physical check 2 of the paper: slope 7 deg, mu 0.1; in plan, at the last sample.
  const std::vector<Case> cases =
      run_cases(motion("a", test::made_up_record(300, 1, 1.0)), few_substeps);
  const double theta = 7.0 * rad_per_deg, t = 299 * 0.01;
  const double expected = 0.5 * standard_gravity_mps2 * (std::sin(theta) - 0.1 * std::cos(theta)) *
                          std::cos(theta) * t * t;
  EXPECT_NEAR(at_scene(cases, {7.0, 0.1, 0.0}).exact_residual_m, expected, 1e-12 * expected);
}

TEST(convergence, without_friction_a_flat_roof_moves_below_the_array_whatever_pads_the_record) {
  // A step of A over one interval, then linearly to zero: U = A dt^2 (1/2 + 1 + 1/3).
  for (const std::size_t zeros : {0u, 50u}) {
    std::vector<double> a(2 + zeros, 0.0);
    a[0] = a[1] = 2.0;
    const Case c = at_scene(run_cases(motion("a", a), few_substeps), {0.0, 0.0, 1.0});
    const double expected = -standard_gravity_mps2 * 1e-4 * 11.0 / 6.0;
    EXPECT_NEAR(c.exact_residual_m, expected, 1e-15);
    EXPECT_NEAR(c.residual_m[3], expected, 0.01 * std::abs(expected));
  }
}

TEST(convergence, twice_the_substeps_halve_the_error_of_a_first_order_scheme) {
  const Case c =
      at_scene(run_cases(motion("a", {2.0, 2.0, -1.0, 3.0}), few_substeps), {0.0, 0.0, 1.0});
  const auto error = [&](std::size_t step) { return error_of(c, step, Measure::exact_peak); };
  EXPECT_GT(error(3), 0.0);
  EXPECT_NEAR(error(1) / error(0), 0.5, 0.05);
  EXPECT_NEAR(error(3) / error(2), 0.5, 0.001);
}

TEST(convergence, every_record_is_scaled_to_the_scenes_peak) {
  std::vector<double> a = test::made_up_record(300, 2, 1.0), b = a;
  for (double& x : b) x *= 16.0;  // a power of two: to the last bit
  const std::vector<Case> of_a = run_cases(motion("a", a), few_substeps),
                          of_b = run_cases(motion("b", b), few_substeps);
  for (std::size_t i = 0; i < of_a.size(); ++i) EXPECT_EQ(of_a[i].residual_m, of_b[i].residual_m);
}

/// Four cases at P = 1, 64, 256, one of which does not slide.
std::vector<Case> by_hand() {
  return {{"a", {}, {0.0, 0.0, 0.0}, 0.0, 0.0, {}, 0.0},
          {"a", {}, {1.5, 1.1, 1.0}, 0.8, 2.0, {}, 0.0},
          {"b", {}, {-0.03, -0.019, -0.02}, -0.016, 0.5, {}, 0.0},
          {"b", {}, {0.3, 0.26, 0.2}, 0.19, 2.0, {}, 0.0}};
}

TEST(convergence, an_error_is_relative_to_what_its_measure_says) {
  const std::vector<Case> cases = by_hand();
  EXPECT_DOUBLE_EQ(error_of(cases[1], 0, Measure::finest), 0.5);
  EXPECT_DOUBLE_EQ(error_of(cases[1], 0, Measure::exact_residual), 0.7 / 0.8);
  EXPECT_DOUBLE_EQ(error_of(cases[1], 0, Measure::exact_peak), 0.35);
  for (const Measure m : {Measure::finest, Measure::exact_residual, Measure::exact_peak})
    EXPECT_TRUE(std::isnan(error_of(cases[0], 0, m)));
}

TEST(convergence, a_summary_has_the_largest_the_median_and_the_worst_of_the_cases_that_slide) {
  const std::vector<Case> cases = by_hand();  // at P = 64: 0.1, 0.05 and 0.3
  const ErrorSummary s = error_summary(cases, 1, Measure::finest);
  EXPECT_EQ(s.counted, 3u);
  EXPECT_NEAR(s.largest, 0.3, 1e-15);
  EXPECT_NEAR(s.median, 0.1, 1e-15);
  EXPECT_EQ(s.worst, &cases[3]);
  EXPECT_TRUE(std::isnan(error_summary({}, 1, Measure::finest).largest));
}

TEST(convergence, which_residuals_are_clear_depends_on_the_residual_that_decides) {
  const std::vector<Case> cases = by_hand();  // the last: 0.19 / 2 exact, 0.2 / 2 at the finest P
  EXPECT_NEAR(error_summary(cases, 1, Measure::finest, ClearBy::exact).largest, 0.1, 1e-15);
  EXPECT_NEAR(error_summary(cases, 1, Measure::finest, ClearBy::finest).largest, 0.3, 1e-15);
}

/// Rows of cells; the first are the columns' names.
std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

double value_at(const std::vector<std::vector<std::string>>& rows, std::size_t row,
                const std::string& column) {
  const auto at = std::ranges::find(rows[0], column);
  if (at == rows[0].end()) throw std::out_of_range(column);
  return std::stod(rows.at(row).at(static_cast<std::size_t>(at - rows[0].begin())));
}

TEST(convergence, the_table_has_a_row_for_each_group_and_p) {
  Group group{"made_up", "", {}};
  for (const char* id : {"a", "b"}) {
    group.cases.push_back({.record = id,
                           .residual_m = {2.0, 1.9, 1.8, 1.7, 1.6, 1.5, 1.25, 1.1, 1.0},
                           .exact_residual_m = 1.0,
                           .exact_peak_m = 2.0,
                           .scheme_s = {1, 2, 3, 4, 5, 6, 7, 8, 9},
                           .exact_s = 0.5});
  }
  group.cases[1].residual_m[chosen_step] = 1.004;
  const auto rows = rows_of(table_csv({group, group}));
  ASSERT_EQ(rows.size(), 1 + 2 * paper_substeps.size());
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  const std::size_t at_64 = 1 + chosen_step;
  EXPECT_EQ(value_at(rows, at_64, "substeps"), 64.0);
  EXPECT_EQ(value_at(rows, at_64, "largest_of_finest_percent"), 25.0);
  EXPECT_EQ(value_at(rows, at_64, "largest_of_exact_peak_percent"), 12.5);
  EXPECT_EQ(value_at(rows, at_64, "records_within_0.48_percent"), 1.0);
  EXPECT_NEAR(value_at(rows, at_64, "smallest_of_records_largest_of_finest_percent"), 0.4, 1e-12);
  EXPECT_EQ(value_at(rows, at_64, "scheme_longest_s"), 7.0);
}

TEST(convergence, the_committed_table_is_what_the_code_gives_for_its_first_record) {
  const auto rows = rows_of(read_text_file(
      GLISSADE_SOURCE_DIR "/tests/verification/figures/first_paper_convergence.csv"));
  ASSERT_EQ(rows.size(), 1 + 3 * paper_substeps.size());
  const Motion first =
      load_suite(GLISSADE_SOURCE_DIR "/suites/synthetic_far_field.toml").motions.front();
  ASSERT_EQ(rows[1][0], first.id);
  const std::vector<Case> cases = run_cases(first, std::span(paper_substeps).first(4));
  for (std::size_t step = 0; step < 4; ++step) {
    const ErrorSummary s = error_summary(cases, step, Measure::exact_peak);
    EXPECT_NEAR(value_at(rows, 1 + step, "largest_of_exact_peak_percent"), 100.0 * s.largest,
                1e-6 * s.largest);
    EXPECT_NEAR(value_at(rows, 1 + step, "median_of_exact_peak_percent"), 100.0 * s.median,
                1e-6 * s.median);
  }
}

TEST(convergence, the_figure_is_drawn) {
  Group group{"made_up", "2 motions", run_cases(motion("a", {1.0, -2.0, 1.5}), paper_substeps)};
  const auto svg = std::filesystem::path(testing::TempDir()) / "glissade_convergence.svg";
  std::filesystem::remove(svg);
  draw(std::span(&group, 1), svg);
  EXPECT_NE(read_text_file(svg).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace glissade::convergence
