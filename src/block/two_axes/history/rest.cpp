// SPDX-License-Identifier: GPL-3.0-or-later
// A history while the block rests.
#include <algorithm>
#include <cmath>

#include "block/full_model/sdirk4.hpp"
#include "block/two_axes/history/history.hpp"
#include "block/two_axes/roof/roof_at_rest.hpp"

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
      largest_a_(base_shear ? std::array{0.0, 0.0} : std::array{never, never}) {
  if (roof != RoofKind::yielding) return;
  const SceneConstants& c = constants_;
  for (std::size_t n = 0; n < 2; ++n) {
    const double phase = (n == 0 ? c.omega_1 : c.omega_2) * ground.dt_s;
    const double twice_zeta = n == 0 ? c.twice_zeta_1 : c.twice_zeta_2;
    spring_steps_[n] = {SpringStep(phase, 1.0, twice_zeta, c.per_mass),
                        SpringStep(phase, c.springs.hardening[n], twice_zeta, c.per_mass)};
  }
}

std::int64_t LaneHistory::rows() const {
  if (table_->rows.empty()) return 0;
  const auto bytes = [](const double* at) { return reinterpret_cast<std::intptr_t>(at); };
  return (bytes(table_->rows.data()) - bytes(ground_.nodes.data())) /
         static_cast<std::intptr_t>(sizeof(double));
}

LaneHistory::Next LaneHistory::begin(HistoryState& state) {
  state = resting_at(0, {});
  for (std::size_t n = 0; n < 2; ++n) {
    state.springs.high[n] = 0.5 * constants_.springs.range[n];
    state.springs.low[n] = -state.springs.high[n];
  }
  if (follows_shear() && !has_mass(roof_)) {
    RoofAtRest alone(constants_, roof_, ground_, *table_, state);
    raise_shear_to_end(alone, 0);
  }
  if (release(piece(state)) == 0.0) return start(state);
  const Next next = rest_from_node(state);
  return next == Next::rests ? rest(state) : next;
}

void LaneHistory::put_at(HistoryState& state, std::size_t node, const RoofState& roof) const {
  state.node = static_cast<std::int64_t>(node);
  LaneMotion<double>& m = state.motion;
  m.left = 1.0;
  m.ground_1 = constants_.factor_1 * ground_.ground(0, node);
  m.ground_2 = constants_.factor_2 * ground_.ground(1, node);
  m.w = constants_.factor_w * ground_.vertical(node);
  state.set_roof(roof_, roof);
}

LaneHistory::Next LaneHistory::start(HistoryState& state) {
  LaneMotion<double>& m = state.motion;
  m.fastest = std::max(m.fastest, rounding_speed * ground_.dt_s * constants_.gravity);
  ++phases_;
  return go_on_from_rest(state);
}

/// By a step in which the load would not let the block rest: else it might not see it slide.
LaneHistory::Next LaneHistory::go_on_from_rest(HistoryState& state) {
  start_s_ = time_s(state);
  LaneMotion<double>& m = state.motion;
  m.v_s = m.v_y = 0.0;
  m.forced = 1.0;
  const RoofPiece rest_of_interval = piece(state);
  // A mode of a few intervals may let it rest and release it again before the end of a step.
  const bool of_modes = roof_ == RoofKind::modes || roof_ == RoofKind::coupled_modes;
  const double first = of_modes ? 1.0 / 16 : 1.0;
  const auto may_rest = [&](double step) {
    for (double part = 1.0; part >= first; part *= 0.5)
      if (ellipse_.may_rest(rest_of_interval.load(part * step))) return true;
    return false;
  };
  double fraction = 1.0;
  while (fraction > shortest_start && may_rest(fraction)) fraction *= 0.5;
  m.trial = fraction * m.left;
  return Next::slides;
}

namespace {

struct Sample {
  double tau, value;
};

/// Where a function that begins at zero or below, and rises above the chord over a part of length
/// tau by no more than bend tau^2, first rises above zero: its halves are searched in turn, down to
/// 1/256. Never: nowhere.
template <class Function>
double first_above(const Function& f, Sample low, Sample high, double bend) {
  constexpr double shortest = 1.0 / 256;
  if (high.value > 0.0) high = {rise_by_secant(f, low.value, high.value, low.tau, high.tau), 0.0};
  const bool rises = high.value == 0.0;
  const double length = high.tau - low.tau, root = rises ? high.tau : never;
  // Near a root at the end it is above zero only if its begin is not below four bends.
  const double most = rises ? low.value + 4.0 * bend * length * length
                            : std::max(low.value, high.value) + bend * length * length;
  if (most <= 0.0 || length <= shortest) return root;
  const double middle = 0.5 * (low.tau + high.tau);
  const Sample half{middle, f(middle)};
  const double left = first_above(f, low, half, bend);
  return left < never ? left : std::min(root, first_above(f, half, high, bend));
}

}  // namespace

/// The fraction of a piece after which the block no longer sticks, or never.
double LaneHistory::release(const RoofPiece& piece) {
  uplift_ = uplift_ || piece.load(0.0).normal < 0.0 || piece.load(1.0).normal < 0.0;
  const auto excess = [&](double tau) { return -friction_reserve(piece.load(tau), constants_); };
  const double begin = excess(0.0), end = excess(1.0);
  constexpr double rounding = 1e-13;  // of gravity, in the load
  if (begin > rounding * constants_.gravity) return 0.0;
  if (!(end > 0.0) && -std::max(begin, end) > piece.deviation()) return never;
  return first_above(excess, {0.0, std::min(begin, 0.0)}, {1.0, end}, piece.bend());
}

