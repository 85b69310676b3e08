// SPDX-License-Identifier: GPL-3.0-or-later
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>
#include <sstream>

namespace glissade::verification {
namespace {

constexpr const char* measured_begins = "<!-- measured -->";
constexpr const char* measured_ends = "<!-- end of measured -->";

std::string number_of(const Chapter& chapter) {
  const std::string number = chapter.title.substr(0, chapter.title.find(' '));
  return number.ends_with('.') ? number.substr(0, number.size() - 1) : number;
}

std::string measured_block(const std::string& text) {
  return fmt::format("\n{}\n\n{}\n{}\n", measured_begins, text.substr(text.front() == '\n'),
                     measured_ends);
}

struct Tally {
  std::size_t cases = 0, passed = 0;
  double of_tolerance = -1.0;  ///< the largest; below zero where no case has one

  void add(const Case& c) {
    ++cases;
    passed += c.pass ? 1 : 0;
    if (!std::isnan(c.of_tolerance)) of_tolerance = std::max(of_tolerance, c.of_tolerance);
  }
};

Tally tally(const std::vector<Chapter>& chapters, ReferenceFrom from) {
  Tally tally;
  for (const Chapter& chapter : chapters)
    for (const Case& c : chapter.cases)
      if (c.from == from) tally.add(c);
  return tally;
}

std::string totals(const std::vector<Chapter>& chapters) {
  std::string text =
      "| chapter | most important reference | cases | passed | largest difference / tolerance |\n"
      "|---|---|---|---|---|\n";
  for (const Chapter& chapter : chapters) {
    Tally tally;
    for (const Case& c : chapter.cases) tally.add(c);
    text += fmt::format("| {} | {} | {} | {} | {} |\n", chapter.title, chapter.reference,
                        tally.cases, tally.passed,
                        tally.of_tolerance < 0.0 ? "-" : fmt::format("{:.2g}", tally.of_tolerance));
  }
  return text;
}

struct Part {
  const char *number, *title, *text;
};
constexpr Part papers[] = {
    {"1.", "1. Is the first paper reproduced?",
     R"(Rodriguez-Nikl, Cedano, Martinez & Ojeda (2019) solve the sliding block on a rigid roof by time steps.
The method and its trends are reproduced. Single numbers depend on the record of the paper, Tokachi-Oki
2003, which is not available: built-in motions are used instead. P is the number of substeps in one
sample interval.)"},
    {"2.", "2. Is the second paper reproduced?",
     R"(Walters, Berkowitz, Lau, Lee & Baker (2012) study an array on a building of one degree of freedom, with
both axes, the vertical, a yielding spring and the mass of the array. Their suites are not published,
except that of Level 2. Built-in suites of the same design spectra are used instead, so that trends can be
compared and single numbers cannot. The trends are reproduced, but for those that the table does not
confirm. Lengths are means over the suite, and the median over the orientations.)"}};

std::string findings_on(const Part& paper, const std::vector<Chapter>& chapters) {
  std::string table = "| chapter | the paper | here | confirmed |\n|---|---|---|---|\n";
  for (const Chapter& chapter : chapters)
    for (const Finding& finding : chapter.findings)
      if (chapter.title.starts_with(paper.number))
        table += fmt::format("| {} | {} | {} | {} |\n", number_of(chapter), finding.paper,
                             finding.here, finding.confirmed);
  return fmt::format("\n## {}\n\n{}\n{}", paper.title, paper.text, measured_block(table));
}

std::string section(const Chapter& chapter) {
  std::string text = fmt::format("\n## {}\n\n{}\n", chapter.title, chapter.text);
  if (!chapter.measured.empty()) text += measured_block(chapter.measured);
  if (!chapter.figures.empty()) text += "\n" + chapter.figures;
  return text;
}

// -- CSV

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  return '"' + std::regex_replace(text, std::regex("\""), "\"\"") + '"';
}

std::string row(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& c : cells) text += (text.empty() ? "" : ",") + cell(c);
  return text + '\n';
}

using Same = std::function<bool(const std::string&, const std::string&)>;

std::string first_difference(const std::string& committed, const std::string& made,
                             const Same& same) {
  std::istringstream a(committed), b(made);
  for (std::string x, y; true;) {
    const bool more_a = static_cast<bool>(std::getline(a, x)),
               more_b = static_cast<bool>(std::getline(b, y));
    if (!more_a && !more_b) return {};
    if (!more_a) x = "(end)";
    if (!more_b) y = "(end)";
    if (!same(x, y)) return fmt::format("committed: {}\nmade now:  {}", x, y);
  }
}

bool same_numbers(const std::string& x, const std::string& y) {
  const std::vector<std::string> a = csv_cells(x), b = csv_cells(y);
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    try {
      if (std::abs(std::stod(a[i]) - std::stod(b[i])) > 0.0101) return false;
    } catch (const std::exception&) {
      return false;  // no numbers
    }
  }
  return true;
}

}  // namespace

