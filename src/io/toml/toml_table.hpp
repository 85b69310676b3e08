// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glissade/core/error.hpp"
#include "glissade/io/text_files.hpp"

namespace glissade {

/// What a number in a file must be: `is_met`, stated as `text` ("above 0"), with the reason where
/// it does not go without saying. A nan never meets a rule.
struct NumberRule {
  const char* text;
  bool (*is_met)(double);
  const char* reason = "";
  const char* unit_key = "";  ///< a key with the unit of these numbers, where their own has none
  bool is_share = false;      ///< of a whole: one above 1 is perhaps in percent
};
inline constexpr NumberRule any_finite{"finite", [](double) { return true; }};
inline constexpr NumberRule above_zero{"above 0", [](double x) { return x > 0.0; }};
inline constexpr NumberRule not_negative{"0 or more", [](double x) { return x >= 0.0; }};
inline constexpr NumberRule share_rule{"from 0 to 1", [](double x) { return x >= 0.0 && x <= 1.0; },
                                       "", "", true};
inline constexpr NumberRule friction_rule{
    "from 0 to 2", [](double x) { return x >= 0.0 && x <= 2.0; }, "no roof has more"};

/// The names an enumeration has in files.
template <class E>
using EnumNames = std::initializer_list<std::pair<const char*, E>>;

/// What a problem is of: a key of the grammar (`value`), of none, or one that has no effect.
enum class ProblemKind { value, unknown_key, idle };

class TomlTable;

/// The text of a TOML document in one form, without some of its tables: equal where two documents
/// differ in these, in comments and in layout only. Throws InputError where it is not TOML.
std::string toml_without(const std::string& text, const std::vector<std::string>& tables);

/// A TOML file that is being read. Problems are collected while its tables are read; `finish` adds
/// a problem for every key that was never read and throws them all, each with file:line and
/// the user's own line.
class TomlDocument {
 public:
  /// Throws InputError where the file cannot be read or is not TOML.
  /// @param files that it is one of, and those that it names; null: they are read
  explicit TomlDocument(const std::filesystem::path& file, TextFiles* files = nullptr);
  ~TomlDocument();
  TomlDocument(const TomlDocument&) = delete;
  TomlDocument& operator=(const TomlDocument&) = delete;

  TomlTable root();
  /// [[key]] in the place of [key]: one of its elements is the table, and a table within that
  /// replaces the document's of the same name. Expects that there is such an element.
  void choose(std::string_view key, std::size_t element);
  /// Leaves a table out, wherever the file has its parts.
  void leave_out(std::string_view table);
  /// Tables of another text in place of the document's; no problem in them has a line.
  void put(const std::string& toml);
  /// Paths that were read are from `folder` in the place of the file's.
  void move_paths(const std::filesystem::path& folder);
  /// What its tables now are, without the layout of the file.
  std::string values() const;
  const std::string& text() const;
  /// The text with every quantity that was read and is written with a unit as a number in the unit
  /// of its key, and without the folders of the paths that hash_without_folders() names.
  std::string text_to_hash() const;
  void add(Problem problem);  ///< one that belongs to no key
  /// From now on a key, "friction.mu" or "chart.shown.level", can be read only where `is_key`
  /// holds: std::logic_error for any other, since it would be in no explanation of the keys.
  void read_only(std::function<bool(const std::string& name)> is_key);
  /// Lengths and forces that were read and that the file gives as plain numbers, with what they are
  /// in US units: "building.height_m = 54 (177 ft)".
  std::vector<std::string> unmarked_numbers() const;
  void finish();

  struct State;

 private:
  std::unique_ptr<State> state_;
};

/// One table of a document; a light handle. A reading function returns nothing where the key is
/// absent or wrong; wrong is noted in the document. The `required_` ones note absence too and
/// return a value that is never used then. A table that is not there reads as an empty one.
class TomlTable {
 public:
  bool exists() const { return node_ != nullptr; }
  bool has(std::string_view key) const;
  bool is_table(std::string_view key) const;  ///< the key is there and holds a table
  bool is_array(std::string_view key) const;
  bool is_empty_array(std::string_view key) const;  ///< [], not one whose elements are wrong
  bool is_number(std::string_view key) const;       ///< one that is written without a unit

