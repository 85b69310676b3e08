// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "glissade/core/file.hpp"
#include "mpi/mpirun.hpp"

namespace glissade::test {

/// Seconds of a run by phase, in order, as its run.json states them.
struct TimedRun {
  std::vector<std::pair<std::string, double>> phases;

  double total_s() const {
    double sum = 0.0;
    for (const auto& [phase, seconds] : phases) sum += seconds;
    return sum;
  }
  double of(const std::string& name) const {
    const auto found = std::ranges::find(phases, name, &std::pair<std::string, double>::first);
    if (found == phases.end()) throw std::runtime_error("run.json has no phase " + name);
    return found->second;
  }
};

/// The quickest of some runs.
inline TimedRun quickest_run(const std::filesystem::path& study, int ranks, int tries) {
  TimedRun quickest;
  for (int i = 0; i < tries; ++i) {
    const ScratchFolder folder;
    const std::string out = folder.path("run").string();
    const Finished run = run_on(ranks, {"run", study.string(), "--out", out});
    if (run.status != 0) throw std::runtime_error(run.err);
    const auto stated = nlohmann::ordered_json::parse(read_text_file(out + "/run.json"));
    TimedRun timed;
    for (const auto& [phase, s] : stated.at("seconds").items())
      timed.phases.emplace_back(phase, s.get<double>());
    if (i == 0 || timed.total_s() < quickest.total_s()) quickest = std::move(timed);
  }
  return quickest;
}

}  // namespace glissade::test
