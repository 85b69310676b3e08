// SPDX-License-Identifier: GPL-3.0-or-later
#include "keys/grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "glissade/core/error.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/study_grammar.hpp"
#include "keys/quantity_table.hpp"
#include "product/product_keys.hpp"
#include "project/project_keys.hpp"
#include "study/published_table.hpp"
#include "study/study_keys.hpp"
#include "toml/written_units.hpp"

namespace glissade {
namespace {

/// What is required first in each table.
std::vector<GrammarKey> make_grammar() {
  std::vector<GrammarKey> all = in_words(study_tables());
  std::ranges::move(in_words(std::vector{published_table()}), std::back_inserter(all));
  for (auto first = all.begin(); first != all.end();) {
    const auto end = std::find_if(first, all.end(),
                                  [&](const GrammarKey& key) { return key.table != first->table; });
    std::stable_partition(first, end,
                          [](const GrammarKey& key) { return key.usual.starts_with("required"); });
    first = end;
  }
  return all;
}

std::string text_of(const DistributionForm& form) {
  return fmt::format("{{ distribution = \"{}\", {} }}", form.name, form.keys);
}

std::string distributions_text() {
  std::string text;
  for (const DistributionForm& form : distribution_forms())
    text += (text.empty() ? "" : ", ") + text_of(form);
  return text;
}

bool has_word(const std::string& text, const std::string& word) {
  const auto is_of_word = [](char c) { return std::isalnum(c) || c == '_'; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_word(text[at - 1])) && (end == text.size() || !is_of_word(text[end])))
      return true;
  }
  return false;
}

/// A table, a key with or without its table, or one of its values.
bool is_meant(const GrammarKey& key, const std::string& wanted) {
  return wanted.empty() || key.table == wanted || key.name() == wanted || key.key == wanted ||
         key.value.find('"' + wanted + '"') != std::string::npos;
}

std::string explained(const std::string& name, const std::string& value,
                      const std::vector<std::string>& lines) {
  std::string text = fmt::format("  {:<24} {}\n", name, wrapped(value, terminal_width, 27));
  for (const std::string& line : lines)
    text += fmt::format("{:27}{}\n", "", wrapped(line, terminal_width, 27));
  return text;
}

/// Of "sa_g" or "sa"; else empty.
std::string measure_text(const std::string& wanted) {
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i) {
    const IntensityMeasure m = IntensityMeasure::number(i);
    const std::string key = m.key();
    if (key != wanted && (wanted.empty() || !key.starts_with(wanted + "_"))) continue;
    std::vector<std::string> lines{m.meaning()};
    if (m.own_key() != nullptr)
      lines.push_back(fmt::format("with the key intensity.{}", m.own_key()));
    return "[intensity]\n" +
           explained("measure",
                     fmt::format("\"{}\", levels in {}", key,
                                 m.unit() == std::string("-") ? "parts" : m.unit()),
                     lines);
  }
  return "";
}

/// The keys that are meant, by table.
template <class Lines>
std::string text_of(const std::vector<GrammarKey>& keys, const std::string& wanted,
                    const char* of_table, Lines lines) {
  std::string text, table;
  for (const GrammarKey& key : keys) {
    if (!is_meant(key, wanted)) continue;
    if (key.table != table)
      text += fmt::format("{}[{}]{}\n", text.empty() ? "" : "\n", key.table, of_table);
    table = key.table;
    text += lines(key);
  }
  return text;
}

std::string study_text(const GrammarKey& key) {
  std::vector<std::string> lines{"usual: " + key.usual, key.in_full()};
  if (const KeyUnits* units = units_of_key(key.key))
    lines.push_back("units, in quotes: " + units->names());
  return explained(key.key.empty() ? "(no keys)" : key.key, key.value, lines);
}

std::string project_text(const GrammarKey& key) {
  return explained(key.key, "for example " + key.value, {key.in_full()});
}

}  // namespace

const std::vector<GrammarKey>& grammar() {
  static const std::vector<GrammarKey> keys = make_grammar();
  return keys;
}

bool has_key(const std::vector<GrammarKey>& keys, const std::string& name) {
  const std::size_t dot = name.find('.'), next = name.find('.', dot + 1);
  return std::ranges::any_of(keys, [&](const GrammarKey& key) {
    if (dot == std::string::npos) return key.table == name;
    if (next == std::string::npos) return key.name() == name;
    const std::string values =
        key.value == quantity_value ? key.value + distributions_text() : key.value;
    return key.name() == name.substr(0, next) && has_word(values, name.substr(name.rfind('.') + 1));
  });
}

