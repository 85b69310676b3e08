// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/report/html.hpp"
#include "glissade/report/html_text.hpp"
#include "glissade/report/table.hpp"

// The pieces reports are made of. Text is escaped here: callers pass it as people read it.
namespace glissade {

struct PageTitle {
  std::string name;  ///< heading of the page
  std::string kind;  ///< after it in the browser's title: "slip fragility"
  Markup style{""};  ///< in addition to that of every page
};

/// All up to and with the <h1>, styles inline.
Html page_head(const PageTitle& title);
Html page_foot();

Html paragraph(const std::string& text);
/// A description of the user, in which no symbols are set.
Html given_text(const std::string& text);
Html heading(const std::string& text);
Html list(const std::vector<std::string>& items);
/// As it was given, line by line.
Html study_file(const std::string& text);
/// Scrolls sideways where it is wider than the page.
Html wide_table(const Table& table);
/// The table; where it is long, that it is a file.
Html table_or_file(const Table& table);
struct ReportParts {
  std::string page;  ///< its file; empty: none
  std::vector<Table> tables;
  std::vector<Figure> figures;
  std::string workbook = "";  ///< the file of all tables; empty: none
};
/// In the place of an earlier report (results_folder.hpp): writes out_dir/tables/NAME.csv of each
/// table and of their columns, and the workbook, draws into out_dir/figures, and has the page
/// written.
void write_parts(ReportParts parts, const std::filesystem::path& out_dir,
                 const std::function<void(std::vector<DrawnFigure>)>& write_page);
/// Drawings in order, each with its number, title and caption.
Html figures_html(const std::vector<DrawnFigure>& figures);
/// Scrolls sideways where the screen is too narrow for its letters.
Html in_box(const Html& drawing);
/// The drawing inline with its number, title and caption.
Html figure_html(const DrawnFigure& drawn, std::size_t number);

}  // namespace glissade
