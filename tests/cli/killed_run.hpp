// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <chrono>
#include <functional>
#include <thread>

#include "cli/child.hpp"
#include "cli/small_study.hpp"

// Runs that are ended from outside.
namespace glissade::test {

/// As small_study, a second of one core longer, in some hundred units.
inline std::string longer_study() { return replaced(small_study(), "samples = 8", "samples = 32"); }

/// Bytes of all journals in a results folder; 0 where there are none.
inline std::uintmax_t journal_bytes(const std::filesystem::path& out) {
  std::uintmax_t bytes = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(out / "journal", ignored)) {
    if (entry.path().extension() != ".units") continue;
    const std::uintmax_t size = entry.file_size(ignored);
    if (!ignored) bytes += size;
  }
  return bytes;
}

/// Units are in the journals.
inline bool some_units_are_done(const std::filesystem::path& out) {
  return journal_bytes(out) > 1000;
}

/// Waits until `moment` or the end of the child; true: it came, and the child goes on.
inline bool reaches(Child& child, const std::function<bool()>& moment) {
  while (child.is_running()) {
    if (moment()) return true;
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  return false;
}

}  // namespace glissade::test
