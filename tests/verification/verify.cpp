// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the verification manual: README.md, cases.csv and longer tables.

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

struct File {
  std::string name, text;
  std::string (*difference)(const std::string& committed, const std::string& made);
};

std::vector<File> files_of(const std::vector<Chapter>& chapters) {
  std::vector<File> files = {
      {"README.md", page(chapters),
       [](const std::string& a, const std::string& b) {
         return first_difference(comparable_page(a), comparable_page(b));
       }},
      {"cases.csv", cases_csv(chapters), [](const std::string& a, const std::string& b) {
         return first_difference(comparable_cases(a), comparable_cases(b));
       }}};
  for (const Chapter& chapter : chapters)
    for (const auto& [name, text] : chapter.files)
      files.push_back({name, text, first_difference_of_numbers});
  return files;
}

bool same_as_committed(const std::filesystem::path& folder, const File& file) {
  const std::string difference = file.difference(read_text_file(folder / file.name), file.text);
  if (!difference.empty())
    std::cerr << fmt::format("the committed {} is not the one this code makes; make it again\n{}\n",
                             file.name, difference);
  return difference.empty();
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty() || arguments.size() > 2) {
    std::cerr
        << "usage: verify FOLDER [COMMITTED_FOLDER]   writes README.md, CSV files and figures\n";
    return 2;
  }
  const std::filesystem::path folder = arguments[0];
  const Folders folders{.suites = GLISSADE_SOURCE_DIR "/suites",
                        .studies = GLISSADE_SOURCE_DIR "/studies",
                        .simulation = GLISSADE_SIMULATED_SPECTRA,
                        .figures = folder / "figures"};
  std::filesystem::create_directories(folders.figures);
  std::vector<Chapter> chapters = {first_paper_checks(folders),
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
                                   second_paper_statements(folders),
                                   sliding_block(folders),
                                   published_scheme(folders),
                                   closed_form_solutions(),
                                   table_kernel(folders),
                                   buildings(folders),
                                   buildings_of_storeys(),
                                   fragility(),
                                   interval_coverage(),
                                   sampling(),
                                   standards(),
                                   simulated_motions(folders),
                                   end_to_end(folders)};
  chapters.push_back(consistency(chapters));
  bool good = report_failures(chapters);
  for (const File& file : files_of(chapters)) {
    write_text_file(folder / file.name, file.text);
    if (arguments.size() == 2) good = same_as_committed(arguments[1], file) && good;
  }
  return good ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