  TomlTable table(std::string_view key) const;
  TomlTable required_table(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  ///< [[key]]

  std::optional<double> number(std::string_view key, const NumberRule& rule = any_finite) const;
  double required_number(std::string_view key, const NumberRule& rule = any_finite) const;
  std::optional<std::vector<double>> numbers(std::string_view key,
                                             const NumberRule& rule = any_finite) const;
  std::optional<std::uint64_t> whole(std::string_view key, std::uint64_t least,
                                     std::uint64_t most) const;
  std::optional<bool> flag(std::string_view key) const;
  std::optional<std::string> text(std::string_view key,
                                  const std::string& remedy = "put it in quotes") const;
  std::string required_text(std::string_view key,
                            const std::string& remedy = "put it in quotes") const;
  std::optional<std::vector<std::string>> texts(std::string_view key) const;

  template <class E>
  std::optional<E> choice(std::string_view key, EnumNames<E> names) const {
    std::string remedy = "give one of:";
    for (const auto& [name, value] : names) remedy += " \"" + std::string(name) + "\"";
    const auto word = text(key, remedy);
    return word ? find_name<E>(key, *word, names) : std::nullopt;
  }
  template <class E>
  std::optional<std::vector<E>> choices(std::string_view key, EnumNames<E> names) const {
    const auto words = texts(key);
    if (!words) return std::nullopt;
    std::vector<E> values;
    for (const std::string& word : *words) {
      if (const auto value = find_name<E>(key, word, names)) values.push_back(*value);
    }
    return values;
  }

  /// Notes a problem at the value of `key` ("" or an absent key: at the table).
  void report(std::string_view key, std::string what, std::string suggestion = "") const {
    report(key, std::move(what), std::move(suggestion), ProblemKind::value);
  }
  /// Notes that a key has no effect.
  void report_idle(std::string_view key, std::string what) const {
    report(key, std::move(what), "it has no effect here: leave it out", ProblemKind::idle);
  }
  /// Notes at `key` that it and another one are given, where they are.
  void refuse_both(std::string_view key, std::string_view other, std::string suggestion) const;
  /// Notes problems reported without a place (validate(...)) at the value of `key`.
  void report(std::string_view key, const InputError& error) const;
  void report_missing(std::string_view key, std::string suggestion = "") const;
  /// A file that the table names, relative to the document's folder.
  TextFile text_file(const std::string& name) const;
  bool is_there(const std::filesystem::path& file) const;
  /// The values of a key are paths (move_paths): where the files are does not change what is
  /// computed.
  void hash_without_folders(std::string_view key) const;
  /// Notes a key that is none where the table has it, and then none of its other unknown keys.
  /// @return whether it has it
  bool refuse_unknown(std::string_view key, std::string suggestion) const;
  /// Whatever else the table contains is not to be reported as unknown: an earlier problem kept it
  /// from being read.
  void ignore_unknown() const;
  std::string name_of(std::string_view key) const;  ///< "building.period_s"
  std::size_t problem_count() const;                ///< of the whole document so far

 private:
  friend class TomlDocument;
  TomlTable(TomlDocument::State* document, const void* node, std::string path)
      : document_(document), node_(node), path_(std::move(path)) {}

  template <class E>
  std::optional<E> find_name(std::string_view key, const std::string& word,
                             EnumNames<E> names) const {
    std::vector<std::string> known;
    for (const auto& [name, value] : names) {
      if (word == name) return value;
      known.emplace_back(name);
    }
    report_unknown_word(key, word, known);
    return std::nullopt;
  }
  void report_unknown_word(std::string_view key, const std::string& word,
                           const std::vector<std::string>& known) const;
  void report(std::string_view key, std::string what, std::string suggestion,
              ProblemKind kind) const;

  TomlDocument::State* document_;
  const void* node_;  ///< a toml::table, or null
  std::string path_;
};

/// One name or several, each once; nothing where the key is absent.
template <class E>
std::optional<std::vector<E>> read_choices(const TomlTable& table, const char* key,
                                           EnumNames<E> names) {
  if (!table.is_array(key)) {
    const auto one = table.choice<E>(key, names);
    return one ? std::optional(std::vector{*one}) : std::nullopt;
  }
  auto given = table.choices<E>(key, names);
  if (!given) return std::nullopt;
  if (table.is_empty_array(key))
    table.report(key, table.name_of(key) + " is empty", "name at least one");
  if (given->empty()) return std::nullopt;
  auto sorted = *given;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end())
    table.report(key, table.name_of(key) + " names one twice", "name each once");
  return given;
}

}  // namespace glissade
