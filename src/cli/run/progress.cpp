// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "shared/say.hpp"

namespace glissade::cli {

Progress::Progress(std::uint64_t total_units, std::uint64_t total_histories)
    : total_units_(total_units),
      total_histories_(total_histories),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_(start_) {}

std::string Progress::line(std::uint64_t done_units) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double share = static_cast<double>(done_units) / static_cast<double>(total_units_);
  const double histories = share * static_cast<double>(total_histories_);
  const double left = share > 0.0 ? seconds * (1.0 - share) / share : 0.0;
  return fmt::format("{:.0f} of {} histories ({:.0f} %), {:.0f} a second, {:.0f} s left", histories,
                     total_histories_, 100.0 * share, seconds > 0.0 ? histories / seconds : 0.0,
                     left);
}

void Progress::update(std::uint64_t done_units) {
  const auto now = Clock::now();
  const auto interval =
      terminal_ ? std::chrono::milliseconds(200) : std::chrono::milliseconds(60000);
  if (now - last_ < interval) return;
  last_ = now;
  const std::string text = line(std::min(done_units, total_units_));
  if (terminal_) {
    say("\r\033[K{}", text);
  } else {
    say("{}\n", text);
  }
}

void Progress::finish() {
  if (terminal_) say("\r\033[K");
}

}  // namespace glissade::cli
