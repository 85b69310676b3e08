// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/write_report.hpp"

#include "glissade/core/file.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/tables.hpp"
#include "package/print/printable.hpp"
#include "page/page.hpp"
#include "page/symbols.hpp"

namespace glissade {

void write_report(const Results& results, const std::filesystem::path& out_dir,
                  const std::vector<Skip>& skips) {
  const LengthUnits units(results.units);
  const UserTexts texts(user_texts(results));
  write_parts({"report.html", csv_tables(results), make_figures(results)}, out_dir,
              [&](std::vector<DrawnFigure> figures) {
                for (DrawnFigure& drawn : figures) drawn.svg = printable(drawn.svg);
                write_text_file(out_dir / "report.html", html_report(results, figures, skips));
              });
}

}  // namespace glissade
