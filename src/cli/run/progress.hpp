// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace glissade::cli {

/// Reports the progress of a run on standard error: one line that renews itself on a terminal, a
/// line a minute in a log.
class Progress {
 public:
  Progress(std::uint64_t total_units, std::uint64_t total_histories);
  void update(std::uint64_t done_units);
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(std::uint64_t done_units) const;
  std::uint64_t total_units_, total_histories_;
  bool terminal_;
  Clock::time_point start_, last_;
};

}  // namespace glissade::cli
