// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/design/product.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/one_package.hpp"
#include "cli/small_study.hpp"
#include "cli/table_rows.hpp"
#include "facts.hpp"
#include "glissade/design/design_clearance.hpp"
#include "one_line.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ProductSheet : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    finished_ = run_program(
        {"clearance", folder_->write("product.toml", small_product()), "--out", out().string()});
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path out() { return folder_->path("out"); }

  static std::vector<Row> table(const fs::path& csv) { return rows_of(read_file(out() / csv)); }

  static inline ScratchFolder* folder_ = nullptr;
  static inline Finished finished_;
};

TEST_F(ProductSheet, has_every_level_in_one_table_in_its_unit_rounded_up) {
  ASSERT_EQ(finished_.status, 0) << finished_.err;
  const auto sheet = table("tables/design_displacements.csv");
  ASSERT_EQ(sheet.size(), 2u * 3u);
  EXPECT_FALSE(std::signbit(rounded_up(0.0, 0.1)));  // "0", not "-0"
  std::size_t i = 0;
  double largest_ft = 0.0;
  for (const std::string target : {"target_1", "target_2"}) {
    std::map<std::pair<double, double>, double> design_ft;  // by slope and friction
    for (const auto& row : table(target + "/tables/chart.csv"))
      if (number(row, "level_g") == 1.2)
        design_ft[{number(row, "slope_deg"), number(row, "mu")}] =
            1.1 * number(row, "mean_slip_m") / 0.3048;
    for (const double slope_deg : {0.0, 2.0, 9.0}) {
      const auto& row = sheet.at(i++);
      EXPECT_EQ(number(row, "slope_deg"), slope_deg);
      for (const auto& [mu, column] :
           {std::pair{0.15, "mu_0.15_ft"}, {0.3, "mu_0.3_ft"}, {0.5, "mu_0.5_ft"}}) {
        const std::string& cell = row.at(column);
        const double expected = design_ft.at({slope_deg, mu});
        if (std::isinf(expected)) {
          EXPECT_EQ(cell, "slides");
          continue;
        }
        // Within the slopes and frictions of ASCE 7-16, 80 % of 5 (S_DS - 0.4)^2 ft or more.
        const double least = mu >= 0.4 && slope_deg <= 2.0 ? 0.8 * 5.0 * 0.8 * 0.8 : 0.0;
        EXPECT_NEAR(std::stod(cell), 0.1 * std::ceil(std::max(expected, least) / 0.1 - 1e-9), 1e-9)
            << slope_deg << mu;
        largest_ft = std::max(largest_ft, std::stod(cell));
      }
    }
  }
  // The larger S_D1 has the larger displacements: each target has a spectrum of its own.
  EXPECT_LT(number(sheet[0], "mu_0.3_ft"), number(sheet[3], "mu_0.3_ft"));
  const std::string out_text = one_line(finished_.out), of = "Largest of the table: ";
  ASSERT_THAT(out_text, states(of, "S_D1 1.1 g", "simulated"));
  EXPECT_NEAR(std::stod(out_text.substr(out_text.find(of) + of.size())), largest_ft, 1e-9);
}

TEST_F(ProductSheet, is_a_page_a_workbook_and_a_pdf) {
  EXPECT_THAT(
      read_file(out() / "product.html"),
      states("S<sub>D1</sub>", "Friction 0.3, ft", "slides", "700-year event", "prescribes for I"));
  EXPECT_TRUE(fs::exists(out() / "product.xlsx") || !fs::exists("/usr/include/xlsxwriter.h"));
  EXPECT_TRUE(fs::exists(out() / "product.pdf") || !fs::exists("/usr/bin/weasyprint"));
  EXPECT_THAT(finished_.out, HasSubstr("product."));
}

