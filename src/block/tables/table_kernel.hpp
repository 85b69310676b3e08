// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "block/events/sliding_block.hpp"
#include "block/polynomial/linear_piece.hpp"
#include "block/polynomial/quartic_piece.hpp"
#include "block/slip_record/crossing_watch.hpp"
#include "block/tables/event_bounds.hpp"
#include "block/tables/scaled_block.hpp"
#include "glissade/block/peak_slip.hpp"
#include "glissade/core/finite.hpp"

namespace glissade::block_detail {

/// One history, event by event.
/// @tparam History NoHistory, or WatchHistory to see where it crosses thresholds
template <class Piece, class History>
class TableKernel {
 public:
  TableKernel(const RoofTable& roof, const Scaled& scene, EventSearch search,
              const History& history)
      : a_(*roof.horizontal),
        w_(roof.vertical.get()),
        a_nodes_(a_.at_nodes()),
        w_nodes_(w_ != nullptr ? w_->at_nodes() : MotionNodes()),
        scene_(scene),
        contact_(scene.block),
        lines_(scene.lines(contact_)),
        every_interval_(search == EventSearch::every_interval),
        step_s_(roof.step_s()),
        ends_with_record_(contact_.slides_at_rest() || (!contact_.stops_at_rest() && !a_.rigid())),
        last_(ends_with_record_ ? a_.ground->last_sample()
                                : std::max(a_.end, w_ != nullptr ? w_->end : 0)),
        bounds_(a_, w_, lines_, last_),
        history_(history),
        body_(contact_, scene.block.directions, history) {}

  SlipPeak run() {
    for (std::size_t i = 0; i < last_;) {
      if (body_.direction() == 0 && !every_interval_) i = bounds_.next_exit(i);
      if (i < last_) i = may_lift_in(i) ? lifted(i) : events(i);
    }
    const bool lifted_at_end = lines_.lift.at(roof(last_)) > 0.0;
    bool stops = false;
    if (!ends_with_record_) {
      // To zero over one more interval, where the tables do not end at zero.
      const Roof end = scaled(roof(last_));
      body_.be_at(time(last_));
      if (end.a != 0.0 || end.w != 0.0) body_.interval(step_s_, time(last_ + 1), end, Roof{});
      stops = body_.coast(step_s_);
    }
    SlipPeak result = body_.result(contact_.cos_slope());
    result.uplift = result.uplift || lifted_at_end;
    result.free_sliding = !stops;
    return result;
  }

 private:
  static constexpr bool linear = std::is_same_v<Piece, LinearPiece>,
                        watched = std::is_same_v<History, WatchHistory>;

  struct Moment {
    std::size_t interval;
    double tau;  ///< fraction of it that has passed
  };

  /// At node i, untouched by sign and ratio.
  Roof roof(std::size_t i) const {
    return {a_nodes_.acceleration_mps2(i), w_ != nullptr ? w_nodes_.acceleration_mps2(i) : 0.0};
  }
  double time(std::size_t i) const { return step_s_ * static_cast<double>(i); }
  Roof scaled(Roof r) const { return {scene_.a_sign * r.a, scene_.w_ratio * r.w}; }

  static int index(int direction) { return direction > 0 ? 0 : 1; }

  /// The roof's acceleration in the interval after node i, and a line of it.
  typename Piece::Interval interval(std::size_t i) const;
  Piece piece(const DriveLine& drive, std::size_t i) const { return {drive, interval(i), step_s_}; }

  bool may_lift_in(std::size_t i) const {
    return bounds_.may_lift() && piece(lines_.lift, i).may_be_positive();
  }

  // -- events

  /// From node i, at rest or sliding, until the block is at rest at a node or may lift. Returns
  /// the node.
  std::size_t events(std::size_t i) {
    Moment now{i, 0.0};
    if (body_.direction() != 0) now = slide_on({body_.speed(), 0.0, 0.0}, i);
    int stopped = 0;
    // A drive is a quartic at most, so starts and stops in an interval are few: the bound only
    // guards against rounding.
    for (int in_interval = 0; body_.direction() == 0; ++in_interval) {
      if (in_interval == 16) throw NotConverged("peak_slip: too many events inside one interval");
      if (now.interval >= last_) return last_;
      const std::size_t here = now.interval;
      if (now.tau >= 1.0 || !start(now, stopped)) return here + 1;
      stopped = body_.direction();
      now = slide(now);
      if (now.interval != here) in_interval = 0;
    }
    return now.interval;
  }

