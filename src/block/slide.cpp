// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/slide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "contact.hpp"
#include "glissade/core/contract.hpp"

namespace glissade {
namespace {

using block_detail::Contact;
using block_detail::Drive;
using block_detail::Roof;

/// A function linear in time over what is left of a piece of a sample interval.
struct Line {
  double value = 0.0, rate = 0.0;
  double end = 0.0;  ///< at the piece's end, exactly
  double at(double t) const { return value + rate * t; }
};

/// When a speed u0 >= 0 under the acceleration `drive` first returns to zero within `length`, if it
/// does: the smaller positive root of u0 + value t + rate t^2 / 2, where the speed is falling.
std::optional<double> time_to_stop(double u0, const Line& drive, double length) {
  const double n = drive.value, k = drive.rate;
  const double discriminant = n * n - 2.0 * k * u0;
  const bool turns_inside =
      k > 0.0 && n < 0.0 && -n < k * length;  // the speed has its minimum inside
  if (turns_inside ? discriminant <= 0.0 : u0 + length * (n + 0.5 * k * length) > 0.0)
    return std::nullopt;
  if (n >= 0.0 && k >= 0.0) return std::nullopt;  // never slows down
  if (u0 == 0.0 && n <= 0.0) return 0.0;          // it was about to start, and is held after all
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double t =
      n <= 0.0 ? 2.0 * u0 / (root - n) : (root + n) / -k;  // the form without cancellation
  return std::min(t, length);
}

/// Ignores the history: slide() without one compiles to nothing here.
struct NoHistory {
  void operator()(double, double, double) const {}
};

/// Integrates one block over pieces of time in which the drives are linear.
template <class History>
class SlidingBlock {
 public:
  SlidingBlock(SlipDirections directions, History history)
      : directions_(directions), history_(history) {}

  bool sliding() const { return direction_ != 0; }
  double time() const { return time_; }

  /// Time passes and the block stays where it is.
  void rest_until(double time) {
    time_ = time;
    history_(time_, slip_, 0.0);
  }

  /// From now to piece_end, `length` later, the drives go linearly from `begin` to `end`.
  void advance(double length, double piece_end, const Drive& begin, const Drive& end) {
    Line down{begin.down, (end.down - begin.down) / length, end.down};
    Line up{begin.up, (end.up - begin.up) / length, end.up};
    if (directions_ == SlipDirections::downslope_only) up = {-1.0, 0.0, -1.0};

    double left = length;
    // Starts and stops inside a piece number a few (each drive is linear, so each direction starts
    // and stops at most twice); the bound only guards against rounding.
    for (int events = 0; events < 16; ++events) {
      if (direction_ == 0 && !start(down, up, left)) return rest_until(piece_end);
      Line& own = direction_ > 0 ? down : up;
      const std::optional<double> stop = time_to_stop(speed_, own, left);
      if (!stop) {
        slide_for(left, own);
        time_ = piece_end;
        return history_(time_, slip_, direction_ * speed_);
      }
      slide_for(*stop, own);
      shift(down, up, *stop);
      own.value = std::min(own.value, 0.0);  // it stopped, so its drive is not positive
      left -= *stop;
      end_phase();
      if (!(left > 0.0)) return rest_until(piece_end);
    }
    throw std::logic_error("slide: too many events inside one sample interval");
  }

  /// No more roof motion: slides on under constant deceleration until it stops. False if it never
  /// does.
  bool coast(const Drive& at_rest, double dt) {
    if (direction_ == 0) return true;
    const double drive = direction_ > 0 ? at_rest.down : at_rest.up;
    if (drive >= 0.0) return false;
    while (direction_ != 0) {
      const double length = std::max(dt, 0.25 * speed_ / -drive);
      advance(length, time_ + length, at_rest, at_rest);
    }
    return true;
  }

  SlipResult result(double cos_slope) const {
    SlipResult r;
    r.peak_downslope_m = std::max(farthest_down_, slip_) * cos_slope;
    r.peak_upslope_m = -std::min(farthest_up_, slip_) * cos_slope + 0.0;  // + 0: no negative zero
    r.peak_displacement_m = std::max(r.peak_downslope_m, r.peak_upslope_m);
    r.residual_displacement_m = slip_ * cos_slope;
    r.peak_velocity_mps = peak_speed_ * cos_slope;
    r.slip_duration_s = duration_;
    r.slip_phases = phases_;
    return r;
  }

