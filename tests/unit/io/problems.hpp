// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "facts.hpp"
#include "glissade/core/error.hpp"

namespace glissade {

inline void PrintTo(const Problem& problem, std::ostream* out) { *out << to_string(problem); }

/// What an InputError reports; empty if nothing was thrown.
template <class Action>
std::vector<Problem> problems_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

/// Everything an InputError says; "" if nothing was thrown.
template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The line of a file that each problem of an InputError names, 0 where none; empty if nothing was
/// thrown.
template <class Action>
std::vector<std::size_t> lines_of(const Action& action) {
  std::vector<std::size_t> lines;
  for (const Problem& p : problems_of(action))
    lines.push_back(std::strtoull(p.where.c_str() + p.where.rfind(':') + 1, nullptr, 10));
  return lines;
}

/// The line and the key of each problem of an InputError: "14 building.period_s".
template <class Action>
std::vector<std::string> faults_of(const Action& action) {
  std::vector<std::string> faults;
  const std::vector<std::size_t> lines = lines_of(action);
  for (const Problem& p : problems_of(action))
    faults.push_back(std::to_string(lines[faults.size()]) + " " +
                     p.what.substr(0, p.what.find(' ')));
  return faults;
}

/// A problem at this place ("record:6", the file without its folder) with these values, keys and
/// names.
MATCHER_P2(is_problem, where, facts,
           "is a problem at " + std::string(where) + " with " + testing::PrintToString(facts)) {
  return arg.where.substr(arg.where.rfind('/') + 1) == where &&
         testing::Value(arg.what + "; " + arg.suggestion, test::states_all(facts));
}
/// The same, and no other problem.
inline auto is_one_problem(const std::string& where, const std::vector<std::string>& facts) {
  return testing::ElementsAre(is_problem(where, facts));
}
template <class... Facts>
auto one_problem(const std::string& where, const Facts&... facts) {
  return is_one_problem(where, std::vector<std::string>{facts...});
}

/// An input that is refused by one problem.
struct Refusal {
  std::string input, where;
  std::vector<std::string> facts;
};
template <class Read>
void expect_refusals(const Read& read, const std::vector<Refusal>& refusals) {
  for (const auto& [input, where, facts] : refusals)
    EXPECT_THAT(problems_of([&] { read(input); }), is_one_problem(where, facts)) << input;
}

}  // namespace glissade
