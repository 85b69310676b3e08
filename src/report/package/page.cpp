// SPDX-License-Identifier: GPL-3.0-or-later
#include "page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/hazard/hazard.hpp"
#include "glissade/core/file.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/package.hpp"
#include "glissade/report/site_sheets.hpp"
#include "package/figures.hpp"
#include "package/free_body.hpp"
#include "package/print/pdf.hpp"
#include "package/print/print_head.hpp"
#include "package/print/printable.hpp"
#include "package/print/workbook.hpp"
#include "package/sections.hpp"
#include "package/sketch.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"
#include "page/symbols.hpp"

namespace glissade {
namespace {

/// A heading that the contents point to.
struct SectionHead {
  Section section;
  Markup id;  ///< "#scope"
  Markup open;
  const char* title;
};
constexpr std::array<SectionHead, 16> heads{{
    {Section::scope, "<li><a href=\"#scope\">", "<h2 id=\"scope\">", "Scope and conditions"},
    {Section::criteria, "<li><a href=\"#criteria\">", "<h2 id=\"criteria\">", "Design criteria"},
    {Section::building, "<li><a href=\"#building\">", "<h2 id=\"building\">", "Building"},
    {Section::array, "<li><a href=\"#array\">", "<h2 id=\"array\">", "Array"},
    {Section::friction, "<li><a href=\"#friction\">", "<h2 id=\"friction\">", "Friction tests"},
    {Section::motions, "<li><a href=\"#motions\">", "<h2 id=\"motions\">", "Motions"},
    {Section::result, "<li><a href=\"#result\">", "<h2 id=\"result\">",
     "Analysis and governing displacement"},
    {Section::separations, "<li><a href=\"#separations\">", "<h2 id=\"separations\">",
     "Separations"},
    {Section::sensitivity, "<li><a href=\"#sensitivity\">", "<h2 id=\"sensitivity\">",
     "Sensitivity"},
    {Section::probability, "<li><a href=\"#probability\">", "<h2 id=\"probability\">",
     "Probability of exceedance"},
    {Section::plausibility, "<li><a href=\"#plausibility\">", "<h2 id=\"plausibility\">",
     "Plausibility of the roof motions"},
    {Section::check, "<li><a href=\"#check\">", "<h2 id=\"check\">", "Independent check by hand"},
    {Section::provisions, "<li><a href=\"#provisions\">", "<h2 id=\"provisions\">",
     "Provisions used"},
    {Section::checks, "<li><a href=\"#checks\">", "<h2 id=\"checks\">",
     "Checks, limits and peer review"},
    {Section::references, "<li><a href=\"#references\">", "<h2 id=\"references\">", "References"},
    {Section::inputs, "<li><a href=\"#inputs\">", "<h2 id=\"inputs\">", "Program and input files"},
}};

Html contents_html() {
  Html html("<div class=\"short\"><ul class=\"contents\">\n");
  for (const SectionHead& head : heads)
    html += enclosed(head.id, fmt::format("{}. {}", number_of(head.section), head.title),
                     "</a></li>\n");
  return html + "</ul></div>\n";
}

Html section_heading(Section section) {
  const SectionHead& head = heads.at(static_cast<std::size_t>(section));
  return enclosed(head.open, fmt::format("{}. {}", number_of(section), head.title), "</h2>\n");
}

/// Rows are whole; a short table is on one page, a longer one may go on with its header repeated.
Html page_table(const Table& table) {
  constexpr std::size_t most_rows = 13;
  return table.rows.size() > most_rows ? wide_table(table)
                                       : "<div class=\"short\">\n" + wide_table(table) + "</div>\n";
}

/// Without a caption, which the heading above it has.
Html plain_table(const Table& table) {
  return "<div class=\"plain\">\n" + page_table(table) + "</div>\n";
}

Html equation(const std::string& text) {
  return enclosed("<p class=\"equation\">", text, "</p>\n");
}

Html warnings_html(const CalculationPackage& package) {
  const std::vector<std::string> warnings = shown_warnings(package);
  return warnings.empty()
             ? Html()
             : "<div class=\"warning\">\n<strong>Warnings</strong>\n" + list(warnings) + "</div>\n";
}

Html title_html(const Project& project) {
  return "<div class=\"title\">\n<div>\n" + wide_table(title_table(project)) +
         "</div>\n<div class=\"stamp\">Stamp and signature</div>\n</div>\n";
}

/// What is decided, on the first page.
Html answer_html(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  Table separations = separations_table(package);
  separations.notes.clear();
  const std::vector<std::string> open = open_items(package);
  return "<div class=\"answer\">\n<strong>Result</strong>\n" +
         list({fmt::format("Governing displacement: {}, by {}.", length_in_both(design.governing_m),
                           governed_by(package)),
               verdict_sentence(package)}) +
         wide_table(separations) +
         (open.empty() ? Html() : "<strong>Open items</strong>\n" + list(open)) + "</div>\n";
}

/// Of all clearances that are stated.
std::string short_verdict(const CalculationPackage& package) {
  const std::string where_wide = verdict_where_wide_enough(package);
  const std::vector<ProjectSeparation>& all = package.design.separations;
  if (where_wide == "not applicable") return where_wide;
  if (std::ranges::any_of(all, [](const ProjectSeparation& s) {
        return s.available_m && *s.available_m < s.required.value_m;
      }))
    return "not sufficient";
  return std::ranges::any_of(all,
                             [](const ProjectSeparation& s) { return s.available_m.has_value(); })
             ? where_wide
             : "not stated";
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
                                      : "All conditions are met: the exception applies.");
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

/// What the motions are, and how they are scaled.
Html roof_motions_html(const CalculationPackage& package) {
  const SuiteSummary& suite = package.demand.suites.front();
  return paragraph(fmt::format(
             "Suite: {}{}. Its motions are those of the roof on which the array stands, of a "
             "model of the building or recorded in it; they are used without a building and "
             "without "
             "a design spectrum. At DBE each is multiplied by {:g} (and by its scale in the "
             "suite), "
             "at MCE by 1.5 times that: a building that yields would have other motions there. "
             "The orientations swap and mirror the "
             "components: slopes along either axis of the building, in either direction.",
             suite.name, suite.description.empty() ? "" : ": " + suite.description,
             package.project.roof_factor)) +
         page_table(motions_table(package.demand.records, package.files, package.project.of_roof)) +
         page_table(scaled_motions_table(package));
}

Html motions_html(const CalculationPackage& package, const std::vector<DrawnFigure>& figures) {
  if (package.project.of_roof) return roof_motions_html(package);
  const SuiteSpectra& spectra = package.demand.suites.front().spectra;
  const SpectralRatios& ratios = spectra.to_target;
  const double to_s = 1.5 * periods_of(package.project).back();
  const std::string beyond =
      to_s > longest_scaled_period_s && !package.project.without_target
          ? fmt::format(
                ", and nowhere below {:g} times it from there to {:.3g} s, 1.5 times the "
                "longest building period of the demand study (by no clause)",
                least_over_target_beyond, to_s)
          : "";
  const bool by_walters = spectra.rule == ScalingRule::walters_2012;
  const std::string rule =
      by_walters ? "its average SRSS spectrum is the design spectrum or more at each period of the "
                   "scaling rule, 0 to 2 s (Walters et al. 2012)" +
                       beyond +
                       ". This is the rule of the paper, and none of ASCE 7: that of an edition is "
                       "suite.scaling_rule of the project"
                 : fmt::format("it meets {}: its {}, here from {:.3g} to {:.3g} s, at DBE and MCE",
                               text_of(spectra.rule).clause, text_of(spectra.rule).spectrum,
                               spectra.range.from_s, spectra.range.to_s);
  return paragraph(fmt::format(
             "Suite: {}: {}. The suite, with its own scales, is multiplied by one factor, {:.4g} "
             "to "
             "DBE, so that {}. {} the lowest is {:.3f} times the design spectrum (at {:.3g} s), "
             "the highest "
             "{:.3f} times (at {:.3g} s){}. MCE is 1.5 times DBE.",
             package.demand.suites.front().name, package.demand.suites.front().description,
             package.demand.records.front().factor_at_unit_level * dbe_level(package.project) /
                 package.demand.records.front().suite_scale,
             rule, by_walters ? "Between these periods" : "There", ratios.lowest.ratio,
             ratios.lowest.period_s, ratios.highest.ratio, ratios.highest.period_s,
             by_walters ? "" : fmt::format(", the mean {:.3f} times", spectra.mean_ratio))) +
         page_table(motions_table(package.demand.records, package.files, package.project.of_roof)) +
         page_table(scaled_motions_table(package)) + page_table(record_spectra_table(package)) +
         figure_html(figures.front(), 1);
}

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
                              length_in_both(design.governing_m),
                              length_in_both(design.rounded_m)));
  return "<div class=\"short\">\n" + list(steps) + "</div>\n";
}

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

