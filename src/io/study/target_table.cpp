// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/target_table.hpp"

namespace glissade {

DesignTarget read_target(const TomlTable& table) {
  const EnumNames<AsceEdition> editions = {{"asce7_10", AsceEdition::asce7_10},
                                           {"asce7_16", AsceEdition::asce7_16}};
  const EnumNames<SiteClass> classes = {{"A", SiteClass::a},
                                        {"B", SiteClass::b},
                                        {"C", SiteClass::c},
                                        {"D", SiteClass::d},
                                        {"E", SiteClass::e}};
  DesignTarget target;
  if (!table.has("edition"))
    table.report_missing("edition", "asce7_10 or asce7_16: their site coefficients differ");
  target.edition = table.choice<AsceEdition>("edition", editions).value_or(target.edition);
  target.ss_g = table.required_number("ss_g", above_zero);
  target.s1_g = table.required_number("s1_g", above_zero);
  target.tl_s = table.number("tl_s", above_zero).value_or(target.tl_s);
  if (table.has("site_class") && table.has("site_classes")) {
    table.report("site_class", "both site_class and site_classes are given", "give one of them");
  }
  if (const auto one = table.choice<SiteClass>("site_class", classes)) target.site_classes = {*one};
  if (const auto many = table.choices<SiteClass>("site_classes", classes)) {
    if (many->empty() && table.texts("site_classes")->empty()) {
      table.report("site_classes", "site_classes is empty", "name at least one of A, B, C, D, E");
    }
    target.site_classes = *many;
  }
  return target;
}

}  // namespace glissade
