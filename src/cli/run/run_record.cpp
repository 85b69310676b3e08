// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_record.hpp"

#include <fmt/chrono.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/input_file.hpp"
#include "shared/put.hpp"

namespace glissade::cli {

std::string now_utc() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

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

using Json = nlohmann::ordered_json;

constexpr std::array state_names = {
    "", "started", "stopped", "part finished", "results written, report missing", "finished"};

void add_phases(Json& json, const PhaseClock& clock) {
  for (const auto& [phase, seconds] : clock.phases()) json["seconds"][phase] = seconds;
}

}  // namespace

Json read_run_json(const std::filesystem::path& run_json_file) {
  constexpr std::uintmax_t most_bytes = 1u << 20;
  constexpr int most_depth = 16;  // JSON is copied and freed by recursion
  if (!std::filesystem::is_regular_file(status_of(run_json_file)) ||
      InputFile(run_json_file).size() > most_bytes)
    return {};
  Json json = Json::parse(
      read_text_file(run_json_file),
      [](int depth, Json::parse_event_t, Json&) { return depth <= most_depth; },
      /*allow_exceptions=*/false);
  return json.is_object() ? json : Json();
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;
}

std::string started_json(const std::string& study_name, const std::string& plan_hash) {
  const Json json{{"study", study_name},
                  {"plan_hash", plan_hash},
                  {"status", name_of(RunState::started)},
                  {"started_utc", now_utc()},
                  {"host", host_name()}};
  return json_text(json);
}

std::string run_json(const Results& results, const std::vector<Skip>& skips,
                     const PhaseClock& clock, int ranks, const WorkCount& count,
                     std::uint64_t resumed, double other_ranks_mb, const std::string& what_to_do) {
  Json json{{"study", results.study_name},
            {"plan_hash", results.plan_hash},
            {"program_version", results.program_version},
            {"status", name_of(what_to_do.empty() ? RunState::finished : RunState::unreported)},
            {"finished_utc", now_utc()},
            {"host", host_name()},
            {"ranks", ranks}};
  if (!what_to_do.empty()) json["what_to_do"] = what_to_do;
  json["histories_integrated"] = count.integrated + count.searched;
  json["histories_at_levels"] = count.integrated;
  json["histories_in_search"] = count.searched;
  json["histories_not_converged"] = count.failed;
  json["histories_from_curve"] = count.from_curve;
  json["roof_motions"] = count.roofs;
  json["units_of_earlier_sessions"] = resumed;
  add_phases(json, clock);
  json["peak_memory_mb"]["first_rank"] = peak_memory_mb();
  if (other_ranks_mb > 0.0) json["peak_memory_mb"]["largest_of_others"] = other_ranks_mb;
  json["warnings"] = texts_of(results.warnings);
  for (const SuiteSummary& suite : results.suites)
    json["design_target"][suite.name] = suite.target.empty() ? Json() : Json(suite.target);
  if (results.reached_target) {
    const ReachedTarget& target = *results.reached_target;
    json["sampling_target"] = {{"target_error", target.target_error},
                               {"error", target.error},  // null: a median has no fit
                               {"is_reached", target.is_reached()},
                               {"scrambles", target.scrambles},
                               {"most_scrambles", target.most_scrambles},
                               {"samples", results.cases.samples}};
  }
  if (results.clearance) {
    const auto [least, most] =
        std::ranges::minmax(results.clearance->required, {}, &RequiredClearance::clearance_m);
    json["required_clearance"] = {{"orientation", to_string(results.clearance->orientation)},
                                  {"factor", results.clearance->factor},
                                  {"smallest_m", least.clearance_m},
                                  {"largest_m", most.clearance_m}};
  }
  json["skipped"] = Json::array();
  for (const Skip& skip : skips)
    json["skipped"].push_back({{"what", skip.what}, {"why", skip.why}, {"count", skip.count}});
  return json_text(json);
}

namespace {

std::string text_in(const std::filesystem::path& run_json_file, const char* key) {
  const Json json = read_run_json(run_json_file);
  const Json value = json.is_object() ? json.value(key, Json()) : Json();
  return value.is_string() ? value.get<std::string>() : "";
}

}  // namespace

const char* name_of(RunState state) { return state_names[static_cast<std::size_t>(state)]; }

RunState state_in(const std::filesystem::path& run_json_file) {
  const auto name = std::ranges::find(state_names, text_in(run_json_file, "status"));
  return name == state_names.end() ? RunState::none
                                   : static_cast<RunState>(name - state_names.begin());
}

bool has_results(RunState state) {
  return state == RunState::finished || state == RunState::unreported;
}

void put_state(const std::filesystem::path& run_json_file, RunState state, const Json& more) {
  Json json = read_run_json(run_json_file);
  json["status"] = name_of(state);
  json.update(more);
  write_text_file(run_json_file, json_text(json));
}

void put_reported(const std::filesystem::path& run_json_file) {
  Json json = read_run_json(run_json_file);
  json["status"] = name_of(RunState::finished);
  json["finished_utc"] = now_utc();
  json.erase("what_to_do");
  write_text_file(run_json_file, json_text(json));
}

std::string plan_hash_in(const std::filesystem::path& run_json_file) {
  return text_in(run_json_file, "plan_hash");
}

namespace {

Skip skip_in(const Json& entry, const std::function<InputError(std::string)>& refused) {
  const auto text = [&](const char* key) {
    const Json value = entry.value(key, Json());
    if (!value.is_string())
      throw refused(fmt::format("an entry of skipped has no text \"{}\"", key));
    return value.get<std::string>();
  };
  if (!entry.is_object()) throw refused("an entry of skipped is no object {}");
  const Json count = entry.value("count", Json());
  if (!count.is_number_unsigned())
    throw refused("an entry of skipped has no whole number \"count\" of 0 or more");
  return {text("what"), text("why"), count.get<std::uint64_t>()};
}

}  // namespace

std::vector<Skip> skips_in(const std::filesystem::path& run_json_file) {
  const auto refused = [&](const std::string& why) {
    return InputError({run_json_file.string(), "is not as glissade run writes it: " + why,
                       "remove it; the report then does not list what was skipped", ""});
  };
  if (!std::filesystem::exists(status_of(run_json_file))) return {};
  const Json json = read_run_json(run_json_file);
  if (!json.is_object()) throw refused("no JSON object {} of less than 1 MiB can be read");
  const Json skipped = json.value("skipped", Json());
  if (skipped.is_null() && json.value("status", Json()) != name_of(RunState::finished)) return {};
  if (!skipped.is_array()) throw refused("it has no list \"skipped\": []");
  std::vector<Skip> skips;
  for (const Json& entry : skipped) skips.push_back(skip_in(entry, refused));
  return skips;
}

}  // namespace glissade::cli
