// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "schedule.hpp"

namespace glissade::test {

/// What a study costs by part, in seconds of one core.
struct StudyCosts {
  std::string name;
  double histories = 0.0;
  double motions_s = 0.0;  ///< shared by the ranks of rank 0's machine
  double motions = 1.0;
  std::vector<double> plan_parts_s;  ///< shared by all ranks
  double units_wanted = 0.0;         ///< of its kernel
  double plan_s = 0.0;               ///< the rest, on rank 0
  std::vector<double> work_s;        ///< motion parts and units, as they go out
  std::size_t motion_parts = 0;      ///< of work_s, first
  std::string longest;               ///< of work_s: the record
  double assembly_s = 0.0;           ///< histories into their table, on rank 0
  double analyses_s = 0.0;           ///< shared by the ranks of rank 0's machine
  double pieces = 1.0;               ///< of the analyses, about
  double results_s = 0.0;            ///< results.h5, by chunks: shared as the analyses are
  double report_s = 0.0;             ///< tables, figures and report, on rank 0
  double motion_bytes = 0.0, result_bytes = 0.0;

  double histories_s() const;  ///< of work_s, the sum
};

/// Runs every part of a study by itself and measures its time on the core, so that other programs
/// on the machine count little; of the report the time that passes.
StudyCosts measure_study(const std::filesystem::path& study, const std::filesystem::path& scratch);

/// The study with `factor` times the samples: its units are cut as those of the plan are.
StudyCosts grown(const StudyCosts& costs, double factor);

/// A part of a run that follows the one before.
struct PredictedPhase {
  std::string name;
  double s = 0.0;
  double one_core_s = 0.0;  ///< of the same work
};

struct PredictedRun {
  std::vector<PredictedPhase> phases;
  double histories_s = 0.0, total_s = 0.0;

  void add(PredictedPhase phase);
};
/// @param cores that the ranks share, 64 at most on one machine
PredictedRun predict(const StudyCosts& costs, int ranks, int cores, const Network& network,
                     Fetch fetch = Fetch::ahead);
/// One core's time over what all ranks take.
double efficiency(const StudyCosts& costs, int ranks, const Network& network,
                  Fetch fetch = Fetch::ahead);

/// The phase that is longest beyond an equal share of its work by each rank.
PredictedPhase largest_loss(const PredictedRun& run, int ranks);

}  // namespace glissade::test