std::string grammar_text(const std::string& wanted) {
  if (std::string measure = measure_text(wanted); !measure.empty()) return measure;
  std::string text = text_of(grammar(), wanted, "", study_text);
  for (const DistributionForm& form : distribution_forms()) {
    if (wanted == form.name || wanted == "distribution")
      text += explained(form.name, text_of(form), {});
  }
  if (wanted.empty()) return text;
  const std::string of_project =
      text_of(project_grammar(), wanted, " of a project (glissade clearance)", project_text);
  const std::string of_product =
      text_of(product_grammar(), wanted, " of a product sheet (glissade clearance)", project_text);
  for (const std::string& more : {of_project, of_product})
    text += (text.empty() || more.empty() ? "" : "\n") + more;
  return text;
}

std::string nearest_grammar_key(const std::string& wanted) {
  std::vector<std::string> names;
  for (const GrammarKey& key : grammar()) names.insert(names.end(), {key.table, key.key});
  for (const auto* keys : {&project_grammar(), &product_grammar()})
    for (const GrammarKey& key : *keys) names.push_back(key.key);
  return nearest_word(wanted.substr(wanted.find('.') + 1), names);  // of table.key the key
}

namespace {

std::string row_of(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string head_of(const std::vector<std::string>& columns) {
  std::string rule = "|";
  for (std::size_t i = 0; i < columns.size(); ++i) rule += "---|";
  return row_of(columns) + rule + "\n";
}

/// A table of the page for each table of the file.
template <class Cells>
std::string keys_page(const std::vector<GrammarKey>& keys, const std::vector<std::string>& columns,
                      Cells cells) {
  std::string page, table;
  for (const GrammarKey& key : keys) {
    if (key.table != table) page += fmt::format("\n### [{}]\n\n", key.table) + head_of(columns);
    table = key.table;
    page += row_of(cells(key));
  }
  return page;
}

std::vector<std::string> study_cells(const GrammarKey& key) {
  return {key.key.empty() ? "" : "`" + key.key + "`",
          key.value == list_value       ? "list"
          : key.value == quantity_value ? "quantity"
                                        : key.value,
          key.usual, key.meaning, key.needs};
}

std::vector<std::string> project_cells(const GrammarKey& key) {
  return {"`" + key.key + "`", "`" + key.value + "`", key.meaning};
}

}  // namespace

std::string grammar_page() {
  std::string page =
      "# The keys of a study, a project and a product sheet\n\n"
      "Made by `glissade explain --markdown`; do not edit.\n\n"
      "A number is in the unit at the end of its key (a level in the unit of its measure), or is "
      "written with one of these units, in quotes: `\"18 in\"`, `\"0.25:12\"`. A list may mix "
      "them.\n\n" +
      head_of({"key", "units"});
  for (const KeyUnits& row : all_key_units())
    page += row_of({fmt::format("`{}`", row.suffix), row.names()});
  page +=
      "\n## Keys of a study\n\n"
      "- *list*: [1, 2, 4], or { from, to, count, spacing }, with spacing \"linear\" (where "
      "absent) or \"log\"\n"
      "- *quantity*: a number; a list (every value is run, in all combinations); { mean, std }, a "
      "normal distribution within the range; or a distribution (a value is drawn for each "
      "sample): " +
      distributions_text() + "\n" +
      keys_page(grammar(), {"key", "value", "where absent", "meaning", "needs"}, study_cells) +
      "\n### Intensity measures\n\n" + head_of({"`intensity.measure`", "unit", "levels are of"});
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i) {
    const IntensityMeasure m = IntensityMeasure::number(i);
    page += row_of({fmt::format("`{}`", m.key()), m.unit(), m.meaning()});
  }
  const std::vector<std::string> columns = {"key", "example", "meaning"};
  return page + "\n## Keys of a project\n" + keys_page(project_grammar(), columns, project_cells) +
         "\n## Keys of a product sheet\n\nBeside those of a study, but [study] and [intensity].\n" +
         keys_page(product_grammar(), columns, project_cells);
}

}  // namespace glissade