std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += line[i];
  }
  return cells;
}

Chapter consistency(std::vector<Chapter>& chapters) {
  Chapter own{
      "10. Consistency",
      "another part of glissade",
      R"(The reference of these cases is another part of glissade: the readable scheme and the fast kernel, the full
model and a simpler one, a run and an interpolation. They show that two parts agree, not that either is
right. Each case begins with the number of its chapter.)",
      {}};
  for (Chapter& chapter : chapters) {
    for (Case& c : chapter.cases) {
      if (c.from != ReferenceFrom::this_code) continue;
      own.cases.push_back(c);
      own.cases.back().name = number_of(chapter) + ": " + c.name;
    }
    std::erase_if(chapter.cases, [](const Case& c) { return c.from == ReferenceFrom::this_code; });
  }
  return own;
}

std::string page(const std::vector<Chapter>& chapters) {
  const Tally outside = tally(chapters, ReferenceFrom::outside),
              own = tally(chapters, ReferenceFrom::this_code);
  std::string text =
      fmt::format(R"(# Verification manual

Does glissade solve its equations right? A case compares a result with a closed form, a published number,
another method, or an exact law of the physics: {} of {} pass. Where the reference is another part of
glissade (chapter 10), {} of {} pass. Every case is a row of [cases.csv](cases.csv). Chapters 1 and 2 begin
with what is confirmed of two papers. Kills, full disks and damaged files: [reliability.md](reliability.md).

{}
Cases whose tolerance is a range, or that must be equal to the last bit, have no number in the last column.

This page and the CSV files are generated, after `cmake --preset dev`:

```
cmake --build --preset dev --target verification_manual   # makes them and the figures, in two minutes
ctest --preset dev -R '^verification'                     # fails where a case fails or a file differs
```

Each chapter has a file in this folder. Other machines may differ in the last digits. Monte Carlo cases have
fixed seeds.
)",
                  outside.passed, outside.cases, own.passed, own.cases, totals(chapters));
  for (const Part& paper : papers) {
    text += findings_on(paper, chapters);
    for (const Chapter& chapter : chapters)
      if (chapter.title.starts_with(paper.number)) text += section(chapter);
  }
  for (const Chapter& chapter : chapters)
    if (std::ranges::none_of(
            papers, [&](const Part& paper) { return chapter.title.starts_with(paper.number); }))
      text += section(chapter);
  return text;
}

std::string cases_csv(const std::vector<Chapter>& chapters) {
  std::string text = "chapter,case,quantity,reference,metric,tolerance,result,pass\n";
  for (const Chapter& chapter : chapters)
    for (const Case& c : chapter.cases)
      text += row({number_of(chapter), c.name, c.quantity, c.reference, c.metric, c.tolerance,
                   c.result, yes(c.pass)});
  return text;
}

std::string comparable_page(const std::string& page) {
  static const std::regex numbers("[-+]?[0-9][-+0-9.,e]*");
  std::istringstream in(page);
  std::string text;
  bool measured = false;
  for (std::string line; std::getline(in, line);) {
    if (line == measured_begins) measured = true;
    if (line == measured_ends) measured = false;
    if (measured)
      line = std::regex_replace(line, numbers, "#");
    else if (line.starts_with("| "))
      line.erase(line.rfind(" | "));
    text += line + '\n';
  }
  return text;
}

std::string comparable_cases(const std::string& csv) {
  constexpr std::size_t result = 6;
  std::istringstream in(csv);
  std::string text;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells = csv_cells(line);
    if (cells.size() > result) cells.erase(cells.begin() + result);
    text += row(cells);
  }
  return text;
}

std::string first_difference(const std::string& committed, const std::string& made) {
  return first_difference(committed, made, std::equal_to<std::string>());
}

std::string first_difference_of_numbers(const std::string& committed, const std::string& made) {
  return first_difference(committed, made, same_numbers);
}

}  // namespace glissade::verification
