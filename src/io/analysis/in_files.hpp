// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "enum_names.hpp"
#include "glissade/study/results.hpp"
#include "results/archive.hpp"
#include "results/envelope.hpp"
#include "results/shared_schema.hpp"
#include "study/grammar.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// The group of Results::runs, each a group by its label.
inline constexpr const char* runs_group = "runs";

/// An analysis in the results file: fields that are named once, for both ways.
struct Exchange {
  void (*write)(const Hdf5Writer& root, const char* table, const IntensityScale& scale,
                const Results& results) = nullptr;
  void (*read)(const Hdf5Reader& root, const char* table, const IntensityScale& scale,
               Results& results) = nullptr;

  /// What `fields(root, table, scale, results)` names.
  template <class Fields>
  static Exchange of(Fields) {
    return {[](const Hdf5Writer& root, const char* table, const IntensityScale& scale,
               const Results& results) { Fields{}(root, table, scale, results); },
            [](const Hdf5Reader& root, const char* table, const IntensityScale& scale,
               Results& results) { Fields{}(root, table, scale, results); }};
  }
  /// What `fields(group, table, scale, run)` names of each of Results::runs, in the group of the
  /// run, which FragilityAnalysis makes.
  template <class Fields>
  static Exchange of_runs(Fields) {
    return of([](const auto& root, const char* table, const auto& scale, auto& results) {
      const auto runs = root.group(runs_group);
      for (auto& run : results.runs) Fields{}(runs.group(run.label), table, scale, run);
    });
  }
  /// What `fields(group, scale, found)` names of one part of the results, in a group with the name
  /// of its table.
  template <auto part, class Fields>
  static Exchange in_group(Fields) {
    return of([](const auto& root, const char* table, const auto& scale, auto& results) {
      if_there(root, table, results.*part,
               [&](const auto& group, auto& found) { Fields{}(group, scale, found); });
    });
  }
};

/// Checks a part of the results that was read, where there is one.
template <auto part, auto check>
void if_found(Results& results) {
  if (results.*part) check(*(results.*part), results);
}

/// What becomes of a value of drawn friction that an analysis may read.
enum class FrictionUse {
  none,      ///< not read
  read,      ///< where the study runs it
  usual,     ///< run where the study does not say which
  required,  ///< the analysis is of this value
};

/// A key of the analysis's own table, as in GrammarKey.
struct AnalysisKey {
  const char* key;
  std::string value, usual, meaning;
};

/// What a study must have beside the table of the analysis; stated in errors and with its first
/// key.
struct AnalysisNeeds {
  const char* what;  ///< "[model] axes = 2"
  bool (*is_met)(const TomlTable& root, const StudyConfig& study);
};
inline constexpr AnalysisNeeds needs_fragility{
    "[fragility]", [](const TomlTable& root, const StudyConfig&) { return root.has("fragility"); }};

/// What an analysis has in study files and results files. A part may be missing.
struct AnalysisInFiles {
  const char* table = nullptr;  ///< of the study file
  void (*read)(const TomlTable& root, StudyConfig& study) = nullptr;
  std::vector<AnalysisKey> keys;
  std::vector<AnalysisNeeds> needs;
  std::vector<KeyNeeds> key_needs;  ///< of its keys, or of others
  std::vector<const char*> uses;  ///< "sampling.scrambles": has no effect but with such an analysis
  bool stands_alone = false;      ///< or is read beside one that does
  bool needs_every_history = false;  ///< those beyond the largest threshold too
  bool of_any_run = false;  ///< can be added to finished results: every run keeps what it reads
  FrictionUse sampled_friction = FrictionUse::none, design_friction = FrictionUse::none;
  Exchange exchange;
  /// Throws Hdf5Error where parts that were read do not fit each other.
  void (*check)(Results& results) = nullptr;
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
