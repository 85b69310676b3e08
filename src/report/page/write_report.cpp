// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/write_report.hpp"

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/tables.hpp"
#include "page/page.hpp"

namespace glissade {

void write_report(const Results& results, const std::filesystem::path& out_dir,
                  const std::vector<Skip>& skips) {
  for (const char* folder : {"tables", "figures"}) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(out_dir / folder, ignored))
      throw InputError({(out_dir / folder).string(),
                        "is a file, and the report writes a folder here",
                        "move it, or name another folder", ""});
  }
  const LengthUnits units(results.units);
  write_tables(csv_tables(results), out_dir);
  const std::vector<DrawnFigure> figures = draw(make_figures(results), out_dir);
  write_text_file(out_dir / "report.html", html_report(results, figures, skips));
}

}  // namespace glissade
