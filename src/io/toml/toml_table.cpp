// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "glissade/core/contract.hpp"
#include "glissade/core/printable.hpp"
#include "text/scan.hpp"
#include "toml/source_text.hpp"
#include "toml/toml_text.hpp"
#include "toml/written_units.hpp"

namespace glissade {

struct TomlDocument::State {
  std::filesystem::path file;
  TextFiles own_files;
  TextFiles* files = &own_files;
  SourceText source{""};
  toml::table root;
  /// A problem, and the table it was found in: of an old key, or perhaps a consequence of one.
  struct Found {
    Problem problem;
    std::string table;
    ProblemKind kind;
  };
  std::vector<Found> found;
  /// Keys that were read, by table; only tables that are being read are here. Never iterated: order
  /// plays no part.
  std::map<const void*, std::set<std::string, std::less<>>> read;
  std::set<const void*> not_checked;
  std::function<bool(const std::string& name)> is_key;
  /// Literals in quotes that text_to_hash() has otherwise: where they begin, and how.
  std::map<std::size_t, std::string> written;

  /// Keys whose values are paths.
  std::vector<std::pair<toml::table*, std::string>> paths;

  /// Plain numbers of keys in m and kN, by where they begin: "height_m = 54 (177 ft)".
  std::map<std::size_t, std::string> unmarked;

