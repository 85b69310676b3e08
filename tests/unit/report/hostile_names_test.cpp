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
#include "page/symbols.hpp"
#include "plot/script.hpp"

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

// What may be part of a script, by type.
static_assert(!gnuplot::Scriptable<std::string>);
static_assert(!gnuplot::Scriptable<std::string_view>);
static_assert(gnuplot::Scriptable<gnuplot::Quoted> && gnuplot::Scriptable<FileName>);

TEST(gnuplot_script, quotes_what_could_end_or_act_in_a_string) {
  using gnuplot::Quoted;
  EXPECT_EQ(Quoted("it's").str(), "'it\u2019s'");
  EXPECT_EQ(Quoted("S_D1 1 g, S_S, S_1x").str(), "'S_{/*1.15 D1}\u00a01 g, S_{/*1.15 S}, S\\_1x'");
  EXPECT_EQ(Quoted("a\nb\rc\td").str(), "'a b c d'");
  EXPECT_EQ(Quoted("{x}_1^2@&~\\").str(), "'\\{x\\}\\_1\\^2\\@\\&\\~\\\\'");
  EXPECT_EQ(Quoted("over \u03b1_0, b_0").str(), "'over \u03b1_{/*1.15 0}, b\\_0'");
  EXPECT_EQ(Quoted("S_DS (g)").str(), "'S_{/*1.15 DS}\u00a0(g)'");
  EXPECT_EQ(Quoted("b", Quoted::Weight::bold).str(), "'{/:Bold b}'");
  EXPECT_EQ(Quoted("DS_1").str(), "'DS\\_1'");  // a word
  const UserTexts texts({"at S_1"});
  EXPECT_EQ(Quoted("S_1 S_S").str(), "'S\\_1 S_{/*1.15 S}'");
}

TEST(gnuplot_script, has_no_line_that_a_name_began) {
  std::string all;
  for (const std::string& name : hostile) all += name;
  for (const std::string& name : {all, "'" + all}) {
    Figure figure{"figure", name, name, name};
    Panel panel{name, {name}, {name}};
    panel.series = {{DataSeries::Kind::line, look(Role::mean), name, name, {0.0, 1.0}, {0.0, 1.0}}};
    panel.rules = {{Rule::Kind::vertical, 0.5, look(Role::mean), name}};
    panel.notes = {{0.5, 0.5, name, {}}};
    figure.panels = {panel, panel};
    const std::string script = gnuplot::script_of(figure);
    EXPECT_THAT(script, Not(HasSubstr("\nsystem"))) << name;
    EXPECT_THAT(script, Not(HasSubstr("\r"))) << name;
    const fs::path folder = fs::path(testing::TempDir()) / "glissade_report_hostile_script";
    fs::remove_all(folder);
    render_figure(figure, folder);
    EXPECT_FALSE(fs::exists(folder / "pwned")) << name;
    EXPECT_THAT(read_text_file(folder / "figure.svg"), Not(HasSubstr("<script"))) << name;
  }
}

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
    results.study_name = results.suites[0].name = results.suites[0].description = name;
    results.intensity_label = results.intensity_symbol = name;
    results.runs[0].label = name;  // the main run's figures are not named by it
    results.runs.resize(1);
    results.runs[0].friction = name;
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
