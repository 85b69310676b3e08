// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/standards_tables.hpp"

#include "glissade/report/format.hpp"

namespace glissade {
namespace {

std::string mark(Provenance provenance) {
  return provenance == Provenance::checked ? "checked" : "recalled";
}

/// A condition that both standards have alike is one row.
std::vector<Cell> row(const std::string& standard, const CodeCondition& c,
                      const std::string& clause) {
  return {standard,
          c.what,
          c.limit,
          c.found,
          std::string(!c.is_met   ? "-"
                      : *c.is_met ? "yes"
                                  : "NO"),
          clause,
          mark(c.provenance)};
}

}  // namespace

Table conditions_table(const ArrayFacts& array) {
  Table table{
      "conditions",
      "Conditions of the prescribed displacements",
      {text_column("standard", "Standard"), text_column("condition", "Condition"),
       text_column("limit", "Limit"), text_column("found", "Found"), text_column("is_met", "Met"),
       text_column("clause", "Clause"), text_column("provision", "Provision")},
      {},
      {verify_note}};
  const std::vector<CodeCondition> asce = conditions_of(Standard::asce7_16, array),
                                   pv1 = conditions_of(Standard::seaoc_pv1_2012, array);
  const std::string of_asce = standard_name(Standard::asce7_16),
                    of_pv1 = standard_name(Standard::seaoc_pv1_2012);
  for (std::size_t i = 0; i < asce.size(); ++i) {
    if (asce[i].limit == pv1[i].limit) {
      table.add(row("both", asce[i], asce[i].clause + "; " + pv1[i].clause));
      continue;
    }
    table.add(row(of_asce, asce[i], asce[i].clause));
    table.add(row(of_pv1, pv1[i], pv1[i].clause));
  }
  return table;
}

Table separations_table(const std::vector<StandardSeparations>& standards) {
  Table table{"separations",
              "Separations",
              {text_column("standard", "Standard"),
               text_column("between", "Between"),
               {"factor", "", "Factor"},
               {"separation", "m", "Separation, m (in)", ColumnKind::length},
               text_column("provision", "Provision")},
              {},
              {}};
  for (const auto& [standard, separations] : standards) {
    for (const Separation& s : separations) {
      table.add({standard_name(standard), s.what, s.factor, s.value_m, mark(s.provenance)});
      if (!s.basis.empty())
        table.notes.push_back(standard_name(standard) + ", " + s.what + ": " + s.basis +
                              " (recalled: verify).");
    }
    table.notes.push_back(qualifying_parapet(standard) + " (recalled: verify).");
  }
  table.notes.emplace_back(verify_note);
  return table;
}

}  // namespace glissade
