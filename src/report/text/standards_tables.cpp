// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/standards_tables.hpp"

#include "glissade/report/format.hpp"

namespace glissade {
Table conditions_table(const ArrayFacts& array) {
  using C = CodeCondition;
  TableOf<C, std::string, std::string> t("conditions",
                                         "Conditions of the prescribed displacements");
  t.text("standard", "Standard", "",
         [](const C&, const std::string& standard, const auto&) { return standard; });
  t.text("condition", "Condition", "", &C::what);
  t.text("limit", "Limit", "", &C::limit);
  t.text("found", "Found", "", &C::found);
  t.text("is_met", "Met", "", [](const C& of) {
    return !of.is_met ? "-" : *of.is_met ? "yes" : "NO";
  });
  t.text("clause", "Clause", "",
         [](const C&, const auto&, const std::string& clause) { return clause; });
  t.text("provision", "Provision", "", [](const C& of) { return provenance_name(of.provenance); });
  const std::vector<C> asce = conditions_of(Standard::asce7_16, array),
                       pv1 = conditions_of(Standard::seaoc_pv1_2012, array);
  for (std::size_t i = 0; i < asce.size(); ++i) {
    if (asce[i].limit == pv1[i].limit) {  // one row
      t.add(asce[i], "both", asce[i].clause + "; " + pv1[i].clause);
      continue;
    }
    t.add(asce[i], standard_name(Standard::asce7_16), asce[i].clause);
    t.add(pv1[i], standard_name(Standard::seaoc_pv1_2012), pv1[i].clause);
  }
  t.notes = {verify_note};
  return t;
}

Table separations_table(const std::vector<StandardSeparations>& standards) {
  using S = Separation;
  TableOf<std::string, S> t("separations", "Separations");
  t.text("standard", "Standard", "", [](const std::string& standard) { return standard; });
  t.text("between", "Between", "", &S::what);
  t.number("factor", "Factor", "", &S::factor);
  t.length("separation", "Separation", "", &S::value_m);
  t.text("provision", "Provision", "", [](const S& s) { return provenance_name(s.provenance); });
  for (const auto& [of, separations] : standards) {
    const std::string standard = standard_name(of);
    for (const S& s : separations) {
      t.add(standard, s);
      if (!s.basis.empty())
        t.notes.push_back(standard + ", " + s.what + ": " + s.basis + " (recalled: verify).");
    }
    t.notes.push_back(qualifying_parapet(of) + " (recalled: verify).");
  }
  t.notes.emplace_back(verify_note);
  return t;
}

}  // namespace glissade
