// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

// An analysis reads the histories of a study. It is a class of
//   InStudy    its part of StudyConfig: what its table of the study file says
//   InResults  its part of Results: what it finds
//   find       makes that of the histories, where the study asks for it
//   in_files   what it has in study files and results files, which module io defines
//   in_report  its tables, figures and sentences, which module report defines
namespace glissade {

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

}  // namespace glissade
