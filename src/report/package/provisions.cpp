// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/units.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/report/format.hpp"
#include "glissade/sampling/pull_test.hpp"
#include "package/sections.hpp"
#include "package/tables.hpp"

namespace glissade {
namespace {

/// The table, row by row.
class ProvisionRows {
 public:
  explicit ProvisionRows(Table& table) : table_(table) {}
  /// @param public_document its number in the references; "" where none is known
  void add(const std::string& clause, const std::string& value, Section where,
           const char* public_document = "") {
    table_.add({clause, value, fixed(number_of(where), 0), std::string(public_document),
                std::string("\u2610")});
  }

 private:
  Table& table_;
};

void add_site(const Project& project, ProvisionRows& rows) {
  const DesignTarget& target = project.site.target;
  const std::string edition = edition_name(target.edition) + ", ";
  const bool is_7_16 = target.edition == AsceEdition::asce7_16;
  if (target.is_mapped()) {
    rows.add(edition + "tables 11.4-1, 11.4-2", "F_a, F_v of the site class", Section::criteria,
             is_7_16 ? "[7]" : "");
    if (target.site_classes == std::vector{SiteClass::unknown})
      rows.add(edition + (is_7_16 ? "11.4.3, 11.4.4" : "11.4.2"),
               is_7_16 ? "default site class: D, F_a of at least 1.2" : "default site class: D",
               Section::criteria, is_7_16 ? "[7]" : "");
    rows.add(edition + (is_7_16 ? "11.4.4, 11.4.5" : "11.4.3, 11.4.4"),
             "S_MS = F_a S_S, S_M1 = F_v S_1, S_DS = 2/3 S_MS, "
             "S_D1 = 2/3 S_M1",
             Section::criteria, is_7_16 ? "[7]" : "");
    if (is_7_16)
      rows.add(edition + "11.4.8",
               "where a ground motion hazard analysis is required: class D with "
               "S_1 of 0.2 g or more, class E; its exceptions",
               Section::scope);
  } else if (!target.period_s.empty()) {
    rows.add(edition + "21.4",
             "S_DS: 90 % of the largest S_a, 0.2 to 5 s; S_D1: largest S_a T, 1 "
             "to 5 s",
             Section::criteria);
    if (project.site.mapped)
      rows.add(edition + "21.3", "a site-specific spectrum is 80 % of the general one or more",
               Section::checks);
  }
  rows.add(edition + "table 1.5-2", "I_e of the risk category", Section::criteria,
           is_7_16 ? "[7]" : "");
  rows.add(edition + "11.6", "seismic design category", Section::criteria, is_7_16 ? "[7]" : "");
  if (!project.of_roof && project.building.approximate_period_s)
    rows.add(edition + "12.8-7, table 12.8-2", "T_a = C_t h^x", Section::building,
             is_7_16 && project.building.system_is_checked ? "[7]" : "");
}

void add_asce7_16(const Project& project, ProvisionRows& rows) {
  const std::string clause = "ASCE 7-16, 13.6.12";
  for (const CodeCondition& c : conditions_of(Standard::asce7_16, {}))
    rows.add(clause, c.text(), Section::scope);
  rows.add(clause, "\u0394_MPV = 5 I_e (S_DS - 0.4)^2 ft", Section::criteria, "[7]");
  rows.add(clause, "\u0394_MPV of at least 24 in", Section::criteria);
  rows.add(clause, "separations: 0.5, 1, 1 and 2 times \u0394_MPV", Section::separations, "[7, 8]");
  rows.add(clause, "4 ft or more to an edge without a qualifying parapet", Section::separations);
  rows.add(clause, qualifying_parapet(Standard::asce7_16), Section::separations);
  rows.add(clause, "nonlinear response history analysis in place of \u0394_MPV", Section::result,
           "[8]");
  if (!project.peer_reviewed)
    rows.add(clause, "its result: 80 % of \u0394_MPV or more, unless peer reviewed",
             Section::result);
}

void add_pv1(const Project& project, ProvisionRows& rows) {
  const std::string clause = "SEAOC PV1-2012";
  if (project.standard == Standard::seaoc_pv1_2012) {
    for (const CodeCondition& c : conditions_of(Standard::seaoc_pv1_2012, {}))
      rows.add(clause, c.text(), Section::scope);
    rows.add(clause, "separations: 0.5, 1, 1 and 2 times the displacement", Section::separations);
    rows.add(clause, qualifying_parapet(Standard::seaoc_pv1_2012), Section::separations);
    rows.add(clause, analysis_provision(Standard::seaoc_pv1_2012), Section::result);
  }
  rows.add(clause, "60 (S_DS - 0.4)^2 in, categories D to F", Section::check, "[5]");
  rows.add(clause, "6 in at least; 6 in for categories A to C", Section::check);
  rows.add(clause, "7 records or more for a mean to count; of fewer the largest", Section::result);
  rows.add(clause, pull_test_provision(), Section::friction);
}

}  // namespace

Table provisions_table(const CalculationPackage& package) {
  const Project& project = package.project;
  Table table{
      "provisions",
      "Provisions used: confirm against the adopted code",
      {text_column("clause", "Clause"), text_column("value", "Value"),
       text_column("section", "Used in section"), text_column("public_document", "Public document"),
       text_column("confirmed", "Confirmed")},
      {}};
  ProvisionRows rows(table);
  add_site(project, rows);
  if (project.standard == Standard::asce7_16) add_asce7_16(project, rows);
  add_pv1(project, rows);
  rows.add("Walters et al. 2012", "design friction: mean - 2 std", Section::friction, "[4]");
  if (!project.of_roof) {
    if (project.scaling_rule == ScalingRule::walters_2012)
      rows.add("Walters et al. 2012",
               "the average SRSS spectrum of the suite is the design spectrum or more, 0 to 2 s",
               Section::motions, "[4]");
    else
      rows.add(text_of(project.scaling_rule).clause, text_of(project.scaling_rule).spectrum,
               Section::motions);
    if (!project.building.alpha.empty())
      rows.add("Miranda & Taghavi 2005", "\u03b1_0 of the structural system", Section::building);
  }
  rows.add("Walters et al. 2012", "1.1 times the mean displacement of the suite", Section::result,
           "[4]");
  rows.add("ASCE 7-16, 13.3-1", "0.4 S_DS (1 + 2 z/h) at a roof", Section::plausibility, "[7]");
  if (!project.of_roof)
    rows.add("ASCE 7-22, 13.3.1", "0.4 S_DS H_f at a roof", Section::plausibility);
  table.notes.push_back(
      "The program states provisions from memory of the standards. Those with a public document "
      "(its number in the references) are reproduced from it; the engineer confirms each against "
      "the adopted code.");
  return table;
}

}  // namespace glissade
