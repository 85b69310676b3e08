// SPDX-License-Identifier: GPL-3.0-or-later
#include "page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/hazard/hazard.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/package.hpp"
#include "glissade/report/site_sheets.hpp"
#include "package/figures.hpp"
#include "package/print/pdf.hpp"
#include "package/print/print_head.hpp"
#include "package/print/printable.hpp"
#include "package/sections.hpp"
#include "package/sketch.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"
#include "page/symbols.hpp"

namespace glissade {
namespace {

Html title_html(const Project& project) {
  return "<div class=\"title\">\n<div>\n" + wide_table(title_table(project)) +
         "</div>\n<div class=\"stamp\">Stamp and signature</div>\n</div>\n";
}

/// What is decided, on the first page.
Html answer_html(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  Table separations = separations_table(package);
  separations.notes.clear();
  const std::vector<std::string> open = open_items(package.design);
  return "<div class=\"answer\">\n<strong>Result</strong>\n" +
         list({fmt::format("Governing displacement: {}, by {}.",
                           length_in_both(design.governing_m, 1), governed_by(package)),
               verdict_sentence(package)}) +
         wide_table(separations) +
         (open.empty() ? Html() : "<strong>Open items</strong>\n" + list(open)) + "</div>\n";
}

Html scope_html(const CalculationPackage& package) {
  const Project& project = package.project;
  const PrescribedValue& standard = of_standard(project, package.design);
  const std::string violated = standard.violated(), not_met = standard.not_met();
  return section_heading(Section::scope) +
         paragraph(fmt::format(
             "An unattached array can slide in an earthquake. This calculation gives the "
             "displacement to design for, by nonlinear response history analysis in place of the "
             "prescribed {}, and the separations that follow from it ({}).",
             displacement_symbol,
             project.standard == Standard::asce7_16 ? "ASCE 7-16, 13.6.12" : "SEAOC PV1-2012")) +
         page_table(scope_table(package)) +
         paragraph(!violated.empty()
                       ? "NOT APPLICABLE: not met: " + violated +
                             ". An unanchored array then requires the approval of the authority."
                   : !not_met.empty() ? "OPEN: not stated: " + not_met + "."
                                      : "All conditions are met: the exception applies.") +
         page_table(premises_table(project));
}

/// What the project gives by points.
std::vector<Table> given_curves(const Project& project) {
  std::vector<Table> tables;
  if (!project.site.target.period_s.empty()) tables.push_back(spectrum_table(project));
  if (project.hazard && !project.hazard->curve.empty())
    tables.push_back(hazard_curve_table(*project.hazard));
  return tables;
}

Html given_curves_html(const Project& project) {
  Html html;
  for (const Table& table : given_curves(project)) html += page_table(table);
  return html;
}

Html separations_html(const CalculationPackage& package) {
  return section_heading(Section::separations) + page_table(separations_table(package)) +
         "<figure>\n" +
         in_box(Html::drawing(separations_sketch(package),
                              "Plan of the roof with the required and available separations")) +
         enclosed("<figcaption>",
                  "Plan: the required separations A to " +
                      separation_letter(package.design.separations.size() - 1) +
                      " to scale, and what is available. Arrays and objects are not to scale.",
                  "</figcaption>\n</figure>\n");
}

/// What the hazard section of a report has in tables.
Html hazard_html(const CalculationPackage& package) {
  if (!package.probability.hazard) return paragraph(hazard_sentence(package));
  // The building period names the run, where there are several.
  const auto of_periods = [&](const Table& table) {
    return package.probability.runs.size() > 1 ? table.without("run") : table;
  };
  return paragraph(
             "Annual rates: the mean of the hazard curve over the capacities of the histories. "
             "Over the design life earthquakes are a Poisson process with the rates of the hazard "
             "curve; residual displacements add up as vectors, and the array is not returned to "
             "its initial position.") +
         page_table(of_periods(
             hazard_table(package.probability, package.design.governing_m).without("fit_rate"))) +
         page_table(of_periods(shown_design_life_table(package.probability)));
}

Html probability_html(const CalculationPackage& package, const Html& figure) {
  return section_heading(Section::probability) + page_table(exceedance_table(package)) +
         (package.design.compared.size() > 1 ? page_table(compared_table(package)) : Html()) +
         figure + hazard_html(package);
}

}  // namespace

namespace {

std::vector<std::string> user_texts(const CalculationPackage& package) {
  std::vector<std::string> texts = glissade::user_texts(package.demand);
  const Project& p = package.project;
  const TitleBlock& title = p.title;
  texts.insert(texts.end(), {title.name, title.address, title.authority, title.code, title.engineer,
                             title.licence, title.revision, title.date, p.site_name, p.array.model,
                             p.array.ballast, p.array.membrane, p.roof.report, p.roof.author,
                             p.roof.date, p.spectrum_file, p.site.analysis.report,
                             p.site.analysis.author, p.site.analysis.date});
  const ProjectFriction& mu = p.friction;
  texts.insert(texts.end(), {mu.source, mu.direction, mu.laboratory, mu.tested_on, mu.test_standard,
                             mu.surface_description});
  for (const TraceFriction& trace : mu.traces) texts.push_back(trace.test);
  for (const DirectionFriction& tested : mu.tested) texts.push_back(tested.direction);
  for (const ProjectGap& gap : p.gaps) texts.push_back(gap.name);
  for (const ComponentFile& file : package.files) texts.push_back(file.file);
  return texts;
}

}  // namespace

SiteSheet site_sheet(const CalculationPackage& package, const std::string& folder) {
  const LengthUnits units(package.project.units);
  const Project& project = package.project;
  SiteSheet sheet{.name = project.site_name,
                  .folder = folder,
                  .sds_g = package.design.site.sds_g,
                  .sd1_g = package.design.site.sd1_g,
                  .friction = project.friction.design(),
                  .governing_m = package.design.governing_m,
                  .is_simulated = project.simulated_motions,
                  .verdict = to_string(verdict_on(project, package.design))};
  const DesignTarget& target = project.site.mapped ? *project.site.mapped : project.site.target;
  if (target.s1_g > 0.0) sheet.s1_g = target.s1_g;
  sheet.user_texts = user_texts(package);
  for (const ProjectSeparation& s : package.design.separations)
    sheet.largest_required_m = std::max(sheet.largest_required_m, s.required.value_m);
  const ProjectBuilding& building = project.building;
  sheet.page =
      "<section class=\"site\">\n" + heading(project.title.name) + answer_html(package) +
      paragraph(fmt::format(
          "{}S_DS {:.3f} g, S_D1 {:.3f} g, seismic design category {}. Building: {}. Roof: "
          "slope {}. Friction: mean {:.3f}, standard deviation {:.3f}.",
          project.title.address.empty() ? "" : project.title.address + ". ",
          package.design.site.sds_g, package.design.site.sd1_g,
          category_text(project.site, package.design.site),
          project.of_roof ? std::string("in the motions of its roof")
                          : "period " + range_text(building.period_s, " s") +
                                (building.alpha.empty() ? ", one mass" : ", modes"),
          range_text(project.slope_deg, " degrees"), project.friction.mean, project.friction.std)) +
      warnings_box(other_warnings(package.design)) +
      paragraph("The whole calculation: " + folder + "/package.pdf.") + "</section>\n";
  return sheet;
}

bool write_package(const CalculationPackage& package, const std::filesystem::path& out_dir) {
  const LengthUnits units(package.project.units);
  const UserTexts texts(user_texts(package));
  const Project& project = package.project;
  std::vector<Table> tables{
      title_table(project),
      scope_table(package),
      premises_table(project),
      criteria_table(package),
      building_table(package),
      array_table(package),
      friction_table(package),
      motions_table(package.demand.records, package.files, package.project.of_roof),
      scaled_motions_table(package),
      files_table(package),
      record_displacements_table(package),
      demand_table(package),
      separations_table(package),
      open_items_table(package),
      uncertainty_table(package),
      exceedance_table(package),
      compared_table(package),
      roof_accelerations_table(package),
      by_hand_table(package),
      prescribed_table(package),
      provisions_table(package),
      checks_table(package)};
  if (!project.of_roof) tables.push_back(record_spectra_table(package));
  if (!project.friction.tested.empty()) tables.push_back(pull_tests_table(project.friction));
  for (Table& table : given_curves(project)) tables.push_back(std::move(table));
  bool is_printed = false;
  const auto write_page = [&](std::vector<DrawnFigure> figures) {
    for (DrawnFigure& drawn : figures) drawn.svg = printable(drawn.svg);
    const bool has_demand_figure = !project.of_roof && figures.size() > 2;
    const Html page =
        print_head(
            {project.title.name, "calculation of required separations", in_inches() ? letter : a4},
            {project.title.name, project.title.revision, project.title.date,
             project.simulated_motions}) +
        paragraph(
            "Calculation of the seismic displacement of an unanchored rooftop solar array, and "
            "of its required separations") +
        title_html(project) + answer_html(package) + warnings_box(other_warnings(package.design)) +
        contents_html() + scope_html(package) + section_heading(Section::criteria) +
        plain_table(criteria_table(package)) + given_curves_html(project) +
        section_heading(Section::building) + plain_table(building_table(package)) +
        section_heading(Section::array) + "<div class=\"inputs\">\n" +
        plain_table(array_table(package)) + "</div>\n" + section_heading(Section::friction) +
        "<div class=\"inputs\">\n" + page_table(friction_table(package)) + "</div>\n" +
        (project.friction.tested.empty() ? Html()
                                         : page_table(pull_tests_table(project.friction))) +
        section_heading(Section::motions) + motions_html(package, figures) +
        result_html(package, has_demand_figure ? figure_html(figures.at(1), 2) : Html()) +
        separations_html(package) + section_heading(Section::uncertainty) +
        page_table(uncertainty_table(package)) +
        probability_html(package, figure_html(figures.back(), figures.size())) +
        section_heading(Section::plausibility) + page_table(roof_accelerations_table(package)) +
        by_hand_html(package) + section_heading(Section::provisions) +
        "<div class=\"provisions\">\n" + page_table(provisions_table(package)) + "</div>\n" +
        checks_html(package) + references_html() + inputs_html(package);
    is_printed = write_and_print(page, out_dir / "package.html");
  };
  write_parts({"package.html", std::move(tables), package_figures(package), "package.xlsx"},
              out_dir, write_page);
  return is_printed;
}

}  // namespace glissade
