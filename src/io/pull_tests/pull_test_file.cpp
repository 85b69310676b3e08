// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/pull_test_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "pull_tests/pull_test_columns.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

using enum PullTestColumn;

struct PullTestRow {
  std::string test, direction;
  std::optional<double> time_s;
  double displacement_m = 0.0, force_n = 0.0, normal_n = 0.0;
};

/// What is wrong with a row: `kind` once, `what` with its own numbers.
struct Trouble {
  std::string kind, what, suggestion;
};

/// The first row of each kind of trouble, and how many more there are: a trace has thousands.
class Troubles {
 public:
  void add(const Trouble& trouble, const std::string& where, std::string_view line) {
    auto [at, is_new] = first_.try_emplace(trouble.kind, order_.size());
    if (is_new) {
      order_.push_back(
          {{where, trouble.what, trouble.suggestion, "  " + std::string(line.substr(0, 100))}, 0});
    } else {
      ++order_[at->second].more;
    }
  }
  void throw_if_any() const {
    ProblemList problems;
    for (auto [problem, more] : order_) {
      if (more > 0) problem.what += " (and so " + std::to_string(more) + " more)";
      problems.add(problem);
    }
    problems.throw_if_any();
  }

 private:
  struct Entry {
    Problem problem;
    std::size_t more;
  };
  std::map<std::string, std::size_t> first_;
  std::vector<Entry> order_;
};

/// A row's numbers and names; nothing, with the trouble, where a cell is none.
std::optional<PullTestRow> read_row(const PullTestHeader& header, std::string_view line,
                                    Trouble& trouble) {
  const std::vector<std::string_view> cells = csv_cells(line);
  if (cells.size() != header.width) {
    trouble = {"columns",
               std::to_string(cells.size()) + " column(s) where the header has " +
                   std::to_string(header.width),
               ""};
    return std::nullopt;
  }
  const auto number = [&](PullTestColumn column) {
    const std::string_view cell = cells[header[column]->index];
    const auto value = parse_number(cell);
    const double si = value ? *value * header[column]->si_per_unit : 0.0;
    if (!value || !std::isfinite(si))
      trouble = {"number", in_quotes(cell) + " is not a finite number", ""};
    return si;
  };
  PullTestRow row;
  row.test = cells[header[test]->index];
  row.direction = cells[header[direction]->index];
  if (row.test.empty() || row.direction.empty())
    trouble = {"name", "test or direction is empty", "name both in every row"};
  if (!is_plain_text(row.test) || !is_plain_text(row.direction)) {
    trouble = {"text",
               "test or direction, " + in_quotes(row.test + " " + row.direction) +
                   ", has characters that are not UTF-8 text",
               "save the file as UTF-8"};
  }
  if (header[time]) row.time_s = number(time);
  row.displacement_m = number(displacement);
  row.force_n = number(force);
  row.normal_n = number(normal);
  if (!trouble.kind.empty()) return std::nullopt;
  return row;
}

/// Rows that become tests, in order.
class TestBuilder {
 public:
  explicit TestBuilder(const std::filesystem::path& file) : file_(file) {}

