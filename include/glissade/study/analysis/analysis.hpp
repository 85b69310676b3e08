// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

// An analysis reads the histories of a study. It is a class of
//   InStudy    its part of StudyConfig: what its table of the study file says
//   InResults  its part of Results: what it finds
//   find       makes that of the histories, where the study asks for it
//   in_files   what it has in study files, which module io defines
//   in_report  its tables, figures and sentences, which module report defines
// and, where it needs them, of
//   keeps      a field of the histories (KeptFields) that is kept for it
//   check      what it needs of the suites and of the model, as problems
//   plan_warnings, plan_notes  on what would be run: of its Plan, or, where the analysis can be
//              added to finished results, of its StudyOutline
//   warnings, notes            on the results
namespace glissade {

class ProblemList;
struct Plan;
struct StudyOutline;
struct StudyConfig;
struct Results;
struct AnalysisInFiles;
struct AnalysisReport;

template <class... Analysis>
struct AnalysisList {
  struct InStudy : Analysis::InStudy... {};
  struct InResults : Analysis::InResults... {};
  static constexpr std::array in_files{&Analysis::in_files...};
  static constexpr std::array in_report{&Analysis::in_report...};
};

/// visit(analysis) for each, in order.
template <class... Analysis, class Visit>
void for_each_analysis(AnalysisList<Analysis...>, Visit visit) {
  (visit(Analysis()), ...);
}

}  // namespace glissade
