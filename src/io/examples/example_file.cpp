// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/example_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "examples/quickstart.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/project_file.hpp"
#include "keys/grammar.hpp"
#include "text/scan.hpp"
#include "toml/toml_text.hpp"

namespace glissade {
namespace {

/// "mu" of "mu = 0.5" and of "# mu = 0.5"; empty where the line has no key.
std::string key_of(std::string_view line) {
  if (line.starts_with("# ")) line.remove_prefix(2);
  const std::string_view key = trimmed(line.substr(0, line.find('=')));
  const bool is_key = line.find('=') != std::string_view::npos && !key.empty() &&
                      key.find_first_of(" #[\"") == std::string_view::npos;
  return is_key ? std::string(key) : "";
}

/// The comment behind a value, from "# " on. Values of the examples hold no '#'.
std::string comment_behind(const std::string& line) {
  const std::size_t at = line.find(" # ", 2);
  return at == std::string::npos ? "" : line.substr(at + 1);
}

}  // namespace

ExampleFile::ExampleFile(const std::string& text, Comments comments) : comments_(comments) {
  LineReader reader(text);
  while (reader.next()) {
    const bool keep = comments == Comments::as_they_are || !is_blank_or_comment(reader.line());
    if (keep) lines_.emplace_back(reader.line());
  }
}

ExampleFile ExampleFile::study() { return {quickstart_study, Comments::of_the_grammar}; }
ExampleFile ExampleFile::project() { return {project_example(), Comments::as_they_are}; }

std::size_t ExampleFile::line_of(const std::string& table, const std::string& key) {
  auto at = std::ranges::find(lines_, "[" + table + "]");
  GLISSADE_EXPECTS(at != lines_.end());
  auto below = ++at;
  for (; at != lines_.end() && !at->starts_with("["); ++at) {
    if (key_of(*at) == key) return static_cast<std::size_t>(at - lines_.begin());
    if (!key_of(*at).empty()) below = at + 1;
  }
  return static_cast<std::size_t>(lines_.insert(below, "") - lines_.begin());
}

void ExampleFile::set(const std::string& table, const std::string& key, const std::string& value) {
  set_example(table, key, value);
  given_.insert(table + "." + key);
}

void ExampleFile::set_example(const std::string& table, const std::string& key,
                              const std::string& value) {
  std::string& line = lines_[line_of(table, key)];
  line = fmt::format("{:<40} {}", key + " = " + value, comment_behind(line));
}

std::string ExampleFile::string_value(const std::string& text) { return quoted(text); }

void ExampleFile::set_text(const std::string& table, const std::string& key,
                           const std::string& text) {
  set(table, key, string_value(text));
}

void ExampleFile::set_numbers(const std::string& table, const std::string& key,
                              const std::vector<double>& values) {
  set(table, key, list_of(values));
}

void ExampleFile::set_path(const std::string& table, const std::string& key,
                           const std::filesystem::path& path, const std::filesystem::path& folder) {
  set(table, key, path_from(path, folder));
}

void ExampleFile::comment_out(const std::string& table, const std::string& key) {
  std::string& line = lines_[line_of(table, key)];
  if (!line.starts_with("#"))
    line = fmt::format("{:<40} {}", "# " + std::string(trimmed(line.substr(0, line.find(" # ")))),
                       comment_behind(line));
}

void ExampleFile::leave_out(const std::string& table) {
  const auto begin = std::ranges::find(lines_, "[" + table + "]");
  GLISSADE_EXPECTS(begin != lines_.end());
  lines_.erase(begin, std::find_if(begin + 1, lines_.end(),
                                   [](const std::string& line) { return line.starts_with("["); }));
}

void ExampleFile::take_example(const std::string& table, const std::string& key) {
  std::string& line = lines_[line_of(table, key)];
  if (line.starts_with("# ")) line.erase(0, 2);
}

std::string ExampleFile::of_example() const {
  std::string text, table, keys;
  const auto end_table = [&] {
    if (!keys.empty())
      text += fmt::format("  {:<12}{}\n", table, wrapped(keys, terminal_width, 14));
    keys.clear();
  };
  for (const std::string& line : lines_) {
    if (line.starts_with("[")) {
      end_table();
      table = line.substr(1, line.find(']') - 1);
    }
    const std::string key = line.starts_with("#") ? "" : key_of(line);
    if (key.empty() || given_.contains(table + "." + key) || line.starts_with(key + " = \"\""))
      continue;
    keys += (keys.empty() ? "" : ", ") + key;
  }
  end_table();
  return text;
}

std::string ExampleFile::text() const {
  std::string text, table;
  const std::vector<GrammarKey>& keys = grammar();
  for (const std::string& line : lines_) {
    if (comments_ == Comments::of_the_grammar && line.starts_with("[")) {
      table = line.substr(1, line.find(']') - 1);
      text += "\n";
    }
    const bool is_long = line.size() > terminal_width && !comment_behind(line).empty();
    const std::string value = comments_ == Comments::of_the_grammar || is_long
                                  ? line.substr(0, line.find(" # ", 2))
                                  : line;
    if (comments_ == Comments::as_they_are && is_long)
      for (const std::string& part : wrapped(comment_behind(line).substr(2), terminal_width - 2))
        text += "# " + part + "\n";
    const auto known = std::ranges::find(keys, table + "." + key_of(line), &GrammarKey::name);
    if (known != keys.end()) {
      for (const std::string& part : wrapped(known->in_full(), terminal_width - 2))
        text += "# " + part + "\n";
    }
    text += value.substr(0, value.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace glissade