  /// From rest at `now`: the block begins to slide, now or later in the interval. `stopped` is the
  /// direction it has just stopped sliding in: that drive is not positive, whatever rounding says.
  bool start(Moment& now, int stopped) {
    const typename Piece::Interval here = interval(now.interval);
    double first = 1.0;
    int direction = 0;
    // The drive it did not stop under first: the two are never positive at once, so where that one
    // is positive already the other is not examined.
    for (const int candidate : {stopped > 0 ? -1 : 1, stopped > 0 ? 1 : -1}) {
      if (index(candidate) >= lines_.directions) continue;
      Piece& drive = rest_[index(candidate)];
      drive.set(lines_.drive[index(candidate)], here, step_s_);
      if (now.tau > 0.0) drive.keep_after(now.tau);
      if (candidate == stopped) drive.begin_at_most_zero();
      const double rise = drive.rise();
      if (rise < first) {
        first = rise;
        direction = candidate;
        if (first == 0.0) break;
      }
    }
    if (direction == 0) return false;
    Piece& own = rest_[index(direction)];
    if (first > 0.0) {
      own.keep_after(first);
      own.begin_at_zero();  // exactly on its threshold: no spurious stop
    }
    now.tau += first * (1.0 - now.tau);
    body_.start(direction);
    return true;
  }

  /// Slides from rest at `now`, under rest_, to the end of the phase, or to the node where it is
  /// still sliding and the search ends.
  Moment slide(const Moment& now) {
    const Piece& own = rest_[index(body_.direction())];
    if (const double tau = own.stop(0.0); tau != never) {
      const SlideState from{time(now.interval) + now.tau * step_s_, body_.slip(), 0.0,
                            body_.direction()};
      body_.slid(own.travel(tau), tau * own.length_s, 0.0);
      if constexpr (watched) {
        const double end = from.time + tau * own.length_s;
        history_.watch->slides(from, own, tau, {end, body_.slip(), 0.0, from.direction});
      }
      body_.stop();
      return {now.interval, now.tau + tau * (1.0 - now.tau)};
    }
    return slide_on({own.gain(1.0), own.travel(1.0), own.length_s}, now.interval + 1);
  }

  /// At the reference node of a phase.
  struct Reference {
    double speed, distance, duration;
  };

  /// Slides on from node r.
  Moment slide_on(const Reference& ref, std::size_t r) {
    const int k = index(body_.direction());
    const DriveLine& drive = lines_.drive[k];
    const double v_a = a_nodes_.velocity_mps(r),
                 v_w = w_ != nullptr ? w_nodes_.velocity_mps(r) : 0.0;
    const auto speed = [&](std::size_t i) {
      double v = ref.speed + drive.a * (a_nodes_.velocity_mps(i) - v_a);
      if (w_ != nullptr) v += drive.w * (w_nodes_.velocity_mps(i) - v_w);
      return std::max(0.0, v + drive.constant * step_s_ * static_cast<double>(i - r));
    };
    const auto distance = [&](std::size_t i) {
      const double t = step_s_ * static_cast<double>(i - r);
      double s = ref.speed * t + drive.a * (a_nodes_.displacement_from_m(r, i) - v_a * t);
      if (w_ != nullptr) s += drive.w * (w_nodes_.displacement_from_m(r, i) - v_w * t);
      return ref.distance + (s + 0.5 * drive.constant * t * t);
    };
    const auto duration = [&](std::size_t i, double tau) {
      return ref.duration + step_s_ * (static_cast<double>(i - r) + tau);
    };
    // After body_.slid(), at the fraction tau of the interval after node i.
    const auto watch = [&, slip = body_.slip(), direction = body_.direction()](std::size_t i,
                                                                               double tau) {
      if constexpr (watched) {
        if (!history_.watch->passes(body_.slip())) return;
        const auto state = [&](std::size_t node) -> SlideState {
          return {time(node), slip + direction * distance(node), speed(node), direction};
        };
        if (ref.duration > 0.0) {
          const SlideState from{time(r) - ref.duration, slip, 0.0, direction};
          history_.watch->slides(from, rest_[k], 1.0, state(r));
        }
        history_.watch->slides(r, i, state, [&](std::size_t node) { return piece(drive, node); },
                               tau,
                               {time(i) + tau * step_s_, body_.slip(), body_.speed(), direction});
      }
    };
    const auto still_sliding = [&](std::size_t i) -> Moment {
      body_.slid(distance(i), duration(i, 0.0), speed(i));
      watch(i, 0.0);
      return {i, 0.0};
    };

    bounds_.set_reference(k, r, ref.speed, v_a, v_w);
    for (std::size_t i = r; i < last_; ++i) {
      if (!every_interval_) i = bounds_.next_stop(k, i);
      if (i == last_) break;
      if (may_lift_in(i)) return still_sliding(i);
      const Piece p = piece(drive, i);
      const double v = speed(i);
      if (const double tau = p.stop(v); tau != never) {
        body_.slid(distance(i) + v * p.length_s * tau + p.travel(tau), duration(i, tau), 0.0);
        watch(i, tau);
        body_.stop();
        return {i, tau};
      }
    }
    return still_sliding(last_);
  }

