// SPDX-License-Identifier: GPL-3.0-or-later
#include "keys/target_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "enum_names.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/improbable.hpp"
#include "text/csv_rows.hpp"

namespace glissade {
namespace {

/// Class F has no coefficients; reported, with what is required in their place.
bool is_class_f(const TomlTable& table, const char* key) {
  const std::vector<std::string> names = table.is_array(key)
                                             ? table.texts(key).value_or(std::vector<std::string>{})
                                             : std::vector{table.text(key).value_or("")};
  if (std::ranges::find(names, "F") == names.end()) return false;
  table.report(key, site_class_f_refusal,
               "give the spectrum of that analysis as spectrum = \"FILE.csv\", in place of ss_g, "
               "s1_g and the class");
  return true;
}

void read_site_classes(const TomlTable& table, DesignTarget& target) {
  const EnumNames<SiteClass> classes = {{"A", SiteClass::a}, {"B", SiteClass::b},
                                        {"C", SiteClass::c}, {"D", SiteClass::d},
                                        {"E", SiteClass::e}, {"default", SiteClass::unknown}};
  if (table.has("site_class") && table.has("site_classes")) {
    table.report("site_class", "both site_class and site_classes are given", "give one of them");
  }
  if (is_class_f(table, "site_class") || is_class_f(table, "site_classes")) return;
  if (const auto one = table.choice<SiteClass>("site_class", classes)) {
    target.site_classes = {*one};
  }
  if (const auto many = table.choices<SiteClass>("site_classes", classes)) {
    if (table.is_empty_array("site_classes"))
      table.report("site_classes", "site_classes is empty", "name at least one of A, B, C, D, E");
    target.site_classes = *many;
  }
}

void read_points(const TextFile& file, DesignTarget& target) {
  const auto take = [&](double mce_factor) {
    return [&target, mce_factor](const NumberRow& of_file) -> RowTrouble {
      const std::vector<double>& row = of_file.values;
      if (row[0] < 0.0) return {"the period is below 0"};
      if (!target.period_s.empty() && row[0] <= target.period_s.back())
        return {"periods must increase from row to row"};
      if (!(row[1] > 0.0)) return {"the acceleration is not above 0"};
      if (row[1] > most_possible_g)
        return {
            fmt::format("the acceleration is in g: no site has more than {:g} g", most_possible_g)};
      target.period_s.push_back(row[0]);
      target.design_sa_g.push_back(row[1] / mce_factor);
      return {};
    };
  };
  read_number_rows(
      file, {{{"period_s", "design_sa_g"}, take(1.0)}, {{"period_s", "mce_sa_g"}, take(1.5)}});
}

void read_spectrum(const TomlTable& table, DesignTarget& target) {
  const std::string name = table.required_text("spectrum");
  table.hash_without_folders("spectrum");
  if (name.empty()) return;
  try {
    read_points(table.text_file(name), target);
  } catch (const InputError& error) {
    table.report("spectrum", error);
    return;
  }
  if (target.period_s.front() > 0.01 || target.period_s.back() < 5.0)
    table.report("spectrum",
                 "the spectrum does not cover the periods from 0.01 s to 5 s, over which a suite "
                 "is scaled and S_DS is read",
                 "give the spectrum from 0.01 s or less to 5 s or more");
}

/// Maps give them in percent of g.
void check_accelerations(const TomlTable& table) {
  for (const char* key : {"ss_g", "s1_g", "sds_g", "sd1_g"}) {
    const double value = table.number(key).value_or(0.0);
    if (value > most_possible_g)
      table.report(key,
                   fmt::format("{} = {:g} is in g: no site has more than {:g} g",
                               table.name_of(key), value, most_possible_g),
                   fmt::format("if it is in percent of g, give {:g}", value / 100.0));
  }
}

/// By a spectrum, by S_DS and S_D1, or by mapped values.
void check_one_form(const TomlTable& table, bool mapped_beside_spectrum) {
  const char* given = nullptr;
  for (const char* key : {"spectrum", "sds_g", "ss_g"}) {
    if (!table.has(key) || (mapped_beside_spectrum && std::string_view(key) == "ss_g")) continue;
    if (given != nullptr)
      table.report(key,
                   table.name_of(given) + " and " + table.name_of(key) +
                       " are both given: one would have no effect",
                   "leave one of them out");
    given = given == nullptr ? key : given;
  }
  if (mapped_beside_spectrum) return;
  for (const char* key : {"s1_g", "site_class", "site_classes"}) {
    if (table.has("spectrum") && table.has(key))
      table.report_idle(
          key, table.name_of("spectrum") + " and " + table.name_of(key) + " are both given");
  }
}

void read_tl(const TomlTable& table, DesignTarget& target) {
  target.tl_s = table.number("tl_s", above_zero).value_or(target.tl_s);
}

void read_mapped(const TomlTable& table, DesignTarget& target) {
  target.ss_g = table.required_number("ss_g", above_zero);
  target.s1_g = table.required_number("s1_g", above_zero);
  read_site_classes(table, target);
  read_tl(table, target);
}

}  // namespace

DesignTarget read_spectrum(const std::filesystem::path& file) {
  DesignTarget target;
  read_points(file, target);
  return target;
}

namespace {

/// One exception of ASCE 7-16, 11.4.8, or a list of them.
std::vector<int> read_exceptions(const TomlTable& table) {
  constexpr const char* key = "hazard_analysis";
  const std::vector<std::string> stated =
      table.is_array(key) ? table.texts(key).value_or(std::vector<std::string>{})
      : table.has(key)    ? std::vector{table.text(key).value_or("")}
                          : std::vector<std::string>{};
  std::vector<int> exceptions;
  for (const std::string& text : stated) {
    const auto found =
        std::ranges::find(exception_names, text, &std::pair<const char*, int>::first);
    if (found == exception_names.end()) {
      table.report(
          key, table.name_of(key) + " = \"" + text + "\" is no exception of 11.4.8",
          "give \"exception 1 of 11.4.8\" (or 2, 3); of an analysis give the spectrum, and "
          "in a project hazard_report, hazard_author and hazard_date");
      break;
    }
    exceptions.push_back(found->second);
  }
  return exceptions;
}

}  // namespace

DesignTarget read_target(const TomlTable& table, std::optional<DesignTarget>* mapped) {
  DesignTarget target;
  if (!table.has("edition"))
    table.report_missing("edition",
                         "asce7_10, asce7_16 or asce7_22: their site coefficients differ");
  target.edition = table.choice<AsceEdition>("edition", edition_names).value_or(target.edition);
  target.exceptions = read_exceptions(table);
  check_accelerations(table);
  const bool has_both = mapped != nullptr && table.has("spectrum") && table.has("ss_g");
  check_one_form(table, has_both);
  if (table.has("spectrum")) {
    read_spectrum(table, target);
  } else if (table.has("sds_g") || table.has("sd1_g")) {
    target.sds_g = table.required_number("sds_g", above_zero);
    target.sd1_g = table.required_number("sd1_g", above_zero);
    read_tl(table, target);
  } else {
    read_mapped(table, target);
  }
  if (has_both) {
    read_mapped(table, mapped->emplace(DesignTarget{.edition = target.edition}));
    mapped->value().exceptions = target.exceptions;
    if (!table.has("site_class") && !table.has("site_classes")) table.report_missing("site_class");
  }
  return target;
}

}  // namespace glissade
