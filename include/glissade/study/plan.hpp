// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/kernel.hpp"
#include "glissade/study/results.hpp"
#include "glissade/study/skip.hpp"

namespace glissade {

/// One slice of a plan: some samples of one record, all levels, all thresholds, all runs.
struct WorkUnit {
  std::size_t record = 0;
  std::uint64_t first_sample = 0, sample_count = 0;
};

/// One friction choice of a study.
struct FrictionRun {
  std::string label;  ///< "sampled", "design"
  std::string description;
  std::vector<double> friction;         ///< per sample
  std::vector<double> friction_across;  ///< per sample; of two axes
  bool repeats = false;                 ///< values come again: half of them or fewer are different
};

/// A study worked out: what would be computed, in which slices, and nothing computed yet. Immutable
/// once made; the same study and motions make the same plan on every rank.
struct Plan {
  StudyConfig config;
  Suite suite;
  KernelChoice kernel;
  std::vector<SamplePoint> samples;
  std::vector<std::size_t> building;  ///< per sample: which of the distinct roofs (component,
                                      ///< period, damping, mass ratio) of a record it is on
  bool roofs_are_kept = false;        ///< so few of them that a record's are all kept
  std::vector<FrictionRun> runs;      ///< sampled first
  std::vector<double>
      factor_at_unit_level;  ///< per record: factor on the motion at intensity 1; 0 for ppa_g
  std::vector<WorkUnit> units;
  std::vector<std::string> notes;  ///< what a reader of the results must know
  std::vector<Skip> skips;         ///< what the study does not need and is not run
  std::string hash;                ///< of everything that decides the results

  std::uint64_t histories()
      const;  ///< records x samples x levels x runs (searches for capacities come on top)
};

/// Draws the samples, scales the suite, cuts the work. Throws InputError where study and suite do
/// not fit (no second component, no vertical although required, no target for sds_g ...).
Plan make_plan(const StudyConfig& config, Suite suite);

/// A page of text: what the plan would run (for --dry-run).
std::string to_string(const Plan& plan);

}  // namespace glissade
