// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "glissade/block/coupled.hpp"
#include "unit/block/reference.hpp"

namespace glissade::test {

/// Block and building in 50 digits, from the free bodies: in every state of contact the building is
/// an oscillator with its own mass, solved by exponentials and sines; what holds in that state is
/// looked at `looks` times in every sample interval, and the moment it ceases to is bisected.
/// Slope >= 0, 0 <= damping < 1.
class CoupledReference {
 public:
  Real down = 0, up = 0, slip = 0, duration = 0;  ///< in plan, m
  Real time = 0, u = 0, u_velocity = 0, velocity = 0;
  Real base_shear = 0, roof_displacement = 0, roof_acceleration = 0;  ///< largest at the looks
  int phases = 0;
  bool uplift = false;

  CoupledReference(const GroundMotion& ground, const MotionFactors& factors,
                   const CoupledBuilding& building, const Block& block, double ring_down_s,
                   int looks = 16)
      : looks_(looks),
        g_(block.gravity_mps2),
        mu_(block.friction),
        r_(building.mass_ratio),
        sine_(sin(Real(block.slope_rad))),
        cosine_(cos(Real(block.slope_rad))),
        zeta_(building.horizontal.damping_ratio),
        omega_(2 * boost::math::constants::pi<Real>() / building.horizontal.period_s) {
    const std::size_t n = ground.horizontal_mps2.size();
    const auto steps = n + static_cast<std::size_t>(ring_down_s / ground.dt_s);
    const auto a = [&](std::size_t i) {
      return i < n ? Real(ground.horizontal_mps2[i]) * factors.horizontal : Real(0);
    };
    const auto w = [&](std::size_t i) {
      return i < n && !ground.vertical_mps2.empty()
                 ? Real(ground.vertical_mps2[i]) * factors.vertical
                 : Real(0);
    };
    for (std::size_t i = 0; i < steps; ++i)
      interval(Real(ground.dt_s), a(i), a(i + 1), w(i), w(i + 1));
    slip *= cosine_;
    down *= cosine_;
    up *= cosine_;
  }

 private:
  struct State {
    Real u, u_velocity, s, velocity;
  };
  /// The ground from the state's time on: a + a_rate t, w + w_rate t.
  struct Ground {
    Real a, a_rate, w, w_rate;
  };

  // At rest (sigma 0), sliding (1, -1), and without friction where lifted.
  Real friction() const { return lifted_ ? Real(0) : mu_; }
  Real q() const { return sine_ - sigma_ * friction() * cosine_; }
  Real mass() const { return sigma_ == 0 ? 1 + r_ : 1 + r_ * sine_ * q(); }
  Real weight() const { return sigma_ == 0 ? Real(0) : r_ * cosine_ * q(); }

