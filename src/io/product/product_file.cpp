// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/product_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "glissade/core/units.hpp"
#include "glissade/io/study_file.hpp"
#include "keys/hazard_table.hpp"
#include "keys/target_table.hpp"
#include "product/product_keys.hpp"
#include "toml/source_text.hpp"
#include "toml/toml_table.hpp"
#include "toml/toml_text.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// "[[name]]": the name of the table that begins in a line; empty: none does.
std::string table_in(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos || line[begin] != '[') return "";
  const std::size_t name = line.find_first_not_of("[ \t", begin);
  const std::size_t end = line.find_first_not_of(
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.", name);
  const bool is_header = name != std::string::npos && end != std::string::npos &&
                         line[line.find_first_not_of(" \t", end)] == ']' &&
                         std::isalpha(static_cast<unsigned char>(line[name])) != 0;
  return is_header ? line.substr(name, end - name) : "";
}

/// Empty lines in their place: every other line keeps its number.
std::string without_own_tables(const std::string& text) {
  std::string rest;
  bool is_own = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); rest += "\n") {
    if (const std::string table = table_in(line); !table.empty())
      is_own = has_key(product_grammar(), table);
    if (!is_own) rest += line;
  }
  return rest;
}

/// The text with the paths of its files relative to another folder.
std::string moved(const Product& product, const fs::path& folder) {
  const toml::table root = parse_toml(product.source_text);
  std::string text = product.source_text;
  // Each is one literal: later ones first, so that earlier offsets hold.
  std::vector<std::pair<std::size_t, std::size_t>> places;
  const SourceText source(text);
  for (const auto& [table, key] : {std::pair{"suite", "file"}, {"friction", "file"}}) {
    const toml::node* node = root[table][key].node();
    if (node == nullptr || !node->is_string()) continue;
    const std::size_t begin = source.offset_of(node->source().begin);
    places.emplace_back(begin, source.offset_of(node->source().end) - begin);
  }
  std::ranges::sort(places, std::greater<>());
  for (const auto& [begin, length] : places) {
    const std::string name = text.substr(begin + 1, length - 2);
    text.replace(begin, length, path_from(product.file.parent_path() / name, folder));
  }
  return text;
}

std::string study_of(const Product& product, std::size_t target, const fs::path& folder,
                     double scaled_to_s) {
  const ProductTarget& of = product.targets[target];
  const bool has_chart = parse_toml(product.source_text).contains("chart");
  return without_own_tables(moved(product, folder)) +
         fmt::format(
             "\n# Made by `glissade clearance` from {}.\n"
             "[study]\nname = {}\ndescription = {}\nunits = \"{}\"\n\n"
             "[intensity]\nmeasure = \"sds_g\"\nlevels = [{}]\ntarget = {{ {} }}\n{}{}",
             quoted(product.file.filename().string()), quoted(product.name),
             quoted(fmt::format("{}. Part of a product sheet: product.html, one folder above",
                                to_string(of.target))),
             product.unit == SheetUnit::metre ? "si" : "us",
             fmt::join(levels_of(product, of), ", "), fmt::join(target_fields(of.target), ", "),
             scaled_to_s > longest_scaled_period_s ? fmt::format("scaled_to_s = {}\n", scaled_to_s)
                                                   : "",
             has_chart ? "" : "\n[chart]\n");
}

double scaled_to_s(const StudyConfig& study) {
  return judged_to_s(study.quantities.at("building", "period_s").largest());
}

std::optional<HazardConfig> hazard_of(const TomlTable& table, const ProductTarget& target,
                                      std::size_t targets) {
  for (const char* key : {"curve", "k0"})
    if (targets > 1 && table.has(key))
      table.report(key,
                   fmt::format("hazard.{} is of one site, and there are {} targets", key, targets),
                   "give one [[target]], or k alone: each target's curve is assumed from its S_DS");
  const bool is_assumed = !table.has("curve") && !table.has("k0");
  return read_hazard(table, "sds_g", is_assumed ? target.target.sds_g : 0.0);
}

void read_targets(const TomlTable& root, Product& product) {
  const std::vector<TomlTable> tables = root.tables("target");
  if (tables.empty())
    root.report("", "the product has no [[target]]",
                "give one for each site of the sheet: [[target]], sds_g = 1.0, sd1_g = 0.6");
  for (const TomlTable& table : tables) {
    DesignTarget target{.edition = AsceEdition::asce7_16};
    read_keys(product_target_table().keys, table, target);
    if (target.sd1_g > target.tl_s * target.sds_g)
      table.report("sd1_g", "T_S = S_D1 / S_DS is above T_L", "check sds_g, sd1_g and tl_s");
    product.targets.push_back({target, {}});
  }
}

void read_product_hazard(const TomlTable& root, Product& product) {
  if (!root.has("hazard")) return;
  const TomlTable table = root.table("hazard");
  for (ProductTarget& target : product.targets) {
    target.hazard = hazard_of(table, target, product.targets.size());
    if (!target.hazard) return;
  }
}

}  // namespace

bool is_product(const fs::path& file) { return TomlDocument(file).root().has("product"); }

Product read_product(const fs::path& file) {
  TomlDocument document(file);
  const TomlTable root = document.root();
  root.ignore_unknown();  // they are of the study
  for (const char* table : {"study", "intensity"})
    if (root.has(table))
      root.report(table, fmt::format("a product file has no [{}]", table),
                  "[product] and the targets give it: leave it out");
  document.read_only([](const std::string& name) { return has_key(product_grammar(), name); });
  Product product{.file = file, .source_text = document.text()};
  root.required_table("product");
  read_keys(product_tables(), {"product", "hazard"}, root, product);
  if (product.round_up_m == 0.0)
    product.round_up_m = product.unit == SheetUnit::metre ? 0.01 : inch_m;
  read_targets(root, product);
  read_product_hazard(root, product);
  document.finish();
  TextFiles files;
  files.put(file.filename().string(), study_of(product, 0, file.parent_path(), 0.0));
  product.suite = read_study(file, files).suite_files.front();
  return product;
}

std::string product_study(const Product& product, std::size_t target, const fs::path& folder) {
  TextFiles files;
  files.put(product.file.filename().string(),
            study_of(product, target, product.file.parent_path(), 0.0));
  return study_of(product, target, folder, scaled_to_s(read_study(product.file, files)));
}

}  // namespace glissade
