// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_units.hpp"

#include <algorithm>

#include "glissade/core/bytes.hpp"
#include "glissade/study/run/exchange.hpp"
#include "glissade/study/run/sampling_progress.hpp"
#include "run/progress.hpp"
#include "run/run_folder.hpp"

namespace glissade::cli {
namespace {

/// The units that no journal holds, on every rank.
std::vector<std::uint64_t> missing_units(const Plan& plan, const Journal& earlier,
                                         const Communicator& world) {
  std::vector<char> done(plan.units.size(), 0);
  for (const UnitResult& unit : earlier.units) done[unit.unit] = 1;
  world.broadcast(done);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t unit = 0; unit < done.size(); ++unit)
    if (done[unit] == 0) missing.push_back(unit);
  return missing;
}

/// Ends the run on all ranks where they have not done all of their `common` units.
void end_if_stopped(const Plan& plan, std::uint64_t done_earlier, std::uint64_t mine,
                    std::uint64_t common, const StopRequest& stop,
                    const std::filesystem::path& folder, const Communicator& world) {
  const auto messages = world.gather(ByteWriter().put(mine).put(stop.reason()).take());
  on_root(world, [&] {
    std::uint64_t done = 0;
    std::string reason;
    for (const std::vector<char>& message : messages) {
      std::uint64_t units = 0;
      std::string of_rank;
      ByteReader(message).get(units).get(of_rank);
      done += units;
      if (reason.empty()) reason = of_rank;
    }
    if (done < common) end_stopped(folder, reason, done_earlier + done, plan.units.size());
  });
}

/// Whether root has enough; the same on every rank.
bool agreed(bool is_enough, const Communicator& world) {
  std::vector<char> message(1, is_enough ? 1 : 0);
  world.broadcast(message);
  return message.front() != 0;
}

}  // namespace

std::vector<UnitResult> run_units(const Plan& plan, Skipping skipping, Journal earlier,
                                  JournalWriter writer, StopRequest& stop,
                                  const std::filesystem::path& folder, const Communicator& world) {
  const std::vector<std::uint64_t> missing = missing_units(plan, earlier, world);
  RoofStore roofs(plan, skipping);
  Progress progress(missing.size(), plan.histories() * missing.size() / plan.units.size());
  SamplingProgress sampling(plan);
  std::vector<UnitResult> all = std::move(earlier.units);
  auto first = missing.begin();
  for (const std::size_t end : plan.unit_ends) {
    const auto last = std::ranges::lower_bound(missing, end);
    const auto count = static_cast<std::uint64_t>(last - first);
    std::vector<UnitResult> mine;
    const auto work = [&](std::uint64_t i) {
      mine.push_back(execute(plan, first[static_cast<std::ptrdiff_t>(i)], roofs));
      keeping_units(folder, [&] { writer.append(mine.back()); });
      if (world.is_root())  // units go out in order: those before are done or under way
        progress.update(static_cast<std::uint64_t>(first - missing.begin()) + i);
    };
    self_schedule(world, count, work, [&] { return stop.before_unit(); });
    keeping_units(folder, [&] { writer.sync(); });
    if (world.is_root()) progress.finish();
    end_if_stopped(plan, all.size(), mine.size(), count, stop, folder, world);
    for (const std::vector<char>& part : world.gather(pack(mine))) {
      for (UnitResult& result : unpack_unit_results(part)) all.push_back(std::move(result));
    }
    if (world.is_root()) sampling.add_block(all);
    first = last;
    if (!agreed(sampling.is_enough(), world)) continue;
    std::erase_if(all, [end](const UnitResult& result) { return result.unit >= end; });
    break;
  }
  return all;
}

}  // namespace glissade::cli
