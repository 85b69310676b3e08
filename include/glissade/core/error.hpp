// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace glissade {

/// One fault of the user's input, reported as `<where>: <what> (<why>); <suggestion>`.
struct Problem {
  std::string where;  ///< "study.toml:12", "record.AT2:5", "--mu"; may be empty
  std::string what;   ///< the value and the rule it breaks: "slope_deg = 95 is not below 90"
  std::string
      suggestion;  ///< what to do: "give the slope in degrees, between -90 and 90"; may be empty
  std::string excerpt;  ///< the input line with a caret below the fault; may be empty
};

/// `where: what; suggestion`, with the excerpt indented on the lines below.
std::string to_string(const Problem& problem);

/// Bad input: all its faults in one throw. The program prints them and exits with status 2; no file
/// is overwritten. Results (never slid, level not reached, uplift ...) are never errors.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Problem problem);
  explicit InputError(std::vector<Problem> problems);
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// Collects problems and throws them together.
class ProblemList {
 public:
  void add(Problem problem) { problems_.push_back(std::move(problem)); }
  void add(const InputError& error);
  bool empty() const { return problems_.empty(); }
  void throw_if_any() const;

 private:
  std::vector<Problem> problems_;
};

/// A word of a command line that a user may copy: in quotes where the shell requires them.
std::string quoted_for_shell(const std::string& word);

/// The candidate that `word` is a misspelling or a synonym of, the nearest by edit distance; ""
/// if none is.
std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace glissade
