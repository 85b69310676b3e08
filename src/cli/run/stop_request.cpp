// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/stop_request.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <atomic>

namespace glissade::cli {
namespace {

static_assert(std::atomic<int>::is_always_lock_free);
std::atomic<int> received = 0;

struct StopSignal {
  int number;
  const char* name;
  int flags;
};
// mpirun and schedulers may send the others more than once.
constexpr StopSignal stop_signals[] = {{SIGINT, "SIGINT", static_cast<int>(SA_RESETHAND)},
                                       {SIGTERM, "SIGTERM", 0},
                                       {SIGHUP, "SIGHUP", 0},
                                       {SIGUSR1, "SIGUSR1", 0}};

void receive_from_now_on(const StopSignal& signal) {
  struct sigaction action = {};
  if (::sigaction(signal.number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN)
    return;  // by nohup, or in the background of a script
  action = {};
  action.sa_handler = [](int number) { received = number; };
  action.sa_flags = SA_RESTART | signal.flags;
  ::sigaction(signal.number, &action, nullptr);
}

double seconds_between(auto from, auto to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::string received_signal() {
  const auto* signal = std::ranges::find(stop_signals, received.load(), &StopSignal::number);
  return signal == std::end(stop_signals) ? "" : signal->name;
}

StopRequest::StopRequest(std::vector<std::filesystem::path> stop_files, double walltime_s,
                         Clock::time_point start)
    : stop_files_(std::move(stop_files)), walltime_s_(walltime_s), start_(start) {
  for (const StopSignal& signal : stop_signals) receive_from_now_on(signal);
}

bool StopRequest::requested() {
  if (!reason_.empty()) return true;
  reason_ = received_signal();
  const auto now = Clock::now();
  if (now - looked_ > std::chrono::milliseconds(500)) {
    looked_ = now;
    std::error_code ignored;
    for (const std::filesystem::path& file : stop_files_)
      if (std::filesystem::exists(file, ignored)) reason_ = "the file " + file.string();
  }
  return !reason_.empty();
}

bool StopRequest::before_unit() {
  constexpr double reserve_s = 1.0;  // for the last flush to the disk
  if (requested()) return true;
  const auto now = Clock::now();
  const bool first = last_unit_ == Clock::time_point();
  if (!first) {
    longest_unit_s_ = std::max(longest_unit_s_, seconds_between(last_unit_, now));
    if (seconds_between(start_, now) + 2.0 * longest_unit_s_ + reserve_s > walltime_s_)
      reason_ = fmt::format("--walltime-s {:g}", walltime_s_);
  }
  last_unit_ = now;
  return !reason_.empty();
}

}  // namespace glissade::cli
