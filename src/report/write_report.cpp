// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/write_report.hpp"

#include "glissade/core/file.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/tables.hpp"

namespace glissade {

void write_report(const Results& results, const std::filesystem::path& out_dir,
                  const std::vector<Skip>& skips) {
  for (const Table& table : csv_tables(results)) {
    write_text_file(out_dir / "tables" / (table.name + ".csv"), to_csv(table));
  }
  const std::filesystem::path figures_dir = out_dir / "figures";
  std::vector<DrawnFigure> drawn;
  for (Figure& figure : make_figures(results)) {
    render_figure(figure, figures_dir);
    std::string svg = read_text_file(figures_dir / (figure.name + ".svg"));
    drawn.push_back({std::move(figure), std::move(svg)});
  }
  write_text_file(out_dir / "report.html", html_report(results, drawn, skips));
}

}  // namespace glissade
