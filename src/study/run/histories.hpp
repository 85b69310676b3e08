// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>

#include "glissade/block/crossing.hpp"
#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/roof_store.hpp"
#include "glissade/study/run/work_count.hpp"
#include "run/two_axis_batch.hpp"

namespace glissade {

/// What a study keeps of a history, in plan.
struct History {
  double peak_displacement_m = 0.0;  ///< by the study's measure
  double peak_vector_m = 0.0;        ///< two axes: the longest displacement vector
  // Two axes, along the slope and across it:
  std::array<double, 2> peak_by_axis_m{}, residual_m{}, closing_m{}, base_shear{};
  bool uplift = false;
  /// The scheme did not converge.
  bool failed = false;
};

/// The histories of one case under one record, at any level of the study.
class Histories {
 public:
  virtual ~Histories() = default;

  /// The array does not slide at this level, as bounds show without a history.
  virtual bool does_not_slide(double level) const = 0;
  /// at() will be needed at this level: it is run with others of the batch, at its next run.
  virtual void prepare(double) {}
  /// at() needs no run of the batch at this level.
  virtual bool is_ready(double) const { return true; }
  /// @param crossings as many as the study's thresholds, or none
  virtual History at(double level, std::span<Crossing> crossings, WorkCount& count) = 0;
  /// By how much the gaps to a neighbour along and across the slope close at most; 0 without one
  /// (Kernel::full only).
  virtual std::array<double, 2> closing_m(double level) const = 0;
  /// The level above which the body begins to rock on its base (Kernel::tables only).
  virtual double tipping_level(const RigidBase& base) const = 0;
};

/// Of which nothing is known but that no clearance is enough: every number is infinite.
History unknown_history();

/// Histories::at(); one that does not converge, or whose displacement is no number, is counted and
/// reported, and the run goes on: it is an unknown_history() without crossings.
History run_history(Histories& histories, double level, std::span<Crossing> crossings,
                    WorkCount& count);

/// By the plan's kernel. Valid as long as the store's record; with Kernel::tables, as long as
/// `roof`.
/// @param curve see RoofStore::curve
/// @param batch runs what is prepared
/// @param remake makes the roof anew: called before every history where nothing is skipped
std::unique_ptr<Histories> histories_of(const Plan& plan, RoofStore& roofs, std::size_t record,
                                        std::size_t case_number, const CaseRoof& roof,
                                        TwoAxisBatch& batch, const std::function<void()>& remake);

}  // namespace glissade
