// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

namespace glissade::test {

/// Whether a text has this value, key or name, and not as a part of a longer one.
inline bool has_whole(const std::string& text, const std::string& fact) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_of_word = [&](std::size_t i) {
    return i < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  const auto goes_on = [&](std::size_t i) {  // "0.5" in "0.55" and "5" in "5.5"
    return is_of_word(i) || (i + 1 < text.size() && text[i] == '.' && is_digit(text[i - 1]) &&
                             is_digit(text[i + 1]));
  };
  for (std::size_t at = text.find(fact); at != std::string::npos; at = text.find(fact, at + 1)) {
    const std::size_t last = at + fact.size() - 1;
    if (!(is_of_word(at) && at > 0 && is_of_word(at - 1)) &&
        !(is_of_word(last) && goes_on(last + 1)))
      return true;
  }
  return false;
}

/// A text with each of these facts, whole, whatever the words around them.
MATCHER_P(states_all, facts, "states " + testing::PrintToString(facts)) {
  return std::ranges::all_of(facts, [&](const auto& fact) { return has_whole(arg, fact); });
}
template <class... Facts>
auto states(const Facts&... facts) {
  return states_all(std::vector<std::string>{facts...});
}

/// The fields of a line of CSV; a quoted comma separates none.
inline std::size_t csv_fields(const std::string& line) {
  bool quoted = false;
  std::size_t count = 1;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++count;
  }
  return count;
}

/// A CSV file with rows, all as wide as its header, below lines of `# notes`.
MATCHER(has_rows_as_wide_as_its_header, "") {
  std::istringstream lines(arg);
  std::size_t header = 0, rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (header == 0) {
      header = csv_fields(line);
      continue;
    }
    ++rows;
    if (csv_fields(line) == header) continue;
    *result_listener << csv_fields(line) << " fields, not " << header << ": " << line;
    return false;
  }
  return rows > 0;
}

}  // namespace glissade::test
