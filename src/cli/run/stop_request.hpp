// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace glissade::cli {

/// Of those below, where one came: its name.
std::string received_signal();

/// Whether a run is to end before its time, and be resumed later: SIGINT, SIGTERM, SIGHUP (its
/// terminal was closed) or SIGUSR1 came, its stop file is there, or its wall time is nearly over. A
/// second SIGINT ends the process at once.
class StopRequest {
 public:
  /// From here on the signals no longer end the process. The wall time begins at `start`.
  /// @param stop_files any of them stops the run
  StopRequest(std::vector<std::filesystem::path> stop_files, double walltime_s,
              std::chrono::steady_clock::time_point start);

  /// Called before every unit. A unit that takes twice as long as the longest so far still ends
  /// within the wall time; the first is always begun.
  bool before_unit();
  bool requested();                                      ///< by a signal or the stop file
  const std::string& reason() const { return reason_; }  ///< "SIGTERM", ...; empty: none

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<std::filesystem::path> stop_files_;
  double walltime_s_, longest_unit_s_ = 0.0;
  Clock::time_point start_, last_unit_ = {}, looked_ = {};
  std::string reason_;
};

}  // namespace glissade::cli
