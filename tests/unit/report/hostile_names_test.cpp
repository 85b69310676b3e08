// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/html_text.hpp"
#include "glissade/report/write_report.hpp"
#include "made_up_results.hpp"

// Names from a results file must stay text wherever they go: in a script of gnuplot, which can run
// commands, and in a page, which can run scripts.
namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> hostile = {"`touch pwned`",
                                          "'; system('touch pwned'); '",
                                          "\'\'\'",
                                          "\"; system(\"touch pwned\"); \"",
                                          "a\nsystem('touch pwned')\n",
                                          "a\r!touch pwned\r",
                                          "$(touch pwned)",
                                          "\\",
                                          "@touch {/:Bold x} ^2 _3 ~a{b}",
                                          "<script>alert(1)</script>",
                                          "../../pwned"};

TEST(html_text, leaves_nothing_that_acts_as_markup) {
  EXPECT_EQ(Html::text("a<b> & \"c\" 'd'").str(), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  EXPECT_EQ(enclosed("<p>", "<i>", "</p>").str(), "<p>&lt;i&gt;</p>");
}

TEST(hostile_names, of_runs_do_not_become_names_of_files) {
  for (const std::string& name : hostile) {
    Results results = made_up_results();
    results.runs[1].label = name;
    EXPECT_THROW(fragility_figure(results, results.runs[1]), InputError) << name;
  }
}

TEST(hostile_names, are_text_in_scripts_and_pages) {
  const fs::path folder = fs::path(testing::TempDir()) / "glissade_report_hostile";
  std::string all;
  for (const std::string& name : hostile) all += name;
  for (const std::string& name : {all, "'" + all}) {
    fs::remove_all(folder);
    Results results = made_up_results();
    results.study_name = results.suite_name = results.suite_description = name;
    results.intensity_label = name + " (g)";
    results.runs[0].label = name;  // the main run's figures are not named by it
    results.runs.resize(1);
    results.runs[0].friction_description = name;
    for (RecordSummary& record : results.records) record.id = record.event = name;
    write_report(results, folder);
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("pwned"))) << name;
    EXPECT_FALSE(fs::exists(folder.parent_path() / "pwned"));
    EXPECT_THAT(read_text_file(folder / "report.html"), Not(HasSubstr("<script"))) << name;
    for (const char* drawing : {"figures/ida.svg", "figures/spectra.svg"})
      EXPECT_THAT(read_text_file(folder / drawing), Not(HasSubstr("<script"))) << name;
  }
}

}  // namespace
}  // namespace glissade