Html by_hand_html(const CalculationPackage& package) {
  const Project& project = package.project;
  const double sds_g = package.design.site.sds_g;
  const Prescription& prescribed = of_standard(project, package.design).prescribed;
  const double over_g = std::max(0.0, sds_g - 0.4), square = over_g * over_g;
  const std::string by_hand =
      project.standard == Standard::asce7_16
          ? fmt::format(
                "\u0394_MPV = 5 I_e (S_DS \u2212 0.4)^2 ft = 5 \u00d7 {:g} \u00d7 ({:.4f} "
                "\u2212 0.4)^2 = {:.4f} ft = {:.2f} in, 24 in at least: {}",
                project.importance, sds_g, 5.0 * project.importance * square,
                60.0 * project.importance * square, length_in_both(prescribed.value_m))
          : fmt::format(
                "60 (S_DS \u2212 0.4)^2 in = 60 \u00d7 ({:.4f} \u2212 0.4)^2 = {:.2f} in, 6 "
                "in at least: {}",
                sds_g, 60.0 * square, length_in_both(prescribed.value_m));
  return section_heading(Section::check) + equation(by_hand) + page_table(by_hand_table(package)) +
         page_table(prescribed_table(package));
}

Html checks_html(const CalculationPackage& package) {
  Table review{"review", "Peer review", {text_column("item", ""), text_column("value", "")}, {}};
  for (const char* item : {"Reviewer", "Licence number", "Findings", "Signature and date"})
    review.add({std::string(item), std::string("____________________")});
  return section_heading(Section::checks) + wide_table(checks_table(package)) +
         paragraph(fmt::format(
             "The solver of glissade {} is verified against closed forms, solutions with 50 digits "
             "and both published papers; every comparison is in its verification manual "
             "(tests/verification/README.md of the program).",
             package.demand.program_version)) +
         list(
             {"The array is rigid and stays in contact with the roof: no tipping, no uplift.",
              "Friction is Coulomb's: it does not change with speed, temperature or wear.",
              package.project.of_roof
                  ? "The array does not act back on the roof, whose motions are "
                    "those of the suite."
              : package.project.building.alpha.empty()
                  ? "The building is elastic with one mode along each axis, without torsion."
                  : "The building is elastic, with several modes along each axis, without torsion.",
              std::string("The governing displacement is that of one earthquake. Displacements of "
                          "several earthquakes during the design life add up, and are not in it") +
                  (package.probability.hazard
                       ? fmt::format(": section {}.", number_of(Section::probability))
                       : "."),
              "The array does not strike anything and no cable restrains it."}) +
         paragraph(
             package.project.peer_reviewed
                 ? "The engineer states that this analysis is peer reviewed; the reviewer "
                   "signs here."
                 : "The least value of the standard is applied. An analysis below it requires "
                   "a peer review, which is recorded here.") +
         "<div class=\"form\">\n" + page_table(review) + "</div>\n";
}

