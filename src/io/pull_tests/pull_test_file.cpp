// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/pull_test_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "glissade/core/error.hpp"
#include "pull_tests/pull_test_columns.hpp"
#include "text/csv_rows.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

using enum PullTestColumn;

constexpr const char* pull_test_beginning =
    "a header (test, direction, displacement_m, force_n, normal_n; or mu, of tests that are "
    "evaluated) and give a row for each sample or test";

struct PullTestRow {
  std::string test, direction;
  std::optional<double> time_s;
  double displacement_m = 0.0, force_n = 0.0, normal_n = 0.0;
};

/// A row's numbers and names; nothing, with the trouble, where a cell is none.
std::optional<PullTestRow> read_row(const PullTestHeader& header, const Cells& cells,
                                    RowTrouble& trouble) {
  const auto number = [&](PullTestColumn column) {
    const std::string_view cell = cells[header[column]->index];
    const auto value = parse_number(cell);
    const double si = value ? *value * header[column]->si_per_unit : 0.0;
    if (!value || !std::isfinite(si))
      trouble = {in_quotes(cell) + " is not a finite number", "", "number"};
    return si;
  };
  PullTestRow row;
  row.test = cells[header[test]->index];
  row.direction = cells[header[direction]->index];
  if (row.test.empty() || row.direction.empty())
    trouble = {"test or direction is empty", "name both in every row"};
  if (!is_plain_text(row.test) || !is_plain_text(row.direction)) {
    trouble = {"test or direction, " + in_quotes(row.test + " " + row.direction) +
                   ", has characters that are not UTF-8 text",
               "save the file as UTF-8", "text"};
  }
  if (header[time]) row.time_s = number(time);
  row.displacement_m = number(displacement);
  row.force_n = number(force);
  row.normal_n = number(normal);
  if (!trouble.what.empty()) return std::nullopt;
  return row;
}

/// Rows that become tests, in order.
class TestBuilder {
 public:
  explicit TestBuilder(const std::filesystem::path& file) : file_(file) {}

  RowTrouble take(const PullTestRow& row, std::size_t line) {
    if (!(row.normal_n > 0.0)) {
      return {"the normal force of test " + row.test + " " + row.direction + ", " +
                  shortest_decimal(row.normal_n) + " N, is not above 0",
              "give the force between array and roof as positive", "normal"};
    }
    if (tests_.empty() || tests_.back().test != row.test ||
        tests_.back().direction != row.direction) {
      const auto [first, is_new] = begins_.try_emplace({row.test, row.direction}, line);
      tests_.push_back({row.test, row.direction, place(file_, line), {}, {}, {}, {}});
      last_time_s_.reset();
      if (!is_new) {
        return {"test " + row.test + " " + row.direction + " already began on line " +
                    std::to_string(first->second),
                "keep the rows of a test together, and name each test of a direction differently",
                "again"};
      }
    }
    if (row.time_s && last_time_s_ && *row.time_s < *last_time_s_) {
      return {"time goes back in test " + row.test + " " + row.direction + ", from " +
                  shortest_decimal(*last_time_s_) + " to " + shortest_decimal(*row.time_s) + " s",
              "give the rows of a test in order of time, and each test its own name", "time"};
    }
    last_time_s_ = row.time_s;
    if (row.time_s) tests_.back().time_s.push_back(*row.time_s);
    tests_.back().displacement_m.push_back(row.displacement_m);
    tests_.back().force_n.push_back(row.force_n);
    tests_.back().normal_n.push_back(row.normal_n);
    return {};
  }
  std::vector<PullTest> tests() && { return std::move(tests_); }

 private:
  std::filesystem::path file_;
  std::vector<PullTest> tests_;
  std::map<std::pair<std::string, std::string>, std::size_t> begins_;  ///< line of the first row
  std::optional<double> last_time_s_;
};

/// A sheet of evaluated tests: mu, and test and direction where they are there.
class Sheet {
 public:
  /// Whether the header is that of a sheet, not of pull tests as logged.
  bool take_header(const Cells& names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto column = std::ranges::find(columns_, lower_case(names[i]), &Column::name);
      if (column == columns_.end() || column->at) return false;
      column->at = i;
    }
    return columns_[0].at.has_value();
  }

  RowTrouble take_row(const Cells& cells) {
    const auto text = [&](const Column& column, const char* otherwise) {
      return std::string(column.at ? cells[*column.at] : otherwise);
    };
    const std::string mu_text = text(columns_[0], ""), direction = text(columns_[1], "all"),
                      test = text(columns_[2], "");
    const auto mu = parse_number(mu_text);
    if (!mu || !(*mu >= 0.0 && *mu <= largest_friction))
      return {
          in_quotes(mu_text) + " is not a friction from 0 to " + shortest_decimal(largest_friction),
          "", "mu"};
    if (direction.empty() || !is_plain_text(direction))
      return {"the direction is empty, or not UTF-8 text", "name it in every row"};
    if (!test.empty() && !names_.emplace(test, lower_case(direction)).second)
      return {fmt::format("test {} {} is there twice", in_quotes(test), direction),
              "give each test once, and each of a direction its own name", "again"};
    const auto same = std::ranges::find_if(tests, [&](const EvaluatedTests& known) {
      return lower_case(known.direction) == lower_case(direction);
    });
    if (same == tests.end())
      tests.push_back({direction, {*mu}});
    else
      same->mu.push_back(*mu);
    return {};
  }

  std::vector<EvaluatedTests> tests;  ///< by direction, "all" where none is stated

 private:
  struct Column {
    std::string name;
    std::optional<std::size_t> at;
  };
  std::array<Column, 3> columns_{{{"mu", {}}, {"direction", {}}, {"test", {}}}};
  std::set<std::pair<std::string, std::string>> names_;  ///< of tests, with their direction
};

/// Nothing where the file is no sheet.
std::vector<EvaluatedTests> read_sheet(const TextFile& file) {
  Sheet sheet;
  read_csv(file,
           {.split = csv_cells,
            .shown_of_a_kind = 1,
            .begin_with = pull_test_beginning,
            .take_header = [&](const auto&, const auto&,
                               const auto& names) { return sheet.take_header(names); },
            .take_row = [&](const auto& cells, const auto&) { return sheet.take_row(cells); }});
  return sheet.tests;
}

}  // namespace

PullTestResults read_pull_test_results(const TextFile& file, const SlidingRule& rule) {
  if (file.path.extension() == ".toml")
    throw InputError({file.path.string(), "is a TOML file, not a table of pull tests (CSV)",
                      "give the table with a row for each test, or sample", ""});
  if (const auto tests = read_sheet(file); !tests.empty()) return {{}, summarise(tests)};
  PullTestResults results{read_pull_tests(file), {}};
  results.summary = summarise(results.tests, rule);
  return results;
}

std::vector<PullTest> read_pull_tests(const TextFile& file) {
  PullTestHeader header;
  TestBuilder builder(file.path);
  read_csv(file, {.split = csv_cells,
                  .shown_of_a_kind = 1,
                  .begin_with = pull_test_beginning,
                  .take_header =
                      [&](const std::string& where, std::string_view line, const Cells& names) {
                        header = read_pull_test_header(where, line, names);
                        return true;
                      },
                  .take_row =
                      [&](const Cells& cells, std::size_t line) {
                        RowTrouble trouble;
                        const auto row = read_row(header, cells, trouble);
                        return row ? builder.take(*row, line) : trouble;
                      }});
  return std::move(builder).tests();
}

}  // namespace glissade