  void note_written(const toml::source_position& at, const std::string& otherwise);
  Problem problem(const toml::source_position& at, std::string what, std::string suggestion) const;
  void find_unknown_keys(const toml::table& table, const std::string& path);
  /// Without keys that have no effect where their table has another fault, from which that may
  /// come.
  void throw_if_any() const;
};

namespace {

/// "friction" of "friction.mu."
std::string table_of(const std::string& path) { return path.substr(0, path.find('.')); }

const toml::table& as_table(const void* node) { return *static_cast<const toml::table*>(node); }

std::string kind_of(const toml::node& node) {
  if (node.is_string()) return "a text";
  if (node.is_boolean()) return "true or false";
  if (node.is_number()) return "a number";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

/// The number of a text with a unit: a problem where the key takes none, or others.
std::optional<double> as_written_number(const std::string& text, const NumberRule& rule,
                                        const TomlTable& table, std::string_view key) {
  const std::string name = table.name_of(key);
  const KeyUnits* known = units_of_key(*rule.unit_key ? rule.unit_key : name);
  if (known == nullptr) {
    table.report(key, name + " is a text, not a number", "leave the quotes out");
    return std::nullopt;
  }
  const auto value = known->value_of(text);
  if (!value)
    table.report(key, name + " = " + in_quotes(text) + " is not " + known->what + " with its unit",
                 parse_number(trimmed(text))
                     ? "leave the quotes out, or give a number with a unit: " + known->names()
                     : "give a number with one of the units: " + known->names());
  return value;
}

/// The value as a finite double: a problem otherwise.
std::optional<double> as_number(TomlDocument::State& document, const toml::node& node,
                                const NumberRule& rule, const TomlTable& table,
                                std::string_view key) {
  const std::string name = table.name_of(key);
  if (!node.is_number() && !node.is_string()) {
    table.report(key, name + " is " + kind_of(node) + ", not a number");
    return std::nullopt;
  }
  const auto given = node.is_number()
                         ? node.value<double>()
                         : as_written_number(*node.value<std::string>(), rule, table, key);
  if (!given) return std::nullopt;
  const double value = *given;
  if (node.is_string()) document.note_written(node.source().begin, shortest_decimal(value));
  const KeyUnits* units = units_of_key(*rule.unit_key ? rule.unit_key : name);
  const KeyUnits::Unit* unit = units != nullptr ? customary_unit(*units) : nullptr;
  if (node.is_number() && unit != nullptr && value != 0.0)
    document.unmarked[document.source.offset_of(node.source().begin)] =
        fmt::format("{} = {:g} ({:.3g} {})", name, value, value / unit->factor, unit->name);
  if (!std::isfinite(value) || !rule.is_met(value)) {
    const std::string reason = *rule.reason ? std::string(" (") + rule.reason + ")" : "";
    table.report(
        key,
        name + " = " +
            (node.is_string() ? in_quotes(*node.value<std::string>()) : shortest_decimal(value)) +
            " is not " + (std::isfinite(value) ? rule.text + reason : "finite"),
        rule.is_share && rule.is_met(value / 100.0)
            ? shortest_decimal(to_twelve_digits(value / 100.0)) + "?"
            : std::string("give a value ") + rule.text);
    return std::nullopt;
  }
  return value;
}

/// Whether it is free of control characters, which is reported.
bool is_clean(const TomlTable& table, std::string_view key, const std::string& text) {
  if (printable(text) == text) return true;
  table.report(key, table.name_of(key) + " = " + in_quotes(text) + " has a control character",
               "leave it out");
  return false;
}

/// Of a key that is called for another unit, "height_ft" of "height_m": what its number is in.
std::string unit_note(const std::string& name, const std::string& nearest) {
  const KeyUnits* units = units_of_key(nearest);
  const auto last_word = [](const std::string& key) { return key.substr(key.rfind('_') + 1); };
  if (units == nullptr || units->units.empty() || last_word(name) == last_word(nearest)) return "";
  return fmt::format(", in {} or written with its unit ({})", units->units.front().name,
                     units->names());
}

}  // namespace

void TomlDocument::State::note_written(const toml::source_position& at,
                                       const std::string& otherwise) {
  const std::size_t place = source.offset_of(at);
  const std::string& text = source.text();
  if (place < text.size() && (text[place] == '"' || text[place] == '\''))
    written[place] = otherwise;
}

Problem TomlDocument::State::problem(const toml::source_position& at, std::string what,
                                     std::string suggestion) const {
  return {at.line > 0 ? place(file, at.line) : file.string(), std::move(what),
          std::move(suggestion), source.excerpt(at)};
}

void TomlDocument::State::find_unknown_keys(const toml::table& table, const std::string& path) {
  const auto keys = read.find(&table);
  if (keys == read.end()) return;
  const std::vector<std::string> known(keys->second.begin(), keys->second.end());
  std::vector<std::pair<toml::source_position, std::string>> unknown;
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    if (!keys->second.contains(name)) unknown.emplace_back(key.source().begin, name);
    if (const toml::table* child = node.as_table()) find_unknown_keys(*child, path + name + ".");
    if (const toml::array* list = node.as_array()) {
      for (const toml::node& element : *list) {
        if (const toml::table* child = element.as_table())
          find_unknown_keys(*child, path + name + ".");
      }
    }
  }
  for (const auto& [at, name] : unknown) {
    const std::string nearest = nearest_word(name, known);
    if (not_checked.contains(&table)) continue;
    std::string suggestion;
    if (!nearest.empty()) {
      suggestion = "did you mean " + nearest + unit_note(name, nearest) + "?";
    } else {
      for (const std::string& word : known)
        suggestion += (suggestion.empty() ? "known are " : ", ") + word;
    }
    found.push_back({problem(at, path + name + " is not a known key", suggestion), table_of(path),
                     ProblemKind::unknown_key});
  }
}

void TomlDocument::State::throw_if_any() const {
  ProblemList problems;
  std::set<std::string> faulty_tables;
  for (const Found& f : found)
    if (f.kind == ProblemKind::value) faulty_tables.insert(f.table);
  for (const Found& f : found)
    if (f.kind != ProblemKind::idle || !faulty_tables.contains(f.table)) problems.add(f.problem);
  problems.throw_if_any();
}

TomlDocument::TomlDocument(const std::filesystem::path& file, TextFiles* files)
    : state_(std::make_unique<State>()) {
  state_->file = file;
  if (files != nullptr) state_->files = files;
  state_->source =
      SourceText(state_->files->text_file(file.parent_path(), file.filename().string()).text);
  refuse_no_text(file, text());
  try {
    state_->root = parse_toml(text());
  } catch (const toml::parse_error& error) {
    throw InputError(
        state_->problem(error.source().begin, std::string(error.description()),
                        file.extension() == ".csv"
                            ? "this is a table (CSV): give a study, project or suite file (TOML)"
                            : "correct the TOML syntax"));
  }
}

std::string toml_without(const std::string& text, const std::vector<std::string>& tables) {
  try {
    toml::table root = parse_toml(text);
    for (const std::string& table : tables) root.erase(table);
    return text_of(root);
  } catch (const toml::parse_error& error) {
    throw InputError({"the study", "is not TOML: " + std::string(error.description()), "", ""});
  }
}

TomlDocument::~TomlDocument() = default;

void TomlDocument::read_only(std::function<bool(const std::string& name)> is_key) {
  state_->is_key = std::move(is_key);
}

TomlTable TomlDocument::root() {
  state_->read[&state_->root];
  return {state_.get(), &state_->root, ""};
}

void TomlDocument::choose(std::string_view key, std::size_t element) {
  toml::table& root = state_->root;
  toml::array* elements = root.get_as<toml::array>(key);
  GLISSADE_EXPECTS(elements != nullptr && element < elements->size() &&
                   (*elements)[element].is_table());
  toml::table chosen = std::move(*(*elements)[element].as_table());
  const toml::key name = root.find(key)->first;
  root.erase(key);
  for (auto at = chosen.begin(); at != chosen.end();) {
    if (!at->second.is_table() && !at->second.is_array_of_tables()) {
      ++at;
      continue;
    }
    root.erase(at->first.str());
    at->second.visit([&](auto& value) { root.insert(at->first, std::move(value)); });
    at = chosen.erase(at);
  }
  root.insert(name, std::move(chosen));
}

void TomlDocument::leave_out(std::string_view table) { state_->root.erase(table); }

void TomlDocument::put(const std::string& toml) {
  for (const auto& [key, value] : parse_toml(toml))
    value.visit([&, name = key.str()](const auto& table) {
      state_->root.insert_or_assign(name, table);  // a copy, which has no place in a file
    });
}

void TomlDocument::move_paths(const std::filesystem::path& folder) {
  const auto move = [&](toml::node& node) {
    if (auto* path = node.as_string())
      *path = relative_path(state_->file.parent_path() / path->get(), folder);
  };
  for (const auto& [table, key] : state_->paths) {
    toml::node& value = *table->get(key);
    if (toml::array* list = value.as_array())
      for (toml::node& element : *list) move(element);
    else
      move(value);
  }
}

std::string TomlDocument::values() const { return text_of(state_->root); }

const std::string& TomlDocument::text() const { return state_->source.text(); }

std::string TomlDocument::text_to_hash() const {
  std::string result;
  std::size_t copied = 0;
  for (const auto& [begin, otherwise] : state_->written) {
    // A TOML string: between quotes of one kind, one or three of them.
    const std::string& text = this->text();
    const std::size_t first = text.find_first_not_of(text[begin], begin);
    const std::string quotes = text.substr(begin, first - begin);
    result += text.substr(copied, begin - copied) + otherwise;
    copied = text.find(quotes, first) + quotes.size();
  }
  return result + text().substr(copied);
}

std::vector<std::string> TomlDocument::unmarked_numbers() const {
  std::vector<std::string> texts;
  for (const auto& [offset, text] : state_->unmarked) texts.push_back(text);
  return texts;
}

void TomlDocument::add(Problem problem) {
  state_->found.push_back({std::move(problem), "", ProblemKind::unknown_key});
}

void TomlDocument::finish() {
  state_->find_unknown_keys(state_->root, "");
  state_->throw_if_any();
}

namespace {

/// The node of a key, or null; the key counts as read.
const toml::node* find(TomlDocument::State& document, const void* table, const std::string& path,
                       std::string_view key) {
  const std::string name = path + std::string(key);
  if (document.is_key && !document.is_key(name))
    throw std::logic_error(name + " is read and is not in the grammar");
  if (table == nullptr) return nullptr;
  document.read[table].emplace(key);
  return as_table(table).get(key);
}

}  // namespace

std::string TomlTable::name_of(std::string_view key) const { return path_ + std::string(key); }

std::size_t TomlTable::problem_count() const { return document_->found.size(); }

bool TomlTable::has(std::string_view key) const {
  return find(*document_, node_, path_, key) != nullptr;
}

bool TomlTable::is_table(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  return node != nullptr && node->is_table();
}

bool TomlTable::is_array(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  return node != nullptr && node->is_array();
}

bool TomlTable::is_empty_array(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  return node != nullptr && node->is_array() && node->as_array()->empty();
}

bool TomlTable::is_number(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  return node != nullptr && node->is_number();
}

void TomlTable::report(std::string_view key, std::string what, std::string suggestion,
                       ProblemKind kind) const {
  toml::source_position at{};
  if (node_ != nullptr) {
    const toml::node* node = key.empty() ? nullptr : as_table(node_).get(key);
    at = (node != nullptr ? node->source() : as_table(node_).source()).begin;
  }
  document_->found.push_back(
      {document_->problem(at, std::move(what), std::move(suggestion)), table_of(path_), kind});
}

void TomlTable::report(std::string_view key, const InputError& error) const {
  const std::string name = key.empty() ? path_.substr(0, path_.find_last_of('.')) : name_of(key);
  for (const Problem& problem : error.problems()) {
    const std::string where = problem.where.empty() ? "" : problem.where + ": ";
    report(key, name + ": " + where + problem.what, problem.suggestion);
  }
}

void TomlTable::refuse_both(std::string_view key, std::string_view other,
                            std::string suggestion) const {
  if (has(key) && has(other))
    report(key, name_of(key) + " and " + name_of(other) + " are both given", std::move(suggestion));
}

void TomlTable::report_missing(std::string_view key, std::string suggestion) const {
  if (exists()) report("", name_of(key) + " is missing", std::move(suggestion));
}

void TomlTable::report_unknown_word(std::string_view key, const std::string& word,
                                    const std::vector<std::string>& known) const {
  const std::string given = name_of(key) + " = \"" + word + "\"";
  const std::string nearest = nearest_word(word, known);
  std::string suggestion = nearest.empty() ? "" : "did you mean \"" + nearest + "\"? ";
  for (std::size_t i = 0; i < known.size(); ++i)
    suggestion += (i == 0 ? "known are " : ", ") + known[i];
  report(key, given + " is not known", suggestion);
}

TextFile TomlTable::text_file(const std::string& name) const {
  return document_->files->text_file(document_->file.parent_path(), name);
}

bool TomlTable::is_there(const std::filesystem::path& file) const {
  return document_->files->is_there(file);
}

void TomlTable::hash_without_folders(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  if (node == nullptr) return;
  document_->paths.emplace_back(const_cast<toml::table*>(&as_table(node_)),  // NOLINT: of its root
                                key);
  const auto note = [&](const toml::node& path) {
    if (const auto text = path.value_exact<std::string>())
      document_->note_written(path.source().begin,
                              '"' + std::filesystem::path(*text).filename().string() + '"');
  };
  if (const toml::array* list = node->as_array())
    for (const toml::node& element : *list) note(element);
  else
    note(*node);
}

bool TomlTable::refuse_unknown(std::string_view key, std::string suggestion) const {
  if (!exists() || as_table(node_).get(key) == nullptr) return false;
  report(key, name_of(key) + " is not a known key", std::move(suggestion),
         ProblemKind::unknown_key);
  ignore_unknown();
  return true;
}

void TomlTable::ignore_unknown() const { document_->not_checked.insert(node_); }

TomlTable TomlTable::table(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  if (node != nullptr && !node->is_table()) {
    report(key, name_of(key) + " is " + kind_of(*node) + ", not a table");
    node = nullptr;
  }
  const void* child = node == nullptr ? nullptr : node->as_table();
  if (child != nullptr) document_->read[child];
  return {document_, child, name_of(key) + "."};
}

TomlTable TomlTable::required_table(std::string_view key) const {
  if (exists() && !has(key)) report("", "[" + name_of(key) + "] is missing");
  return table(key);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  std::vector<TomlTable> result;
  if (node == nullptr) return result;
  const toml::array* list = node->as_array();
  const auto is_a_table = [](const toml::node& element) { return element.is_table(); };
  if (list == nullptr || !std::all_of(list->begin(), list->end(), is_a_table)) {
    report(key, name_of(key) + " is not a list of tables",
           "write [[" + name_of(key) + "]] above each");
    return result;
  }
  for (const toml::node& element : *list) {
    document_->read[element.as_table()];
    result.push_back(TomlTable(document_, element.as_table(), name_of(key) + "."));
  }
  return result;
}

std::optional<double> TomlTable::number(std::string_view key, const NumberRule& rule) const {
  const toml::node* node = find(*document_, node_, path_, key);
  if (node == nullptr) return std::nullopt;
  return as_number(*document_, *node, rule, *this, key);
}

double TomlTable::required_number(std::string_view key, const NumberRule& rule) const {
  if (!has(key)) report_missing(key);
  return number(key, rule).value_or(0.0);
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key,
                                                      const NumberRule& rule) const {
  const toml::node* node = find(*document_, node_, path_, key);
  if (node == nullptr) return std::nullopt;
  const toml::array* list = node->as_array();
  if (list == nullptr) {
    report(key, name_of(key) + " is " + kind_of(*node) + ", not a list of numbers");
    return std::nullopt;
  }
  std::vector<double> values;
  for (const toml::node& element : *list) {
    const auto value = as_number(*document_, element, rule, *this, key);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<std::uint64_t> TomlTable::whole(std::string_view key, std::uint64_t least,
                                              std::uint64_t most) const {
  const toml::node* node = find(*document_, node_, path_, key);
  if (node == nullptr) return std::nullopt;
  const std::string range = std::to_string(least) + " to " + std::to_string(most);
  if (!node->is_integer()) {
    report(key, name_of(key) + " is not a whole number", "give a whole number, " + range);
    return std::nullopt;
  }
  const std::int64_t value = *node->value<std::int64_t>();
  if (value < 0 || static_cast<std::uint64_t>(value) < least ||
      static_cast<std::uint64_t>(value) > most) {
    report(key, name_of(key) + " = " + std::to_string(value) + " is out of range",
           "give a whole number, " + range);
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(value);
}

std::optional<bool> TomlTable::flag(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_boolean())
    report(key, name_of(key) + " is " + kind_of(*node) + ", not true or false");
  return node->value_exact<bool>();
}

std::optional<std::string> TomlTable::text(std::string_view key, const std::string& remedy) const {
  const toml::node* node = find(*document_, node_, path_, key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string())
    report(key, name_of(key) + " is " + kind_of(*node) + ", not a text", remedy);
  std::optional<std::string> text = node->value_exact<std::string>();
  return text && is_clean(*this, key, *text) ? text : std::nullopt;
}

std::string TomlTable::required_text(std::string_view key, const std::string& remedy) const {
  if (!has(key)) report_missing(key);
  std::optional<std::string> value = text(key, remedy);
  if (value && value->empty()) report(key, name_of(key) + " is empty");
  return value.value_or("");
}

std::optional<std::vector<std::string>> TomlTable::texts(std::string_view key) const {
  const toml::node* node = find(*document_, node_, path_, key);
  if (node == nullptr) return std::nullopt;
  const toml::array* list = node->as_array();
  std::vector<std::string> values;
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    if (const auto value = list->get(i)->value_exact<std::string>()) values.push_back(*value);
  }
  if (list == nullptr || values.size() != list->size()) {
    report(key, name_of(key) + " is not a list of texts", "write it as [\"...\", \"...\"]");
    return std::nullopt;
  }
  for (const std::string& value : values)
    if (!is_clean(*this, key, value)) return std::nullopt;
  return values;
}

}  // namespace glissade
