// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <variant>

#include "package/print/print_head.hpp"
#include "package/sections.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"

namespace glissade {

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
                  ? "The building is elastic with one mode along each axis, without torsion; its "
                    "roof diaphragm is rigid."
                  : "The building is elastic, with several modes along each axis, without torsion; "
                    "its roof diaphragm is rigid.",
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

namespace {

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

}  // namespace

Html inputs_html(const CalculationPackage& package) {
  Html html = section_heading(Section::inputs) +
              paragraph(fmt::format(
                  "glissade {} ({}); plan of the demand study {}, of the probability "
                  "study {}; project file SHA-256 {}, suite file SHA-256 {}. The same files "
                  "and version give the same numbers.",
                  package.demand.program_version, package.build, package.demand.plan_hash,
                  package.probability.plan_hash, package.project_sha256, package.suite_sha256));
  if (!package.project.simulated_motions) html += files_html(files_table(package));
  return html + "<h3>Project file, without its comments</h3>\n" +
         study_file(package.project.source_text);
}

}  // namespace glissade