Html references_html() {
  Html html = section_heading(Section::references) + "<ol>\n";
  for (
      const char* reference :
      {"ASCE/SEI 7-16 (2017). Minimum design loads and associated criteria for buildings and other "
       "structures.",
       "ASCE/SEI 7-22 (2022). The same.",
       "SEAOC PV1-2012. Structural seismic requirements and commentary for rooftop solar "
       "photovoltaic arrays.",
       "Walters, M., Berkowitz, R., Lau, D., Lee, W., Baker, J. (2012). Seismic considerations and "
       "evaluation approach for \"isolated\" rooftop PV arrays. SEAOC Convention Proceedings.",
       "Rodriguez-Nikl, T., Cedano, Martinez, Ojeda (2019). Predicted slip of ballasted solar "
       "arrays on angled roofs due to seismic motion.",
       "Miranda, E., Taghavi, S. (2005). Approximate floor acceleration demands in multistory "
       "buildings. J. Struct. Eng. 131(2):203-211.",
       "Seismic design load calculation of a permit, 12 September 2023. City of Santa Ana, "
       "building "
       "records, document 370815, page 20.",
       "Package of a manufacturer of ballasted arrays, design loads, 7.3.1. City of Santa Ana, "
       "building records, document 376473, page 60."})
    html += enclosed("<li>", reference, "</li>\n");
  return html + "</ol>\n";
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

/// Two columns, so that a hash stands on one line: "rsn169 first: RSN169_1.AT2".
Html files_html(const Table& files) {
  Table page{files.name,
             files.title,
             {text_column("file", "Record, component: file"),
              text_column("sha256", "SHA-256, first 16 digits")},
             {}};
  page.notes.push_back("All 64 digits are in tables/files.csv.");
  constexpr std::size_t shown_digits = 16;
  const auto text = [](const Cell& cell) { return std::get<std::string>(cell); };
  for (const std::vector<Cell>& row : files.rows) {
    const std::string file = std::filesystem::path(text(row[2])).filename().string();
    page.add(
        {text(row[0]) + " " + text(row[1]) + ": " + file, text(row[3]).substr(0, shown_digits)});
  }
  return Html("<div class=\"files\">\n") + page_table(page) + "</div>\n";
}

Html inputs_html(const CalculationPackage& package) {
  Html html = section_heading(Section::inputs) +
              paragraph(fmt::format(
                  "glissade {} ({}); plan of the demand study {}, of the probability "
                  "study {}; project file SHA-256 {}, suite file SHA-256 {}. The same files "
                  "and version give the same numbers.",
                  package.demand.program_version, package.build, package.demand.plan_hash,
                  package.probability.plan_hash, package.project_sha256, package.suite_sha256));
  if (!package.files.empty()) html += files_html(files_table(package));
  return html + "<h3>Project file, without its comments</h3>\n" +
         study_file(without_comments(package.project.source_text));
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
                  .is_simulated = package.files.empty(),
                  .verdict = short_verdict(package)};
  const DesignTarget& target = project.site.mapped ? *project.site.mapped : project.site.target;
  if (target.s1_g > 0.0) sheet.s1_g = target.s1_g;
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
      warnings_html(package) + paragraph("The whole calculation: " + folder + "/package.pdf.") +
      "</section>\n";
  return sheet;
}

