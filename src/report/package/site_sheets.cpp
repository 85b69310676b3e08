// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/site_sheets.hpp"

#include <algorithm>

#include "glissade/core/wrap.hpp"
#include "package/print/pdf.hpp"
#include "package/print/print_head.hpp"
#include "package/units.hpp"
#include "page/symbols.hpp"

namespace glissade {
namespace {

constexpr Markup site_pages =
    "<style>\n.site { break-before: page; break-inside: avoid; }\n</style>\n";

Table sites_table(const SiteSheets& sheets) {
  const LengthUnits units(sheets.units);
  Table table{
      "sites",
      "Sites: governing displacement, largest required separation, verdict",
      {text_column("site", "Site"), text_column("sds", "S_DS"), text_column("sd1", "S_D1"),
       text_column("friction", "Friction"), text_column("governing", "Governing displacement"),
       text_column("required", "Largest required separation"), text_column("verdict", "Verdict"),
       text_column("folder", "Package")},
      {},
      {"Friction: mean - 2 std. Verdict: on the available separations that are stated; open: see "
       "the page of the site."}};
  for (const SiteSheet& site : sheets.sites)
    table.add({site.name, fixed(site.sds_g, 3, "g"), fixed(site.sd1_g, 3, "g"),
               fixed(site.friction, 3), length_cell(site.governing_m),
               length_cell(site.largest_required_m), site.verdict, site.folder});
  return table;
}

}  // namespace

std::string sites_screen(const SiteSheets& sheets) {
  std::string folders;
  for (const SiteSheet& site : sheets.sites)
    folders += (folders.empty() ? "Packages, in this order: " : ", ") + site.folder;
  return wrapped(sheets.name, terminal_width, 0) + "\n" +
         to_text(sites_table(sheets).without("folder")) + wrapped(folders, terminal_width, 2) +
         "\n";
}

bool write_site_sheets(const SiteSheets& sheets, const std::filesystem::path& out_dir) {
  std::vector<std::string> names{sheets.name};
  for (const SiteSheet& site : sheets.sites)
    names.insert(names.end(), site.user_texts.begin(), site.user_texts.end());
  const UserTexts texts(names);
  const Table table = sites_table(sheets);
  const bool is_simulated = std::ranges::any_of(sheets.sites, &SiteSheet::is_simulated);
  Html page = print_head({sheets.name, "required separations by site",
                          sheets.units == UnitSystem::us_customary ? letter : a4},
                         {.name = sheets.name, .is_simulated = is_simulated}) +
              site_pages +
              paragraph(
                  "Seismic displacement of unanchored rooftop solar arrays, and their "
                  "required separations, by site") +
              wide_table(table);
  for (const SiteSheet& site : sheets.sites) page += site.page;
  bool is_printed = false;
  write_parts({"sites.html", {table}, {}, "sites.xlsx"}, out_dir,
              [&](auto) { is_printed = write_and_print(page, out_dir / "sites.html"); });
  return is_printed;
}

}  // namespace glissade
