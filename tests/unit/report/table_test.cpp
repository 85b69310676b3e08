// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/friction_report.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "made_up_results.hpp"
#include "one_line.hpp"

namespace glissade {
namespace {

using test::states;
using testing::Not;

Table small_table() {
  Table table{"small",
              "Two\nrows",
              {{"who", "", "Who", ColumnKind::text},
               {"slip", "m", "Slip, m (in)", ColumnKind::length, "", true}},
              {}};
  table.add({std::string("a, \"b\""), Estimate{0.254, {0.2, 0.3}}});
  table.add({std::string("<c>"), Estimate{std::numeric_limits<double>::quiet_NaN(), {}}});
  return table;
}

TEST(table, becomes_csv_with_units_quotes_and_empty_fields_for_nan) {
  EXPECT_EQ(to_csv(small_table()),
            "who,slip_m,slip_low95_m,slip_high95_m\n\"a, "
            "\"\"b\"\"\",0.254,0.2,0.3\n<c>,,,\n");
}

TEST(table, becomes_aligned_text_with_inches_and_dashes) {
  EXPECT_EQ(to_text(small_table()),
            "Two rows\n"
            "  Who                    Slip, m (in)\n"
            "  a, \"b\"  0.254 (10.0) [0.200, 0.300]\n"
            "  <c>                               -\n");
}

TEST(table, becomes_escaped_html) {
  const std::string html = to_html(small_table()).str();
  EXPECT_THAT(html, states("<td>&lt;c&gt;</td>", "<caption><div>Two\nrows</div></caption>"));
}

TEST(table, breaks_no_line_between_a_number_and_its_unit_nor_after_a_sign_on_a_page) {
  Table table{"t", "T", {text_column("a", "A")}, {}};
  table.add({std::string("0.605 s, along it -second, 3 to 4 - 5")});
  table.add({std::string("[9.98e-05, 0.000248]")});
  table.add({std::string("0.8 % [< 0.1 %, 1.4 %]; 19.2 (0.488), of 7 [checked here]")});
  EXPECT_THAT(
      to_html(table).str(),
      states("<td>0.605\u00a0s, along it -\u2060second, 3\u00a0to 4 - 5</td>", "9.98e-\u206005",
             "0.8 % [&lt; 0.1 %, 1.4 %]; 19.2 (0.488), of 7 [checked here]"));
  EXPECT_THAT(to_csv(table), states("0.605 s, along it -second"));
}

TEST(table, has_annual_rates_in_one_notation) {
  const Column column{"annual_rate", "per_year", "Annual rate", ColumnKind::rate, "", true};
  EXPECT_EQ(cell_text(column, Estimate{0.000164, {9.98e-05, 0.000248}}), "1.6e-4 [1.0e-4, 2.5e-4]");
  EXPECT_EQ(cell_text(column, 0.0), "0");
}

TEST(table, says_that_a_one_sided_median_is_a_lower_bound) {
  const Column column{"median", "g", "Median", ColumnKind::number, "", true};
  EXPECT_EQ(cell_text(column, NumberCell({2.0, {}}, "> ")), "> 2.00");
}

TEST(table, has_numbers_of_their_own_unit_and_digits_in_a_column_of_text) {
  Table table{"t", "T", {text_column("value", "Value")}, {}};
  NumberCell both = fixed(12.5, 1, "in");
  both.beside = " (0.318 m)";
  table.add({both});
  table.add({significant(0.30004, 3, "s")});
  table.add({fixed(std::nan(""), 3)});
  EXPECT_EQ(to_csv(table), "value\n12.5 in (0.318 m)\n0.3 s\n-\n");
  EXPECT_EQ(estimate_of(table.rows[0][0]).value, 12.5);
}

// A record may be called what a spreadsheet takes for a formula.
TEST(table, has_no_text_that_is_a_formula_in_csv) {
  Table table{"t", "T", {text_column("id", "Id"), {"x", "", "x"}}, {}, {}};
  for (const char* id : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "a=1", "-"}) table.add({id, -1.0});
  EXPECT_EQ(to_csv(table),
            "id,x\n'=1+1,-1\n'+1,-1\n'-1,-1\n'@SUM(A1),-1\n'\t=1,-1\na=1,-1\n-,-1\n");
}

// What a cell holds does not move those after it (hazard.csv had rows wider than its header).
TEST(table, has_the_fields_that_its_columns_declare_whatever_its_cells_hold) {
  Table table{"t",
              "T",
              {{"a", "", "A", ColumnKind::share},
               {"b", "", "B", ColumnKind::number, "", true},
               {"c", "", "C", ColumnKind::number, "", true},
               {"d", "", "D"}},
              {}};
  table.add({NumberCell({0.5, {}}, "< "), 0.25, std::string("-"), 4.0});
  EXPECT_EQ(to_csv(table), "a,b,b_low95,b_high95,c,c_low95,c_high95,d\n0.5,0.25,,,-,,,4\n");
  EXPECT_THAT(to_text(table), states("< 50 %"));
}

#ifdef GLISSADE_CONTRACTS
TEST(table, refuses_rows_that_do_not_fit_its_columns) {
  Table table = small_table();
  EXPECT_THROW(table.add({std::string("a")}), std::logic_error);
  EXPECT_THROW(table.add({1.0, 2.0}), std::logic_error);  // a number as text
  table.columns[1].with_interval = false;
  EXPECT_NO_THROW(table.add({std::string("a"), Estimate{0.254, {}}}));
  EXPECT_THROW(table.add({std::string("a"), Estimate{0.254, {0.2, 0.3}}}), std::logic_error);
}
#endif

TEST(table, loses_just_the_column_it_is_shown_without) {
  const Table rest = small_table().without("who");
  ASSERT_EQ(rest.columns.size(), 1u);
  EXPECT_EQ(rest.columns[0].stem, "slip");
  EXPECT_EQ(std::get<NumberCell>(rest.rows[0][0]).value, 0.254);
}

TEST(tables, have_as_many_fields_in_every_row_as_in_the_header_and_say_where_they_are_in_plan) {
  for (const Table& table : csv_tables(made_up_results())) {
    const bool has_displacements = std::ranges::any_of(
        table.columns, [](const Column& column) { return column.kind == ColumnKind::length; });
    EXPECT_EQ(table.title.find("isplacements are in plan") != std::string::npos, has_displacements)
        << table.name.text();
    EXPECT_THAT(to_csv(table), test::has_rows_as_wide_as_its_header()) << table.name.text();
    EXPECT_EQ(std::ranges::count(to_csv(table), '\n'), std::ssize(table.rows) + 1);
  }
}

// pd.read_csv takes the first line as the header.
TEST(tables, begin_with_a_header_of_names_that_columns_csv_explains) {
  std::vector<Table> tables = csv_tables(made_up_results());
  tables.push_back(pull_tests_table(PullTestSummary{}));
  const Table columns = columns_table(tables);
  std::size_t names = 0;
  for (const Table& table : tables) {
    const std::string header = to_csv(table).substr(0, to_csv(table).find('\n'));
    EXPECT_THAT(header, testing::MatchesRegex("[a-z][A-Za-z0-9_,]*")) << table.name.text();
    names += static_cast<std::size_t>(std::ranges::count(header, ',')) + 1;
  }
  ASSERT_EQ(columns.rows.size(), names);
  for (const std::vector<Cell>& row : columns.rows)
    for (const std::size_t text : {0, 1, 2, 3, 4}) EXPECT_NE(std::get<std::string>(row[text]), "");
  EXPECT_THAT(to_csv(columns), states("pull_tests,speed_mps,m/s,", "the sliding part"));
}

TEST(tables, and_figures_of_one_axis_say_so) {
  Results results = made_up_results();
  for (const SlidingAxes axes : {SlidingAxes::one, SlidingAxes::two}) {
    results.axes = axes;
    const auto says = [&](const std::string& text) {
      return (text.find("one axis only") != std::string::npos) == (axes == SlidingAxes::one);
    };
    for (const Table& table : csv_tables(results)) EXPECT_TRUE(says(table.title)) << table.title;
    for (const Figure& figure : make_figures(results)) {
      EXPECT_TRUE(figure.name == FileName("spectra") || says(figure.below)) << figure.title;
    }
  }
}

TEST(tables, and_figures_page_and_summary_name_the_design_target) {
  Results results = made_up_results();
  const std::string target = "ASCE 7-10, S_S 1.5 g, S_1 0.6 g, site class C";
  EXPECT_THAT(summary_text(results, {}), Not(states("target")));
  results.suites.front().target = target;
  for (const Table& table : csv_tables(results)) EXPECT_THAT(table.title, states(target));
  for (const Figure& figure : make_figures(results)) EXPECT_THAT(figure.below, states(target));
  EXPECT_THAT(test::one_line(summary_text(results, {})), states(target));
  EXPECT_THAT(html_report(results, {}, {}),
              states("ASCE 7-10, S<sub>S</sub> 1.5 g, S<sub>1</sub> 0.6 g, site class C"));
  results.suites.push_back(results.suites.front());  // one of two suites has another target
  results.suites.back().target = "ASCE 7-16, S_DS 2 g, S_D1 1 g";
  for (const Figure& figure : make_figures(results))
    EXPECT_EQ(figure.below.find(target) != std::string::npos, figure.name == FileName("spectra"));
  results.suites.front().name = "first";
  results.suites.back().name = "second";
  for (const Table& table : csv_tables(results)) {
    if (table.name == FileName("spectra")) {
      EXPECT_THAT(table.title, states(target));
    } else if (table.name == FileName("records")) {
      EXPECT_THAT(table.title, states("first", "second"));
      EXPECT_THAT(table.title, Not(states(target)));
    }
  }
  results.suites.pop_back();
  results.measure = IntensityMeasure::pga_g;  // nothing rests on it
  for (const Table& table : csv_tables(results)) EXPECT_THAT(table.title, Not(states(target)));
}

TEST(tables, leave_out_standards_when_there_are_none) {
  Results results = made_up_results();
  for (RunResults& run : results.runs) run.standards.clear();
  for (const Table& table : csv_tables(results)) EXPECT_NE(table.name.text(), "standards");
}

TEST(stripes_table, counts_what_the_histories_show) {
  const Results results = made_up_results();
  const RunResults& run = results.runs[0];
  // The last level of the first threshold, counted directly.
  const HistoryTable& histories = results.histories;
  const std::size_t last = histories.levels - 1;
  double above = 0.0;
  for (std::size_t i = 0; i < histories.records; ++i) {
    for (std::size_t c = run.first_case; c < run.first_case + run.cases; ++c)
      above += histories.displacement_m(i, c, last) >= results.thresholds_m[0] ? 1 : 0;
  }
  const Table table = stripes_table(results, results.runs);
  const std::vector<Cell>& row = table.rows[last];
  EXPECT_EQ(std::get<double>(row[3]), static_cast<double>(histories.records * run.cases));
  EXPECT_EQ(std::get<double>(row[4]), above);
}

TEST(samples_table, has_a_row_for_each_sample_and_a_column_for_each_parameter) {
  const Results results = made_up_results();
  const Table table = samples_table(results);
  ASSERT_EQ(table.rows.size(), 16u);
  for (const Parameter& p : parameters()) {
    if (p.axes == Parameter::Axes::two) continue;  // one axis
    for (std::size_t j = 0; j < 16; ++j) {
      const double cell = std::get<double>(cell_of(table, j, std::string(p.table) + "_" + p.key));
      if (p.absent != nullptr)
        EXPECT_TRUE(std::isnan(cell)) << p.key;  // alpha of one mass
      else
        EXPECT_EQ(cell, value_of(p, results.cases.cases[j])) << p.key;
    }
  }
  EXPECT_EQ(std::get<double>(cell_of(table, 3, "ground_azimuth_deg")),
            results.cases.cases[3].orientation.ground_azimuth_deg);
}

TEST(samples_table, of_very_many_samples_has_the_first) {
  Results results = made_up_results();
  results.cases.samples = 5000;
  results.cases.cases.resize(results.cases.combinations() * results.cases.per_combination());
  const Table table = samples_table(results);
  EXPECT_EQ(table.rows.size(), 4096u);
  EXPECT_THAT(table.title, states("4096", "5000"));
}

TEST(fragility_table, leaves_failed_fits_empty_and_the_summary_uses_the_fit_that_converged) {
  Results results = made_up_results();
  FitSummary& fit = results.runs[0].fragilities[0].capacities;
  fit = FitSummary{};
  fit.note = "too few";
  const Table table = fragility_table(results);
  EXPECT_TRUE(std::isnan(std::get<NumberCell>(table.rows[1][3]).value));
  EXPECT_EQ(cell_text(table.columns[3], table.rows[1][3]), "-");
  const Table summary = fragility_summary_table(results);
  EXPECT_EQ(std::get<NumberCell>(summary.rows[0][2]).value,
            results.runs[0].fragilities[0].stripes.curve.median);
  EXPECT_EQ(std::get<std::string>(cell_of(summary, 0, "method")), "stripes");
  EXPECT_EQ(std::get<std::string>(cell_of(summary, 1, "method")), "capacities");
}

TEST(table, fits_a_terminal_by_breaking_headings_and_texts_and_leaving_out_the_last_columns) {
  Table table{"wide",
              "A title that is longer than a terminal is wide, so that it takes two lines of it",
              {text_column("id", "Record")},
              {}};
  for (int c = 0; c < 4; ++c)
    table.columns.push_back({"c" + std::to_string(c), "", "A heading " + std::to_string(c)});
  table.add({"rsn953_beverly_hills_14145_mulhol", 1.0, 2.0, 3.0, 4.0});
  const auto longest = [&] {
    std::size_t length = 0;
    for (const std::string& line : wrapped(to_text(table), 10000))
      length = std::max(length, display_width(line));
    return length;
  };
  EXPECT_LE(longest(), terminal_width);
  EXPECT_THAT(to_text(table), states("rsn953_beverly_hills_14145_mulhol"));  // headings first
  for (int c = 4; c < 12; ++c) {
    table.columns.push_back({"c" + std::to_string(c), "", "A heading " + std::to_string(c)});
    table.rows[0].emplace_back(1.0);
  }
  EXPECT_LE(longest(), terminal_width);
  EXPECT_THAT(to_text(table), states("CSV", "A heading 7"));
  table.columns[1].detail = true;
  EXPECT_THAT(to_text(table), Not(states("heading 0")));
  EXPECT_THAT(to_csv(table), states("c0,c1"));
}

TEST(fragility_tables, show_the_share_that_slides_freely_and_where_half_of_all_exceed) {
  Results results = made_up_results();
  for (const Column& column : fragility_summary_table(results).columns)
    EXPECT_NE(column.stem, "free_sliding_share");  // none does
  FitSummary& fit = results.runs[0].fragilities[0].capacities;
  fit.curve.floor = 0.125;
  for (const Table& table : {fragility_summary_table(results), fragility_table(results)}) {
    const std::size_t row = table.name == "fragility" ? 1 : 0;
    const Cell share = cell_of(table, row, "free_sliding_share");
    EXPECT_EQ(
        table.name == "fragility" ? std::get<NumberCell>(share).value : std::get<double>(share),
        0.125);
    EXPECT_EQ(std::get<NumberCell>(cell_of(table, row, "p50")).value, fit.curve.intensity_at(0.5));
  }
}

}  // namespace
}  // namespace glissade
