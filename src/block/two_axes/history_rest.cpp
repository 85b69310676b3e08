// SPDX-License-Identifier: GPL-3.0-or-later
// A history while the block rests.
#include <algorithm>
#include <cmath>

#include "block/full_model/sdirk4.hpp"
#include "block/two_axes/roof/roof_at_rest.hpp"
#include "history.hpp"

namespace glissade::block_detail::two_axes {
LaneHistory::LaneHistory(const SceneConstants& constants, RoofKind roof, const GroundNodes& ground,
                         std::shared_ptr<const RestTable> table, const DistanceCrossings& crossings,
                         bool base_shear)
    : constants_(constants),
      ellipse_({constants.mu, constants.mu * constants.aspect}),
      roof_(roof),
      ground_(ground),
      table_(std::move(table)),
      crossings_(crossings),
      largest_a_(base_shear ? std::array{0.0, 0.0} : std::array{never, never}) {}

std::int64_t LaneHistory::rows() const {
  if (table_->rows.empty()) return 0;
  const auto bytes = [](const double* at) { return reinterpret_cast<std::intptr_t>(at); };
  return (bytes(table_->rows.data()) - bytes(ground_.nodes.data())) /
         static_cast<std::intptr_t>(sizeof(double));
}

LaneHistory::Next LaneHistory::begin(HistoryState& state) {
  state = resting_at(0, {});
  if (follows_shear() && !has_mass(roof_)) {
    RoofAtRest alone(constants_, roof_, ground_, *table_, state);
    raise_shear_to_end(alone, 0);
  }
  if (release(piece(state)) == 0.0) return start(state);
  return rest_from_node(state);
}

HistoryState LaneHistory::resting_at(std::int64_t node, const RoofState& state) const {
  const auto i = static_cast<std::size_t>(node);
  HistoryState s;
  s.node = node;
  s.motion.left = 1.0;
  s.motion.ground_1 = constants_.factor_1 * ground_.ground(0, i);
  s.motion.ground_2 = constants_.factor_2 * ground_.ground(1, i);
  s.motion.w = constants_.factor_w * ground_.vertical(i);
  s.set_roof(roof_, state);
  return s;
}

LaneHistory::Next LaneHistory::start(HistoryState& state) {
  LaneMotion<double>& m = state.motion;
  m.fastest = std::max(m.fastest, rounding_speed * ground_.dt_s * constants_.gravity);
  ++phases_;
  return go_on_from_rest(state);
}

/// By a step at whose end the load would not let the block rest: else it might not see it slide.
LaneHistory::Next LaneHistory::go_on_from_rest(HistoryState& state) const {
  LaneMotion<double>& m = state.motion;
  m.v_s = m.v_y = 0.0;
  m.forced = 1.0;
  const RoofPiece rest_of_interval = piece(state);
  double fraction = 1.0;
  while (fraction > shortest_start && ellipse_.may_rest(rest_of_interval.load(fraction)))
    fraction *= 0.5;
  m.trial = fraction * m.left;
  return Next::slides;
}

namespace {

struct Sample {
  double tau, value;
};

/// Where a function that is not positive at both ends, and leaves the chord over a part of length
/// tau by no more than bend tau^2, first rises above zero: its halves are searched in turn, down to
/// 1/256. Never: nowhere.
template <class Function>
double rise_above_chord(const Function& f, Sample low, Sample high, double bend) {
  constexpr double shortest = 1.0 / 256;
  const double length = high.tau - low.tau;
  if (std::max(low.value, high.value) + bend * length * length <= 0.0 || length <= shortest)
    return never;
  const double middle = 0.5 * (low.tau + high.tau), value = f(middle);
  if (value > 0.0) return rise_by_secant(f, low.value, value, low.tau, middle);
  const double left = rise_above_chord(f, low, {middle, value}, bend);
  return left < 1.0 ? left : rise_above_chord(f, {middle, value}, high, bend);
}

}  // namespace

/// The fraction of a piece after which the block no longer sticks, or
/// never.
double LaneHistory::release(const RoofPiece& piece) {
  uplift_ = uplift_ || piece.load(0.0).normal < 0.0 || piece.load(1.0).normal < 0.0;
  const auto excess = [&](double tau) { return -friction_reserve(piece.load(tau), constants_); };
  const double begin = excess(0.0), end = excess(1.0);
  constexpr double rounding = 1e-13;  // of gravity, in the load
  if (begin > rounding * constants_.gravity) return 0.0;
  if (end > 0.0) return rise_by_secant(excess, std::min(begin, 0.0), end);
  if (-std::max(begin, end) > piece.deviation()) return never;
  return rise_above_chord(excess, {0.0, std::min(begin, 0.0)}, {1.0, end}, piece.bend());
}

LaneHistory::Next LaneHistory::rest(HistoryState& state) {
  const RoofPiece rest_of_interval = piece(state);
  const double fraction = release(rest_of_interval);
  if (has_mass(roof_)) rest_of_interval.raise(largest_a_, std::min(fraction, 1.0));
  rest_of_interval.move(state, std::min(fraction, 1.0));
  return fraction < 1.0 ? start(state) : rest_from_node(state);
}

/// Moves the state to where the block starts to slide in the interval after a
/// node. Returns false where it does not.
bool LaneHistory::starts_after(std::size_t node, const RoofAtRest& roof, HistoryState& state) {
  HistoryState at = resting_at(static_cast<std::int64_t>(node), roof.state(node));
  const RoofPiece interval = piece(at);
  const double fraction = release(interval);
  if (!(fraction < 1.0)) return false;
  if (has_mass(roof_)) interval.raise(largest_a_, fraction);
  interval.move(at, fraction);
  LaneMotion<double>& m = state.motion;
  m.left = at.motion.left;
  m.ground_1 = at.motion.ground_1;
  m.ground_2 = at.motion.ground_2;
  m.w = at.motion.w;
  state.set_roof(roof_, at.roof(roof_));
  state.node = at.node;
  return true;
}

LaneHistory::Next LaneHistory::rest_from_node(HistoryState& state) {
  RoofAtRest roof(constants_, roof_, ground_, *table_, state);
  const auto begin = static_cast<std::size_t>(state.node);
  const std::size_t quiet = table_->end;
  std::size_t next_interval = begin;  // the first not looked into
  const auto starts_in = [&](std::size_t interval) {
    if (interval < next_interval) return false;
    next_interval = interval + 1;
    return starts_after(interval, roof, state);
  };
  for (std::size_t i = begin;;) {
    if (roof_ == RoofKind::modes && i >= quiet)  // what comes is known by its bound alone
      return roof.sticks_from(i) ? Next::finished : Next::unsupported;
    if (!roof.after_record() && i >= quiet) roof.end_record();
    if (roof.sticks_from(i)) {
      if (has_mass(roof_)) raise_shear_to_end(roof, i);
      return Next::finished;
    }
    if (i >= ground_.end) return ground_.ends_early() ? Next::unsupported : Next::finished;
    const std::size_t first = i, end = roof.tile_end(i);
    if (!roof.sticks_in_tile(i)) {
      for (i = roof.first_release(i, end); i <= end; i = roof.first_release(i + 1, end)) {
        const bool within = roof.after_record() || i < quiet;
        if ((i > roof.base() && starts_in(i - 1)) || (within && starts_in(i))) {
          if (has_mass(roof_)) raise_shear(roof, first, static_cast<std::size_t>(state.node));
          return start(state);
        }
      }
    }
    i = end;
    if (has_mass(roof_)) raise_shear(roof, first, end);
    roof.renew(i);
  }
}

}  // namespace glissade::block_detail::two_axes
