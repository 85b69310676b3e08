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
std::vector<char> done_units(const UnitRun& run) {
  std::vector<char> done(run.plan.units.size(), 1);
  for (const std::size_t unit : units_of(run.plan, run.part))
    done[unit] = run.at_root && run.at_root->histories.has(unit) ? 1 : 0;
  run.world.broadcast(done);
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

/// What a rank does of the run.
class Rank {
 public:
  explicit Rank(UnitRun& run)
      : run_(run),
        done_(done_units(run)),
        missing_in_all_(static_cast<std::uint64_t>(std::ranges::count(done_, 0))),
        wanted_((run.at_root ? run.at_root->units : 0) + missing_in_all_),
        motion_parts_left_(run.part.is_all() ? motion_part_count(run.plan) : 0),
        roofs_(run.plan, run.skipping),
        progress_(missing_in_all_, run.plan.histories() * missing_in_all_ / run.plan.units.size()) {
  }

  /// With the motion parts that are left, which the analyses need and a part of the plan has not.
  void share_block(std::size_t block) {
    missing_ = longest_first(run_.plan, block);
    std::erase_if(missing_, [&](std::size_t unit) { return done_[unit] != 0; });
    mine_ = 0;
    const std::uint64_t done_earlier = run_.at_root ? run_.at_root->units : 0;
    self_schedule(
        run_.world, motion_parts_left_ + missing_.size(),
        [&](std::uint64_t i) {
          if (i < motion_parts_left_)
            my_motion_parts_.put(i).put(motion_part(run_.plan, i));
          else
            run_unit(i - motion_parts_left_);
        },
        [&] { return has_begun_ ? run_.stop.before_unit() : run_.stop.requested(); });
    motion_parts_left_ = 0;
    together(run_.world, [&] { keeping_units(run_.folder, [&] { run_.journal.sync(); }); });
    if (run_.world.is_root()) progress_.finish();
    end_if_stopped(done_earlier);
    run_.world.collect(
        mine_, [&] { return run_.journal.read_next(); },
        [&](const std::vector<char>& unit) { run_.at_root->add(unpack_unit_result(unit)); });
    if (run_.at_root) run_.at_root->sampling.end_block();
    in_blocks_before_ += missing_.size();
  }

  void collect_motion_parts() {
    const std::size_t count = motion_part_count(run_.plan);
    auto numbers = numbered_parts(count, run_.world.gather(my_motion_parts_.take()));
    const double other_ranks_mb = largest_of_others_mb(run_.world);
    if (!run_.at_root) return;
    for (std::size_t i = 0; i < count; ++i)
      if (numbers[i].empty()) numbers[i] = motion_part(run_.plan, i);  // it was to stop, all done
    run_.at_root->motion_parts = std::move(numbers);
    run_.at_root->other_ranks_mb = other_ranks_mb;
  }

 private:
  /// @param i of those that are missing of the block
  void run_unit(std::uint64_t i) {
    if (!std::exchange(has_begun_, true)) run_.stop.before_unit();  // the first is always begun
    const UnitResult unit = execute(run_.plan, missing_[i], roofs_);
    keeping_units(run_.folder, [&] { run_.journal.append(unit); });
    ++mine_;
    if (!run_.at_root) return;
    run_.at_root->add(unit);
    // Units go out in order: those before are done or under way.
    progress_.update(in_blocks_before_ + i);
  }

  /// Ends the run on all ranks where they have not done all that was missing of the block.
  void end_if_stopped(std::uint64_t done_earlier) {
    const auto messages = run_.world.gather(ByteWriter().put(mine_).put(run_.stop.reason()).take());
    on_root(run_.world, [&] {
      std::uint64_t done = 0;
      std::string reason;
      for (const std::vector<char>& message : messages) {
        std::uint64_t units = 0;
        std::string of_rank;
        ByteReader(message).get(units).get(of_rank);
        done += units;
        if (reason.empty()) reason = of_rank;
      }
      if (done < missing_.size()) end_stopped(run_.folder, reason, done_earlier + done, wanted_);
    });
  }

  UnitRun& run_;
  std::vector<char> done_;  ///< by unit, at the begin
  std::uint64_t missing_in_all_, wanted_;
  std::size_t motion_parts_left_;
  RoofStore roofs_;
  Progress progress_;
  ByteWriter my_motion_parts_;
  std::vector<std::size_t> missing_;               ///< units of this block
  std::uint64_t mine_ = 0, in_blocks_before_ = 0;  ///< units
  bool has_begun_ = false;                         ///< a unit
};

}  // namespace

void UnitRun::run() {
  Rank rank(*this);
  for (std::size_t block = 0; block < plan.unit_ends.size(); ++block) {
    rank.share_block(block);
    if (root_says(world, [&] { return at_root->sampling.is_enough(); })) break;
  }
  if (part.is_all()) rank.collect_motion_parts();
}

}  // namespace glissade::cli
