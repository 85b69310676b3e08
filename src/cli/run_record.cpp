// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_record.hpp"

#include <fmt/chrono.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

namespace glissade::cli {

void PhaseClock::end_phase(const std::string& name) {
  const auto now = std::chrono::steady_clock::now();
  phases_.emplace_back(name, std::chrono::duration<double>(now - last_).count());
  last_ = now;
}

namespace {

std::string host_name() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return host.data();
}

std::string now_utc() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

using Json = nlohmann::ordered_json;

struct RunHead {
  std::string study, plan_hash, program_version;
};

/// How every finished run.json begins.
Json finished(const RunHead& head, int ranks) {
  return {{"study", head.study},
          {"plan_hash", head.plan_hash},
          {"program_version", head.program_version},
          {"status", "finished"},
          {"finished_utc", now_utc()},
          {"host", host_name()},
          {"ranks", ranks}};
}

void add_phases(Json& json, const PhaseClock& clock) {
  for (const auto& [phase, seconds] : clock.phases()) json["seconds"][phase] = seconds;
}

}  // namespace

std::string started_json(const std::string& study_name, const std::string& plan_hash) {
  const Json json{{"study", study_name},
                  {"plan_hash", plan_hash},
                  {"status", "started"},
                  {"started_utc", now_utc()},
                  {"host", host_name()}};
  return json.dump(2) + "\n";
}

std::string run_json(const Results& results, const std::vector<Skip>& skips,
                     const PhaseClock& clock, int ranks, const WorkCount& count) {
  Json json = finished({results.study_name, results.plan_hash, results.program_version}, ranks);
  json["histories_integrated"] = count.integrated + count.searched;
  json["histories_at_levels"] = count.integrated;
  json["histories_in_search"] = count.searched;
  json["roof_motions"] = count.roofs;
  add_phases(json, clock);
  json["skipped"] = Json::array();
  for (const Skip& skip : skips)
    json["skipped"].push_back({{"what", skip.what}, {"why", skip.why}, {"count", skip.count}});
  return json.dump(2) + "\n";
}

std::string run_json(const ClearanceResults& results, std::uint64_t histories,
                     const PhaseClock& clock, int ranks) {
  Json json = finished({results.study_name, results.plan_hash, results.program_version}, ranks);
  json["histories_integrated"] = histories;
  add_phases(json, clock);
  return json.dump(2) + "\n";
}

std::vector<Skip> skips_in(const std::filesystem::path& run_json_file) {
  std::vector<Skip> skips;
  std::ifstream in(run_json_file);
  const auto json = nlohmann::json::parse(in, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || !json.contains("skipped")) return skips;
  for (const auto& skip : json["skipped"]) {
    skips.push_back(
        {skip.value("what", ""), skip.value("why", ""), skip.value("count", std::uint64_t{0})});
  }
  return skips;
}

}  // namespace glissade::cli
