// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/execute.hpp"

#include <algorithm>
#include <functional>

#include "glissade/core/finite.hpp"
#include "glissade/core/not_converged.hpp"
#include "run/capacities.hpp"
#include "run/histories.hpp"

namespace glissade {
namespace {

void keep(const History& history, const KeptFields& kept, HistoryFields& fields) {
  fields.peak_displacement_m.push_back(history.peak_displacement_m);
  fields.uplift.push_back(history.uplift ? 1 : 0);
  fields.failed.push_back(history.failed ? 1 : 0);
  if (kept.two_axes) {
    fields.peak_vector_m.push_back(history.peak_vector_m);
    fields.residual_along_m.push_back(history.residual_m[0]);
    fields.residual_across_m.push_back(history.residual_m[1]);
  }
  if (kept.by_axis) {
    fields.peak_along_m.push_back(history.peak_by_axis_m[0]);
    fields.peak_across_m.push_back(history.peak_by_axis_m[1]);
  }
  if (kept.closing) {
    fields.closing_along_m.push_back(history.closing_m[0]);
    fields.closing_across_m.push_back(history.closing_m[1]);
  }
  if (kept.base_shear) {
    fields.shear_along.push_back(history.base_shear[0]);
    fields.shear_across.push_back(history.base_shear[1]);
  }
}

/// Its failure is one of the history.
void run_neighbour(const Histories& histories, double level, History& history, WorkCount& count) {
  try {
    history.closing_m = histories.closing_m(level);
  } catch (const NotConverged&) {
    if (!history.failed) ++count.failed;
    history.failed = true;
    history.closing_m = {infinity, infinity};
  }
}

/// All levels of one case.
void run_levels(const Plan& plan, std::span<const double> levels, Histories& histories,
                Skipping skipping, HistoryFields& fields, WorkCount& count) {
  const StudyConfig& config = plan.config;
  const KeptFields kept(config);
  const bool stops = config.fragility && config.fragility->stop_at_largest;
  bool beyond = false;  // the largest threshold is reached, and nothing above it is needed
  for (const double level : levels) {
    History history;
    std::vector<Crossing> crossings(kept.crossings ? config.thresholds_m().size() : 0);
    if (beyond) {
      if (skipping == Skipping::all) {
        ++count.beyond;
      } else {
        run_history(histories, level, crossings, count);
      }
      history = unknown_history();
    } else if (histories.does_not_slide(level)) {
      ++count.below_yield;
    } else {
      history = run_history(histories, level, crossings, count);
      beyond = stops && history.peak_displacement_m >= config.thresholds_m().back();
    }
    if (kept.closing) run_neighbour(histories, level, history, count);
    keep(history, kept, fields);
    for (const Crossing& crossing : crossings) {
      fields.crossing_time_s.push_back(crossing.time_s);
      fields.crossing_speed_mps.push_back(crossing.speed_mps);
    }
  }
  if (!kept.tips) return;
  const double tipping = histories.tipping_level(*config.tipping);
  for (const double level : levels)
    fields.tips.push_back(config.intensity.measure.factor_of_level(level) > tipping ? 1 : 0);
}

using Cases = std::vector<std::unique_ptr<Histories>>;

/// The levels of cases that are run together.
void prepare_levels(const Plan& plan, std::span<const double> levels, const Cases& cases,
                    TwoAxisBatch& batch) {
  // Where a level decides whether the next is needed, each is run by itself.
  if (plan.config.fragility && plan.config.fragility->stop_at_largest) return;
  for (const auto& histories : cases)
    for (const double level : levels)
      if (!histories->does_not_slide(level)) histories->prepare(level);
  batch.run();
}

/// The cases of a unit in turn, with the roofs that they lie on, some at once.
class CasesOfUnit {
 public:
  CasesOfUnit(const Plan& plan, const WorkUnit& unit, RoofStore& roofs)
      : plan_(plan),
        unit_(unit),
        roofs_(roofs),
        at_once_(skips() ? RoofStore::most_at_once : 1),
        next_(unit.first),
        under_end_(unit.first) {}

  bool at_end() const { return next_ == unit_.first + unit_.count; }

  /// With Kernel::tables, those of before are no longer valid.
  std::unique_ptr<Histories> next(TwoAxisBatch& batch) {
    if (next_ == under_end_) make_roofs();
    const std::size_t number = plan_.order[next_++];
    if (plan_.building[number] != buildings_[roof_]) ++roof_;
    const std::function<void()> remake =
        skips() ? std::function<void()>() : [this] { roofs_.under(unit_.record, buildings_); };
    return histories_of(plan_, roofs_, unit_.record, number, under_[roof_], batch, remake);
  }

 private:
  bool skips() const { return roofs_.skipping() == Skipping::all; }

  void make_roofs() {
    buildings_.clear();
    roof_ = 0;
    for (; under_end_ < unit_.first + unit_.count; ++under_end_) {
      const std::size_t building = plan_.building[plan_.order[under_end_]];
      if (!buildings_.empty() && buildings_.back() == building) continue;
      if (buildings_.size() == at_once_) break;
      buildings_.push_back(building);
    }
    under_ = roofs_.under(unit_.record, buildings_);
  }

  const Plan& plan_;
  const WorkUnit& unit_;
  RoofStore& roofs_;
  std::size_t at_once_;
  std::size_t next_, under_end_;  // in Plan::order
  std::vector<std::size_t> buildings_;
  std::span<const CaseRoof> under_;
  std::size_t roof_ = 0;  // of the last case, in buildings_
};

}  // namespace

UnitResult execute(const Plan& plan, std::size_t unit_index, RoofStore& roofs) {
  UnitResult result;
  result.unit = unit_index;
  const std::uint64_t roofs_before = roofs.roofs_made();
  // SIMD lanes are filled with the histories of several cases: those that are done wait for others
  // only at the end of all.
  const std::size_t together = plan.kernel.kernel == Kernel::tables ? 1 : 64;
  const KeptFields kept(plan.config);
  const auto thresholds = kept.crossings ? plan.config.thresholds_m() : std::span<const double>();
  const std::span<const double> levels = plan.levels_of(plan.units[unit_index].record);
  for (CasesOfUnit of_unit(plan, plan.units[unit_index], roofs); !of_unit.at_end();) {
    TwoAxisBatch batch(thresholds);
    Cases cases;
    while (!of_unit.at_end() && cases.size() < together) cases.push_back(of_unit.next(batch));
    prepare_levels(plan, levels, cases, batch);
    for (const auto& histories : cases)
      run_levels(plan, levels, *histories, roofs.skipping(), result.fields, result.count);
    if (kept.capacities) find_capacities(plan.config, cases, batch, result.fields, result.count);
  }
  result.count.roofs = roofs.roofs_made() - roofs_before;
  return result;
}

UnitResult execute(const Plan& plan, std::size_t unit, Skipping skipping) {
  RoofStore roofs(plan, skipping);
  return execute(plan, unit, roofs);
}

}  // namespace glissade
