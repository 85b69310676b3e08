// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "convergence/cases.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/suite_file.hpp"
#include "verification/chapters.hpp"
#include "verification/page.hpp"

namespace glissade::verification {
namespace {

using convergence::error_summary;
using convergence::Measure;
using convergence::paper_substeps;

const std::string paper = "Rodriguez-Nikl et al. 2019, ";

double largest(const std::vector<convergence::Case>& cases, std::size_t step, Measure measure) {
  return error_summary(cases, step, measure).largest;
}

/// The rows at P = 64 of the table that the program `convergence` wrote.
struct AllRecords {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  explicit AllRecords(const std::filesystem::path& csv) {
    std::istringstream in(read_text_file(csv));
    std::string line;
    std::getline(in, line);
    names = csv_cells(line);
    while (std::getline(in, line))
      if (const auto cells = csv_cells(line); cells.size() == names.size() && cells[1] == "64")
        rows.push_back(cells);
    if (rows.size() != 3) throw std::runtime_error(csv.string() + ": not three rows at P = 64");
  }

  /// Of the built-in or of the recorded motions.
  double of(const std::string& name, bool recorded) const {
    const auto at = std::ranges::find(names, name);
    if (at == names.end()) throw std::runtime_error("no column " + name);
    return std::stod(rows[recorded ? 2 : 1][static_cast<std::size_t>(at - names.begin())]);
  }
};

std::string table_of_all_records(const AllRecords& all) {
  std::string table =
      "At P = 64, errors in %, as `convergence` wrote it:\n\n| | the paper, one record | 22 "
      "built-in motions | 22 recorded motions |\n|---|---|---|---|\n";
  const auto add = [&](const char* what, const char* stated, const std::string& column,
                       double factor = 1.0) {
    table += fmt::format("| {} | {} | {:.3g} | {:.3g} |\n", what, stated,
                         factor * all.of(column, false), factor * all.of(column, true));
  };
  add("largest, relative to the residual at P = 256", "0.48", "largest_of_finest_percent");
  add("median", "", "median_of_finest_percent");
  add("records whose largest error is 0.48 % or less", "1", "records_within_0.48_percent");
  add("largest of the record with the smallest", "",
      "smallest_of_records_largest_of_finest_percent");
  add("largest, residuals that are clear by the exact solution", "",
      "largest_of_finest_clear_by_exact_percent");
  add("largest, residuals that are clear by P = 256", "",
      "largest_of_finest_clear_by_finest_percent");
  add("largest, relative to the exact residual", "", "largest_of_exact_residual_percent");
  add("largest, relative to the exact peak", "", "largest_of_exact_peak_percent");
  add("longest time of a history, ms", "less than 90", "scheme_longest_s", 1e3);
  add("the same, exact solution, ms", "", "exact_longest_s", 1e3);
  return table;
}

std::vector<Finding> findings_on_error(const AllRecords& all) {
  const double built_in = all.of("records_within_0.48_percent", false),
               recorded = all.of("records_within_0.48_percent", true);
  return {
      {"largest error at P = 64, relative to P = 256: 0.48 %",
       fmt::format("not larger for {:g} of 22 built-in and {:g} of 22 recorded motions", built_in,
                   recorded),
       built_in + recorded == 44 ? "yes" : "not for other motions"},
      {"P = 64 is chosen",
       fmt::format("largest error at P = 64, relative to the exact peak: {:.2g} % built-in, {:.2g} "
                   "% recorded motions",
                   all.of("largest_of_exact_peak_percent", false),
                   all.of("largest_of_exact_peak_percent", true)),
       all.of("largest_of_exact_peak_percent", true) < 5.0 ? "yes, for the peak" : "no"}};
}

/// The mean order between P = 8 and 256 of the largest error relative to the exact peak.
double observed_order(const std::vector<convergence::Case>& cases) {
  static_assert(paper_substeps[3] == 8 && paper_substeps[convergence::finest_step] == 256);
  return std::log2(largest(cases, 3, Measure::exact_peak) /
                   largest(cases, convergence::finest_step, Measure::exact_peak)) /
         5.0;
}

}  // namespace

Chapter first_paper_convergence(const Folders& folders) {
  const std::vector<convergence::Case> cases = convergence::run_cases(
      load_suite(folders.suites / "synthetic_far_field.toml").motions.front(), paper_substeps);
  const std::size_t runs = cases.size() * paper_substeps.size();
  const AllRecords all(GLISSADE_SOURCE_DIR
                       "/tests/verification/figures/first_paper_convergence.csv");
  return {
      "1.3 Convergence",
      "the 540 runs of the paper; the exact solution",
      R"(The 540 runs of the paper ([cases](../convergence/README.md)) are repeated with the first motion of
suites/synthetic_far_field.toml. The paper takes P = 256 as the truth. Here the exact solution is known.
Cases that do not slide are left out.

The largest error of the paper does not hold for other motions, although their substep at P = 64 is half
that of the paper. It is relative to the residual displacement, which is small where the array stops near
its first position. Relative to the peak, the error decreases with the first order of the scheme. A
residual is *clear* if it is at least 10 % of the exact peak.

Here a run continues until the array stops; in the paper it ends with the record. Times are processor
times of single histories. Table and figure are from
`build/dev/tests/convergence/convergence --out tests/verification/figures`, whose
[CSV](figures/first_paper_convergence.csv) has every P. The recorded motions are those of FEMA P-695.)",
      {all_equal({"60 scenes at 9 numbers of substeps", "runs", paper + "540"},
                 {runs == 540 ? 0 : 1, 1}),
       limit({"60 scenes, P = 256", "residual slip / peak slip",
              "slide(); the paper takes P = 256 for the truth", ReferenceFrom::this_code},
             {"largest difference", largest(cases, convergence::finest_step, Measure::exact_peak),
              0.01}),
       limit({"60 scenes, P = 64, the paper's choice", "residual slip, relative to that at P = 256",
              paper + "Fig. 5: largest 0.48 % with its motion"},
             {"median difference",
              error_summary(cases, convergence::chosen_step, Measure::finest).median,
              convergence::paper_largest_error}),
       within({"60 scenes, P from 8 to 256", "largest error of residual slip / peak slip",
               "slide(); first order of an explicit step, 1", ReferenceFrom::this_code},
              {"observed order", observed_order(cases), 0.8, 1.2})},
      "![Error of the published scheme over its substeps, and its longest "
      "time](figures/first_paper_convergence.svg)\n",
      table_of_all_records(all),
      findings_on_error(all)};
}

}  // namespace glissade::verification
