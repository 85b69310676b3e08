// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/html.hpp"
#include "glissade/report/table.hpp"

// The pieces reports are made of. Text is escaped here: callers pass it as people read it.
namespace glissade {

struct PageTitle {
  std::string name;  ///< heading of the page
  std::string kind;  ///< after it in the browser's title: "slip fragility"
};

/// All up to and with the <h1>, styles inline.
std::string page_head(const PageTitle& title);
std::string page_foot();

std::string paragraph(const std::string& text);
std::string heading(const std::string& text);
std::string list(const std::vector<std::string>& items);
/// Scrolls sideways where it is wider than the page.
std::string wide_table(const Table& table);
/// The drawing inline with its number, title and caption.
std::string figure_html(const DrawnFigure& drawn, std::size_t number);

}  // namespace glissade
