// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glissade/core/shared_list.hpp"
#include "glissade/motion/motion.hpp"
#include "glissade/study/cases/case_set.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/plan/kernel.hpp"
#include "glissade/study/plan/skip.hpp"

namespace glissade {

/// A record of a plan.
struct PlannedRecord {
  std::size_t suite = 0, motion = 0;
};

/// One slice of a plan: some cases of one record, all levels, all thresholds.
struct WorkUnit {
  std::size_t record = 0;
  std::size_t first = 0, count = 0;  ///< in Plan::order
};

/// What a plan lists by case or building: as long as the samples are many, so that the ranks of one
/// machine store it once. Made by one rank.
struct PlanLists {
  SharedList<CaseNumber> same_as;  ///< by case: the first with the same histories; rank 0 only
  /// The cases that are run, block by block of the samples, those on one building together.
  SharedList<CaseNumber> order;
  /// By case: which of the distinct roofs of a record it is on.
  SharedList<CaseNumber> building;
  SharedList<CaseNumber> by_building;  ///< those of `order`, building by building
  SharedList<CaseNumber> first_on;     ///< by building and one more: its first in `by_building`
  SharedList<WorkUnit> units;          ///< block by block of the samples that are run in turn
  std::vector<std::size_t> unit_ends;  ///< by block: the end of its units
  bool roofs_are_kept = false;         ///< so few of them that a record's are all kept
  bool frictions_repeat = false;       ///< half of the frictions or fewer are different

  /// The cases on a building, of those that are run, in their order.
  std::span<const CaseNumber> cases_on(std::size_t number) const {
    return std::span<const CaseNumber>(by_building)
        .subspan(first_on[number], first_on[number + 1] - first_on[number]);
  }
};

/// Makes by_building and first_on of order and building.
void list_by_building(PlanLists& lists, std::size_t buildings);

/// A study worked out: what would be computed, in which slices, and nothing computed yet. Immutable
/// once made; the same study and motions make the same plan on every rank.
struct Plan : PlanLists {
  StudyConfig config;
  std::vector<Suite> suites;           ///< with the records that are run
  std::vector<PlannedRecord> records;  ///< of all suites, in their order
  KernelChoice kernel;
  PlannedCases cases;
  std::vector<double> factor_at_unit_level;    ///< by record: factor on the motion at level 1; 0
                                               ///< where it depends on the roof
  FirstPeriods first_periods;                  ///< of all buildings, where the rule is of them
  std::vector<SpectraByRule> scaling_spectra;  ///< by suite; empty unless the levels are S_DS
  // Of rank 0 only:
  std::vector<std::string> warnings;  ///< what is possible and not probable: first in every output
  std::vector<std::string> notes;     ///< remarks that belong to the results
  /// So many of them, the first, are of what is run; the others of what analyses would make of it.
  std::size_t warnings_of_run = 0, notes_of_run = 0;
  std::vector<Skip> skips;  ///< what the study does not need and is not run
  /// A line for each suite and each of its motions: name, then a hash of what is taken of it.
  std::string motions_text;
  std::string hash;  ///< of everything that decides the results or stands in them; on every rank

  const Suite& suite_of(std::size_t record) const { return suites[records[record].suite]; }
  const Motion& motion(std::size_t record) const {
    return suite_of(record).motions[records[record].motion];
  }
  /// The design spectrum that strengths and levels of a suite rest on; null: none.
  const DesignTarget* target_of(std::size_t suite) const;
  const DesignTarget* target(std::size_t record) const { return target_of(records[record].suite); }
  /// Those at which a record is run: all, or that of its stripe.
  std::span<const double> levels_of(std::size_t record) const {
    const std::span<const double> all = config.intensity.levels;
    return config.by_stripes ? all.subspan(records[record].suite, 1) : all;
  }
  /// Records x cases x levels that are run; searches for capacities come on top.
  std::uint64_t histories() const;
  /// Predicted seconds of one core.
  double predicted_seconds() const;
};

/// By record; empty: not stated.
std::vector<std::string> events_of(const Plan& plan);

/// What every rank makes itself, first: the records. Throws InputError where study and suites do
/// not fit (no second component, no vertical although required, no target for sds_g ...).
Plan begin_plan(const StudyConfig& config, std::vector<Suite> suites);
/// The records whose spectra the scales of the suites rest on: all, or 0. Any rank computes that
/// of a record.
std::size_t spectra_to_scale(const Plan& plan);
std::vector<double> spectrum_to_scale(const Plan& plan, std::size_t record);
/// Then: scales of the suites, and the cases by their numbers. Throws InputError where no record
/// can be scaled so.
void scale_plan(Plan& plan, std::vector<std::vector<double>> spectra_g);
/// What one rank makes: the lists, its texts and its hash. Throws InputError where cases are not
/// possible.
void finish_plan(Plan& plan);
/// All of it.
Plan make_plan(const StudyConfig& config, std::vector<Suite> suites);

/// Of what scale_plan() gives, with some of the cases, and of the mathematics here. Ranks whose
/// fingerprints differ would run other histories: another study file, another processor.
std::string fingerprint(const Plan& plan);

/// How many units a study is cut into, where it has that many cases of 1 ms or more: fewer of the
/// full model, whose lanes are filled by the cases of one unit.
double units_wanted(Kernel kernel);

/// The units of a block in the order in which ranks take them: the longest first, as predicted.
std::vector<std::size_t> longest_first(const Plan& plan, std::size_t block);

/// Part `number`, from 1, of `count` parts of a plan; 0 of 0: all of it.
struct PlanPart {
  std::uint64_t number = 0, count = 0;
  bool is_all() const { return count == 0; }
};

/// The units of a part, the longest first: every `count`-th of them, so that the predicted costs of
/// two parts differ by one unit at most.
std::vector<std::size_t> units_of(const Plan& plan, const PlanPart& part);

/// The plan of the first blocks of samples, those with so many units: where a run ended.
Plan first_blocks(Plan plan, std::size_t units);

/// A page of text: what the plan would run (for --dry-run).
std::string to_string(const Plan& plan);

}  // namespace glissade