bool write_package(const CalculationPackage& package, const std::filesystem::path& out_dir,
                   bool overwrite) {
  const LengthUnits units(package.project.units);
  const Project& project = package.project;
  std::vector<Table> tables{
      title_table(project),
      scope_table(package),
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
      sensitivity_table(package),
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
  write_workbook(tables, out_dir / "package.xlsx");
  std::vector<DrawnFigure> figures = write_parts(
      {"package.html", std::move(tables), package_figures(package)}, out_dir, overwrite);
  for (DrawnFigure& drawn : figures) drawn.svg = printable(drawn.svg);
  const bool has_demand_figure = !project.of_roof && figures.size() > 2;
  const Html page =
      print_head(
          {project.title.name, "calculation of required separations", in_inches() ? letter : a4},
          footer_text(package)) +
      paragraph(
          "Calculation of the seismic displacement of an unanchored rooftop solar array, and "
          "of its required separations") +
      title_html(project) + answer_html(package) + warnings_html(package) + contents_html() +
      scope_html(package) + section_heading(Section::criteria) +
      plain_table(criteria_table(package)) + given_curves_html(project) +
      section_heading(Section::building) + plain_table(building_table(package)) +
      section_heading(Section::array) + "<div class=\"inputs\">\n" +
      plain_table(array_table(package)) + "</div>\n" + section_heading(Section::friction) +
      "<div class=\"inputs\">\n" + page_table(friction_table(package)) + "</div>\n" +
      (project.friction.tested.empty() ? Html() : page_table(pull_tests_table(project.friction))) +
      section_heading(Section::motions) + motions_html(package, figures) +
      result_html(package, has_demand_figure ? figure_html(figures.at(1), 2) : Html()) +
      separations_html(package) + section_heading(Section::sensitivity) +
      page_table(sensitivity_table(package)) +
      probability_html(package, figure_html(figures.back(), figures.size())) +
      section_heading(Section::plausibility) + page_table(roof_accelerations_table(package)) +
      by_hand_html(package) + section_heading(Section::provisions) +
      "<div class=\"provisions\">\n" + page_table(provisions_table(package)) + "</div>\n" +
      checks_html(package) + references_html() + inputs_html(package) + page_foot();
  write_text_file(out_dir / "package.html", with_symbols(page.str()));
  return print_page(out_dir / "package.html");
}

}  // namespace glissade
