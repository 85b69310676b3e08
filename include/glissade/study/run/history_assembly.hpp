// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/run/execute.hpp"

namespace glissade {

/// The histories of a plan, put together as its units come, in any order: a unit needs to be kept
/// no longer than it takes to add it.
class HistoryAssembly {
 public:
  explicit HistoryAssembly(const Plan& plan);
  void add(const UnitResult& unit);
  std::size_t units() const { return units_; }
  const WorkCount& count() const { return count_; }
  /// The whole table. Throws std::logic_error where a unit of the plan is missing.
  HistoryTable take();

 private:
  const Plan& plan_;
  HistoryTable table_;
  std::vector<bool> has_;
  std::size_t units_ = 0;
  WorkCount count_;
};

}  // namespace glissade
