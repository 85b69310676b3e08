// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glissade/study/results.hpp"

namespace glissade {

/// While one lives, what reads as a symbol in these names and ids of the user, "R_1", is set
/// nowhere: neither on a page nor in a figure.
class UserTexts {
 public:
  explicit UserTexts(const std::vector<std::string>& texts);
  ~UserTexts();
  UserTexts(const UserTexts&) = delete;
  UserTexts& operator=(const UserTexts&) = delete;
  static bool have(std::string_view symbol);

 private:
  std::set<std::string, std::less<>> before_;
};
/// Of the study, its suites and records.
std::vector<std::string> user_texts(const Results& results);

/// A page with its symbols set: "S_DS" with a subscript, "h^x" with a superscript. A symbol is one
/// letter; names of keys and files, drawings, listings and texts of the user stay as they are.
std::string with_symbols(const std::string& page);

}  // namespace glissade
