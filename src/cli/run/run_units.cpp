// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/run_units.hpp"

#include <algorithm>
#include <utility>

#include "glissade/core/bytes.hpp"
#include "glissade/study/run/exchange.hpp"
#include "glissade/study/run/motion_parts.hpp"
#include "run/progress.hpp"
#include "run/run_folder.hpp"
#include "run/run_record.hpp"

namespace glissade::cli {
namespace {

/// By unit: whether a journal holds it, or it is of another part. On every rank.
std::vector<char> done_units(const Plan& plan, const PlanPart& part, const RunHistories* all,
                             const Communicator& world) {
  std::vector<char> done(plan.units.size(), 1);
  for (const std::size_t unit : units_of(plan, part))
    done[unit] = all != nullptr && all->histories.has(unit) ? 1 : 0;
  world.broadcast(done);
  return done;
}

/// The largest memory of a rank other than root; on root.
double largest_of_others_mb(const Communicator& world) {
  const auto memories = world.gather(ByteWriter().put(peak_memory_mb()).take());
  double largest_mb = 0.0;
  for (std::size_t rank = 1; rank < memories.size(); ++rank) {
    double mb = 0.0;
    ByteReader(memories[rank]).get(mb);
    largest_mb = std::max(largest_mb, mb);
  }
  return largest_mb;
}

/// Ends the run of `all` units on all ranks where they have not done all of their `common` units.
void end_if_stopped(std::uint64_t all, std::uint64_t done_earlier, std::uint64_t mine,
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
    if (done < common) end_stopped(folder, reason, done_earlier + done, all);
  });
}

}  // namespace

void run_units(const Plan& plan, const PlanPart& part, Skipping skipping, RunHistories* all,
               JournalWriter writer, StopRequest& stop, const std::filesystem::path& folder,
               const Communicator& world) {
  const std::vector<char> done = done_units(plan, part, all, world);
  const auto missing_in_all = static_cast<std::uint64_t>(std::ranges::count(done, 0));
  const std::uint64_t wanted = (all != nullptr ? all->units : 0) + missing_in_all;
  RoofStore roofs(plan, skipping);
  Progress progress(missing_in_all, plan.histories() * missing_in_all / plan.units.size());
  ByteWriter my_motion_parts;
  // That are left; the analyses need them, which a part of the plan has not.
  std::size_t motion_parts = part.is_all() ? motion_part_count(plan) : 0;
  bool begun = false;        // a unit, on this rank
  std::uint64_t before = 0;  // units of blocks before
  for (std::size_t block = 0; block < plan.unit_ends.size(); ++block) {
    std::vector<std::size_t> missing = longest_first(plan, block);
    std::erase_if(missing, [&](std::size_t unit) { return done[unit] != 0; });
    std::uint64_t mine = 0;
    const auto work = [&](std::uint64_t i) {
      if (i < motion_parts) {
        my_motion_parts.put(i).put(motion_part(plan, i));
        return;
      }
      i -= motion_parts;
      if (!std::exchange(begun, true)) stop.before_unit();  // the first unit is always begun
      const UnitResult unit = execute(plan, missing[i], roofs);
      keeping_units(folder, [&] { writer.append(unit); });
      ++mine;
      if (all == nullptr) return;
      all->add(unit);
      progress.update(before + i);  // units go out in order: those before are done or under way
    };
    const std::size_t units_before = all != nullptr ? all->units : 0;
    self_schedule(world, motion_parts + missing.size(), work,
                  [&] { return begun ? stop.before_unit() : stop.requested(); });
    motion_parts = 0;
    together(world, [&] { keeping_units(folder, [&] { writer.sync(); }); });
    if (world.is_root()) progress.finish();
    end_if_stopped(wanted, units_before, mine, missing.size(), stop, folder, world);
    world.collect(
        mine, [&] { return writer.read_next(); },
        [&](const std::vector<char>& unit) { all->add(unpack_unit_result(unit)); });
    if (all != nullptr) all->sampling.end_block();
    before += missing.size();
    if (root_says(world, [&] { return all->sampling.is_enough(); })) break;
  }
  if (!part.is_all()) return;
  auto numbers = numbered_parts(motion_part_count(plan), world.gather(my_motion_parts.take()));
  const double other_ranks_mb = largest_of_others_mb(world);
  if (all == nullptr) return;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i].empty()) numbers[i] = motion_part(plan, i);  // it was to stop, and all was done
  all->motion_parts = std::move(numbers);
  all->other_ranks_mb = other_ranks_mb;
}

}  // namespace glissade::cli
