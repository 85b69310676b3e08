// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/write_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

TEST(write_report, leaves_a_page_tables_and_figures_and_no_partial_files) {
  const fs::path folder = fs::path(testing::TempDir()) / "glissade_report_whole";
  fs::remove_all(folder);
  write_report(made_up_results(), folder);
  for (const char* table :
       {"fragility", "slip", "standards", "stripes", "records", "spectra", "samples"}) {
    EXPECT_TRUE(fs::exists(folder / "tables" / (std::string(table) + ".csv"))) << table;
  }
  const std::string html = read_text_file(folder / "report.html");
  for (const char* figure : {"fragility", "fragility_design", "slip_vs_sds", "ida", "spectra"}) {
    EXPECT_TRUE(fs::exists(folder / "figures" / (std::string(figure) + ".pdf"))) << figure;
    EXPECT_THAT(html, testing::HasSubstr("id=\"figure_" + std::string(figure) + "\""));
  }
  // Only definitions, which have an id, refer to others: WeasyPrint does not print another <use>.
  for (std::size_t at = html.find("<use "); at != std::string::npos;
       at = html.find("<use ", at + 1))
    EXPECT_LT(html.find(" id=", at), html.find('>', at));
  // "S_DS (g)" below the axis, of three parts, begins left of its centre.
  EXPECT_NE(html.find("text-anchor=\"start\">\n\t\t<text x=\"-"), std::string::npos);
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    EXPECT_THAT(entry.path().string(), testing::Not(testing::HasSubstr(".partial")));
  }
}

TEST(write_report, throws_an_input_error_where_it_cannot_write) {
  EXPECT_THROW(write_report(made_up_results(), "/dev/null/report"), InputError);
}

}  // namespace
}  // namespace glissade
