// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/print/pdf.hpp"

#include <cstdlib>
#include <optional>
#include <string>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/report/results_folder.hpp"
#include "page/page.hpp"
#include "page/symbols.hpp"
#include "plot/child_program.hpp"

namespace glissade {
namespace {

/// Its last table is where its end says, behind which nothing follows.
bool is_whole_pdf(const std::string& pdf) {
  const std::size_t at = pdf.rfind("startxref\n");
  if (!pdf.starts_with("%PDF-") || !pdf.ends_with("%%EOF\n") || at == std::string::npos)
    return false;
  const std::size_t table = std::strtoull(pdf.c_str() + at + 10, nullptr, 10);
  return table < at && pdf.find_first_of("x0123456789", table) == table;  // xref, or an object
}

}  // namespace

bool write_and_print(const Html& page, const std::filesystem::path& html) {
  const std::string text = with_symbols((page + page_foot()).str());
  write_text_file(html, text);
  std::filesystem::path pdf = html;
  pdf.replace_extension(".pdf");
  MemoryFile in(pdf);
  const MemoryFile out(pdf);
  in.write(text);
  // Without a date in the fonts the same page gives the same bytes.
  std::optional<std::string> failure =
      ChildProgram{.words = {"weasyprint", "--quiet", "--pdf-variant", "pdf/ua-1", "-", "-"},
                   .variable = "SOURCE_DATE_EPOCH=0",
                   .files = {&in, &out},
                   .input = in.name(),
                   .output = out.name()}
          .failure();
  if (!failure) return false;
  std::string printed = failure->empty() ? out.read() : "";
  if (failure->empty() && !is_whole_pdf(printed)) failure = "what it printed is incomplete";
  if (!failure->empty())
    throw InputError({pdf.string(),
                      "WeasyPrint could not print " + html.filename().string() + ": " + *failure,
                      "see whether `weasyprint " + html.filename().string() +
                          " x.pdf` works there, and whether there is memory",
                      ""});
  begin_files(pdf.parent_path(), {pdf.filename().string()});
  write_text_file(pdf, printed);
  return true;
}

}  // namespace glissade
