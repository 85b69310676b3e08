// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/product_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "glissade/core/units.hpp"
#include "keys/hazard_table.hpp"
#include "keys/target_table.hpp"
#include "product/product_keys.hpp"
#include "study/study_document.hpp"
#include "toml/source_text.hpp"
#include "toml/toml_table.hpp"
#include "toml/toml_text.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// The study of a target in place of the tables of the product.
/// @param scaled_to_s of its suite; 0: not known yet
void put_study(TomlDocument& document, const Product& product, std::size_t target,
               double scaled_to_s) {
  const ProductTarget& of = product.targets[target];
  for (const GrammarKey& key : product_grammar()) document.leave_out(key.table);
  document.put(fmt::format(
      "[study]\nname = {}\ndescription = {}\nunits = \"{}\"\n"
      "[intensity]\nmeasure = \"sds_g\"\nlevels = [{}]\ntarget = {{ {} }}\n{}{}",
      quoted(product.name),
      quoted(fmt::format("{}. Part of a product sheet: product.html, one folder above",
                         to_string(of.target))),
      product.unit == SheetUnit::metre ? "si" : "us", fmt::join(levels_of(product, of), ", "),
      fmt::join(target_fields(of.target), ", "),
      scaled_to_s > longest_scaled_period_s ? fmt::format("scaled_to_s = {}\n", scaled_to_s) : "",
      document.root().has("chart") ? "" : "[chart]\n"));
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
  Product product{.file = file, .source_text = without_comments(document.text())};
  root.required_table("product");
  read_keys(product_tables(), {"product", "hazard"}, root, product);
  if (product.round_up_m == 0.0)
    product.round_up_m = product.unit == SheetUnit::metre ? 0.01 : inch_m;
  read_targets(root, product);
  read_product_hazard(root, product);
  document.finish();
  TextFiles files;
  TomlDocument study(file, &files);
  put_study(study, product, 0, 0.0);
  product.suite = read_study(study, file, files).suite_files.front();
  return product;
}

std::string product_study(const Product& product, std::size_t target, const fs::path& folder) {
  TextFiles files;
  files.put(product.file.filename().string(), product.source_text);
  TomlDocument document(product.file, &files);
  put_study(document, product, target, 0.0);
  const StudyConfig study = read_study(document, product.file, files);
  put_study(document, product, target, scaled_to_s(study));
  document.move_paths(folder);
  return fmt::format("# Made by `glissade clearance` from {}.\n{}",
                     quoted(product.file.filename().string()), document.values());
}

}  // namespace glissade