 private:
  /// From rest: begins to slide, now or later in the piece. Moves time to the start.
  bool start(Line& down, Line& up, double& left) {
    const auto start_time = [left](const Line& drive) -> std::optional<double> {
      if (drive.value > 0.0) return 0.0;
      if (!(drive.end > 0.0 && drive.rate > 0.0)) return std::nullopt;
      const double wait = -drive.value / drive.rate;
      if (wait < left) return wait;
      return std::nullopt;  // within rounding of the piece's end: the next piece starts it
    };
    const std::optional<double> down_start = start_time(down), up_start = start_time(up);
    if (!down_start && !up_start) return false;
    direction_ = down_start && (!up_start || *down_start <= *up_start) ? 1 : -1;
    const double wait = direction_ > 0 ? *down_start : *up_start;
    if (wait > 0.0) {
      shift(down, up, wait);
      (direction_ > 0 ? down : up).value = 0.0;  // exactly on its threshold: no spurious stop
      left -= wait;
    }
    time_ += wait;
    ++phases_;
    history_(time_, slip_, 0.0);
    return true;
  }

  static void shift(Line& down, Line& up, double t) {
    down.value = down.at(t);
    up.value = up.at(t);
  }

  void slide_for(double t, const Line& drive) {
    const double end_drive = drive.at(t);
    const double end_speed = speed_ + t * (drive.value + 0.5 * drive.rate * t);
    const double fastest = drive.value > 0.0 && end_drive < 0.0
                               ? speed_ - 0.5 * drive.value * drive.value / drive.rate
                               : std::max(speed_, end_speed);
    slip_ += direction_ * (t * (speed_ + t * (0.5 * drive.value + drive.rate * t / 6.0)));
    peak_speed_ = std::max(peak_speed_, fastest);
    speed_ = std::max(end_speed, 0.0);
    duration_ += t;
    time_ += t;
  }

  void end_phase() {
    direction_ = 0;
    speed_ = 0.0;
    farthest_down_ = std::max(farthest_down_,
                              slip_);  // slip is monotone inside a phase: peaks are at phase ends
    farthest_up_ = std::min(farthest_up_, slip_);
    history_(time_, slip_, 0.0);
  }

