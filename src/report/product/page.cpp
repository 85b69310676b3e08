// SPDX-License-Identifier: GPL-3.0-or-later
#include "page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/chart/view.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/report/format.hpp"
#include "package/print/pdf.hpp"
#include "package/print/print_head.hpp"
#include "package/tables.hpp"
#include "page/symbols.hpp"
#include "product/tables.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// Each once.
std::vector<std::string> warnings_of(const ProductSheet& sheet) {
  std::vector<std::string> warnings;
  const auto add = [&](const std::string& warning) {
    if (std::ranges::find(warnings, capitalised(warning)) == warnings.end())
      warnings.push_back(capitalised(warning));
  };
  if (sheet.is_simulated) add(simulated_motions_warning);
  if (sheet.targets.front().found.of_largest)
    add("fewer than 7 records: the largest counts in place of the mean");
  for (const SheetTarget& of : sheet.targets) std::ranges::for_each(of.warnings, add);
  std::string without_vertical;
  for (const RecordSummary& record : sheet.targets.front().records)
    if (!record.has_vertical)
      without_vertical += (without_vertical.empty() ? "" : ", ") + record.id;
  if (!without_vertical.empty()) add("records without vertical motion: " + without_vertical);
  return warnings;
}

std::vector<Table> shown_tables(const ProductSheet& sheet) {
  std::vector<Table> tables{design_displacements_table(sheet)};
  if (sheet.targets.front().target.hazard) tables.push_back(life_displacements_table(sheet));
  tables.push_back(prescribed_displacements_table(sheet));
  if (sheet.targets.front().found.period_s.size() > 1)
    tables.push_back(displacements_by_period_table(sheet));
  return tables;
}

std::vector<std::string> basis_of(const ProductSheet& sheet) {
  const SheetTarget& first = sheet.targets.front();
  std::vector<std::string> basis{
      "Motions: " + first.suite +
          ". For each site the suite is multiplied by one factor, so that its average SRSS "
          "spectrum is the design spectrum of S_DS and S_D1 or more (Walters et al. 2012).",
      first.counted, "Model: " + first.kernel + "."};
  basis.emplace_back(
      "Separations are the displacement times 0.5 between similar arrays, 1 to an obstruction or "
      "an edge with a qualifying parapet, 2 to any other edge (ASCE 7-16, 13.6.12; there 4 ft or "
      "more).");
  return basis;
}

}  // namespace

SheetTarget sheet_target(const Product& product, const ProductTarget& target,
                         const Results& results) {
  const SuiteSummary& suite = results.suites.front();
  return {target,
          displacements_of(product, target, results),
          how_counted(results),
          suite.name + (suite.description.empty() ? "" : ": " + suite.description),
          results.model.kernel,
          results.plan_hash,
          texts_of(results.warnings),
          results.records};
}

std::string sheet_screen(const ProductSheet& sheet) {
  std::string text = wrapped(sheet.product.name, terminal_width, 0) + "\n" +
                     wrapped(largest_sentence(sheet), terminal_width, 2) + "\n\n" +
                     to_text(design_displacements_table(sheet)) + "\n" +
                     to_text(prescribed_displacements_table(sheet)) + "\n";
  for (const std::string& warning : warnings_of(sheet))
    text += wrapped("WARNING: " + warning, terminal_width, 2) + "\n";
  return text;
}

bool write_product_sheet(const ProductSheet& sheet, const std::filesystem::path& out_dir) {
  const Product& product = sheet.product;
  std::vector<std::string> names{product.name, product.manufacturer, product.revision,
                                 product.date};
  for (const SheetTarget& of : sheet.targets) {
    names.push_back(of.suite);
    for (const RecordSummary& r : of.records) names.insert(names.end(), {r.id, r.event, r.station});
  }
  const UserTexts texts(names);
  std::vector<Table> tables = shown_tables(sheet);
  Html shown;
  for (const Table& table : tables) shown += wide_table(table);
  tables.push_back(all_displacements_table(sheet));
  const Table motions = motions_table(sheet.targets.front().records, {}, /*of_roof=*/false);
  tables.push_back(motions);
  std::string plans;
  for (const SheetTarget& of : sheet.targets) plans += (plans.empty() ? "" : ", ") + of.plan_hash;
  const Html page =
      print_head(
          {product.name, "design displacements", product.unit == SheetUnit::metre ? a4 : letter},
          {product.name, product.revision, product.date, sheet.is_simulated}) +
      paragraph("Design displacement of an unanchored rooftop solar array in an earthquake" +
                (product.manufacturer.empty() ? "" : ". Manufacturer: " + product.manufacturer)) +
      "<div class=\"answer\">\n" + list({largest_sentence(sheet)}) + "</div>\n" +
      warnings_box(warnings_of(sheet)) + shown + heading("What the displacements rest on") +
      list(basis_of(sheet)) + wide_table(motions) + heading("Program and input files") +
      paragraph(fmt::format(
          "glissade {} ({}); plans of the studies {}; product file SHA-256 {}, suite file SHA-256 "
          "{}. The same files and version give the same numbers. All digits are in "
          "tables/displacements.csv.",
          sheet.program_version, sheet.build, plans, sheet.product_sha256, sheet.suite_sha256)) +
      "<h3>Product file, without its comments</h3>\n" + study_file(product.source_text);
  bool is_printed = false;
  write_parts({"product.html", std::move(tables), {}, "product.xlsx"}, out_dir,
              [&](auto) { is_printed = write_and_print(page, out_dir / "product.html"); });
  return is_printed;
}

}  // namespace glissade