/// A spring yields, or is elastic again from where it is.
void LaneHistory::change_spring(HistoryState& state, const RoofPiece::SpringEvent& event) const {
  SpringMotion<double>& springs = state.springs;
  const std::size_t n = event.axis;
  if (event.direction == 0) {
    const double force = n == 0 ? state.motion.x_1 : state.motion.x_2;
    const bool from_above = springs.direction[n] > 0.0;
    springs.high[n] = from_above ? force : force + constants_.springs.range[n];
    springs.low[n] = from_above ? force - constants_.springs.range[n] : force;
  }
  springs.direction[n] = event.direction;
}

void LaneHistory::rest_on_springs(HistoryState& state) {
  const SceneConstants& c = constants_;
  const SpringMotion<double>& springs = state.springs;
  RoofState roof = state.roof(roof_);
  const double factor[] = {c.factor_1, c.factor_2}, twice_zeta[] = {c.twice_zeta_1, c.twice_zeta_2};
  auto i = static_cast<std::size_t>(state.node);
  for (const auto last = static_cast<std::size_t>(limit()); i < last; ++i) {
    RoofState next{};
    std::array<double, 2> begin_a, end_a;
    double deviation = 0.0;
    bool happens = false, raises = false;
    for (std::size_t n = 0; n < 2; ++n) {
      const bool yields = springs.direction[n] != 0.0;
      const SpringStep& step = spring_steps_[n][yields ? 1 : 0];
      const SpringStep::Begin begin{
          roof[n][0], {factor[n] * ground_.ground(n, i), factor[n] * ground_.ground(n, i + 1)}};
      const OscillatorState from = roof[n][0], to = next[n][0] = step.end(begin);
      begin_a[n] = -(twice_zeta[n] * from.y + from.x) * c.per_mass;
      end_a[n] = -(twice_zeta[n] * to.y + to.x) * c.per_mass;
      const double a_left = step.a_deviation(begin), x_left = step.x_deviation(begin);
      deviation += a_left;
      raises =
          raises || std::max(std::abs(begin_a[n]), std::abs(end_a[n])) + a_left > largest_a_[n];
      const double y_left = step.y_deviation(begin);
      happens = happens || (yields ? springs.direction[n] > 0.0 ? std::min(from.y, to.y) <= y_left
                                                                : std::max(from.y, to.y) >= -y_left
                                   : std::max(from.x, to.x) + x_left >= springs.high[n] ||
                                         std::min(from.x, to.x) - x_left <= springs.low[n]);
    }
    const auto reserve = [&](const std::array<double, 2>& a, std::size_t node) {
      return friction_reserve(load_of(c, a, c.factor_w * ground_.vertical(node)), c);
    };
    if (happens || std::min(reserve(begin_a, i), reserve(end_a, i + 1)) <=
                       deviation * reserve_per_acceleration(c))
      break;
    if (raises) {
      put_at(state, i, roof);
      piece(state).raise(largest_a_, 1.0);
    }
    roof = next;
  }
  put_at(state, i, roof);
}

LaneHistory::Next LaneHistory::rest(HistoryState& state) {
  for (;;) {
    const RoofPiece rest_of_interval = piece(state);
    const double released = release(rest_of_interval);
    const RoofPiece::SpringEvent event = rest_of_interval.next_event(state.springs);
    const double fraction = std::min({released, event.at, 1.0});
    if (has_mass(roof_)) rest_of_interval.raise(largest_a_, fraction);
    rest_of_interval.move(state, fraction);
    if (event.at == fraction) {
      change_spring(state, event);
    } else if (released < 1.0) {
      return start(state);
    } else if (!state.any_yields()) {
      const Next next = rest_from_node(state);
      if (next != Next::rests) return next;
    } else if (state.node >= limit()) {
      return Next::unsupported;
    } else {
      rest_on_springs(state);
    }
  }
}

/// What happens first in the interval after a node, and the state there: Next::finished, and the
/// state as it was, where nothing does.
LaneHistory::Next LaneHistory::next_after(std::size_t node, const RoofAtRest& roof,
                                          HistoryState& state) {
  HistoryState at = resting_at(node, roof.state(node));
  const RoofPiece interval = piece(at);
  const double released = release(interval);
  const RoofPiece::SpringEvent event = interval.next_event(state.springs);
  const double fraction = std::min(released, event.at);
  if (!(fraction < 1.0)) return Next::finished;
  if (has_mass(roof_)) interval.raise(largest_a_, fraction);
  interval.move(at, fraction);
  LaneMotion<double>& m = state.motion;
  m.left = at.motion.left;
  m.ground_1 = at.motion.ground_1;
  m.ground_2 = at.motion.ground_2;
  m.w = at.motion.w;
  state.set_roof(roof_, at.roof(roof_));
  state.node = at.node;
  if (event.at > fraction) return Next::slides;
  change_spring(state, event);
  return Next::rests;
}

LaneHistory::Next LaneHistory::rest_from_node(HistoryState& state) {
  RoofAtRest roof(constants_, roof_, ground_, *table_, state);
  const auto begin = static_cast<std::size_t>(state.node);
  const std::size_t quiet = table_->end;
  std::size_t next_interval = begin;  // the first not looked into
  const auto next_in = [&](std::size_t interval) {
    if (interval < next_interval) return Next::finished;
    next_interval = interval + 1;
    return next_after(interval, roof, state);
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
        Next next = i > roof.base() ? next_in(i - 1) : Next::finished;
        if (next == Next::finished && within) next = next_in(i);
        if (next == Next::finished) continue;
        if (has_mass(roof_)) raise_shear(roof, first, static_cast<std::size_t>(state.node));
        return next == Next::slides ? start(state) : next;
      }
    }
    i = end;
    if (has_mass(roof_)) raise_shear(roof, first, end);
    roof.renew(i);
  }
}

}  // namespace glissade::block_detail::two_axes
