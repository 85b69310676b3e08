// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/roof/roof_piece.hpp"

#include <algorithm>

#include "block/two_axes/roof/one_mass_series.hpp"

namespace glissade::block_detail::two_axes {
namespace {

/// Terms of a power series of free vibration of which the rest is below 1e-10, by omega times the
/// length of the piece.
int terms_for(double phase) {
  if (phase < 0.02) return 6;
  if (phase < 0.1) return 8;
  if (phase < 0.3) return 10;
  return phase < 0.9 ? 12 : 20;
}

}  // namespace

RoofState HistoryState::roof(RoofKind roof) const {
  RoofState state{};
  if (roof == RoofKind::coupled_modes) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t n = 0; n < most_modes; ++n)
        state[axis][n] = {modes.x[axis][n], modes.y[axis][n]};
    return state;
  }
  state[0][0] = {motion.x_1, motion.y_1};
  state[1][0] = {motion.x_2, motion.y_2};
  return state;
}

void HistoryState::set_roof(RoofKind roof, const RoofState& state) {
  if (roof == RoofKind::coupled_modes) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t n = 0; n < most_modes; ++n) {
        modes.x[axis][n] = state[axis][n].x;
        modes.y[axis][n] = state[axis][n].y;
      }
    return;
  }
  motion.x_1 = state[0][0].x;
  motion.y_1 = state[0][0].y;
  motion.x_2 = state[1][0].x;
  motion.y_2 = state[1][0].y;
}

RoofPiece::RoofPiece(const HistoryState& state, const GroundNodes& ground, const RestTable& table,
                     const SceneConstants& c, RoofKind roof, const BlockVelocity& block_velocity)
    : constants_(&c), roof_(roof), length_s_(ground.dt_s * state.motion.left) {
  const LaneMotion<double>& m = state.motion;
  const auto next = static_cast<std::size_t>(state.node + 1);
  ground_ = {m.ground_1, m.ground_2};
  ground_end_ = {c.factor_1 * ground.ground(0, next), c.factor_2 * ground.ground(1, next)};
  w_ = m.w;
  w_end_ = c.factor_w * ground.vertical(next);
  if (roof == RoofKind::rigid) {
    for (std::size_t n = 0; n < 2; ++n) {
      a_[n][0] = ground_[n];
      a_[n][1] = ground_end_[n] - ground_[n];
    }
    return;
  }
  if (roof == RoofKind::modes) {
    terms_ = row_terms;
    const auto node = static_cast<std::size_t>(state.node);
    read(table.row(0, node), c.factor_1, m.left, a_[0]);
    read(table.row(1, node), c.factor_2, m.left, a_[1]);
    return;
  }
  if (roof == RoofKind::coupled_modes)
    respond_on_modes(state.roof(roof), block_velocity);
  else
    respond(state.roof(roof), block_velocity, state.springs);
}

void RoofPiece::respond(const RoofState& state, const BlockVelocity& block_velocity,
                        const SpringMotion<double>& springs) {
  const SceneConstants& c = *constants_;
  terms_ = terms_for(std::max(c.omega_1, c.omega_2) * length_s_);
  const double omega[] = {c.omega_1, c.omega_2}, damping[] = {c.twice_zeta_1, c.twice_zeta_2};
  const double omega_rho[] = {c.omega_rho_1, c.omega_rho_2};
  for (std::size_t n = 0; n < 2; ++n) {
    block_rate_[n] = {omega_rho[n] * block_velocity.begin[n],
                      omega_rho[n] * block_velocity.rise[n]};
    const double stiffness = springs.direction[n] == 0.0 ? 1.0 : c.springs.hardening[n];
    const OneMassSeries axis{omega[n] * length_s_,
                             stiffness,
                             damping[n],
                             c.per_mass,
                             {ground_[n], ground_end_[n] - ground_[n]},
                             block_rate_[n]};
    x_[n][0][0] = state[n][0].x;
    y_[n][0][0] = state[n][0].y;
    axis.expand(static_cast<std::size_t>(terms_), x_[n][0], y_[n][0], a_[n]);
  }
}

RoofPiece::SpringEvent RoofPiece::next_event(const SpringMotion<double>& springs) const {
  SpringEvent first;
  if (roof_ != RoofKind::yielding) return first;
  const auto consider = [&](std::size_t axis, double at, int direction) {
    if (at < first.at) first = {at, axis, direction};
  };
  for (std::size_t n = 0; n < 2; ++n) {
    const double margin = constants_->springs.margin[n], yields = springs.direction[n];
    if (yields == 0.0) {
      Series force{x_[n][0], terms_};
      force.c[0] = (x_[n][0][0] - springs.high[n]) - margin;
      consider(n, first_rise(force), 1);
      force.c[0] = (x_[n][0][0] - springs.low[n]) + margin;
      consider(n, first_fall(force), -1);
      continue;
    }
    Series rate{y_[n][0], terms_};
    for (std::size_t k = 0; k < 2; ++k) rate.c[k] -= block_rate_[n][k];
    rate.c[0] += yields * margin;
    consider(n, first_fall(rate, yields > 0.0 ? Sign::plus : Sign::minus), 0);
  }
  return first;
}