  SlipDirections directions_;
  History history_;
  int direction_ = 0;   // +1 sliding down, -1 up, 0 at rest
  double speed_ = 0.0;  // |v| along the slope
  double slip_ = 0.0;   // along the slope, down positive
  double time_ = 0.0;
  double farthest_down_ = 0.0, farthest_up_ = 0.0, peak_speed_ = 0.0, duration_ = 0.0;
  std::size_t phases_ = 0;
};

/// The number of samples up to the last that is not zero, at least one.
std::size_t without_trailing_zeros(const RoofAcceleration& roof) {
  std::size_t n = roof.horizontal_mps2.size();
  while (n > 1 && roof.horizontal_mps2[n - 1] == 0.0 &&
         (roof.vertical_mps2.empty() || roof.vertical_mps2[n - 1] == 0.0)) {
    --n;
  }
  return n;
}

template <class History>
SlipResult slide_with(const RoofAcceleration& roof, const Block& block, History history) {
  GLISSADE_EXPECTS(roof.dt_s > 0.0 && !roof.horizontal_mps2.empty());
  GLISSADE_EXPECTS(roof.vertical_mps2.empty() ||
                   roof.vertical_mps2.size() == roof.horizontal_mps2.size());
  GLISSADE_EXPECTS(block.friction >= 0.0 && std::abs(block.slope_rad) < std::numbers::pi / 2);

  // A surface that falls toward -x is the mirror image of one that falls toward +x.
  const double mirror = block.slope_rad < 0.0 ? -1.0 : 1.0;
  const Contact contact(block, std::abs(block.slope_rad));
  const double a_factor = mirror * roof.horizontal_factor, w_factor = roof.vertical_factor;
  const auto sample = [&](std::size_t i) {
    return Roof{a_factor * roof.horizontal_mps2[i],
                roof.vertical_mps2.empty() ? 0.0 : w_factor * roof.vertical_mps2[i]};
  };
  const auto may_rest = [&](const Roof& r) {
    const Drive drive = contact.sliding(r);
    return drive.down <= 0.0 &&
           (drive.up <= 0.0 || block.directions == SlipDirections::downslope_only) &&
           contact.normal(r) >= 0.0;
  };

  SlidingBlock<History> body(block.directions, history);
  bool uplift = false;
  // One sample interval, ending at time `end`.
  const auto step = [&](double end, const Roof& r0, const Roof& r1) {
    const double n0 = contact.normal(r0), n1 = contact.normal(r1);
    if (n0 >= 0.0 && n1 >= 0.0)
      return body.advance(roof.dt_s, end, contact.sliding(r0), contact.sliding(r1));
    uplift = true;
    const auto lifted = [&](double length, const Roof& from, const Roof& to) {
      body.advance(length, body.time() + length, contact.frictionless(from),
                   contact.frictionless(to));
    };
    if (n0 < 0.0 && n1 < 0.0) return lifted(roof.dt_s, r0, r1);
    // Contact is lost or found again where N passes through zero.
    const double share = n0 / (n0 - n1);
    const Roof touch{r0.a + share * (r1.a - r0.a), r0.w + share * (r1.w - r0.w)};
    const double before = share * roof.dt_s, after = (1.0 - share) * roof.dt_s;
    if (n0 < 0.0) {
      if (before > 0.0) lifted(before, r0, touch);
      if (after > 0.0) body.advance(after, end, contact.sliding(touch), contact.sliding(r1));
    } else {
      if (before > 0.0)
        body.advance(before, body.time() + before, contact.sliding(r0), contact.sliding(touch));
      if (after > 0.0) lifted(after, touch, r1);
    }
  };

  std::size_t n = roof.horizontal_mps2.size();
  if (!contact.slides_at_rest())
    n = without_trailing_zeros(roof);  // padding changes nothing, to the last bit
  Roof now = sample(0);
  bool rested = may_rest(now);
  for (std::size_t i = 1; i < n; ++i) {
    const Roof next = sample(i);
    const bool rests = may_rest(next);
    const double end = static_cast<double>(i) * roof.dt_s;
    if (rested && rests && !body.sliding()) {
      body.rest_until(end);  // both ends of the interval in the stick range, so all between
    } else {
      step(end, now, next);
    }
    now = next;
    rested = rests;
  }

  SlipResult result;
  if (contact.slides_at_rest()) {
    result = body.result(contact.cos_slope());
    result.free_sliding = true;
  } else {
    step(static_cast<double>(n) * roof.dt_s, now, Roof{});
    const bool stopped = body.coast(contact.sliding(Roof{}), roof.dt_s);
    result = body.result(contact.cos_slope());
    result.free_sliding = !stopped;
  }
  result.uplift = uplift || contact.normal(now) < 0.0;
  return result;
}

}  // namespace

SlipResult slide(const RoofAcceleration& roof, const Block& block) {
  return slide_with(roof, block, NoHistory{});
}

SlipResult slide(const RoofAcceleration& roof, const Block& block,
                 std::vector<SlipPoint>& history) {
  const double cos_slope = std::cos(block.slope_rad);
  history.assign(1, SlipPoint{});
  return slide_with(roof, block, [&](double time, double slip, double velocity) {
    history.push_back({time, slip * cos_slope, velocity * cos_slope});
  });
}

bool cannot_slip(const Block& block, double peak_horizontal_mps2, double peak_vertical_mps2) {
  const Contact contact(block, std::abs(block.slope_rad));
  for (const double a : {-peak_horizontal_mps2, peak_horizontal_mps2}) {
    for (const double w : {-peak_vertical_mps2, peak_vertical_mps2}) {
      const Drive drive = contact.sliding({a, w});
      if (drive.down > 0.0 || drive.up > 0.0 || contact.normal({a, w}) < 0.0) return false;
    }
  }
  return true;
}

double resting_deceleration_mps2(const Block& block) {
  const Contact contact(block, std::abs(block.slope_rad));
  return std::max(0.0, -contact.sliding({}).down);
}

double yield_acceleration_mps2(const Block& block) {
  const double slope = std::abs(block.slope_rad), phi = std::atan(block.friction);
  if (slope >= phi) return 0.0;
  const double down = block.gravity_mps2 * std::tan(phi - slope);
  const double up = slope + phi < std::numbers::pi / 2 ? block.gravity_mps2 * std::tan(slope + phi)
                                                       : std::numeric_limits<double>::infinity();
  return std::min(down, up);
}

}  // namespace glissade
