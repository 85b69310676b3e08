// SPDX-License-Identifier: GPL-3.0-or-later
#include "pull_tests/pull_test_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
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
  const auto at = std::ranges::find(known_names, name, &KnownName::name);
  return at == known_names.end() ? nullptr : &*at;
}

/// The known name that a word was to be, or nullptr.
const KnownName* nearest_name(const std::string& word) {
  std::vector<std::string> names;
  for (const KnownName& known : known_names) names.emplace_back(known.name);
  return find_name(nearest_word(word, names));
}

/// One problem for all names that are not known and all columns that are therefore missing.
class HeaderFaults {
 public:
  void add_unknown(std::string_view cell) {
    const KnownName* meant = nearest_name(std::string(cell));
    unknown_.push_back(in_quotes(cell) +
                       (meant ? " (" + joined(names_of(meant->column)) + "?)" : ""));
    if (meant) meant_.insert(meant->column);
  }
  void check(const PullTestHeader& header, const std::string& where, ProblemList& problems) const {
    std::vector<std::string> missing;
    for (const PullTestColumn needed : {test, direction, displacement, force, normal})
      if (!header[needed] && !meant_.contains(needed)) missing.push_back(joined(names_of(needed)));
    const auto are = [](const std::vector<std::string>& names, const char* what) {
      return fmt::format("{} {} {} {}", names.size() == 1 ? "the column" : "the columns",
                         fmt::join(names, "; "), names.size() == 1 ? "is" : "are", what);
    };
    std::string what = unknown_.empty() ? "" : are(unknown_, "not known");
    if (!missing.empty()) what += (what.empty() ? "" : ", and ") + are(missing, "missing");
    if (!what.empty())
      problems.add({where, what,
                    "the first line names test, direction, time_s (if logged), displacement, force "
                    "and normal force, with units; or, of friction that is evaluated already, mu, "
                    "test and direction alone",
                    ""});
  }

 private:
  std::vector<std::string> unknown_;
  std::set<PullTestColumn> meant_;
};

}  // namespace

PullTestHeader read_pull_test_header(const std::string& where, std::string_view line,
                                     const std::vector<std::string_view>& cells) {
  refuse_separators(where, line, ";\t");
  PullTestHeader header;
  ProblemList problems;
  HeaderFaults faults;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const KnownName* known = find_name(lower_case(cells[i]));
    if (known == nullptr) {
      faults.add_unknown(cells[i]);
      continue;
    }
    auto& column = header.columns[static_cast<std::size_t>(known->column)];
    if (column)
      problems.add({where, joined(names_of(known->column)) + " is there more than once",
                    "keep one of them", ""});
    column = PullTestHeader::Column{i, known->si_per_unit};
  }
  faults.check(header, where, problems);
  problems.throw_if_any();
  return header;
}

}  // namespace glissade