  /// An interval in which the block may lift: the roof motion linear over 64ths of it.
  std::size_t lifted(std::size_t i);

  const MotionTable& a_;
  const MotionTable* w_;  ///< null: no vertical
  MotionNodes a_nodes_, w_nodes_;
  Scaled scene_;
  Contact contact_;
  Lines lines_;
  bool every_interval_;
  double step_s_;
  /// Friction never stops it: it is reported where it is at the record's last sample. On a rigid
  /// roof at critical friction nothing moves after that but the block.
  bool ends_with_record_;
  std::size_t last_;  ///< node
  EventBounds bounds_;
  History history_;
  SlidingBlock<History> body_;
  Piece rest_[2] = {};  ///< the drives over what is left of the interval
};

template <class Piece, class History>
typename Piece::Interval TableKernel<Piece, History>::interval(std::size_t i) const {
  if constexpr (linear) {
    return {roof(i), roof(i + 1)};
  } else {
    if (w_ == nullptr) return {a_nodes_.acceleration_after(i), {}, false};
    return {a_nodes_.acceleration_after(i), w_nodes_.acceleration_after(i), true};
  }
}

template <class Piece, class History>
std::size_t TableKernel<Piece, History>::lifted(std::size_t i) {
  body_.be_at(time(i));
  if constexpr (linear) {
    body_.interval(step_s_, time(i + 1), scaled(roof(i)), scaled(roof(i + 1)));
  } else {
    constexpr int pieces = 64;
    const auto [a_after, w_after, vertical] = interval(i);
    const QuarticPiece a(a_after, step_s_), w(w_after, step_s_);
    Roof left = scaled({a.at(0.0), vertical ? w.at(0.0) : 0.0});
    for (int k = 1; k <= pieces; ++k) {
      const double tau = static_cast<double>(k) / pieces;
      const Roof right = scaled({a.at(tau), vertical ? w.at(tau) : 0.0});
      body_.interval(step_s_ / pieces, time(i) + tau * step_s_, left, right);
      left = right;
    }
  }
  return i + 1;
}

/// peak_slip() with a history that records the events.
template <class History>
SlipPeak walk_events(const RoofTable& roof, const Block& block, const MotionFactors& factors,
                     EventSearch search, const History& history) {
  require_block(block);
  require_acceleration({factors.horizontal[0], factors.vertical}, "the factors");
  const Scaled scene(block, factors);
  const bool linear = roof.horizontal->rigid() && (!roof.vertical || roof.vertical->rigid());
  return in_metres(linear ? TableKernel<LinearPiece, History>(roof, scene, search, history).run()
                          : TableKernel<QuarticPiece, History>(roof, scene, search, history).run(),
                   scene.factor);
}

}  // namespace glissade::block_detail
