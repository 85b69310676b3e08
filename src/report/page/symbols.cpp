// SPDX-License-Identifier: GPL-3.0-or-later
#include "page/symbols.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "glissade/report/format.hpp"

namespace glissade {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
/// The second byte of a Greek letter ends at `at`.
bool is_greek(std::string_view page, std::size_t at) {
  const auto lead = at >= 2 ? static_cast<unsigned char>(page[at - 2]) : 0U;
  return lead == 0xCEU || lead == 0xCFU;
}

/// Up to the end of letters, digits, and points between digits.
std::size_t end_of_index(std::string_view page, std::size_t at) {
  while (at < page.size() && (is_letter(page[at]) || is_digit(page[at]) ||
                              (page[at] == '.' && at + 1 < page.size() && is_digit(page[at + 1]) &&
                               is_digit(page[at - 1]))))
    ++at;
  return at;
}

/// A Greek letter ends at `at`, or another letter that is a word of its own.
bool is_symbol(std::string_view page, std::size_t at) {
  if (is_greek(page, at)) return true;
  if (at == 0 || !is_letter(page[at - 1])) return false;
  return at == 1 || (!is_word(page[at - 2]) && page[at - 2] != '.' && !is_greek(page, at - 1));
}

/// Where nothing is set: a tag, or all of an element that shows its text as it is; to the end of
/// the page where it is not closed.
std::size_t end_of_markup(std::string_view page, std::size_t at) {
  const auto behind = [&](std::string_view close) {
    const std::size_t found = page.find(close, at);
    return found == std::string_view::npos ? page.size() : found + close.size();
  };
  for (const auto& [open, close] :
       std::array<std::array<std::string_view, 2>, 5>{{{"<style", "</style>"},
                                                       {"<span class=\"given\"", "</span>"},
                                                       {"<title", "</title>"},
                                                       {"<pre", "</pre>"},
                                                       {"<svg", "</svg>"}}})
    if (page.substr(at).starts_with(open)) return behind(close);
  return behind(">");
}

/// Each symbol that `may_be_set`.
std::string set_symbols(std::string_view page, const auto& may_be_set) {
  std::string set;
  set.reserve(page.size() + page.size() / 16);
  std::size_t at = 0;
  while (at < page.size()) {
    const char c = page[at];
    if (c == '<') {
      const std::size_t end = end_of_markup(page, at);
      set.append(page, at, end - at);
      at = end;
      continue;
    }
    const bool is_sub = c == '_' && is_symbol(page, at), is_sup = c == '^';
    const std::size_t end = is_sub || is_sup ? end_of_index(page, at + 1) : at;
    const std::size_t begin = is_greek(page, at) ? at - 2 : at - std::min<std::size_t>(at, 1);
    if (end <= at + 1 ||
        (end < page.size() && (page[end] == '_' || page[end] == '.') && end + 1 < page.size() &&
         is_word(page[end + 1])) ||
        !may_be_set(page.substr(begin, end - begin))) {
      set += c;
      ++at;
      continue;
    }
    const char* tag = is_sub ? "sub" : "sup";
    set.append("<").append(tag).append(">").append(page, at + 1, end - at - 1);
    set.append("</").append(tag).append(">");
    at = end;
  }
  return set;
}

std::set<std::string, std::less<>> symbols_of_user;

}  // namespace

UserTexts::UserTexts(const std::vector<std::string>& texts) {
  std::set<std::string, std::less<>> found;
  for (const std::string& text : texts)
    set_symbols(text, [&](std::string_view symbol) {
      found.emplace(symbol);
      found.insert(capitalised(std::string(symbol)));  // at the beginning of a sentence
      return false;
    });
  before_ = std::exchange(symbols_of_user, std::move(found));
}
UserTexts::~UserTexts() { symbols_of_user = std::move(before_); }
bool UserTexts::have(std::string_view symbol) { return symbols_of_user.contains(symbol); }

std::vector<std::string> user_texts(const Results& results) {
  std::vector<std::string> texts{results.study_name};
  for (const SuiteSummary& suite : results.suites) texts.push_back(suite.name);
  for (const RecordSummary& r : results.records)
    texts.insert(texts.end(), {r.id, r.event, r.station});
  return texts;
}

std::string with_symbols(const std::string& page) {
  return set_symbols(page, [](std::string_view symbol) { return !UserTexts::have(symbol); });
}

}  // namespace glissade
