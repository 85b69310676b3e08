// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "glissade/core/units.hpp"
#include "glissade/design/premises.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/report/format.hpp"
#include "glissade/sampling/pull_test.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string or_blank(const std::string& text) {
  return text.empty() ? "____________________" : text;
}

std::string target_text(const Project& project) {
  const DesignTarget& target = project.site.target;
  if (!target.period_s.empty())
    return fmt::format("{}, spectrum of {} points, {}{}", edition_name(target.edition),
                       target.period_s.size(), project.spectrum_file,
                       project.site.mapped ? "; beside it " + to_string(*project.site.mapped) : "");
  if (target.sds_g > 0.0)
    return fmt::format("{}, S_DS {:.3f} g and S_D1 {:.3f} g as given", edition_name(target.edition),
                       target.sds_g, target.sd1_g);
  std::string classes;
  for (const SiteClass site : target.site_classes)
    classes += (classes.empty() ? "" : ", ") + to_string(site);
  return fmt::format("{}, S_S {:.3f} g, S_1 {:.3f} g, site class {}{}",
                     edition_name(target.edition), target.ss_g, target.s1_g, classes,
                     target.site_classes.size() > 1 ? " (the largest)" : "");
}

}  // namespace

Table title_table(const Project& project) {
  Table table{"title", "Project", {text_column("item", ""), text_column("value", "")}, {}};
  const TitleBlock& title = project.title;
  for (const auto& [item, value] :
       {std::pair<const char*, const std::string&>{"Project", title.name},
        {"Address", title.address},
        {"Authority having jurisdiction", title.authority},
        {"Governing code", title.code},
        {"Engineer", title.engineer},
        {"Licence number", title.licence},
        {"Revision", title.revision},
        {"Date", title.date}})
    table.add({std::string(item), or_blank(value)});
  return table;
}

namespace {

/// Rows of what is given or found, with where it comes from.
class InputRows {
 public:
  explicit InputRows(const char* name, const char* title)
      : table_{name,
               title,
               {text_column("quantity", "Quantity"), text_column("value", "Value"),
                text_column("source", "Source")},
               {}} {}
  void add(const std::string& quantity, const Cell& value, const std::string& source) {
    table_.add({quantity, value, source});
  }
  /// Nothing where it is not stated.
  void add_stated(const char* quantity, const std::string& value) {
    if (!value.empty()) add(quantity, value, project_file);
  }
  void add_premise(const char* quantity, const std::string& value) {
    add(quantity, value.empty() ? "not stated" : value, project_file);
  }
  void add_length(const char* quantity, const std::optional<double>& length_m) {
    add(quantity, length_m ? Cell(length_cell_in_both(*length_m)) : "not stated", project_file);
  }
  Table table() && { return std::move(table_); }

  static constexpr const char* project_file = "project file";

 private:
  Table table_;
};

/// "35 ft (10.67 m)", or "10.67 m".
NumberCell height_cell(double height_m) {
  if (!in_inches()) return significant(height_m, 4, "m");
  NumberCell height = significant(height_m / foot_m, 4, "ft");
  height.beside = " (" + text_of(significant(height_m, 4, "m")) + ")";
  return height;
}

/// One value, or the first and the last: "1.19 degrees", "1.19 to 2.39 degrees".
Cell range_cell(const std::vector<double>& values, const std::string& unit,
                const std::string& beside = "") {
  if (values.size() > 1)
    return range_text(values, (unit.empty() ? "" : " " + unit).c_str()) + beside;
  NumberCell value = significant(values.front(), 3, unit);
  value.beside = beside;
  return value;
}

const char* verdict_of(const std::optional<bool>& is_met) {
  return !is_met ? "not stated" : *is_met ? "met" : "NOT MET";
}

}  // namespace

Table scope_table(const CalculationPackage& package) {
  const Project& project = package.project;
  Table table{"conditions",
              project.standard == Standard::asce7_16
                  ? "Conditions of the exception for unattached arrays (ASCE 7-16, 13.6.12)"
                  : "Conditions of SEAOC PV1-2012 for unattached arrays",
              {text_column("condition", "Condition"), text_column("value", "Value"),
               text_column("limit", "Limit"), text_column("clause", "Clause"),
               text_column("verdict", "Verdict")},
              {}};
  for (const CodeCondition& c : of_standard(project, package.design).conditions)
    table.add({c.what, c.found, c.limit, c.clause, std::string(verdict_of(c.is_met))});
  return table;
}

Table premises_table(const Project& project) {
  Table table{"premises",
              "Premises of the verdict: before all are met no separation is sufficient",
              {text_column("premise", "Premise"), text_column("value", "Value"),
               text_column("required", "Required"), text_column("key", "Key of the project"),
               text_column("verdict", "Verdict")},
              {}};
  for (const Premise& premise : premises_of(project))
    table.add({capitalised(premise.what), premise.found.text, std::string(premise.required),
               std::string(premise.key), std::string(premise.found.is_met ? "met" : "OPEN")});
  return table;
}

