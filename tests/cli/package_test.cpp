// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <sstream>

#include "cli/killed_run.hpp"
#include "cli/one_package.hpp"
#include "cli/shaking.hpp"
#include "cli/table_rows.hpp"
#include "facts.hpp"
#include "glissade/block/two_axis.hpp"
#include "glissade/building/modes.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/units.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/suite_file.hpp"

namespace glissade::test {
namespace {

using testing::Not;

std::map<std::string, bool> checks_in(const nlohmann::json& json) {
  std::map<std::string, bool> met;
  for (const auto& check : json.at("checks")) met[check.at("check")] = check.at("is_met");
  return met;
}

TEST_F(Package, leaves_the_page_its_numbers_and_the_studies_it_ran) {
  ASSERT_EQ(finished_.status, 0) << finished_.err;
  for (const char* name :
       {"package.html", "package.json", "demand.toml", "demand/results.h5", "probability.toml",
        "probability/results.h5", "tables/separations.csv", "figures/demand.svg"})
    EXPECT_GT(fs::exists(out() / name) ? fs::file_size(out() / name) : 0, 0u) << name;
}

TEST_F(Package, numbers_the_records_as_figure_1_does) {
  EXPECT_THAT(read_file(out() / "tables/motions.csv"), testing::StartsWith("number,id,"));
  EXPECT_THAT(read_file(out() / "package.html"), states(">No.<", ">PGD, in<"));
}

// A clearance that is large enough may not be accepted: never "sufficient" beside an open item.
TEST_F(Package, with_open_items_no_clearance_is_sufficient) {
  EXPECT_THAT(finished_.out,
              states("available 12.7 in: open", "Open: Motions of the suite: simulated"));
  EXPECT_THAT(read_file(out() / "package.html"), states("Open items", ">open<"));
  EXPECT_THAT(read_file(out() / "tables/separations.csv"), Not(testing::HasSubstr("sufficient")));
}

// The page has what a checker of plans looks for, in this order.
TEST_F(Package, is_in_the_order_of_a_calculation) {
  const std::string page = read_file(out() / "package.html");
  std::size_t last = 0;
  for (const char* part : {">Authority having jurisdiction<",
                           ">Licence number<",
                           ">Stamp and signature<",
                           ">Result<",
                           "<h2 id=\"scope\">1. Scope",
                           "\">2. Design criteria</h2>",
                           "\">3. Building</h2>",
                           "\">4. Array</h2>",
                           "\">5. Friction tests</h2>",
                           "\">6. Motions</h2>",
                           "\">7. Analysis and governing displacement</h2>",
                           "\">8. Separations</h2>",
                           "\">9. Model uncertainty</h2>",
                           "\">10. Probability of exceedance</h2>",
                           "\">11. Plausibility of the roof motions</h2>",
                           "\">12. Independent check by hand</h2>",
                           "\">13. Provisions used</h2>",
                           "\">14. Checks, limits and peer review</h2>",
                           "\">15. References</h2>",
                           "\">16. Program and input files</h2>"}) {
    const std::size_t at = page.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    EXPECT_GT(at, last) << part;
    last = at;
  }
  EXPECT_THAT(page, states("S<sub>DS</sub>", "&#39;s", "h<sup>x</sup>"));
  EXPECT_THAT(page, Not(testing::HasSubstr("filled in by hand")));  // a comment of the project file
}

// Each provision once, to be confirmed, in place of remarks.
TEST_F(Package, lists_the_provisions_to_confirm_and_says_nowhere_that_they_are_recalled) {
  EXPECT_THAT(read_file(out() / "package.html"), Not(testing::HasSubstr("recalled")));
  EXPECT_THAT(read_file(out() / "tables/provisions.csv"),
              states("13.6.12", "80 %", "24 in", "11.4.8", "13.3-1", "[7]", "[4]", "\u2610"));
}

TEST_F(Package, mean_and_analysis_add_up_from_the_displacements_of_the_records) {
  double sum_in = 0.0, printed_sum = 0.0, printed_mean = 0.0, printed_analysis = 0.0;
  int records = 0;
  for (const std::string& line : lines_of(read_file(out() / "tables/record_displacements.csv"))) {
    if (line.starts_with("number")) continue;
    const double value = std::stod(line.substr(line.find_last_of(',') + 1));
    if (line.find("Sum") != std::string::npos)
      printed_sum = value;
    else if (line.find("Mean") != std::string::npos)
      printed_mean = value;
    else if (line.find("mean") != std::string::npos)
      printed_analysis = value;
    else
      sum_in += value, ++records;
  }
  ASSERT_EQ(records, 7);
  EXPECT_NEAR(printed_sum, sum_in, 7 * 0.005 + 1e-9);
  EXPECT_NEAR(printed_mean, sum_in / 7, 0.011);
  EXPECT_NEAR(printed_analysis, 1.1 * sum_in / 7, 0.012);
  EXPECT_NEAR(printed_analysis, numbers().at("analysis_m").get<double>() / 0.0254, 0.0051);
  for (const char* table : {"scaled_motions", "record_spectra"})  // what the factor follows from
    EXPECT_TRUE(fs::exists(out() / "tables" / (std::string(table) + ".csv"))) << table;
}

// City of Santa Ana, building records, document 370815, page 20.
TEST_F(Package, has_the_separations_of_the_published_sheet_beside_its_own) {
  EXPECT_THAT(read_file(out() / "tables/by_hand.csv"),
              states("12.7 in (1.06 ft)", "25.4 in (2.12 ft)", "50.8 in (4.23 ft)",
                     "10.5 in (0.88 ft)", "20.5 in (1.71 ft)", "48.0 in (4.00 ft)"));
  EXPECT_NEAR(read_project(project_file).building.approximate_period_s.value(), 0.288, 5e-4);
}

// Table and figure of one probability are of the same numbers.
TEST_F(Package, figure_and_table_of_the_probability_agree) {
  const nlohmann::json compared = numbers().at("compared").at(0);
  std::map<double, double> drawn;  // by shaking over that of the DBE
  const std::string data = read_file(out() / "figures/exceedance.dat");
  for (const std::string& line : lines_of(data.substr(data.find("# share")))) {
    std::istringstream words(line);
    double x = 0.0, y = 0.0;
    if (words >> x >> y) drawn.emplace(std::round(1e6 * x) / 1e6, y);
  }
  ASSERT_EQ(compared.at("dbe").at("period_s"), compared.at("mce").at("period_s"));
  for (const auto& [level, x] : {std::pair{"dbe", 1.0}, {"mce", 1.5}}) {
    ASSERT_TRUE(drawn.contains(x)) << level;
    EXPECT_NEAR(drawn[x], compared.at(level).at("probability"), 1e-12) << level;
  }
}

TEST_F(Package, has_the_site_values_of_the_published_calculation) {
  EXPECT_NEAR(numbers().at("sds_g"), 1.050, 5e-4);
  EXPECT_NEAR(numbers().at("sd1_g"), 0.574, 5e-4);
  EXPECT_NEAR(numbers().at("least_value_m"), 0.8 * 25.4 * 0.0254, 2e-3);
}

// S_DS and 1.5 S_D1 of the published calculation (supplement 3 of ASCE 7-16, recalled), 0 to 2 s.
TEST_F(Package, compares_the_suite_with_the_spectrum_that_exception_2_requires) {
  const Results demand = read_results(out() / "demand/results.h5");
  const SuiteSpectra& spectra = demand.suites.front().spectra;
  const nlohmann::json json = numbers();
  const DesignSpectrum given{json.at("sds_g"), json.at("sd1_g"), 8.0},
      required{json.at("sds_g"), 1.5 * json.at("sd1_g").get<double>(), 8.0};
  double lowest = 10.0;
  for (std::size_t i = 0; i < spectra.periods_s.size() && spectra.periods_s[i] <= 2.0; ++i)
    lowest = std::min(lowest, spectra.average_g[i] / spectra.target_g[i] *
                                  given.sa_g(spectra.periods_s[i]) /
                                  required.sa_g(spectra.periods_s[i]));
  const auto check = std::ranges::find_if(json.at("checks"), [](const auto& c) {
    return c.at("check").template get<std::string>().find("1.5 S_D1") != std::string::npos;
  });
  ASSERT_NE(check, json.at("checks").end());
  EXPECT_NEAR(std::stod(check->at("found").get<std::string>()), lowest, 5.1e-4);
  EXPECT_EQ(check->at("is_met"), lowest >= 0.98);
}

// From the histories of the demand study: the mean of the records in each orientation, the largest
// over orientations, periods, alphas, with and without vertical, at design friction and DBE.
TEST_F(Package, analysis_is_1_1_times_the_largest_mean_of_the_histories) {
  std::map<std::string, std::pair<double, int>> sums;  // by everything but the record
  for (const Row& row : rows_of(read_file(out() / "demand/tables/histories.csv"))) {
    const bool is_of_project = row.at("condition").find("friction 0.474") != std::string::npos &&
                               number(row, "slope_deg") < 2.0;  // not the steeper one
    if (number(row, "level_g") > 1.1 || !is_of_project) continue;
    auto& [sum_m, records] = sums[row.at("orientation") + row.at("vertical") + row.at("condition") +
                                  "|" + row.at("period_s")];
    sum_m += number(row, "displacement_m");
    ++records;
  }
  double largest_m = 0.0;
  for (const auto& [key, sum] : sums) {
    ASSERT_EQ(sum.second, 7) << key;  // records of the suite
    largest_m = std::max(largest_m, sum.first / sum.second);
  }
  EXPECT_GT(largest_m, 0.0);
  EXPECT_NEAR(numbers().at("analysis_m"), 1.1 * largest_m, 1e-12);
}

/// Peak acceleration of a roof of these modes, 5 % damped: linear acceleration (Newmark, beta 1/6),
/// 64 steps for each of the record.
double roof_peak_mps2(const std::vector<Mode>& modes, double dt_s, const Samples& ground) {
  constexpr int parts = 64;
  const double h = dt_s / parts;
  struct State {
    double u = 0.0, v = 0.0, a = 0.0;
  };
  std::vector<State> states(modes.size());
  double peak = 0.0;
  for (std::size_t i = 0; i + 1 < ground.size(); ++i)
    for (int part = 1; part <= parts; ++part) {
      const double a_g = std::lerp(ground[i], ground[i + 1], part / double{parts});
      double roof = a_g;
      for (std::size_t n = 0; n < modes.size(); ++n) {
        const double w = 2.0 * std::numbers::pi / modes[n].period_s, c = 0.1 * w;
        auto& [u, v, a] = states[n];
        const double u_predicted = u + h * v + h * h * a / 3.0, v_predicted = v + h * a / 2.0;
        a = -(a_g + c * v_predicted + w * w * u_predicted) /
            (1.0 + c * h / 2.0 + w * w * h * h / 6.0);
        u = u_predicted + h * h * a / 6.0;
        v = v_predicted + h * a / 2.0;
        roof += modes[n].participation * a;
      }
      peak = std::max(peak, std::abs(roof));
    }
  return peak;
}

// The median over the records of the geometric mean of both axes.
TEST_F(Package, prints_the_peak_acceleration_of_the_roof_beside_both_editions) {
  const Project project = read_project(project_file);
  const Suite suite = load_suite(project.suite);
  const Results demand = read_results(out() / "demand/results.h5");
  const nlohmann::json json = numbers(), &roof = json.at("roof_acceleration").at(0);
  const double period_s = roof.at("period_s"), sds_g = json.at("sds_g");
  std::vector<Mode> all = cantilever_modes(period_s, project.building.alpha.front(), most_modes);
  const std::vector<Mode> modes = governing_modes(all);
  std::vector<double> peaks_g;
  for (std::size_t i = 0; i < suite.motions.size(); ++i) {
    const Motion& motion = suite.motions[i];
    double product = 1.0;
    for (const Samples& component : motion.horizontal_mps2)
      product *= roof_peak_mps2(modes, motion.dt_s, component) / standard_gravity_mps2;
    peaks_g.push_back(sds_g * demand.records[i].factor_at_unit_level * std::sqrt(product));
  }
  EXPECT_NEAR(roof.at("median_g"), quantile_of(peaks_g, 0.5), 0.01 * quantile_of(peaks_g, 0.5));
  EXPECT_NEAR(roof.at("p84_g"), quantile_of(peaks_g, 0.84), 0.01 * quantile_of(peaks_g, 0.84));
  EXPECT_NEAR(roof.at("asce7_16_g"), 1.2 * sds_g, 1e-12);
  const double hf =
      1.0 + std::min(1.0 / period_s, 2.5) + std::max(1.0 - 0.16 / (period_s * period_s), 0.0);
  EXPECT_NEAR(roof.at("asce7_22_g"), 0.4 * sds_g * hf, 1e-12);
  EXPECT_EQ(json.at("roof_acceleration").size(), 10u);  // five periods, both ends of alpha
  EXPECT_EQ(json.at("roof_acceleration").at(0).at("alpha"), project.building.alpha.front());  // 0
  EXPECT_THAT(finished_.out, states("Roof peak", "ASCE 7-16", "7-22"));
}

// One trial a record and none exceeding: 1 - 0.025^(1/7), Clopper & Pearson.
TEST_F(Package, an_interval_is_never_narrower_than_that_of_the_records) {
  double last_period_s = 0.0;
  const nlohmann::json json = numbers();
  for (const auto& e : json.at("exceedance")) {
    EXPECT_GE(e.at("high95"), 1.0 - std::pow(0.025, 1.0 / 7.0));
    EXPECT_LE(e.at("low95"), e.at("probability"));
    if (e.at("level") != "DBE") continue;
    EXPECT_GT(e.at("period_s"), last_period_s);
    last_period_s = e.at("period_s");
  }
  EXPECT_EQ(json.at("exceedance").size(), 10u);  // two levels, five periods
}

// From the histories of the probability study, at S_DS and each building period: the shares above
// what the clearances allow, and the largest 90th percentile.
TEST_F(Package, compares_what_each_clearance_allows_with_the_histories) {
  const Results results = read_results(out() / "probability/results.h5");
  const HistoryTable& histories = results.histories;
  const nlohmann::json json = numbers();
  const auto level = static_cast<std::size_t>(
      std::ranges::find(results.levels, json.at("sds_g").get<double>()) - results.levels.begin());
  std::vector<std::vector<double>> slips_m;  // by building period
  for (const RunResults& run : results.runs) {
    std::vector<double>& slips = slips_m.emplace_back();
    for (std::size_t record = 0; record < histories.records; ++record)
      for (std::size_t i = 0; i < run.cases; ++i)
        slips.push_back(
            histories.fields.peak_displacement_m[histories.at(record, run.first_case + i, level)]);
  }
  ASSERT_EQ(slips_m.size(), 5u);
  ASSERT_EQ(json.at("compared").size(), 5u);  // the governing displacement, four clearances
  // 1.06 ft / 0.5, 2.12 ft, 2.12 ft, 4.23 ft / 2
  const std::array allowed_m = {json.at("governing_m").get<double>(), 2.12 * foot_m, 2.12 * foot_m,
                                2.12 * foot_m, 2.115 * foot_m};
  for (std::size_t row = 0; row < allowed_m.size(); ++row) {
    const auto& compared = json.at("compared").at(row);
    EXPECT_NEAR(compared.at("displacement_m"), allowed_m[row], 1e-12);
    double largest = 0.0;
    for (const std::vector<double>& slips : slips_m)
      largest = std::max(largest, static_cast<double>(std::ranges::count_if(
                                      slips, [&](double s) { return s > allowed_m[row]; })) /
                                      static_cast<double>(slips.size()));
    EXPECT_NEAR(compared.at("dbe").at("probability"), largest, 1e-12);
  }
  double largest_m = 0.0;
  for (const std::vector<double>& slips : slips_m)
    largest_m = std::max(largest_m, quantile_of(slips, 0.9));
  EXPECT_GT(largest_m, 0.0);
  EXPECT_NEAR(json.at("accepted").at("displacement_m"), largest_m, 1e-12);
}

TEST_F(Package, separations_are_parts_of_the_governing_displacement_rounded_up) {
  const nlohmann::json json = numbers();
  const double governing_m = json.at("governing_m");
  EXPECT_EQ(governing_m,
            std::max(json.at("analysis_m").get<double>(), json.at("least_value_m").get<double>()));
  ASSERT_EQ(json.at("separations").size(), 4u);
  for (const auto& s : json.at("separations")) {
    EXPECT_EQ(s.at("verdict"), s.at("available_m").is_null()              ? "not stated"
                               : s.at("available_m") < s.at("required_m") ? "not sufficient"
                                                                          : "open");
    const double exact_m = std::max(s.at("factor").get<double>() * governing_m,
                                    s.at("least_m").get<double>()),
                 required_m = s.at("required_m");
    EXPECT_GE(required_m, exact_m - 1e-12);
    EXPECT_LT(required_m, exact_m + 0.0127);
    EXPECT_NEAR(std::remainder(required_m, 0.0127), 0.0, 1e-12);
  }
}

// ASCE 7-16: 2 x 20.3 in is less than 4 ft (recalled).
TEST_F(Package, an_edge_without_a_parapet_is_4_ft_away_or_more) {
  const nlohmann::json json = numbers();
  EXPECT_LT(2.0 * json.at("governing_m").get<double>(), 1.2);
  EXPECT_NEAR(json.at("separations").at(3).at("required_m"), 1.2192, 1e-9);
  EXPECT_THAT(read_file(out() / "tables/columns.csv"), states("and 4 ft or more", "0.2 S_DS"));
}

TEST_F(Package, states_value_limit_and_verdict_of_each_condition) {
  EXPECT_THAT(read_file(out() / "tables/conditions.csv"),
              states("centre of mass", "0.133 S_DS", "13.6.12", ",met"));
  EXPECT_THAT(read_file(out() / "tables/premises.csv"),
              states("11.4.8", "exception 2 of 11.4.8", "simulated", "OPEN", ",met"));
  EXPECT_THAT(read_file(out() / "package.html"), states("All conditions are met"));
}

TEST_F(Package, computes_two_storeys_by_modes) {
  EXPECT_THAT(finished_.out, states("alpha 0 to 2"));
  EXPECT_THAT(read_file(out() / "demand.toml"), states("alpha = [0, 2]", "mass_ratio = 0\n"));
  EXPECT_THAT(read_file(out() / "package.html"),
              states("uniform cantilever of flexure and shear", "neglected"));
}

// A long period on one mass: its roof moves far less than the standards have. And sections of the
// array that are too weak.
TEST_F(Package, of_a_soft_roof_and_a_weak_array_is_not_applicable) {
  std::string text = moved_project();
  for (const auto& [from, to] : {std::pair{"storeys = 2", "storeys = 1"},
                                 {"35 ft", "130 ft"},
                                 {"interconnection = 0.2", "interconnection = 0.05"}})
    text = replaced(text, from, to);
  const fs::path other = folder_->path("soft");
  const WithoutWeasyprint path;
  const Finished child =
      succeeding({"clearance", folder_->write("soft.toml", text), "--out", other.string()});
  EXPECT_THAT(one_line(child.out),
              states("NOT APPLICABLE", "peak acceleration of the roof", "7-22"));
  EXPECT_THAT(read_file(other / "package.html"), states("NOT APPLICABLE", "NOT MET"));
  const std::string separations = read_file(other / "tables/separations.csv");
  EXPECT_THAT(separations, states("not applicable"));
  EXPECT_THAT(separations, Not(testing::HasSubstr(",sufficient")));
  const auto json = nlohmann::json::parse(read_file(other / "package.json"));
  EXPECT_THAT(json.at("prescribed").at(0).at("conditions_not_met").get<std::string>(),
              states("strength", "0.05"));
  const std::string roof = "median peak acceleration of the roof at DBE";
  EXPECT_FALSE(checks_in(json).at(roof));
  double lowest = 10.0;
  const nlohmann::json whole = numbers();
  for (const auto& peak : whole.at("roof_acceleration"))
    lowest = std::min(
        lowest, peak.at("median_g").get<double>() / std::max(peak.at("asce7_16_g").get<double>(),
                                                             peak.at("asce7_22_g").get<double>()));
  EXPECT_EQ(checks_in(whole).at(roof), lowest >= 0.8);  // a limit of the program
}

TEST_F(Package, warns_of_simulated_motions_and_of_records_that_are_the_nearest_to_a_target) {
  for (const std::string& text : {finished_.out, read_file(out() / "package.html")})
    EXPECT_THAT(text, states("simulated"));
  EXPECT_THAT(numbers().at("warnings").dump(), states("nearest"));
  const std::string report = read_file(out() / "demand/report.html");
  EXPECT_THAT(report, states("DBE, S_DS = 1.05 g", "MCE, S_DS = 1.58 g"));
  EXPECT_THAT(report, Not(states("nearest")));  // it gives no probability
}

TEST_F(Package, says_which_key_gives_annual_rates_and_the_displacement_that_adds_up) {
  EXPECT_THAT(finished_.out, states("[hazard]"));
  EXPECT_FALSE(numbers().contains("annual_rate"));
}

/// Empty without libxlsxwriter or Python.
std::string text_of_workbook(const fs::path& file) {
  if (!fs::exists(file) || !fs::exists("/usr/bin/python3")) return "";
  Child child({"/usr/bin/python3", "-c",
               "import sys, zipfile\n"
               "book = zipfile.ZipFile(sys.argv[1])\n"
               "for name in sorted(book.namelist()):\n"
               "  print(book.read(name).decode())\n",
               file.string()});
  return child.wait().out;
}

TEST_F(Package, of_a_hazard_curve_has_annual_rates_and_the_displacement_that_adds_up) {
  const fs::path other = folder_->path("hazard");
  const std::string text =
      replaced(replaced(moved_project(), "licence = \"\"", "licence = \"0012345\""), "[clearances]",
               "[hazard]\nk0 = 1e-3\nk = 2.2\ndesign_life_years = 25\n\n[clearances]") +
      "\n[[gap]]\nname = \"skylight <3>\"\nkind = \"obstruction\"\navailable_m = \"1 ft\"\n"
      "\n[[gap]]\nname = \"duct\"\nkind = \"obstruction\"\navailable_m = \"9 ft\"\n";
  const WithoutWeasyprint path;
  const Finished child =
      succeeding({"clearance", folder_->write("hazard.toml", text), "--out", other.string()});
  EXPECT_THAT(child.out, states("50 years"));
  EXPECT_THAT(read_file(other / "package.html"), states("25 years"));
  const auto json = nlohmann::json::parse(read_file(other / "package.json"));
  ASSERT_EQ(json.at("annual_rate").size(), 5u);  // by period
  for (const auto& rate : json.at("annual_rate")) EXPECT_GT(rate.get<double>(), 0.0);

  // Each gap is checked beside the four clearances, and drawn by its letter.
  const auto& skylight = json.at("separations").at(2);
  EXPECT_EQ(json.at("separations").size(), 6u);
  EXPECT_THAT(skylight.at("between").get<std::string>(), states("fixed object", "skylight <3>"));
  EXPECT_EQ(skylight.at("verdict"), "not sufficient");
  EXPECT_EQ(json.at("separations").at(3).at("verdict"), "open");
  EXPECT_EQ(json.at("compared").size(), 7u);
  EXPECT_THAT(child.out, states("NOT SUFFICIENT"));
  EXPECT_THAT(
      read_file(other / "package.html"),
      states("skylight &lt;3&gt;", "B, C, D: ", "C available 12.0 in", "separations A to F"));
  const std::string workbook = text_of_workbook(other / "package.xlsx");
  if (workbook.empty()) return;
  EXPECT_THAT(workbook, testing::HasSubstr("0012345"));  // no number
}

TEST_F(Package, a_page_holds_text_as_text_and_few_tests_and_a_peer_review_are_warned_of) {
  const std::string support = "friction that the tests support with 95 % confidence";
  EXPECT_TRUE(checks_in(numbers()).at(support));
  const std::string friction = GLISSADE_SOURCE_DIR "/studies/data/pull_tests.csv";
  std::string text = replaced(moved_project(), "Office building, roof array (example)",
                              "<script>alert(1)</script>");
  text = replaced(text, "file = \"" + friction + "\"\ndirection = \"along\"",
                  "mu = { mean = 0.55, std = 0.04 }\ntests = 3");
  text = replaced(text, "compare = \"asce7_16\"", "compare = \"asce7_16\"\npeer_reviewed = true");
  const fs::path other = folder_->path("other");
  const WithoutWeasyprint path;
  const Finished child =
      succeeding({"clearance", folder_->write("script.toml", text), "--out", other.string()});
  EXPECT_THAT(read_file(other / "package.html"), Not(testing::HasSubstr("<script")));
  const auto json = nlohmann::json::parse(read_file(other / "package.json"));
  EXPECT_FALSE(checks_in(json).at(support));
  EXPECT_EQ(json.at("least_value_m"), 0.0);
  EXPECT_EQ(json.at("governing_m"), json.at("analysis_m"));
  EXPECT_THAT(child.out, states("peer_reviewed"));
}

TEST_F(Package, states_what_each_premise_and_the_records_change_the_largest_change_first) {
  const nlohmann::json json = numbers();
  std::vector<std::string> premises;
  double before = infinity;
  for (const auto& row : json.at("model_uncertainty")) {
    premises.push_back(row.at("premise"));
    EXPECT_EQ(row.at("calculated_m"), json.at("analysis_m"));
    EXPECT_LE(row.at("change"), before);
    before = row.at("change");
  }
  EXPECT_THAT(premises,
              testing::UnorderedElementsAre("friction, mean", "building damping",
                                            "building period, s", "\u03b1_0 of the building",
                                            "roof slope, degrees", "vertical motion", "records"));
  EXPECT_GT(json.at("mce_analysis_m"), json.at("analysis_m"));
  EXPECT_GT(json.at("bound_analysis_m"), json.at("analysis_m"));  // lower bound of the tests
  EXPECT_THAT(finished_.out, testing::HasSubstr("Largest change"));
  EXPECT_THAT(read_file(out() / "package.html"), states("Not varied: the roof diaphragm"));
  EXPECT_THAT(read_file(out() / "tables/model_uncertainty.csv"),
              states("95 % interval of the mean of 6 tests"));
  EXPECT_THAT(read_file(out() / "tables/columns.csv"), states("model_uncertainty", "Low end: "));
}

TEST_F(Package, run_json_of_the_folder_has_the_warnings_of_the_package) {
  const auto run = nlohmann::json::parse(read_file(out() / "run.json"));
  EXPECT_EQ(run.at("status"), "finished");
  EXPECT_EQ(run.at("warnings"), numbers().at("warnings"));
  EXPECT_FALSE(run.at("build").get<std::string>().empty());
}

/// The words of a PDF, without what each build has of its own; empty without pdftotext.
std::string words_of(const fs::path& pdf) {
  if (!fs::exists("/usr/bin/pdftotext")) return "";
  Child child({"/usr/bin/pdftotext", "-layout", pdf.string(), "-"});
  std::istringstream words(child.wait().out);
  std::string text, word;
  while (words >> word) text += word + " ";
  return std::regex_replace(text, std::regex(R"(\(commit [^)]*\)|study [0-9a-f]{16})"), "");
}

// Made again by: glissade clearance studies/permit_project.toml --out DIR, which leaves
// package.pdf.
TEST_F(Package, of_the_example_is_the_one_in_studies) {
  const std::string committed = words_of(GLISSADE_SOURCE_DIR "/studies/permit_package.pdf");
  if (!fs::exists(out() / "package.pdf") || committed.empty())
    GTEST_SKIP() << "WeasyPrint or pdftotext is not installed (packages.txt)";
  const std::string made = words_of(out() / "package.pdf");
  const auto [stale, fresh] = std::ranges::mismatch(committed, made);
  const auto at = static_cast<std::size_t>(fresh - made.begin());
  EXPECT_TRUE(committed == made) << "studies/permit_package.pdf is stale, from: "
                                 << made.substr(at > 60 ? at - 60 : 0, 160);
}

// The workbook has the quantities as numbers, with their unit as a format.
TEST_F(Package, workbook_has_the_numbers_of_the_tables) {
  const std::string text = text_of_workbook(out() / "package.xlsx");
  if (text.empty()) GTEST_SKIP() << "libxlsxwriter or Python is not installed (packages.txt)";
  for (const char* part : {"name=\"record_displacements\"", "<v>23.27</v>", "0.0&quot; in&quot;",
                           "Provisions used", "60 (S_DS - 0.4)^2 in, categories D to F"})
    EXPECT_THAT(text, testing::HasSubstr(part));
}

// Of PATH only gnuplot is left, which draws the figures.
TEST_F(Package, without_weasyprint_says_that_the_page_is_to_be_printed) {
  const fs::path other = folder_->path("unprinted");
  fs::copy(out(), other, fs::copy_options::recursive);
  fs::remove(other / "package.html");
  const WithoutWeasyprint path;
  const Finished child = succeeding({"clearance", "--resume", other.string()});
  EXPECT_THAT(child.out, states("package.html", "print it from a browser"));
  EXPECT_FALSE(fs::exists(other / "package.pdf"));
  EXPECT_EQ(read_file(other / "package.html"), read_file(out() / "package.html"));
}

}  // namespace
}  // namespace glissade::test
