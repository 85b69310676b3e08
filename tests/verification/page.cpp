// SPDX-License-Identifier: GPL-3.0-or-later
#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "glissade/core/file.hpp"

namespace glissade::verification {
namespace {

constexpr const char* measured_begins = "<!-- measured -->";
constexpr const char* measured_ends = "<!-- end of measured -->";

std::string row(const Case& c) {
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", c.name, c.quantity, c.reference,
                     c.metric, c.tolerance, c.result, c.pass ? "yes" : "**no**");
}

std::string section(const Chapter& chapter) {
  std::string text = fmt::format("\n## {}\n\n{}\n\n", chapter.title, chapter.text);
  if (!chapter.cases.empty())
    text +=
        "| case | quantity | reference | metric | tolerance | result | pass "
        "|\n|---|---|---|---|---|---|---|\n";
  for (const Case& c : chapter.cases) text += row(c);
  if (!chapter.measured.empty())
    text += fmt::format("\n{}\n{}\n{}\n", measured_begins, chapter.measured, measured_ends);
  if (!chapter.figures.empty()) text += "\n" + chapter.figures;
  return text;
}

struct Tally {
  std::size_t cases = 0, passed = 0;
};
Tally tally(const std::vector<Chapter>& chapters, ReferenceFrom from) {
  Tally tally;
  for (const Chapter& chapter : chapters)
    for (const Case& c : chapter.cases) {
      if (c.from != from) continue;
      ++tally.cases;
      tally.passed += c.pass ? 1 : 0;
    }
  return tally;
}

}  // namespace

Chapter consistency(std::vector<Chapter>& chapters) {
  Chapter own{
      "10. Consistency",
      R"(The reference of these cases is another part of glissade: the readable scheme beside a fast kernel, the
full model beside a simpler one, a run beside an interpolation. They show that two parts agree, not that
either is right; what they agree with is verified in the chapters above. Each case begins with the number of its chapter.)",
      {}};
  for (Chapter& chapter : chapters) {
    const std::string number = chapter.title.substr(0, chapter.title.find(' '));
    for (Case& c : chapter.cases) {
      if (c.from != ReferenceFrom::this_code) continue;
      own.cases.push_back(c);
      own.cases.back().name = number + (number.ends_with('.') ? " " : ": ") + c.name;
    }
    std::erase_if(chapter.cases, [](const Case& c) { return c.from == ReferenceFrom::this_code; });
  }
  return own;
}

Chapter reliability() {
  return {.title = "11. Reliability",
          .text =
              "What was done to runs and files, by which command, and what came of it. These "
              "commands take minutes to hours; `reliability.md` is made by hand from what "
              "they print.",
          .cases = {},
          .measured = read_text_file(GLISSADE_SOURCE_DIR "/tests/verification/reliability.md")};
}

std::string page(const std::vector<Chapter>& chapters) {
  const Tally outside = tally(chapters, ReferenceFrom::outside),
              own = tally(chapters, ReferenceFrom::this_code);
  std::string text = fmt::format(R"(# Verification manual

Does glissade solve its equations right? Each row compares a result with a reference that does not
come from the code that is verified: a closed form, a published number, another method, or an exact
law of the physics. {} of {} cases pass.

Cases whose reference is another part of glissade are in chapter 10, Consistency: {} of {} pass. The
published scheme and the elastic link are there where they are compared with `slide()`.

This page is generated; do not edit it. From the top folder, after `cmake --preset dev`:

```
# generates this page and its figures (two minutes)
cmake --build --preset dev --target verification_manual
# generates it elsewhere; fails if a case fails, or if the committed page lists other
# cases, references, tolerances or verdicts
ctest --preset dev -R '^verification'
```

The target runs `verify_simulation` (the long simulations of chapter 6) and then
`build/dev/tests/verification/verify tests/verification`. This folder has one file for each chapter;
`case.hpp` defines a case. *Result* is that of the machine that generated the page: others may
differ in the last digits only. Monte Carlo cases have fixed seeds, and their chapter
states the confidence with which the tolerance was chosen. Run times are in tests/bench.
)",
                                 outside.passed, outside.cases, own.passed, own.cases);
  for (const Chapter& chapter : chapters) text += section(chapter);
  return text;
}

std::string comparable(const std::string& page) {
  std::istringstream in(page);
  std::string text;
  bool measured = false;
  for (std::string line; std::getline(in, line);) {
    if (line == measured_begins) measured = true;
    if (line.starts_with("| ") && !measured) {
      const auto verdict = line.rfind(" | ");
      const auto result = line.rfind(" | ", verdict - 1);
      line.erase(result, verdict - result);
    }
    if (!measured) text += line + '\n';
    if (line == measured_ends) measured = false;
  }
  return text;
}

std::string first_difference(const std::string& committed, const std::string& made) {
  std::istringstream a(committed), b(made);
  for (std::string x, y; true;) {
    const bool more_a = static_cast<bool>(std::getline(a, x)),
               more_b = static_cast<bool>(std::getline(b, y));
    if (!more_a && !more_b) return {};
    if (!more_a) x = "(end of page)";
    if (!more_b) y = "(end of page)";
    if (x != y) return fmt::format("committed: {}\nmade now:  {}", x, y);
  }
}

}  // namespace glissade::verification
