// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/error.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>

#include "glissade/core/printable.hpp"

namespace glissade {

namespace {

/// A name of a file's may be as long as the file.
std::string shortened(const std::string& text) {
  constexpr std::size_t most_bytes = 4000;
  if (text.size() <= most_bytes) return text;
  std::size_t end = most_bytes;
  while ((static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u && end > 0) --end;  // in UTF-8
  return text.substr(0, end) + "...";
}

}  // namespace

std::string quoted_for_shell(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-=:,@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string to_string(const Problem& problem) {
  std::string text;
  if (!problem.where.empty()) text += printable_name(problem.where) + ": ";
  text += shortened(problem.what);
  if (!problem.suggestion.empty()) text += "; " + problem.suggestion;
  if (!problem.excerpt.empty()) text += "\n" + problem.excerpt;
  return printable(text);
}

namespace {

std::string join(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += "\n";
    text += to_string(problem);
  }
  return text;
}

/// Optimal string alignment distance (Levenshtein with adjacent transpositions), by rows.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1), above(row), above_that(row);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    above_that.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min(replace, std::min(above[j], row[j - 1]) + 1);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], above_that[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

InputError::InputError(Problem problem) : InputError(std::vector<Problem>{std::move(problem)}) {}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error(join(problems)), problems_(std::move(problems)) {}

void ProblemList::add(const InputError& error) {
  problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
}

void ProblemList::throw_if_any() const {
  constexpr std::size_t most = 100;
  if (problems_.empty()) return;
  if (problems_.size() <= most) throw InputError(problems_);
  std::vector<Problem> shown(problems_.begin(), problems_.begin() + most);
  shown.push_back({"", std::to_string(problems_.size() - most) + " more problems", "", ""});
  throw InputError(std::move(shown));
}

namespace {

/// Without the dashes of an option.
std::string stem_of(const std::string& word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
}

/// "sa" of "sa_period_s", "mu" of "--mu".
std::string first_part(const std::string& word) {
  const std::string stem = stem_of(word);
  return stem.substr(0, stem.find_first_of("-_"));
}

/// With the name here of a quantity that people call otherwise: "slope_deg" of "tilt_deg".
std::string usual_name(const std::string& word) {
  struct Synonym {
    const char *said, *name;
  };
  const std::string part = first_part(word);
  for (const auto& [said, name] :
       {Synonym{"angle", "slope"}, Synonym{"tilt", "slope"}, Synonym{"pitch", "rise"},
        Synonym{"coefficient", "mu"}, Synonym{"friction", "mu"},
        Synonym{"clearances", "thresholds"}, Synonym{"gap", "clearance"}, Synonym{"output", "out"},
        Synonym{"force", "overwrite"}}) {
    if (part != said) continue;
    const std::size_t begin = word.size() - stem_of(word).size();
    return word.substr(0, begin) + name + word.substr(begin + part.size());
  }
  return word;
}

std::string in_lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// asce7_22 and asce7_10: two numbers, no misspelling.
bool differ_in_digits_only(const std::string& a, const std::string& b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return std::ranges::equal(a, b,
                            [&](char x, char y) { return x == y || (is_digit(x) && is_digit(y)); });
}

/// "period" of "period_s"; of a name that does not end with a unit, the name.
std::string without_unit(const std::string& name) {
  const std::size_t at = name.find_last_of("-_");
  if (at == std::string::npos) return name;
  const std::string last = name.substr(at + 1);
  return last.size() <= 3 || last == "years" ? name.substr(0, at) : name;
}

/// Slips of the pen from a word, or a synonym of it, to a name with or without its unit.
std::size_t distance_between(const std::string& word, const std::string& name) {
  const std::string bare = without_unit(name);
  const bool begins = stem_of(word).size() > 2 && bare != name && bare.starts_with(word);
  std::size_t least = begins ? 1 : word.size();
  for (const std::string& said : {word, usual_name(word)})
    least = std::min({least, edit_distance(said, name), edit_distance(said, bare)});
  return least;
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_word = 100;
  if (word.size() > longest_word) return "";
  const std::string lower = in_lower_case(word);
  for (const std::string& candidate : candidates) {
    if (in_lower_case(candidate) == lower) return candidate;
  }
  // Words of a few letters, or of as many other digits, are other words.
  const std::size_t size = word.size();
  const std::size_t most = size < 3 ? 0 : size < 6 ? 1 : size < 12 ? 2 : 3;
  std::string best;
  std::size_t best_distance = most + 1;
  for (const std::string& candidate : candidates) {
    if (differ_in_digits_only(word, candidate)) continue;
    const std::size_t distance = distance_between(word, candidate);
    if (distance > most || distance > best_distance ||
        (distance == best_distance && candidate.size() >= best.size()))
      continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

}  // namespace glissade
