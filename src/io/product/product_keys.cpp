// SPDX-License-Identifier: GPL-3.0-or-later
#include "product/product_keys.hpp"

#include <algorithm>

#include "enum_names.hpp"

namespace glissade {
namespace {

constexpr EnumNames<SheetUnit> sheet_unit_names = {
    {"in", SheetUnit::inch}, {"ft", SheetUnit::foot}, {"m", SheetUnit::metre}};
constexpr NumberRule above_one{"above 1", [](double x) { return x > 1.0; }};

}  // namespace

const std::vector<KeyTable<Product>>& product_tables() {
  static const std::vector<KeyTable<Product>> tables = {
      {"product",
       {{"name", "\"Racking A, feet on TPO\"", "required", "name of the product",
         requires_text<&Product::name>()},
        {"manufacturer", "\"\"", "", "of the product", reads<&Product::manufacturer>()},
        {"revision", "\"0\"", "", "of the sheet", reads<&Product::revision>()},
        {"date", "\"\"", "", "of the sheet", reads<&Product::date>()},
        {"unit", "\"in\"", "", "\"in\", \"ft\" or \"m\": of the sheet and its CSV files",
         reads<&Product::unit>(sheet_unit_names)},
        {"round_up_m", "\"1 in\"", "", "displacements are rounded up to this",
         reads<&Product::round_up_m>(above_zero)}}},
      {"hazard",
       {{"k", "2.2", "",
         "the hazard curve of each target is assumed from its S_DS by the risk target of ASCE 7, "
         "with this exponent; with k0 it is k0 S_DS^-k, of one target"},
        {"k0", "1e-3", "", "annual rate of exceeding S_DS = 1 g"},
        {"curve", "\"hazard.csv\"", "", "columns sds_g, annual_rate, of one target"},
        {"design_life_years", "25", "required", "in which smaller events add up"},
        {"event_years", "700", "", "return period of the one large event",
         reads<&Product::event_years>(above_one)}}}};
  return tables;
}

const KeyTable<DesignTarget>& product_target_table() {
  static const KeyTable<DesignTarget> table = {
      "target",
      {{"edition", "\"asce7_16\"", "", "of [[target]], one for each site of the sheet",
        reads<&DesignTarget::edition>(edition_names)},
       {"sds_g", "1.0", "required", "S_DS, g", requires_number<&DesignTarget::sds_g>(above_zero)},
       {"sd1_g", "0.6", "required", "S_D1, g", requires_number<&DesignTarget::sd1_g>(above_zero)},
       {"tl_s", "8", "", "T_L, s", reads<&DesignTarget::tl_s>(above_zero)}}};
  return table;
}

const std::vector<GrammarKey>& product_grammar() {
  static const std::vector<GrammarKey> keys = [] {
    std::vector<GrammarKey> all = in_words(product_tables());
    const std::vector<GrammarKey> of_target = in_words(std::vector{product_target_table()});
    all.insert(std::ranges::find(all, "hazard", &GrammarKey::table), of_target.begin(),
               of_target.end());
    return all;
  }();
  return keys;
}

}  // namespace glissade