// The integral of the mean displacement over the rates of a power law, by the trapezoidal rule
// between the levels of the chart, whose means are linear there.
TEST_F(ProductSheet, adds_up_the_earthquakes_that_are_smaller_than_the_event) {
  std::map<std::pair<double, double>, std::vector<std::pair<double, double>>> means;
  for (const auto& row : table("target_1/tables/chart.csv"))
    means[{number(row, "slope_deg"), number(row, "mu")}].emplace_back(number(row, "level_g"),
                                                                      number(row, "mean_slip_m"));
  std::size_t compared = 0;
  for (const auto& row : table("tables/life_displacements.csv")) {
    if (number(row, "sd1_g") != 0.5 || row.at("event_ft") == "slides") continue;
    const double event_g = number(row, "event_sds_g");
    // Rates are k0 x^-2.5, with that of the event 1/700.
    const auto rate = [&](double x) { return std::pow(x / event_g, -2.5) / 700.0; };
    double sum_m = 0.0, event_m = 0.0, from_g = 0.0, from_m = 0.0;
    for (const auto& [level_g, mean_m] : means.at({number(row, "slope_deg"), number(row, "mu")})) {
      if (level_g == event_g) event_m = mean_m;
      if (from_g > 0.0 && level_g <= event_g) {
        constexpr int parts = 2000;
        for (int i = 0; i < parts; ++i) {
          const double a = std::lerp(from_g, level_g, i / double{parts}),
                       b = std::lerp(from_g, level_g, (i + 1) / double{parts}),
                       at = std::lerp(from_m, mean_m, (i + 0.5) / parts);
          sum_m += at * (rate(a) - rate(b));
        }
      }
      from_g = level_g;
      from_m = mean_m;
    }
    EXPECT_NEAR(number(row, "smaller_ft"), 25.0 * sum_m / 0.3048, 1e-4 * number(row, "smaller_ft"));
    EXPECT_NEAR(number(row, "event_ft"), 1.1 * event_m / 0.3048, 1e-9);
    const double total = number(row, "event_ft") + number(row, "smaller_ft");
    EXPECT_NEAR(number(row, "total_ft"), 0.1 * std::ceil(total / 0.1), 1e-9);
    ++compared;
  }
  EXPECT_EQ(compared, 8u);  // 9 points but those that slide: 9 degrees on 0.15
}

TEST_F(ProductSheet, goes_on_where_it_was_stopped_and_knows_that_it_is_whole) {
  const Finished again = succeeding({"clearance", "--resume", out().string()});
  EXPECT_THAT(again.out, HasSubstr("is finished"));
  const std::string sheet = read_file(out() / "product.html");
  fs::remove(out() / "product.html");
  fs::remove_all(out() / "target_2");
  succeeding({"clearance", "--resume", out().string()});
  EXPECT_EQ(read_file(out() / "product.html"), sheet);
}

TEST_F(ProductSheet, check_says_what_would_run) {
  const Finished child = succeeding({"check", folder_->path("product.toml").string()});
  EXPECT_THAT(child.out, states("target_1", "target_2", "racking", "glissade clearance"));
}

TEST_F(ProductSheet, what_is_wrong_is_named_with_its_line_in_the_product_file) {
  const auto refuses = [&](const std::string& from, const std::string& to,
                           const std::vector<std::string>& parts) {
    const std::string file = folder_->write("wrong.toml", replaced(small_product(), from, to));
    const fs::path other = folder_->path("refused");
    expect_refused(run_program({"clearance", file, "--out", other.string()}), parts);
    EXPECT_FALSE(fs::exists(other));
  };
  refuses("mu = [0.15", "mue = [0.15", {"wrong.toml:26", "friction.mue is not a known key", "mu"});
  refuses("sd1_g = 1.1", "sd1_gg = 1.1", {"wrong.toml:12", "target.sd1_gg is not a known key"});
  refuses("unit = \"ft\"", "unit = \"feet\"", {"wrong.toml:3", "known are in, ft, m"});
  refuses("k = 2.5", "k = 2.5\nk0 = 1e-3", {"hazard.k0 is of one site", "2 targets"});
  refuses("[roof]", "[intensity]\nlevels = [1]\n\n[roof]", {"has no [intensity]"});
  refuses("[[target]]\nsds_g = 1.2\nsd1_g = 0.5\n\n[[target]]\nsds_g = 1.2\nsd1_g = 1.1\n", "",
          {"no [[target]]"});
}

// Mean displacements of x at rates x^-3: the integral of x |d rate| from 1 to 2 is
// 3/2 (1 - 1/4), from 1 to 4 3/2 (1 - 1/16).
TEST(AccumulatedDisplacement, is_the_integral_of_the_mean_over_the_rates) {
  const HazardCurve curve = HazardCurve::power_law(1.0, 3.0);
  const std::vector<double> levels = {1.0, 2.0, 4.0};
  EXPECT_NEAR(accumulated_m(curve, levels, levels, 4.0, 10.0), 10.0 * 1.5 * (1.0 - 1.0 / 16.0),
              2e-3);
  EXPECT_NEAR(accumulated_m(curve, levels, levels, 2.0, 1.0), 1.5 * (1.0 - 1.0 / 4.0), 2e-4);
  EXPECT_EQ(accumulated_m(curve, levels, {0.0, 0.0, 1.0}, 2.0, 1.0), 0.0);
}

}  // namespace
}  // namespace glissade::test
