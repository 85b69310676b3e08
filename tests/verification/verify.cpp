// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the verification manual. See the head of the page it writes.

#include <fmt/format.h>

#include <exception>
#include <iostream>

#include "chapters.hpp"
#include "glissade/core/file.hpp"
#include "page.hpp"

namespace {

using namespace glissade;
using namespace glissade::verification;

bool report_failures(const std::vector<Chapter>& chapters) {
  bool good = true;
  for (const Chapter& chapter : chapters)
    for (const auto& c : chapter.cases)
      if (!c.pass) {
        good = false;
        std::cerr << fmt::format("FAILS: {}: {}, {}: {} (tolerance {})\n", chapter.title, c.name,
                                 c.quantity, c.result, c.tolerance);
      }
  return good;
}

bool same_as_committed(const std::filesystem::path& committed, const std::string& made) {
  const std::string difference =
      first_difference(comparable(read_text_file(committed)), comparable(made));
  if (!difference.empty())
    std::cerr << "the committed page is not the one this code makes; make it again\n"
              << difference << '\n';
  return difference.empty();
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty() || arguments.size() > 2) {
    std::cerr
        << "usage: verify FOLDER [COMMITTED_PAGE]   writes FOLDER/README.md and FOLDER/figures\n";
    return 2;
  }
  const std::filesystem::path folder = arguments[0];
  const Folders folders{.suites = GLISSADE_SOURCE_DIR "/suites",
                        .studies = GLISSADE_SOURCE_DIR "/studies",
                        .simulation = GLISSADE_SIMULATED_SPECTRA,
                        .figures = folder / "figures"};
  std::filesystem::create_directories(folders.figures);
  std::vector<Chapter> chapters = {sliding_block(folders),
                                   published_scheme(folders),
                                   closed_form_solutions(),
                                   table_kernel(folders),
                                   buildings(folders),
                                   fragility(),
                                   interval_coverage(),
                                   sampling(),
                                   standards(),
                                   simulated_motions(folders),
                                   end_to_end(folders),
                                   first_paper_checks(folders),
                                   first_paper_link(folders),
                                   first_paper_convergence(folders),
                                   first_paper_parametric_study(folders),
                                   first_paper_charts(folders),
                                   second_paper_coupled(),
                                   second_paper_yielding(),
                                   second_paper_two_axes(folders),
                                   second_paper_friction(),
                                   second_paper_crossings(folders),
                                   second_paper_vertical(folders),
                                   second_paper_statements(folders)};
  chapters.push_back(consistency(chapters));
  chapters.push_back(reliability());
  const std::string text = page(chapters);
  write_text_file(folder / "README.md", text);
  const bool good = report_failures(chapters);
  const bool same = arguments.size() < 2 || same_as_committed(arguments[1], text);
  return good && same ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
