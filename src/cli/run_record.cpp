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

}  // namespace

std::string started_json(const std::string& study_name, const std::string& plan_hash) {
  const nlohmann::ordered_json json{{"study", study_name},
                                    {"plan_hash", plan_hash},
                                    {"status", "started"},
                                    {"started_utc", now_utc()},
                                    {"host", host_name()}};
  return json.dump(2) + "\n";
}

std::string run_json(const Results& results, const std::vector<Skip>& skips,
                     const PhaseClock& clock, int ranks, const WorkCount& count) {
  nlohmann::ordered_json json;
  json["study"] = results.study_name;
  json["plan_hash"] = results.plan_hash;
  json["program_version"] = results.program_version;
  json["status"] = "finished";
  json["finished_utc"] = now_utc();
  json["host"] = host_name();
  json["ranks"] = ranks;
  json["histories_integrated"] = count.integrated + count.searched;
  json["histories_at_levels"] = count.integrated;
  json["histories_in_search"] = count.searched;
  json["roof_motions"] = count.roofs;
  for (const auto& [phase, seconds] : clock.phases()) json["seconds"][phase] = seconds;
  json["skipped"] = nlohmann::ordered_json::array();
  for (const Skip& skip : skips)
    json["skipped"].push_back({{"what", skip.what}, {"why", skip.why}, {"count", skip.count}});
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