  Trouble take(const PullTestRow& row, std::size_t line) {
    if (!(row.normal_n > 0.0)) {
      return {"normal",
              "the normal force of test " + row.test + " " + row.direction + ", " +
                  shortest_decimal(row.normal_n) + " N, is not above 0",
              "give the force between array and roof as positive"};
    }
    if (tests_.empty() || tests_.back().test != row.test ||
        tests_.back().direction != row.direction) {
      const auto [first, is_new] = begins_.try_emplace({row.test, row.direction}, line);
      tests_.push_back({row.test, row.direction, place(file_, line), {}, {}, {}});
      last_time_s_.reset();
      if (!is_new) {
        return {"again",
                "test " + row.test + " " + row.direction + " already began on line " +
                    std::to_string(first->second),
                "keep the rows of a test together, and name each test of a direction differently"};
      }
    }
    if (row.time_s && last_time_s_ && *row.time_s < *last_time_s_) {
      return {"time",
              "time goes back in test " + row.test + " " + row.direction + ", from " +
                  shortest_decimal(*last_time_s_) + " to " + shortest_decimal(*row.time_s) + " s",
              "give the rows of a test in order of time, and each test its own name"};
    }
    last_time_s_ = row.time_s;
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

/// Columns of a sheet of evaluated tests: mu, and test and direction where they are there.
struct SheetColumns {
  std::size_t width = 0;
  std::optional<std::size_t> mu, direction, test;
};

/// Nothing where the header is that of pull tests as logged, or of no file that is known.
std::optional<SheetColumns> sheet_columns(std::string_view header) {
  const std::vector<std::string_view> cells = csv_cells(header);
  SheetColumns columns{cells.size(), {}, {}, {}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string name = lower_case(cells[i]);
    if (name == "mu" && !columns.mu)
      columns.mu = i;
    else if (name == "direction" && !columns.direction)
      columns.direction = i;
    else if (name == "test" && !columns.test)
      columns.test = i;
    else
      return std::nullopt;
  }
  return columns.mu ? std::optional(columns) : std::nullopt;
}

/// Friction by direction, "all" where none is stated; nothing where the file is no sheet.
std::vector<EvaluatedTests> read_sheet(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  LineReader reader(text);
  std::optional<SheetColumns> columns;
  std::vector<EvaluatedTests> tests;
  std::set<std::pair<std::string, std::string>> names;  // of tests, with their direction
  Troubles troubles;
  while (reader.next()) {
    if (is_blank_or_comment(reader.line())) continue;
    if (!columns) {
      columns = sheet_columns(reader.line());
      if (!columns) return {};
      continue;
    }
    const std::vector<std::string_view> cells = csv_cells(reader.line());
    const auto refuse = [&](const Trouble& trouble) {
      troubles.add(trouble, place(file, reader.number()), reader.line());
    };
    if (cells.size() != columns->width) {
      refuse({"columns",
              fmt::format("{} column(s) where the header has {}", cells.size(), columns->width),
              ""});
      continue;
    }
    const std::string direction(columns->direction ? cells[*columns->direction] : "all");
    const auto mu = parse_number(cells[*columns->mu]);
    if (!mu || !(*mu >= 0.0 && *mu <= largest_friction)) {
      refuse({"mu",
              in_quotes(cells[*columns->mu]) + " is not a friction from 0 to " +
                  shortest_decimal(largest_friction),
              ""});
    } else if (direction.empty() || !is_plain_text(direction)) {
      refuse({"name", "the direction is empty, or not UTF-8 text", "name it in every row"});
    } else if (const std::string test(columns->test ? cells[*columns->test] : "");
               !test.empty() && !names.emplace(test, lower_case(direction)).second) {
      refuse({"again", fmt::format("test {} {} is there twice", in_quotes(test), direction),
              "give each test once, and each of a direction its own name"});
    } else {
      const auto same = std::ranges::find_if(tests, [&](const EvaluatedTests& known) {
        return lower_case(known.direction) == lower_case(direction);
      });
      if (same == tests.end())
        tests.push_back({direction, {*mu}});
      else
        same->mu.push_back(*mu);
    }
  }
  troubles.throw_if_any();
  if (columns && tests.empty())
    throw InputError(
        {file.string(), "there are no rows below the header", "give a row for each test", ""});
  return tests;
}

}  // namespace

PullTestResults read_pull_test_results(const std::filesystem::path& file, const SlidingRule& rule) {
  if (file.extension() == ".toml")
    throw InputError({file.string(), "is a TOML file, not a table of pull tests (CSV)",
                      "give the table with a row for each test, or sample", ""});
  if (const auto tests = read_sheet(file); !tests.empty()) return {{}, summarise(tests)};
  PullTestResults results{read_pull_tests(file), {}};
  results.summary = summarise(results.tests, rule);
  return results;
}

std::vector<PullTest> read_pull_tests(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  LineReader reader(text);
  std::optional<PullTestHeader> header;
  TestBuilder builder(file);
  Troubles troubles;
  std::size_t rows = 0;
  while (reader.next()) {
    if (is_blank_or_comment(reader.line())) continue;
    if (!header) {
      header = read_pull_test_header(file, reader.number(), reader.line());
      continue;
    }
    ++rows;
    Trouble trouble;
    if (const auto row = read_row(*header, reader.line(), trouble))
      trouble = builder.take(*row, reader.number());
    if (!trouble.kind.empty()) troubles.add(trouble, place(file, reader.number()), reader.line());
  }
  troubles.throw_if_any();
  if (rows == 0) {
    throw InputError({file.string(),
                      header ? "there are no rows below the header" : "the file is empty",
                      "begin with a header (test, direction, displacement_m, force_n, normal_n) "
                      "and give a row for each sample",
                      ""});
  }
  return std::move(builder).tests();
}

}  // namespace glissade
