// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/reduce.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "glissade/study/run/history_assembly.hpp"
#include "glissade/study/run/motion_parts.hpp"
#include "words/model_text.hpp"
#include "words/results_notes.hpp"

#ifndef GLISSADE_VERSION
#error "the build defines GLISSADE_VERSION"
#endif

namespace glissade {
namespace {

/// The plan's part of the results.
Results header_of(const Plan& plan, const std::vector<std::vector<double>>& motion_parts) {
  Results results;
  put_study(plan.config, results);
  results.program_version = GLISSADE_VERSION;
  results.plan_hash = plan.hash;
  results.model = model_text(plan);
  results.cases = plan.cases.stored();
  put_motions(plan, motion_parts, results);
  return results;
}

/// What an analysis finds, where the study asks for it.
template <class Analysis>
void analyse(const StudyConfig& study, Results& results) {
  if constexpr (requires { &Analysis::find; }) {
    if constexpr (!std::is_empty_v<typename Analysis::InStudy>) {
      const auto& [is_asked] = static_cast<const typename Analysis::InStudy&>(study);
      if (!is_asked) return;
    }
    auto& [found] = static_cast<typename Analysis::InResults&>(results);
    found = Analysis::find(study, results);
  }
}

template <class... Analysis>
void analyse(AnalysisList<Analysis...>, const StudyConfig& study, Results& results) {
  (analyse<Analysis>(study, results), ...);
  if (study.sampling.target)
    results.reached_target = reached_target(study, results.sampling_errors);
}

/// Each once.
template <class T>
void append(const std::vector<T>& some, std::vector<T>& all) {
  for (const T& one : some)
    if (std::ranges::find(all, one) == all.end()) all.push_back(one);
}

/// What the analyses say, in place of what they said.
void add_remarks_on_analyses(const StudyConfig& study, Results& results) {
  const Remarks remarks = remarks_on_analyses(results, study);
  results.warnings.erase(results.warnings.begin() + results.warnings_of_run,
                         results.warnings.end());
  results.notes.resize(results.notes_of_run);
  append(remarks.warnings, results.warnings);
  append(remarks.notes, results.notes);
}

void add_remarks(const Plan& plan, Results& results) {
  results.warnings.assign(plan.warnings.begin(), plan.warnings.begin() + plan.warnings_of_run);
  results.notes = plan.notes;
  results.notes.resize(plan.notes_of_run);
  const Remarks of_run = remarks_on_run(results, plan.config);
  append(of_run.warnings, results.warnings);
  append(of_run.notes, results.notes);
  results.warnings_of_run = results.warnings.size();
  results.notes_of_run = results.notes.size();
  add_remarks_on_analyses(plan.config, results);
}

}  // namespace

Results reduce(const Plan& plan, const std::vector<UnitResult>& units) {
  HistoryAssembly histories(plan);
  for (const UnitResult& unit : units) histories.add(unit);
  std::vector<std::vector<double>> parts;
  for (std::size_t i = 0; i < motion_part_count(plan); ++i) parts.push_back(motion_part(plan, i));
  return reduce(plan, histories.take(plan), parts);
}

Results reduce(const Plan& plan, HistoryTable histories,
               const std::vector<std::vector<double>>& motion_parts) {
  Results results = header_of(plan, motion_parts);
  results.histories = std::move(histories);
  results.histories.unit_of = event_units(results.records);
  analyse(Analyses(), plan.config, results);
  add_remarks(plan, results);
  return results;
}

void put_study(const StudyConfig& study, Results& results) {
  results.study_name = study.name;
  results.study_description = study.description;
  results.study_text = study.source_text;
  results.study_data_files = study.data_files;
  results.units = study.units;
  results.seed = study.seed;
  results.measure = study.intensity.measure;
  results.intensity_label = intensity_label(study.intensity);
  results.intensity_symbol = study.intensity.measure.symbol(study.intensity);
  results.building = study.building;
  results.axes = study.model.axes;
  results.displacement = study.model.displacement;
  results.levels = study.intensity.levels;
  results.by_stripes = study.by_stripes;
  results.published = study.published;
  results.thresholds_m = study.thresholds_m();
}

void analyse_again(StudyConfig study, Results& results) {
  // As it was run: on these motions, and where sampling.target_error ended it.
  study.intensity.of_roof = results.suites.front().of_roof;
  if (study.sampling.target)
    study.sampling =
        study.sampling.first_blocks(results.cases.samples / study.sampling.blocks().size);
  put_study(study, results);
  static_cast<Analyses::InResults&>(results) = {};
  analyse(Analyses(), study, results);
  add_remarks_on_analyses(study, results);
}

std::vector<Skip> skipped_again(const StudyConfig& study, const std::vector<Skip>& skips) {
  std::vector<Skip> again = skipped_analyses(study);
  std::ranges::copy_if(skips, std::back_inserter(again), [](const Skip& skip) {
    return skip.what != skipped_analyses({}).front().what;
  });
  return again;
}

std::vector<Skip> skipped(const Plan& plan, const WorkCount& count) {
  std::vector<Skip> skips = plan.skips;
  const auto add = [&](const char* what, const char* why, std::uint64_t number) {
    if (number > 0) skips.push_back({what, why, number});
  };
  add("histories whose roof moves too little to start sliding",
      "they cannot slide: zero without integration", count.below_yield);
  add("histories above the level that reaches the largest threshold",
      "[fragility] stop_at_largest = true", count.beyond);
  add("searches for a capacity", "the levels decide: not reached, or exceeded without shaking",
      count.decided);
  return skips;
}

}  // namespace glissade
