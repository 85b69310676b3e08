// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "glissade/report/format.hpp"
#include "package/free_body.hpp"
#include "package/sections.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"

namespace glissade {
namespace {

Html model_html(bool of_roof, bool of_modes) {
  const Html building =
      of_modes
          ? paragraph(
                "Mode n of the building along each of its axes, with the ground acceleration a_g "
                "(D: displacement of the mode; \u03c9: circular frequency; \u03b6: damping ratio; "
                "\u03b3: participation at the roof):") +
                equation(
                    "D_n'' + 2\u03b6\u03c9_n D_n' + \u03c9_n^2 D_n = \u2212 a_g,   a = a_g + "
                    "\u03a3 \u03b3_n D_n''")
          : paragraph(
                "Building with the ground acceleration a_g, along each of its axes (M: mass; u: "
                "displacement of the roof relative to the ground; \u03c9: circular frequency; "
                "\u03b6: damping ratio), here along the slope:") +
                equation(
                    "M (u'' + 2\u03b6\u03c9 u' + \u03c9^2 u) = \u2212 M a_g \u2212 (N sin\u03b8 "
                    "\u2212 F_s cos\u03b8),   a = u'' + a_g");
  const Html bodies =
      "<figure>\n" + in_box(Html::drawing(free_body_svg, "Free bodies of array and roof")) +
      "<figcaption>Free bodies of the array and of the roof.</figcaption>\n</figure>\n";
  return "<div class=\"short\">\n" +
         paragraph(
             of_roof
                 ? "The roof moves as the motions of the suite state. The array is a rigid mass on "
                   "it "
                   "with Coulomb friction; it slides in plan along both axes at once and does not "
                   "act "
                   "back on the roof."
             : of_modes
                 ? "The building is linear, with several modes along each of its two horizontal "
                   "axes, of one damping ratio: those of a uniform cantilever of flexure and shear "
                   "(Miranda & Taghavi 2005), as many as carry 95 % of the mass or have periods "
                   "above 0.05 s, six at most. The array is a rigid mass on its roof with Coulomb "
                   "friction; it slides in plan along both axes at once. Its mass is neglected: it "
                   "does not act back on the building. The roof moves vertically with the ground."
                 : "The building is a linear oscillator along each of its two horizontal axes, "
                   "with "
                   "one period and damping ratio. The array is a rigid mass on its roof with "
                   "Coulomb friction; it slides in plan along both axes at once and acts back on "
                   "the building. The roof moves vertically with the ground.") +
         (of_roof || of_modes ? Html() : bodies) + "</div>\n" +
         paragraph(fmt::format(
             "Array (m: mass; s, y: displacement along and across the slope, s positive down; N: "
             "normal force; F: friction; a: acceleration of the roof; w: vertical acceleration of "
             "the {}; \u03b8: slope):",
             of_roof ? "roof" : "ground")) +
         equation("N/m = (g + w) cos\u03b8 + a sin\u03b8 \u2265 0") +
         equation(
             "s'' = (g + w) sin\u03b8 \u2212 a cos\u03b8 \u2212 F_s/m,   y'' = \u2212 a_y \u2212 "
             "F_y/m") +
         paragraph(
             "Friction while sliding with the velocity v = (s', y'), and while the array does not "
             "slide:") +
         equation("F = \u03bc N v/|v|,   |F| \u2264 \u03bc N") + (of_roof ? Html() : building) +
         paragraph(fmt::format(
             "Sliding begins where |F| would exceed \u03bcN and ends where v = 0. The displacement "
             "of a history is the SRSS of the largest displacements along both axes (Walters et "
             "al. 2012), in plan. Between samples the {} acceleration is linear. Equations "
             "and sources: src/theory.md of the program.",
             of_roof ? "roof" : "ground"));
}

/// How the analysis leads to the displacement that governs.
Html governing_html(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  const PrescribedValue& standard = of_standard(package.project, design);
  std::vector<std::string> steps{fmt::format(
      "Analysis (Walters et al. 2012): {:g} \u00d7 {} = {}.", design.factor,
      length_in_both(design.analysis_m / design.factor, 1), length_in_both(design.analysis_m, 1))};
  if (package.project.peer_reviewed) {
    steps.push_back(
        "The engineer states that the analysis is peer reviewed: no least value applies.");
  } else {
    steps.push_back(fmt::format(
        "Least value of an analysis: {:g} \u00d7 {} = {} ({}){}.", standard.floor_share,
        length_in_both(standard.prescribed.value_m, 1), length_in_both(design.floor_m, 1),
        standard_name(package.project.standard),
        standard.may_be_used() ? ""
                               : "; it is applied although conditions of the prescribed value are "
                                 "not met, which is on the safe side"));
  }
  steps.push_back(fmt::format("Governing displacement: the larger, {}; rounded up to {}.",
                              length_in_both(design.governing_m, 1),
                              length_in_both(design.rounded_m)));
  steps.push_back(deciding_sentence(design) +
                  fmt::format(" Each premise: section {}.", number_of(Section::uncertainty)));
  return "<div class=\"short\">\n" + list(steps) + "</div>\n";
}

}  // namespace

Html result_html(const CalculationPackage& package, const Html& figure) {
  const bool of_modes = !package.project.building.alpha.empty();
  return section_heading(Section::result) + model_html(package.project.of_roof, of_modes) +
         paragraph(fmt::format(
             "The displacement is computed for all combinations of {}slope and orientation of the "
             "records, with and without vertical motion. The governing case is that with the "
             "largest mean over the records.",
             package.project.of_roof
                 ? ""
                 : fmt::format("building period, {}, ", varied_of_building(package.project)))) +
         page_table(record_displacements_table(package)) + page_table(demand_table(package)) +
         figure + governing_html(package);
}

}  // namespace glissade