  State at(const State& from, const Ground& ground, const Real& t) const {
    const Real m = mass(), omega = omega_ / sqrt(m), zeta = zeta_ / sqrt(m),
               beta = omega * sqrt(1 - zeta * zeta);
    const Real force = ground.a + weight() / m * (g_ + ground.w),
               rate = ground.a_rate + weight() / m * ground.w_rate;
    // u'' + 2 zeta omega u' + omega^2 u = -(force + rate t)
    const Real o2 = omega * omega, u0 = -force / o2 + 2 * zeta * rate / (o2 * omega),
               u1 = -rate / o2;
    const Real p = from.u - u0, pv = (from.u_velocity - u1 + zeta * omega * p) / beta;
    const Real decay = exp(-zeta * omega * t), c = cos(beta * t), s = sin(beta * t);
    State to;
    to.u = decay * (p * c + pv * s) + u0 + u1 * t;
    to.u_velocity =
        decay * ((beta * pv - zeta * omega * p) * c - (beta * p + zeta * omega * pv) * s) + u1;
    to.s = from.s;
    to.velocity = from.velocity;
    if (sigma_ == 0) return to;
    const Real roof_velocity =
        to.u_velocity - from.u_velocity + ground.a * t + ground.a_rate * t * t / 2;
    const Real roof_way =
        to.u - from.u - from.u_velocity * t + ground.a * t * t / 2 + ground.a_rate * t * t * t / 6;
    const Real gravity_velocity = (g_ + ground.w) * t + ground.w_rate * t * t / 2;
    const Real gravity_way = (g_ + ground.w) * t * t / 2 + ground.w_rate * t * t * t / 6;
    const Real inertia = cosine_ + sigma_ * friction() * sine_;
    to.velocity += q() * gravity_velocity - inertia * roof_velocity;
    to.s += from.velocity * t + q() * gravity_way - inertia * roof_way;
    return to;
  }
  Real elastic(const State& s) const {
    return -(2 * zeta_ * omega_ * s.u_velocity + omega_ * omega_ * s.u);
  }
  Real acceleration(const State& s, const Real& w) const {
    return (elastic(s) - weight() * (g_ + w)) / mass();
  }
  Real normal(const State& s, const Real& w) const {
    return (g_ + w) * cosine_ + acceleration(s, w) * sine_;
  }
  Real demand(const State& s, const Real& w) const {
    return (g_ + w) * sine_ - acceleration(s, w) * cosine_;
  }
  bool contact_holds(const State& s, const Real& w) const { return (normal(s, w) < 0) == lifted_; }
  bool block_holds(const State& s, const Real& w) const {
    if (sigma_ != 0) return sigma_ * s.velocity >= 0;
    return abs(demand(s, w)) <= friction() * normal(s, w) + Real(1e-40);
  }

  void interval(const Real& h, const Real& a0, const Real& a1, const Real& w0, const Real& w1) {
    Ground ground{a0, (a1 - a0) / h, w0, (w1 - w0) / h};
    State state{u, u_velocity, slip, velocity};
    Real gone = 0;
    for (int look = 0; look <= looks_; ++look) {
      const Real until = h * look / looks_;
      for (int guard = 0; guard < 40; ++guard) {
        const auto holds = [&](const Real& t) {
          const State s = at(state, ground, t);
          const Real w = ground.w + ground.w_rate * t;
          return contact_holds(s, w) && block_holds(s, w);
        };
        Real low = 0, high = until - gone;
        if (holds(high)) break;
        for (int i = 0; i < 160; ++i) {
          const Real middle = (low + high) / 2;
          (holds(middle) ? low : high) = middle;
        }
        move(state, ground, high);
        gone += high;
        see(state, ground.w);
        change(state, ground.w);
        see(state, ground.w);
      }
      see(at(state, ground, until - gone), ground.w + ground.w_rate * (until - gone));
    }
    move(state, ground, h - gone);
    u = state.u;
    u_velocity = state.u_velocity;
    slip = state.s;
    velocity = state.velocity;
    time += h;
    down = std::max(down, slip);
    up = std::max(up, Real(-slip));
  }

  void move(State& state, Ground& ground, const Real& t) {
    state = at(state, ground, t);
    ground.a += ground.a_rate * t;
    ground.w += ground.w_rate * t;
    if (sigma_ != 0) duration += t;
  }
  /// What held no longer does.
  void change(State& s, const Real& w) {
    down = std::max(down, s.s);
    up = std::max(up, Real(-s.s));
    if (!contact_holds(s, w)) {
      lifted_ = !lifted_;
      uplift = true;
    } else if (sigma_ != 0) {
      sigma_ = 0;
      s.velocity = 0;
    } else {
      sigma_ = demand(s, w) > 0 ? 1 : -1;
      ++phases;
    }
  }
  void see(const State& s, const Real& w) {
    base_shear = std::max(base_shear, Real(abs(elastic(s)) / g_));
    roof_displacement = std::max(roof_displacement, Real(abs(s.u)));
    roof_acceleration = std::max(roof_acceleration, Real(abs(acceleration(s, w))));
  }

  int looks_;
  Real g_, mu_, r_, sine_, cosine_, zeta_, omega_;
  int sigma_ = 0;
  bool lifted_ = false;
};

}  // namespace glissade::test
