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
#include "glissade/report/standards_tables.hpp"
#include "package/figures.hpp"
#include "package/free_body.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"

namespace glissade {
namespace {

constexpr Markup letter = "@page { size: letter; } @page wide { size: letter landscape; }";
constexpr Markup a4 = "@page { size: A4; } @page wide { size: A4 landscape; }";
constexpr Markup style = R"(
@page { margin: 20mm 17mm 18mm; @bottom-left { content: "Seismic displacement of an unanchored solar array"; font: 9pt Arial, sans-serif; } }
h2 { counter-increment: section; break-after: avoid; } h2::before { content: counter(section) ". "; }
.contents { columns: 20em 2; } .contents a { color: inherit; text-decoration: none; }
.equation { font-family: "Times New Roman", serif; font-size: 1.15em; margin: .4em 0 .4em 2em; }
caption { font-weight: bold; color: #222; } .note { font-weight: normal; }
.files td:last-child { font-family: monospace; overflow-wrap: anywhere; }
@media print {
  .short, li { break-inside: avoid; } .own-page { break-before: page; } h1 { font-size: 1.6em; } .answer ul, .warning ul { margin: .3em 0; } .inputs td:last-child { overflow-wrap: anywhere; }
  h2 { margin-top: 1.2em; } .contents a::after { content: " " leader(".") " " target-counter(attr(href), page); }
  figure { max-width: 17cm; } .files td:last-child { white-space: nowrap; } .files td { overflow-wrap: anywhere; }
}
)";

/// A heading that the contents point to.
struct Section {
  Markup id;  ///< "#result"
  Markup open;
  const char* title;
};
constexpr std::array<Section, 10> sections{{
    {"<li><a href=\"#result\">", "<h2 id=\"result\">", "Result"},
    {"<li><a href=\"#inputs\">", "<h2 id=\"inputs\">", "Inputs"},
    {"<li><a href=\"#motions\">", "<h2 id=\"motions\">", "Design spectrum and ground motions"},
    {"<li><a href=\"#model\">", "<h2 id=\"model\">", "Model"},
    {"<li><a href=\"#demand\">", "<h2 id=\"demand\">", "Displacement demand"},
    {"<li><a href=\"#required\">", "<h2 id=\"required\">", "Required displacement"},
    {"<li><a href=\"#sensitivity\">", "<h2 id=\"sensitivity\">", "Sensitivity"},
    {"<li><a href=\"#probability\">", "<h2 id=\"probability\">", "Probability of exceedance"},
    {"<li><a href=\"#checks\">", "<h2 id=\"checks\">", "Checks and limits"},
    {"<li><a href=\"#records\">", "<h2 id=\"records\">", "Program and input files"},
}};

Html contents_html(const char* motions_title) {
  Html html("<ol class=\"contents\">\n");
  for (const Section& section : sections)
    html += enclosed(section.id, &section == &sections[2] ? motions_title : section.title,
                     "</a></li>\n");
  return html + "</ol>\n";
}

const char* motions_title(const Project& project) {
  return project.of_roof ? "Design values and motions of the roof" : sections[2].title;
}

Html section_heading(std::size_t number) {
  return enclosed(sections.at(number).open, sections.at(number).title, "</h2>\n");
}

/// Rows are whole; a short table is on one page, a longer one may go on with its header repeated.
Html page_table(const Table& table) {
  constexpr std::size_t most_rows = 8;
  return table.rows.size() > most_rows ? wide_table(table)
                                       : "<div class=\"short\">\n" + wide_table(table) + "</div>\n";
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

Html result_html(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  const bool of_roof = package.project.of_roof;
  std::vector<std::string> answers{
      fmt::format("Governing displacement: {}, rounded up to {}.",
                  length_in_both(design.governing_m), length_in_both(design.rounded_m)),
      verdict_sentence(package), fmt::format("It is given by {}.", governed_by(package)),
      fmt::format("Analysis: {:g} x the largest {} displacement over {}all "
                  "orientations of the records at DBE = {}{}. With the median of "
                  "the orientations in place of the largest it would be {}.",
                  design.factor, design.of_largest ? "single" : "mean",
                  of_roof ? "" : fmt::format("{} building periods and ", design.demand.size()),
                  length_in_both(design.analysis_m),
                  of_roof ? "" : fmt::format(" (period {:.3g} s)", design.period_s),
                  length_in_both(design.median_analysis_m))};
  const PrescribedValue& standard = of_standard(package.project, design);
  answers.push_back(
      fmt::format("The full value that {} prescribes is {}: {}.", standard_name(standard.standard),
                  length_in_both(standard.prescribed.value_m),
                  standard.may_be_used()
                      ? "those conditions of its use that are known here (recalled: verify) are met"
                      : "not met or not stated for its use are: " + standard.not_met()));
  if (!standard.may_be_used())
    answers.push_back(
        "Outside these conditions an unanchored array requires the approval of the authority.");
  for (const ExceedanceAt& e : {design.compared.front().dbe, design.compared.front().mce})
    answers.push_back(fmt::format(
        "Probability that the governing displacement is exceeded, given {} shaking: {} (95 % "
        "interval {} to {}){}.",
        e.level, format_share(e.probability), format_share(e.interval.low),
        format_share(e.interval.high),
        of_roof ? ""
                : fmt::format(", at the building period with the largest, {:.3g} s", e.period_s)));
  answers.push_back(accepted_sentence(design) + ".");
  answers.push_back(hazard_sentence(package));
  // Beside the table, which scrolls on a narrow screen.
  Table separations = separations_table(package);
  Html reservations;
  for (const std::string& note : separations.notes) reservations += paragraph(note);
  separations.notes.clear();
  return section_heading(0) + page_table(separations) + reservations + "<div class=\"answer\">\n" +
         list(answers) + "</div>\n";
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
  return enclosed(sections[2].open, motions_title(package.project), "</h2>\n") +
         page_table(site_table(package)) +
         paragraph(fmt::format(
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
         page_table(motions_table(package)) + page_table(scaled_motions_table(package));
}

Html motions_html(const CalculationPackage& package, const std::vector<DrawnFigure>& figures) {
  if (package.project.of_roof) return roof_motions_html(package);
  const SpectralRatios& ratios = package.demand.suites.front().spectra.to_target;
  const double to_s = 1.5 * periods_of(package.project).back();
  const std::string beyond =
      to_s > longest_scaled_period_s && !package.project.without_target
          ? fmt::format(
                ", and nowhere below {:g} times it from there to {:.3g} s, 1.5 times the "
                "longest building period of the demand study (ASCE 7-16, 16.2, recalled)",
                least_over_target_beyond, to_s)
          : "";
  return section_heading(2) + page_table(site_table(package)) +
         paragraph(
             fmt::format("Suite: {}: {}. The suite, with its own scales, is multiplied by one "
                         "factor, so that its average SRSS spectrum is the design spectrum or more "
                         "at each period of the scaling rule, 0 to 2 s (Walters et al. 2012){}. "
                         "Between these periods the lowest is {:.3f} times the design spectrum (at "
                         "{:.3g} s), the highest {:.3f} times (at {:.3g} s). MCE is 1.5 times DBE.",
                         package.demand.suites.front().name,
                         package.demand.suites.front().description, beyond, ratios.lowest.ratio,
                         ratios.lowest.period_s, ratios.highest.ratio, ratios.highest.period_s)) +
         page_table(motions_table(package)) + page_table(scaled_motions_table(package)) +
         page_table(record_spectra_table(package)) + figure_html(figures.front(), 1);
}

Html model_html(bool of_roof, bool of_modes) {
  const Html building =
      paragraph(
          "Building with the ground acceleration a_g, along each of its axes (M: mass; u: "
          "displacement of the roof relative to the ground; \u03c9: circular frequency; "
          "\u03b6: damping ratio), here along the slope:") +
      equation(
          "M (u'' + 2\u03b6\u03c9 u' + \u03c9\u00b2 u) = \u2212 M a_g \u2212 (N sin\u03b8 "
          "\u2212 F_s cos\u03b8),   a = u'' + a_g");
  const Html bodies =
      "<figure>\n" + in_box(Html::drawing(free_body_svg, "Free bodies of array and roof")) +
      "<figcaption>Free bodies of the array and of the roof.</figcaption>\n</figure>\n";
  return "<div class=\"short\">\n" + section_heading(3) +
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
                   "above 0.05 s, six at most; the equation below is that of one mode, on which "
                   "the "
                   "ground and the array act by its participation. The array is a rigid mass on "
                   "its "
                   "roof with Coulomb friction; it slides in plan along both axes at once and acts "
                   "back on the building. The roof moves vertically with the ground."
                 : "The building is a linear oscillator along each of its two horizontal axes, "
                   "with "
                   "one period and damping ratio. The array is a rigid mass on its roof with "
                   "Coulomb friction; it slides in plan along both axes at once and acts back on "
                   "the building. The roof moves vertically with the ground.") +
         (of_roof ? Html() : bodies) + "</div>\n" +
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
             of_roof ? "roof" : "ground")) +
         list({"Walters, M., Berkowitz, R., Lau, D., Lee, W., Baker, J. (2012). Seismic "
               "considerations and evaluation approach for \"isolated\" rooftop PV arrays. SEAOC "
               "Convention Proceedings.",
               "Rodriguez-Nikl, T., et al. (2019). Predicted slip of ballasted solar arrays on "
               "angled roofs due to seismic motion.",
               "ASCE/SEI 7-16 (2017). Minimum design loads and associated criteria for buildings "
               "and other structures.",
               "SEAOC PV1-2012. Structural seismic requirements and commentary for rooftop solar "
               "photovoltaic arrays."});
}

Html required_html(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  std::vector<std::string> steps{fmt::format(
      "Analysis (Walters et al. 2012): {:g} x {} = {}.", design.factor,
      length_in_both(design.analysis_m / design.factor, 1), length_in_both(design.analysis_m, 1))};
  if (package.project.peer_reviewed) {
    steps.push_back(
        "The project states that the analysis is peer reviewed: no least value applies.");
  } else {
    steps.push_back(fmt::format(
        "Least value of an analysis by {}: {}{}.", standard_name(package.project.standard),
        length_in_both(design.floor_m),
        of_standard(package.project, design).may_be_used()
            ? ""
            : "; it is applied although conditions of the prescribed value are not met, which is "
              "on the safe side"));
  }
  steps.push_back(fmt::format("Governing displacement: the larger, {}; rounded up to {}.",
                              length_in_both(design.governing_m),
                              length_in_both(design.rounded_m)));
  return "<div class=\"short\">\n" + section_heading(5) + list(steps) + "</div>\n" +
         page_table(prescribed_table(package)) +
         page_table(conditions_table(facts_of(package.project, design.site)));
}

Html checks_html(const CalculationPackage& package) {
  return section_heading(8) + page_table(checks_table(package)) +
         page_table(roof_accelerations_table(package)) +
         paragraph(fmt::format(
             "The solver of glissade {} is verified against closed forms, solutions with 50 digits "
             "and both published papers; every comparison is in its verification manual "
             "(tests/verification/README.md of the program).",
             package.demand.program_version)) +
         list(
             {"The array is rigid and stays in contact with the roof: no tipping, no uplift.",
              "Friction is Coulomb's: it does not change with speed, temperature or wear.",
              package.project.of_roof
                  ? "The array does not act back on the roof, whose motions are those of the suite."
                  : "The building is elastic with one mode along each axis, without torsion.",
              std::string("The governing displacement is that of one earthquake. Displacements of "
                          "several earthquakes during the design life add up, and are not in it") +
                  (package.probability.hazard ? ": section 8." : "."),
              "The array does not strike anything and no cable restrains it.",
              "Statements marked (recalled) are from memory of the standard: verify them."});
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

Html records_html(const CalculationPackage& package) {
  Html html = section_heading(9) +
              paragraph(fmt::format(
                  "glissade {} ({}); plan of the demand study {}, of the probability "
                  "study {}; project file SHA-256 {}, suite file SHA-256 {}. The same files "
                  "and version give the same numbers.",
                  package.demand.program_version, package.build, package.demand.plan_hash,
                  package.probability.plan_hash, package.project_sha256, package.suite_sha256));
  if (!package.files.empty()) html += files_html(files_table(package));
  return html + "<h3 class=\"own-page\">Project file</h3>\n" +
         study_file(package.project.source_text);
}

}  // namespace

void write_package(const CalculationPackage& package, const std::filesystem::path& out_dir,
                   bool overwrite) {
  const LengthUnits units(package.project.units);
  std::vector<Table> tables{title_table(package.project),
                            inputs_table(package),
                            site_table(package),
                            motions_table(package),
                            files_table(package),
                            demand_table(package),
                            prescribed_table(package),
                            separations_table(package),
                            sensitivity_table(package),
                            conditions_table(facts_of(package.project, package.design.site)),
                            exceedance_table(package),
                            compared_table(package),
                            checks_table(package),
                            roof_accelerations_table(package)};
  for (Table& table : given_curves(package.project)) tables.push_back(std::move(table));
  const std::vector<DrawnFigure> figures = write_parts(
      {"package.html", std::move(tables), package_figures(package)}, out_dir, overwrite);
  const bool has_demand_figure = !package.project.of_roof && figures.size() > 2;
  const Html page =
      page_head({package.project.title.name, "calculation of required separations",
                 in_inches() ? letter : a4}) +
      "<style>" + style + "</style>\n" +
      paragraph(
          "Calculation of the seismic displacement of an unanchored rooftop solar array, and "
          "of its required separations") +
      page_table(title_table(package.project)) + warnings_html(package) + result_html(package) +
      contents_html(motions_title(package.project)) + section_heading(1) +
      "<div class=\"inputs\">\n" + page_table(inputs_table(package)) + "</div>\n" +
      given_curves_html(package.project) + motions_html(package, figures) +
      model_html(package.project.of_roof, !package.project.building.alpha.empty()) +
      section_heading(4) + page_table(demand_table(package)) +
      (has_demand_figure ? figure_html(figures.at(1), 2) : Html()) + required_html(package) +
      section_heading(6) + page_table(sensitivity_table(package)) + section_heading(7) +
      page_table(exceedance_table(package)) +
      (package.design.compared.size() > 1 ? page_table(compared_table(package)) : Html()) +
      figure_html(figures.back(), figures.size()) + hazard_html(package) + checks_html(package) +
      records_html(package) + page_foot();
  write_text_file(out_dir / "package.html", page.str());
}

}  // namespace glissade
