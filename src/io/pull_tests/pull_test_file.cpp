// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/pull_test_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "glissade/core/error.hpp"
#include "glissade/core/printable.hpp"
#include "pull_tests/pull_test_columns.hpp"
#include "text/csv_rows.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

using enum PullTestColumn;

constexpr const char* pull_test_beginning =
    "a header (test, direction, displacement_m, force_n, normal_n; or mu, of tests that are "
    "evaluated) and give a row for each sample or test";

Cells comma_cells(std::string_view line) { return quoted_cells(line, ','); }

struct PullTestRow {
  std::string test, direction;
  std::optional<double> time_s;
  double displacement_m = 0.0, force_n = 0.0, normal_n = 0.0;
};

/// Of a name that is no text of one line; else empty.
std::string fault_of(const std::string& name) {
  if (printable_name(name) == name) return "";
  return "the name " + in_quotes(name) + " has characters that are no UTF-8 text";
}

std::string folded(std::string_view direction) { return lower_case(trimmed(direction)); }

/// Directions by the spelling in which each first stands: those that differ in case or in blanks
/// around them are one.
class DirectionNames {
 public:
  std::string name_of(std::string_view text) {
    const std::string spelling(trimmed(text));
    const std::string& first = first_.try_emplace(folded(spelling), spelling).first->second;
    if (spelling != first) others_[first].insert(spelling);
    return first;
  }
  /// "" where the direction is spelt in one way.
  std::string note_on(const std::string& direction) const {
    const auto other = others_.find(direction);
    if (other == others_.end()) return "";
    return fmt::format("direction {}: also spelt {}, taken as one direction", direction,
                       fmt::join(other->second, ", "));
  }

 private:
  std::map<std::string, std::string> first_;             ///< by lower case
  std::map<std::string, std::set<std::string>> others_;  ///< by the first spelling
};

/// A row's numbers and names; nothing, with the trouble, where a cell is none.
std::optional<PullTestRow> read_row(const PullTestHeader& header, const Cells& cells,
                                    DirectionNames& directions, RowTrouble& trouble) {
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
  row.direction = directions.name_of(cells[header[direction]->index]);
  if (row.test.empty() || row.direction.empty())
    trouble = {"test or direction is empty", "name both in every row"};
  for (const std::string& name : {row.test, row.direction})
    if (std::string what = fault_of(name); !what.empty())
      trouble = {what, "save the file as UTF-8", "text"};
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
  explicit Sheet(DirectionNames& directions) : directions_(directions) {}

  /// Whether the header is that of a sheet, not of pull tests as logged. InputError where it has
  /// mu and other columns, or one twice.
  bool take_header(const std::string& where, const Cells& names) {
    std::vector<std::string> others;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto column = std::ranges::find(columns_, lower_case(names[i]), &Column::name);
      if (column == columns_.end() || column->at)
        others.push_back(in_quotes(names[i]));
      else
        column->at = i;
    }
    if (columns_[0].at && !others.empty())
      throw InputError({where, fmt::format("has mu, and beside it {}", fmt::join(others, ", ")),
                        "friction of tests that are evaluated has the columns mu, test and "
                        "direction, each once: leave the others out",
                        ""});
    return columns_[0].at.has_value();
  }

  RowTrouble take_row(const Cells& cells) {
    const auto text = [&](const Column& column, const char* otherwise) {
      return std::string(column.at ? cells[*column.at] : otherwise);
    };
    const std::string mu_text = text(columns_[0], ""), test = text(columns_[2], ""),
                      direction = directions_.name_of(text(columns_[1], "all"));
    const auto mu = parse_number(mu_text);
    if (!mu || !(*mu >= 0.0 && *mu <= largest_friction))
      return {
          in_quotes(mu_text) + " is not a friction from 0 to " + shortest_decimal(largest_friction),
          "", "mu"};
    if (direction.empty()) return {"the direction is empty", "name it in every row"};
    if (std::string what = fault_of(direction); !what.empty())
      return {what, "save the file as UTF-8", "text"};
    if (!test.empty() && !names_.emplace(test, direction).second)
      return {fmt::format("test {} {} is there twice", in_quotes(test), direction),
              "give each test once, and each of a direction its own name", "again"};
    const auto same = std::ranges::find(tests, direction, &EvaluatedTests::direction);
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
  DirectionNames& directions_;
  std::array<Column, 3> columns_{{{"mu", {}}, {"direction", {}}, {"test", {}}}};
  std::set<std::pair<std::string, std::string>> names_;  ///< of tests, with their direction
};

/// Nothing where the file is no sheet.
std::vector<EvaluatedTests> read_sheet(const TextFile& file, DirectionNames& directions) {
  Sheet sheet(directions);
  read_csv(file,
           {.split = comma_cells,
            .shown_of_a_kind = 1,
            .begin_with = pull_test_beginning,
            .take_header = [&](const auto& where, const auto&,
                               const auto& names) { return sheet.take_header(where, names); },
            .take_row = [&](const auto& cells, const auto&) { return sheet.take_row(cells); }});
  return sheet.tests;
}

std::vector<PullTest> read_logs(const TextFile& file, DirectionNames& directions) {
  PullTestHeader header;
  TestBuilder builder(file.path);
  read_csv(file, {.split = comma_cells,
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
                        const auto row = read_row(header, cells, directions, trouble);
                        return row ? builder.take(*row, line) : trouble;
                      }});
  return std::move(builder).tests();
}

}  // namespace

PullTestResults read_pull_test_results(const TextFile& file, const SlidingRule& rule) {
  if (file.path.extension() == ".toml")
    throw InputError({file.path.string(), "is a TOML file, not a table of pull tests (CSV)",
                      "give the table with a row for each test, or sample", ""});
  DirectionNames names;
  PullTestResults results;
  if (const auto tests = read_sheet(file, names); !tests.empty()) {
    results.summary = summarise(tests);
  } else {
    results.tests = read_logs(file, names);
    results.summary = summarise(results.tests, rule);
  }
  for (DirectionFriction& d : results.summary.directions) {
    d.note = names.note_on(d.direction);
    if (!d.note.empty()) results.summary.notes.insert(results.summary.notes.begin(), d.note);
  }
  return results;
}

const DirectionFriction* find_direction(const PullTestSummary& summary, const std::string& name) {
  const auto at = std::ranges::find_if(summary.directions, [&](const DirectionFriction& d) {
    return folded(d.direction) == folded(name);
  });
  return at == summary.directions.end() ? nullptr : &*at;
}

std::vector<PullTest> read_pull_tests(const TextFile& file) {
  DirectionNames directions;
  return read_logs(file, directions);
}

}  // namespace glissade
