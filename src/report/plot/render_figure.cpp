// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>

#include "glissade/core/file.hpp"
#include "glissade/report/figure.hpp"
#include "plot/labels.hpp"
#include "plot/script.hpp"

namespace glissade {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

/// Cairo writes the time of day as (D:YYYYMMDDhhmmssZ) and heeds no SOURCE_DATE_EPOCH; the digits
/// are set to 1970 in place, so that no offset in the file moves.
void remove_creation_date(std::string& pdf) {
  const std::string key = "/CreationDate (D:";
  const std::size_t at = pdf.find(key);
  if (at == std::string::npos) return;
  static constexpr std::string_view epoch = "19700101000000";
  for (std::size_t i = 0; i < epoch.size(); ++i) {
    char& digit = pdf[at + key.size() + i];
    if (std::isdigit(static_cast<unsigned char>(digit))) digit = epoch[i];
  }
}

}  // namespace

void render_figure(const Figure& figure, const std::filesystem::path& folder) {
  write_text_file(folder / (figure.name + ".dat"), gnuplot::data_of(figure));
  write_text_file(folder / (figure.name + ".gp"), gnuplot::script_of(figure));
  gnuplot::Drawn drawn = gnuplot::draw(figure, folder);

  // Names unique to the figure, so that one page can contain several drawings.
  replace_all(drawn.svg, "id='gp", "id='" + figure.name.text() + "_gp");
  replace_all(drawn.svg, "'#gp", "'#" + figure.name.text() + "_gp");
  replace_all(drawn.svg, "id=\"gnuplot_canvas\"", "id=\"" + figure.name.text() + "_canvas\"");
  write_text_file(folder / (figure.name + ".svg"), with_tooltips(drawn.svg, figure));

  remove_creation_date(drawn.pdf);
  write_text_file(folder / (figure.name + ".pdf"), drawn.pdf);
}

}  // namespace glissade
