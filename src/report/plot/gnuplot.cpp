// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/error.hpp"
#include "plot/child_program.hpp"
#include "plot/script.hpp"

namespace glissade::gnuplot {
namespace {

[[noreturn]] void throw_failed(const std::filesystem::path& script, const std::string& why) {
  throw InputError({script.string(), "gnuplot could not draw this figure: " + why,
                    "see whether `gnuplot " + script.filename().string() +
                        "` works there, and whether there is "
                        "memory",
                    ""});
}

/// What was drawn, to its last word.
std::string drawn_in(const MemoryFile& file, const std::filesystem::path& script,
                     const std::string& last_word) {
  std::string text = file.read();
  const std::size_t at = text.rfind(last_word);
  if (at == std::string::npos || text.size() - at > last_word.size() + 2)
    throw_failed(script, "what it drew is incomplete");
  return text;
}

}  // namespace

Drawn draw(const Figure& figure, const std::filesystem::path& folder) {
  const std::filesystem::path shown = folder / (figure.name + ".gp");
  const MemoryFile svg(shown), pdf(shown);
  MemoryFile script(shown);
  script.write(script_of(figure, {svg.descriptor(), pdf.descriptor()}));
  const std::optional<std::string> failure = ChildProgram{
      .words = {"gnuplot", "--default-settings", script.name()},
      .folder = folder,
      .files = {&svg, &pdf, &script}}.failure();
  if (!failure) {
    throw InputError({"gnuplot", "the program is not found, and the figures are drawn with it",
                      "install it (Debian: apt install gnuplot-nox) or add its folder to PATH; "
                      "then make the report from the results file",
                      ""});
  }
  if (!failure->empty()) throw_failed(shown, *failure);
  return {drawn_in(svg, shown, "</svg>"), drawn_in(pdf, shown, "%%EOF")};
}

}  // namespace glissade::gnuplot
