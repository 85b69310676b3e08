// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/html_text.hpp"

#include <algorithm>

namespace glissade {

Html Html::text(std::string_view plain) {
  Html html;
  html.page_.reserve(plain.size());
  for (const char c : plain) {
    const char* entity = c == '&'    ? "&amp;"
                         : c == '<'  ? "&lt;"
                         : c == '>'  ? "&gt;"
                         : c == '"'  ? "&quot;"
                         : c == '\'' ? "&#39;"
                                     : nullptr;
    entity ? html.page_ += entity : html.page_ += c;
  }
  return html;
}

Html Html::drawing(const std::string& svg, std::string_view label) {
  Html html;
  html.page_ = svg.substr(std::min(svg.find("<svg"), svg.size()));
  // Its own title, which browsers show over all of the drawing.
  const std::string_view begin = "<title>", end = "</title>", description = "<desc id=\"";
  const std::size_t first_group = html.page_.find("<g ");
  if (const std::size_t at = html.page_.find(begin); at < first_group)
    html.page_.erase(at, html.page_.find(end, at) + end.size() - at);
  std::string attributes = " role=\"img\" aria-label=\"" + text(label).page_ + "\"";
  if (const std::size_t at = html.page_.find(description); at < html.page_.find("<g ")) {
    const std::size_t id = at + description.size();
    attributes +=
        " aria-describedby=\"" + html.page_.substr(id, html.page_.find('"', id) - id) + "\"";
  }
  if (html.page_.starts_with("<svg")) html.page_.insert(4, attributes);
  return html;
}

Html enclosed(Markup before, std::string_view text, Markup after) {
  return Html(before) + Html::text(text) + Html(after);
}

}  // namespace glissade
