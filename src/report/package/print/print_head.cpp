// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/print/print_head.hpp"

namespace glissade {
namespace {

constexpr Markup style = R"(
@page { margin: 18mm 16mm 17mm; @bottom-left { content: element(footer); font: 8pt "Liberation Sans", Arial, sans-serif; } @bottom-right { content: "Page " counter(page) " of " counter(pages); font: 8pt "Liberation Sans", Arial, sans-serif; } }
body { font-family: "Liberation Sans", Arial, Helvetica, sans-serif; }
.footer { position: running(footer); margin: 0; font: 8pt "Liberation Sans", Arial, sans-serif; } @media screen { .footer { display: none; } }
h2 { break-after: avoid; } sub, sup { font-size: .72em; line-height: 0; }
.contents { columns: 2; list-style: none; padding: 0; } .contents a { color: inherit; text-decoration: none; }
.equation { font-family: "Liberation Serif", "Times New Roman", serif; font-size: 1.1em; margin: .3em 0 .3em 2em; }
caption { font-weight: bold; color: #222; } .note { font-weight: normal; }
.title { display: flex; } .title > div:first-child { flex: 3; } .stamp { flex: 1.2; border: 1px solid #444; margin: 1em 0 1em 1.5em; padding: .4em; min-height: 11em; color: #555; font-size: .85em; }
.plain caption, .answer caption, .title caption, .title th, .form th { display: none; } .form td { height: 1.9em; }
.answer table { background: #fff; } .provisions td:first-child { white-space: nowrap; }
.inputs td:nth-child(2) { width: 32%; } .files td:last-child { font-family: monospace; overflow-wrap: anywhere; }
@media print {
  .short, li { break-inside: avoid; } h1 { font-size: 1.5em; margin-top: 0; } .answer ul, .warning ul { margin: .3em 0; padding-left: 1.4em; }
  h2 { margin: 1em 0 .4em; font-size: 1.25em; } .contents a::after { content: " " leader(".") " " target-counter(attr(href), page); }
  figure { max-width: 16.5cm; } .drawing svg { width: 13.2cm; } .files td:last-child { white-space: nowrap; } .files td, .inputs td:last-child { overflow-wrap: anywhere; }
  pre { columns: 2; } table { margin: .5em 0; } p { margin: .5em 0; } .title table { margin: .6em 0; }
}
)";

}  // namespace

Html print_head(const PageTitle& title, const Footer& footer) {
  const auto [name, revision, date, is_simulated] = footer;
  return page_head(title) + "<style>" + style + "</style>\n" +
         enclosed("<p class=\"footer\">",
                  name + (revision.empty() ? "" : ", revision " + revision) +
                      (date.empty() ? "" : ", " + date) +
                      (is_simulated ? ". SIMULATED MOTIONS: NOT FOR A PERMIT" : ""),
                  "</p>\n");
}

Html warnings_box(const std::vector<std::string>& warnings) {
  return warnings.empty()
             ? Html()
             : "<div class=\"warning\">\n<strong>Warnings</strong>\n" + list(warnings) + "</div>\n";
}

}  // namespace glissade
