// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glissade/study/run/execute.hpp"

namespace glissade {

/// The histories of a plan, put together as its units come, in any order: a unit needs to be kept
/// no longer than it takes to add it.
class HistoryAssembly {
 public:
  /// @param pages folder for what is larger than the memory (core/paged_memory.hpp); empty: none
  explicit HistoryAssembly(const Plan& plan, const std::filesystem::path& pages = {});
  void add(const UnitResult& unit);
  bool has(std::size_t unit) const { return has_[unit]; }
  const WorkCount& count() const { return count_; }
  /// The whole table of `plan`: this one, or that of its first blocks of samples. Throws
  /// std::logic_error where a unit is missing.
  HistoryTable take(const Plan& plan);

 private:
  const Plan& plan_;
  HistoryTable table_;
  std::vector<bool> has_;
  WorkCount count_;
};

}  // namespace glissade
