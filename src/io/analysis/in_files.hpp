// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "glissade/study/results.hpp"
#include "study/study_keys.hpp"

namespace glissade {

/// What becomes of a value of drawn friction that an analysis may read.
enum class FrictionUse {
  none,      ///< not read
  read,      ///< where the study runs it
  usual,     ///< run where the study does not say which
  required,  ///< the analysis is of this value
};

inline const StudyNeed needs_fragility{"[fragility]",
                                       [](auto& root, auto&) { return root.has("fragility"); }};

/// What an analysis has in study files. A part may be missing.
struct AnalysisInFiles {
  const char* table = nullptr;  ///< of the study file
  /// What the rows of its keys do not say; after them.
  void (*read)(const TomlTable& root, StudyConfig& study) = nullptr;
  std::vector<StudyKey> keys;
  std::vector<StudyNeed> needs;   ///< beside the table of the analysis
  std::vector<const char*> uses;  ///< "sampling.scrambles": has no effect but with such an analysis
  bool stands_alone = false;      ///< or is read beside one that does
  bool needs_every_history = false;  ///< those beyond the largest threshold too
  bool of_stripes = false;           ///< a record may be run at one level only
  bool of_any_run = false;  ///< can be added to finished results: every run keeps what it reads
  FrictionUse sampled_friction = FrictionUse::none, design_friction = FrictionUse::none;
};

/// All, in the order of Analyses.
const std::vector<AnalysisInFiles>& analyses_in_files();

/// The tables of analyses for which a property holds.
std::vector<std::string> tables_where(const std::function<bool(const AnalysisInFiles&)>& property);
/// "[fragility], [chart]"
std::string listed(const std::vector<std::string>& tables, const std::string& last = ", ");

/// The suite: the study does not scale it at all, or not to its longest period.
bool may_miss_target(const StudyConfig& study);

}  // namespace glissade
