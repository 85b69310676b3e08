// SPDX-License-Identifier: GPL-3.0-or-later
// A history while the block rests.
#include <algorithm>
#include <cmath>

#include "history.hpp"
#include "rest_search.hpp"

namespace glissade::block_detail::two_axes {
namespace {

constexpr double zeros[8] = {};

/// The root of a function, almost a line, that rises from at most zero at `low` to above zero at
/// `high`: the secant rule, kept within the bracket.
template <class Function>
double rise_between(const Function& f, double low, double high, double f_low, double f_high) {
  double x0 = low, f0 = f_low, x1 = high, f1 = f_high;
  for (int i = 0; i < 60; ++i) {
    double x = x1 - f1 * (x1 - x0) / (f1 - f0);
    if (!(x >= low && x <= high)) x = 0.5 * (low + high);
    const double value = f(x);
    (value > 0.0 ? high : low) = x;
    const double moved = std::abs(x - x1);
    x0 = x1;
    f0 = f1;
    x1 = x;
    f1 = value;
    if (moved < 1e-9 || value == 0.0 || high - low < 1e-13) break;
  }
  return x1;
}

}  // namespace

History::History(const Constants<double>& constants, Roof roof, const GroundNodes& ground,
                 std::shared_ptr<const RestTable> table)
    : constants_(constants), roof_(roof), ground_(ground), table_(std::move(table)) {}

History::Next History::begin(Spot& spot) {
  spot = resting_at(0, {});
  const RoofPiece first = piece(spot, {});
  if (release(first) == 0.0) {
    start(spot, false);
    return slide(spot, false);
  }
  return rest_from_node(spot);
}

Spot History::resting_at(std::int64_t node, const std::array<AxisState, 2>& state) const {
  const auto i = static_cast<std::size_t>(node);
  Spot s;
  s.node = node;
  s.motion.left = 1.0;
  s.motion.ground_1 = constants_.factor_1 * ground_.ground(0, i);
  s.motion.ground_2 = constants_.factor_2 * ground_.ground(1, i);
  s.motion.w = constants_.factor_w * ground_.vertical(i);
  s.motion.x_1 = state[0].x;
  s.motion.y_1 = state[0].y;
  s.motion.x_2 = state[1].x;
  s.motion.y_2 = state[1].y;
  return s;
}

void History::start(Spot& spot, bool smoothly) {
  Motion<double>& m = spot.motion;
  m.v_s = m.v_y = 0.0;
  m.fastest = std::max(m.fastest, 1e-9 * ground_.dt_s * constants_.gravity);
  step_s_ = never;
  ++phases_;
  if (smoothly) start_smoothly(spot);
}

/// The share of a piece after which friction holds the block no longer, or never.
double History::release(const RoofPiece& piece) const {
  const double mu = constants_.mu;
  const auto excess = [&](double y) { return -grip_left(piece.load(y), mu); };
  const double begin = excess(0.0), end = excess(1.0);
  if (begin > 1e-13 * constants_.gravity) return 0.0;
  if (end > 0.0) return rise_between(excess, 0.0, 1.0, std::min(begin, 0.0), end);
  const double sag = piece.sag();
  if (sag == 0.0 || -std::max(begin, end) > sag) return never;
  constexpr int parts = 16;
  double before = std::min(begin, 0.0);
  for (int i = 1; i < parts; ++i) {
    const double y = static_cast<double>(i) / parts, value = excess(y);
    if (value > 0.0) return rise_between(excess, y - 1.0 / parts, y, before, value);
    before = value;
  }
  return never;
}

/// Whether friction holds the block whatever the roof does within these bounds.
bool History::holds(double a_1, double a_2, double w) const {
  const Constants<double>& c = constants_;
  const double a = std::sqrt(a_1 * a_1 + a_2 * a_2) * (1.0 + 1e-12);
  return (c.gravity + w) * c.tangent + a / c.cosine <=
         c.mu * (c.gravity - w - c.tangent * a) * (1.0 - 1e-12);
}

History::Next History::rest(Spot& spot) {
  const RoofPiece rest_of_interval = piece(spot, {});
  const double share = release(rest_of_interval);
  if (share < 1.0) {
    rest_of_interval.move(spot, share);
    start(spot, share > 0.0);
    return slide(spot, false);
  }
  rest_of_interval.move(spot, 1.0);
  return rest_from_node(spot);
}

History::Next History::rest_from_node(Spot& spot) {
  const Constants<double>& c = constants_;
  const bool rigid = roof_ == Roof::rigid;
  const double factors[] = {c.factor_1, c.factor_2};
  const std::size_t quiet = ground_.quiet;
  std::size_t base = static_cast<std::size_t>(spot.node), i = base, examined = base;
  bool tail = base >= quiet;
  // The free vibration at node `base`: of all the roof does, what the table does not tell.
  std::array<AxisState, 2> free{};
  std::array<double, 2> free_bound{};
  const auto set_free = [&](std::size_t node, const std::array<AxisState, 2>& state) {
    base = node;
    free = state;
    for (std::size_t n = 0; n < 2 && !rigid; ++n) free_bound[n] = table_->free[n].bound(free[n]);
  };
  const auto state_at = [&](std::size_t node) {
    std::array<AxisState, 2> state{};
    for (std::size_t n = 0; n < 2 && !rigid; ++n) {
      state[n] = table_->free[n].after(node - base, free[n]);
      if (tail) continue;
      const AxisState own = table_->state(n, node);
      state[n].x += factors[n] * own.x;
      state[n].y += factors[n] * own.y;
    }
    return state;
  };
  if (!rigid) {
    std::array<AxisState, 2> state{
        {{spot.motion.x_1, spot.motion.y_1}, {spot.motion.x_2, spot.motion.y_2}}};
    for (std::size_t n = 0; n < 2 && !tail; ++n) {
      const AxisState own = table_->state(n, base);
      state[n].x -= factors[n] * own.x;
      state[n].y -= factors[n] * own.y;
    }
    if (roof_ == Roof::building && !tail) state = {};  // rounding
    set_free(base, state);
  }
  // Examines the interval after a node: true if the block leaves it there.
  const auto leaves = [&](std::size_t node) {
    if (node < examined) return false;
    Spot at = resting_at(static_cast<std::int64_t>(node), state_at(node));
    const RoofPiece interval = piece(at, {});
    const double share = release(interval);
    examined = node + 1;
    if (!(share < 1.0)) return false;
    interval.move(at, share);
    Motion<double>& m = spot.motion;
    const Motion<double> before = m;
    m = at.motion;
    m.at_s = before.at_s;
    m.at_y = before.at_y;
    m.fastest = before.fastest;
    m.path = before.path;
    m.farthest2 = before.farthest2;
    m.ahead_s = before.ahead_s;
    m.back_s = before.back_s;
    m.ahead_y = before.ahead_y;
    m.back_y = before.back_y;
    spot.node = at.node;
    return true;
  };
  const double per_a = 1.0 / c.cosine + c.mu * c.tangent;
  const std::size_t longest =
      quiet + static_cast<std::size_t>(RoofMotionOptions{}.longest_ring_down_s / ground_.dt_s);
  const double rounding = 1e-12 * c.gravity;
  for (;;) {
    if (!tail && i >= quiet) {
      if (rigid) return Next::over;
      const auto state = state_at(quiet);
      tail = true;
      set_free(quiet, state);
      i = quiet;
    }
    const std::size_t k = i / block_nodes;
    std::array<double, 2> bound = free_bound;
    double w_to_come = 0.0, w_block = 0.0;
    std::array<double, 2> block = bound, sag{};
    for (std::size_t n = 0; n < 2; ++n) {
      if (!rigid) sag[n] = free_bound[n] * table_->free[n].sag();
      if (tail) continue;
      bound[n] += std::abs(factors[n]) * table_->coming[n][k];
      block[n] += std::abs(factors[n]) * table_->block[n][k];
      sag[n] += std::abs(factors[n]) * table_->sag[n][k];
    }
    if (!tail) {
      w_to_come = std::abs(c.factor_w) * ground_.coming_w[k];
      w_block = std::abs(c.factor_w) * ground_.block_w[k];
    }
    // A bound on what is still to come holds between nodes too: the sag of any block is far below
    // the amplitude, of which a fifth is set aside.
    if (rigid ? holds(bound[0], bound[1], w_to_come)
              : holds(1.2 * bound[0], 1.2 * bound[1], w_to_come))
      return Next::over;
    if (tail && i >= longest) return Next::over;
    const std::size_t end = tail ? i + block_nodes : (k + 1) * block_nodes;
    if (!tail && holds(block[0] + sag[0], block[1] + sag[1], w_block)) {
      i = end;
    } else {
      const double needed = (sag[0] + sag[1]) * per_a + rounding;
      while (i < end) {
        RestMotion motion;
        const auto start_state =
            rigid ? std::array<AxisState, 2>{}
                  : std::array<AxisState, 2>{table_->free[0].after(i - base, free[0]),
                                             table_->free[1].after(i - base, free[1])};
        for (std::size_t n = 0; n < 2; ++n)
          motion.axis[n] = {tail ? zeros : table_->a[n],
                            factors[n],
                            rigid ? zeros : table_->free[n].x_part().data(),
                            rigid ? zeros : table_->free[n].y_part().data(),
                            start_state[n].x,
                            start_state[n].y};
        motion.w = tail ? zeros : ground_.w.data();
        const std::size_t loose = first_loose(motion, c, tail ? 0 : i, needed);
        if (loose == 8) {
          i = std::min(i + 8, end);
          continue;
        }
        const std::size_t node = i + loose;
        if (!tail && node > quiet) {
          i = quiet;
          break;
        }
        if (node > base && leaves(node - 1)) {
          start(spot, true);
          return slide(spot, false);
        }
        if (!tail && node >= quiet) {
          i = quiet;
          break;
        }
        if (leaves(node)) {
          start(spot, true);
          return slide(spot, false);
        }
        i = node + 1;
      }
    }
    if (rigid) continue;
    if (tail) {
      std::array<AxisState, 2> state = state_at(i);
      set_free(i, state);
    } else {
      for (std::size_t n = 0; n < 2; ++n)
        free_bound[n] = table_->free[n].bound(table_->free[n].after(i - base, free[n]));
    }
  }
}

}  // namespace glissade::block_detail::two_axes
