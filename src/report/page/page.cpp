// SPDX-License-Identifier: GPL-3.0-or-later
#include "page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/core/file.hpp"
#include "glissade/core/in_parallel.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/report/results_folder.hpp"
#include "package/print/workbook.hpp"

namespace glissade {
namespace {

constexpr Markup style = R"(
body { font: 16px/1.5 Arial, Helvetica, sans-serif; color: #222; max-width: 68em; margin: 2em auto; padding: 0 1em; overflow-wrap: anywhere; }
h1 { margin-bottom: 0; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }
.answer { background: #eef4fa; border-left: 4px solid #0072b2; padding: .6em 1em; }
.answer p { margin: .4em 0; }
.warning { background: #fff4e0; border-left: 4px solid #e69f00; padding: .4em 1em; }
figure { margin: 1.5em auto; max-width: 46em; } .drawing { overflow-x: auto; } .drawing svg { display: block; width: 100%; min-width: 34em; height: auto; }
figcaption, caption { color: #444; font-size: .9em; text-align: left; padding: .3em 0; }
.wide { overflow-x: auto; container-type: inline-size; }
caption div { position: sticky; left: 0; width: fit-content; max-width: 100cqw; }
table { border-collapse: collapse; font-size: .85em; margin: 1em 0; }
th, td { border-bottom: 1px solid #ddd; padding: .2em .6em; text-align: left; vertical-align: top; overflow-wrap: break-word; }
th { background: #f4f4f4; vertical-align: bottom; } .number { text-align: right; white-space: nowrap; }
td:not(.number) { min-width: 7em; }
.many table { font-size: .72em; } .many th, .many td { padding: .2em .35em; } .many td:not(.number) { min-width: 5em; }
dt { font-weight: bold; } dd { margin: 0 0 .5em 1.5em; }
pre { background: #f7f7f7; border: 1px solid #ddd; padding: .8em; white-space: pre-wrap; overflow-wrap: anywhere; font-size: .85em; }
@page { margin: 12mm 14mm 14mm; @bottom-right { content: "Page " counter(page) " of " counter(pages); font: 9pt Arial, sans-serif; } }
@page wide { size: landscape; }
@media print {
  .many, h2:has(+ .many), h3:has(+ .many) { page: wide; }
  body { max-width: none; margin: 0; padding: 0; font-size: 10pt; line-height: 1.35; } h2, h3 { break-after: avoid; } figcaption { break-before: avoid; }
  figure { max-width: none; margin: .3em auto; } .drawing svg { width: 16.7cm; min-width: 0; max-width: 100%; margin: 0 auto; } figure, tr, caption { break-inside: avoid; } caption, thead, tbody tr:first-child { break-after: avoid; } tbody tr:last-child { break-before: avoid; }
  .wide { overflow: visible; container-type: normal; } caption div { max-width: none; } pre { box-decoration-break: clone; -webkit-box-decoration-break: clone; margin-right: 1px; } table, .many table, pre, figcaption, caption { font-size: 9pt; } table { width: 100%; } thead { display: table-header-group; }
  th, td { padding: .15em .35em; } th.number, td.number { white-space: normal; }
  td:not(.number), .many td:not(.number) { min-width: 0; } .many th, .many td { padding: .15em .2em; } p, li { orphans: 3; widows: 3; }
}
)";

std::size_t longest_word(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string& word : wrapped(text, 1)) longest = std::max(longest, display_width(word));
  return longest;
}

}  // namespace

Html page_head(const PageTitle& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         enclosed("<title>", title.name + " - " + title.kind, "</title>\n<style>") + style +
         title.style + enclosed("</style>\n</head>\n<body>\n<h1>", title.name, "</h1>\n");
}

Html page_foot() { return Html("</body>\n</html>\n"); }

Html paragraph(const std::string& text) { return enclosed("<p>", text, "</p>\n"); }

Html given_text(const std::string& text) {
  return enclosed("<span class=\"given\">", text, "</span>");
}

Html heading(const std::string& text) { return enclosed("<h2>", text, "</h2>\n"); }

Html wide_table(const Table& table) {
  // Of 9 pt letters on an upright page; words are not broken.
  constexpr double page_mm = 187.0, letter_mm = 1.75, space_mm = 2.5;
  double width_mm = 0.0;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t letters = longest_word(table.columns[c].heading);
    for (const std::vector<Cell>& row : table.rows)
      letters = std::max(letters, longest_word(unbroken(cell_text(table.columns[c], row[c]))));
    width_mm += space_mm + letter_mm * static_cast<double>(letters);
  }
  return (width_mm > page_mm ? Html("<div class=\"wide many\">") : Html("<div class=\"wide\">")) +
         to_html(table) + "</div>\n";
}

Html table_or_file(const Table& table) {
  constexpr std::size_t most_rows = 60;
  if (table.rows.size() <= most_rows) return wide_table(table);
  return paragraph(fmt::format("{}: {} rows in tables/{}.csv.", table.title, table.rows.size(),
                               table.name.text()));
}

Html list(const std::vector<std::string>& items) {
  Html html("<ul>\n");
  for (const std::string& item : items) html += enclosed("<li>", item, "</li>\n");
  return html + "</ul>\n";
}

Html study_file(const std::string& text) { return enclosed("<pre>", text, "</pre>\n"); }

Html in_box(const Html& drawing) { return "<div class=\"drawing\">" + drawing + "</div>\n"; }

Html figure_html(const DrawnFigure& drawn, std::size_t number) {
  const Figure& figure = drawn.figure;
  return enclosed("<figure id=\"figure_", figure.name.text(), "\">\n") +
         in_box(Html::drawing(drawn.svg, figure.title)) +
         enclosed("<figcaption><strong>", fmt::format("Figure {}. {}.", number, figure.title),
                  "</strong> ") +
         enclosed("", figure.caption, "</figcaption>\n</figure>\n");
}

Html figures_html(const std::vector<DrawnFigure>& figures) {
  Html html;
  for (std::size_t i = 0; i < figures.size(); ++i) html += figure_html(figures[i], i + 1);
  return html;
}

void write_parts(ReportParts parts, const std::filesystem::path& out_dir,
                 const std::function<void(std::vector<DrawnFigure>)>& write_page) {
  parts.tables.push_back(columns_table(parts.tables));
  std::vector<std::string> names;
  if (!parts.page.empty()) names.push_back(parts.page);
  const bool has_workbook = makes_workbooks && !parts.workbook.empty();
  if (has_workbook) names.push_back(parts.workbook);
  for (const Table& table : parts.tables) names.push_back("tables/" + (table.name + ".csv"));
  for (const Figure& figure : parts.figures)
    for (const char* ending : {".dat", ".gp", ".svg", ".pdf"})
      names.push_back("figures/" + (figure.name + ending));
  begin_files(out_dir, names);
  for (const Table& table : parts.tables)
    write_text_file(out_dir / "tables" / (table.name + ".csv"), to_csv(table));
  if (has_workbook) write_workbook(parts.tables, out_dir / parts.workbook);
  std::vector<DrawnFigure> drawn(parts.figures.size());
  in_parallel(drawn.size(), [&](std::size_t i) {
    Figure& figure = parts.figures[i];
    render_figure(figure, out_dir / "figures");
    std::string svg = read_text_file(out_dir / "figures" / (figure.name + ".svg"));
    drawn[i] = {std::move(figure), std::move(svg)};
  });
  write_page(std::move(drawn));
  end_report(out_dir, names);
}

}  // namespace glissade