Table criteria_table(const CalculationPackage& package) {
  const Project& project = package.project;
  const SiteValues& site = package.design.site;
  const DesignTarget& target = project.site.target;
  const std::string edition = edition_name(target.edition);
  InputRows rows("site", "Design criteria");
  const auto in_g = [](double value_g) { return fixed(value_g, 3, "g"); };
  rows.add("Risk category", to_string(project.site.risk), InputRows::project_file);
  rows.add("I_e", significant(project.importance, 6),
           project.importance == importance_factor(project.site.risk) ? edition + ", table 1.5-2"
                                                                      : InputRows::project_file);
  if (target.is_mapped()) {
    std::string classes;
    for (const SiteClass site_class : target.site_classes)
      classes += (classes.empty() ? "" : ", ") + to_string(site_class);
    rows.add("Site class", classes + (target.site_classes.size() > 1 ? " (the largest)" : ""),
             InputRows::project_file);
    rows.add("S_S", in_g(target.ss_g), InputRows::project_file);
    rows.add("S_1", in_g(target.s1_g), InputRows::project_file);
  } else {
    rows.add("Spectrum", target_text(project), InputRows::project_file);
  }
  if (site.fa > 0.0) {
    const bool is_default = target.site_classes == std::vector{SiteClass::unknown};
    rows.add("F_a", fixed(site.fa, 3),
             edition + ", table 11.4-1" +
                 (!is_default                               ? ""
                  : target.edition == AsceEdition::asce7_16 ? ", class D, and 1.2 or more"
                                                            : ", class D"));
    rows.add("F_v", fixed(site.fv, 3),
             edition + ", table 11.4-2" + (is_default ? ", class D" : ""));
  }
  const bool points = !target.period_s.empty();
  rows.add("S_MS", in_g(site.sms_g()), target.is_mapped() ? "F_a S_S" : "1.5 S_DS");
  rows.add("S_M1", in_g(site.sm1_g()), target.is_mapped() ? "F_v S_1" : "1.5 S_D1");
  rows.add("S_DS", in_g(site.sds_g),
           points               ? "90 % of the largest of the spectrum, 0.2 to 5 s (21.4)"
           : target.is_mapped() ? "2/3 S_MS"
                                : "as given");
  rows.add("S_D1", in_g(site.sd1_g),
           points               ? "largest S_a T of its points, 1 to 5 s (21.4)"
           : target.is_mapped() ? "2/3 S_M1"
                                : "as given");
  rows.add("T_S", fixed(site.sd1_g / site.sds_g, 3, "s"), "S_D1 / S_DS");
  if (!points && !project.of_roof)
    rows.add("T_L", significant(target.tl_s, 6, "s"),
             project.site.states_tl ? InputRows::project_file : "NOT STATED: assumed");
  rows.add("Distance to the nearest active fault",
           project.site.fault_distance_km
               ? Cell(significant(*project.site.fault_distance_km, 3, "km"))
               : "not stated",
           InputRows::project_file);
  rows.add("Seismic design category",
           category_text(project.site, site) +
               (target.is_mapped() || project.site.mapped ? "" : " (S_1 is not stated)"),
           edition + ", 11.6");
  const Prescription& prescribed = of_standard(project, package.design).prescribed;
  rows.add(displacement_symbol, length_cell_in_both(prescribed.value_m),
           prescribed.basis + ": the prescribed displacement");
  return std::move(rows).table();
}

Table building_table(const CalculationPackage& package) {
  const Project& p = package.project;
  const ProjectBuilding& building = p.building;
  InputRows rows("building", "Building");
  if (p.of_roof) {
    rows.add("Model", "none is computed: the motions are those of its roof", "suite file");
    rows.add_premise("Report on the roof motions", p.roof.report);
    rows.add_premise("Its author", p.roof.author);
    rows.add_premise("Its date", p.roof.date);
  } else {
    rows.add_stated("Structural system", building.system);
    if (building.height_m)
      rows.add("Height h", height_cell(*building.height_m), InputRows::project_file);
  }
  rows.add("Storeys", building.storeys ? Cell(significant(*building.storeys, 6)) : "not stated",
           InputRows::project_file);
  if (p.of_roof) return std::move(rows).table();
  if (building.approximate_period_s)
    rows.add("T_a", fixed(*building.approximate_period_s, 3, "s"), building.period_basis);
  rows.add("Periods computed",
           building.period_s.size() == 1
               ? Cell(significant(building.period_s.front(), 3, "s"))
               : Cell(fmt::format("{:.3g} s", fmt::join(building.period_s, ", "))),
           building.approximate_period_s ? building.bounds_text : building.period_basis);
  rows.add("Model",
           building.alpha.empty()
               ? "one mass on one spring"
               : "modes of a uniform cantilever of flexure and shear, \u03b1_0 " +
                     range_text(building.alpha, ""),
           building.model_basis);
  rows.add("Damping", significant(100.0 * building.damping, 6, "%"), InputRows::project_file);
  rows.add("Roof diaphragm",
           building.diaphragm.empty()      ? "NOT STATED: computed as rigid"
           : building.diaphragm == "rigid" ? "rigid"
                                           : building.diaphragm + ": computed as rigid",
           InputRows::project_file);
  return std::move(rows).table();
}

