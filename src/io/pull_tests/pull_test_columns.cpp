// SPDX-License-Identifier: GPL-3.0-or-later
#include "pull_tests/pull_test_columns.hpp"

#include <algorithm>
#include <string>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

using enum PullTestColumn;

struct KnownName {
  const char* name;
  PullTestColumn column;
  double si_per_unit;
};
constexpr std::array<KnownName, 12> known_names{{{"test", test, 1.0},
                                                 {"direction", direction, 1.0},
                                                 {"time_s", time, 1.0},
                                                 {"displacement_m", displacement, 1.0},
                                                 {"displacement_mm", displacement, 1e-3},
                                                 {"displacement_in", displacement, inch_m},
                                                 {"force_n", force, 1.0},
                                                 {"force_kn", force, 1e3},
                                                 {"force_lbf", force, pound_force_n},
                                                 {"normal_n", normal, 1.0},
                                                 {"normal_kn", normal, 1e3},
                                                 {"normal_lbf", normal, pound_force_n}}};

std::vector<std::string> names_of(PullTestColumn column) {
  std::vector<std::string> names;
  for (const KnownName& known : known_names)
    if (known.column == column) names.emplace_back(known.name);
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return text;
}

const KnownName* find_name(const std::string& name) {
  const auto at = std::find_if(known_names.begin(), known_names.end(),
                               [&](const KnownName& known) { return name == known.name; });
  return at == known_names.end() ? nullptr : &*at;
}

std::string suggestion_for(const std::string& name) {
  if (name == "mu")
    return "friction of each test, evaluated already, is a file with a column mu, and test and "
           "direction if wanted, alone";
  std::vector<std::string> names;
  for (const KnownName& known : known_names) names.emplace_back(known.name);
  const std::string nearest = nearest_word(name, names);
  return nearest.empty() ? "known are " + joined(names) +
                               "; or, of friction that is evaluated already, mu, test and "
                               "direction alone; leave others out"
                         : "did you mean " + nearest + "?";
}

}  // namespace

PullTestHeader read_pull_test_header(const std::string& where, std::string_view line,
                                     const std::vector<std::string_view>& cells) {
  refuse_separators(where, line, ";\t");
  PullTestHeader header;
  ProblemList problems;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string name = lower_case(cells[i]);
    const KnownName* known = find_name(name);
    if (known == nullptr) {
      problems.add(
          {where, "the column " + in_quotes(cells[i]) + " is not known", suggestion_for(name), ""});
      continue;
    }
    auto& column = header.columns[static_cast<std::size_t>(known->column)];
    if (column) {
      problems.add({where, joined(names_of(known->column)) + " is there more than once",
                    "keep one of them", ""});
    }
    column = PullTestHeader::Column{i, known->si_per_unit};
  }
  for (const PullTestColumn needed : {test, direction, displacement, force, normal}) {
    if (!header[needed]) {
      problems.add({where, "the column " + joined(names_of(needed)) + " is missing",
                    "the first line names the columns, separated by commas", ""});
    }
  }
  problems.throw_if_any();
  return header;
}

}  // namespace glissade