/// As RoofSeries::RespondModes.
void RoofPiece::respond_on_modes(const RoofState& state, const BlockVelocity& block_velocity) {
  const SceneConstants& c = *constants_;
  const ModeConstants<double>& of = c.modes;
  double fastest = 0.0;
  for (const auto& axis : of.omega) fastest = std::max(fastest, *std::ranges::max_element(axis));
  terms_ = terms_for(fastest * length_s_);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    count_[axis] = c.count[axis];
    const double forcing[] = {ground_[axis], ground_end_[axis] - ground_[axis]};
    for (std::size_t n = 0; n < count_[axis]; ++n) {
      x_[axis][n][0] = state[axis][n].x;
      y_[axis][n][0] = state[axis][n].y;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(terms_); ++k) {
      const double ground = k < 2 ? forcing[k] : 0.0;
      double rate[most_modes], e[most_modes], sum = of.ground_share[axis] * ground;
      for (std::size_t n = 0; n < count_[axis]; ++n) {
        rate[n] = y_[axis][n][k];
        if (k == 0) rate[n] -= of.omega_share[axis][n] * block_velocity.begin[axis];
        if (k == 1) rate[n] -= of.omega_share[axis][n] * block_velocity.rise[axis];
        e[n] = -(of.twice_zeta[axis][n] * rate[n] + x_[axis][n][k]);
        sum += e[n];
      }
      a_[axis][k] = of.per_mass[axis] * sum;
      if (k + 1 == static_cast<std::size_t>(terms_)) break;
      for (std::size_t n = 0; n < count_[axis]; ++n) {
        const double factor = of.omega[axis][n] * length_s_ * Series::inverse[k + 1];
        x_[axis][n][k + 1] = factor * rate[n];
        y_[axis][n][k + 1] = factor * (e[n] - of.share[axis][n] * sum - of.gamma[axis][n] * ground);
      }
    }
  }
}

/// The series of a sample interval over what is left of it: Horner's shift, then a change of scale.
void RoofPiece::read(std::span<const double, row_terms> row, double factor, double left,
                     Terms& a) const {
  std::ranges::copy(row, a.begin());
  const double passed = 1.0 - left;
  for (std::size_t i = 0; i + 1 < row_terms; ++i)
    for (std::size_t k = row_terms - 1; k-- > i;) a[k] += passed * a[k + 1];
  for (std::size_t k = 0; k < row_terms; ++k, factor *= left) a[k] *= factor;
}

Load RoofPiece::load(double tau) const {
  return load_of(*constants_, {sum(a_[0], terms_, tau), sum(a_[1], terms_, tau)},
                 w_ + tau * (w_end_ - w_));
}

double RoofPiece::deviation() const {
  double total = 0.0;
  for (std::size_t k = 2; k < static_cast<std::size_t>(terms_); ++k)
    total += std::abs(a_[0][k]) + std::abs(a_[1][k]);
  return total * reserve_per_acceleration(*constants_);
}

double RoofPiece::bend() const {
  double second = 0.0;  // |a''|
  for (std::size_t k = 2; k < static_cast<std::size_t>(terms_); ++k)
    second += static_cast<double>(k * (k - 1)) * (std::abs(a_[0][k]) + std::abs(a_[1][k]));
  return 0.125 * second * reserve_per_acceleration(*constants_);
}

namespace {

/// No |value| up to t is larger: that at the ends, and how far the series leaves its chord.
double bound_of(const Series& a, double t) {
  double left = 0.0, power = t;
  for (int k = 2; k < a.terms; ++k) left += (k == 2 ? 0.25 : 1.0) * std::abs(a.c[k]) * (power *= t);
  return std::max(std::abs(a.c[0]), std::abs(a.at(t))) + left;
}

}  // namespace

void raise_largest(double& most, const Series& a, double t) {
  most = std::max({most, std::abs(a.c[0]), std::abs(a.at(t))});
  if (bound_of(a, t) > most) most = std::max(most, largest(a, t));
}

double RoofPiece::bound(std::size_t axis, double tau) const {
  return bound_of({a_[axis], terms_}, tau);
}

void RoofPiece::raise(std::array<double, 2>& most, double tau) const {
  if (most[0] == never) return;
  for (std::size_t n = 0; n < 2; ++n) raise_largest(most[n], {a_[n], terms_}, tau);
}

void RoofPiece::move(HistoryState& state, double tau) const {
  LaneMotion<double>& m = state.motion;
  const bool whole = tau >= 1.0;
  m.ground_1 = whole ? ground_end_[0] : ground_[0] + tau * (ground_end_[0] - ground_[0]);
  m.ground_2 = whole ? ground_end_[1] : ground_[1] + tau * (ground_end_[1] - ground_[1]);
  m.w = whole ? w_end_ : w_ + tau * (w_end_ - w_);
  if (has_state(roof_)) {
    RoofState roof{};
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t n = 0; n < count_[axis]; ++n)
        roof[axis][n] = {sum(x_[axis][n], terms_, tau), sum(y_[axis][n], terms_, tau)};
    state.set_roof(roof_, roof);
  }
  m.left = whole ? 1.0 : m.left * (1.0 - tau);
  if (whole) ++state.node;
}

}  // namespace glissade::block_detail::two_axes