Table array_table(const CalculationPackage& package) {
  const Project& p = package.project;
  InputRows rows("array", "Array");
  rows.add_premise("Model", p.array.model);
  rows.add_stated("Ballast", p.array.ballast);
  rows.add_stated("Roof membrane", p.array.membrane);
  if (!p.of_roof)
    rows.add("Mass over that of the building",
             p.building.alpha.empty() ? range_cell(p.building.mass_ratio, "") : "neglected",
             p.building.mass_basis);
  std::vector<double> rises;
  for (const double slope_deg : p.slope_deg)
    rises.push_back(12.0 * std::tan(slope_deg * rad_per_deg));
  rows.add("Roof slope",
           range_cell(p.slope_deg, "degrees", " (rise in 12: " + range_text(rises, "") + ")"),
           InputRows::project_file);
  rows.add_length("Centre of mass above the roof", p.array.centre_of_mass_m);
  rows.add_length("Least spacing of the supports", p.array.support_spacing_m);
  rows.add("Strength across any section over the weight of its lighter side",
           p.array.interconnection ? Cell(significant(*p.array.interconnection, 3)) : "not stated",
           InputRows::project_file);
  return std::move(rows).table();
}

Table friction_table(const CalculationPackage& package) {
  const ProjectFriction& mu = package.project.friction;
  InputRows rows("friction", "Coefficient of friction");
  rows.add_premise("Laboratory", mu.laboratory);
  rows.add_premise("Tests of", mu.tested_on);
  rows.add_stated("Test standard", mu.test_standard);
  rows.add_premise("Surface", mu.surface_text());
  rows.add("Tests", mu.tests ? Cell(fixed(static_cast<double>(*mu.tests), 0)) : "not stated",
           mu.source);
  rows.add("\u03bc, mean", fixed(mu.mean, 3), "of the tests");
  rows.add("standard deviation", fixed(mu.std, 3), "of the tests (n - 1)");
  rows.add("\u03bc, design", fixed(mu.design(), 3), "mean - 2 std (Walters et al. 2012)");
  if (mu.lower_bound)
    rows.add(bound_name(mu), fixed(*mu.lower_bound, 3),
             "with 95 % confidence, 97.7 % of pulls have more (normal friction, this number of "
             "tests)");
  return std::move(rows).table();
}

Table pull_tests_table(const ProjectFriction& friction) {
  Table table{"pull_tests",
              "Pull tests",
              {text_column("direction", "Direction"), text_column("test", "Test"),
               text_column("mu", "\u03bc, sliding"), text_column("travel", "Travel"),
               text_column("speed", "Speed, mm/s")},
              {}};
  for (const TraceFriction& t : friction.traces)
    table.add({t.direction, t.test + (!meets_provision(t) ? " *" : ""), fixed(t.sliding_mu, 3),
               length_cell(t.travel_m), significant(1e3 * t.speed_mps, 3)});
  if (friction.traces.empty())
    for (const DirectionFriction& d : friction.tested)
      for (std::size_t i = 0; i < d.sliding_mu.size(); ++i)
        table.add({d.direction, fixed(static_cast<double>(i + 1), 0), fixed(d.sliding_mu[i], 3),
                   std::string("-"), std::string("-")});
  for (const DirectionFriction& d : friction.tested)
    table.notes.push_back(fmt::format("{}{}: mean {:.3f}, std {:.3f}, mean - 2 std {:.3f}.",
                                      d.direction,
                                      d.direction == friction.direction ? " (taken)" : "",
                                      d.sliding.mean, d.sliding.std, d.sliding.mean_minus_2_std));
  if (!std::ranges::all_of(friction.traces, meets_provision))
    table.notes.push_back("* does not meet this: " + pull_test_provision() + ".");
  return friction.traces.empty() ? table.without("travel").without("speed") : table;
}

Table spectrum_table(const Project& project) {
  const DesignTarget& target = project.site.target;
  Table table{"spectrum",
              fmt::format("Target spectrum as given, {} (SHA-256 {})", project.spectrum_file,
                          project.spectrum_sha256),
              {text_column("period", "Period, s"), text_column("design", "Design S_a, g"),
               text_column("mce", "MCE_R S_a, g")},
              {}};
  for (std::size_t i = 0; i < target.period_s.size(); ++i)
    table.add({significant(target.period_s[i], 6), significant(target.design_sa_g[i], 4),
               significant(mce_over_dbe * target.design_sa_g[i], 4)});
  return table;
}

Table hazard_curve_table(const ProjectHazard& hazard) {
  Table table{"hazard_curve",
              fmt::format("Hazard curve of the site as given, {} (SHA-256 {})", hazard.curve,
                          hazard.sha256),
              {text_column("sds", "S_DS, g"), text_column("rate", "Annual rate")},
              {}};
  for (const HazardPoint& point : hazard.points)
    table.add({significant(point.intensity, 4), significant(point.annual_rate, 4)});
  return table;
}

}  // namespace glissade
