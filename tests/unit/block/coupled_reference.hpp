// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "glissade/block/coupled.hpp"
#include "unit/block/reference.hpp"

namespace glissade::test {

/// Block and building in 50 digits, from the free bodies: in every state of contact the building is
/// an oscillator with its own mass and, where its spring yields, its own stiffness, solved by
/// exponentials and sines; what holds in that state is
/// looked at `looks` times in every sample interval, and the moment it ceases to is bisected.
/// Slope >= 0, 0 <= damping < 1.
class CoupledReference {
 public:
  Real down = 0, up = 0, slip = 0, duration = 0;  ///< in plan, m
  Real time = 0, u = 0, u_velocity = 0, velocity = 0;
  Real base_shear = 0, roof_displacement = 0, roof_acceleration = 0;  ///< largest at the looks
  Real ductility = 0, residual_roof = 0;  ///< the former the largest at the looks
  int phases = 0, yields = 0;
  /// Of the displacements, in plan, that are watched for: as far as they have been reached.
  struct Crossed {
    Real time, speed;
  };
  std::vector<Crossed> crossed;
  bool uplift = false;

  CoupledReference(const GroundMotion& ground, const MotionFactors& factors,
                   const CoupledBuilding& building, const Block& block, double ring_down_s,
                   int looks = 16, std::vector<double> thresholds_m = {})
      : looks_(looks),
        thresholds_m_(std::move(thresholds_m)),
        g_(block.gravity_mps2),
        mu_(block.friction.along),
        mu_static_(Real(block.friction.along) * block.law.static_over_sliding),
        r_(building.mass_ratio),
        sine_(sin(Real(block.slope_rad))),
        cosine_(cos(Real(block.slope_rad))),
        zeta_(building.horizontal.damping_ratio),
        omega_(2 * boost::math::constants::pi<Real>() / building.horizontal.period_s),
        yields_at_(building.yielding.yield_acceleration_mps2),
        alpha_(building.yielding.yields() ? building.yielding.hardening_ratio : 0.0) {
    const std::size_t n = ground.horizontal_mps2.size();
    const auto steps = n + static_cast<std::size_t>(ring_down_s / ground.dt_s);
    const auto a = [&](std::size_t i) {
      return i < n ? Real(ground.horizontal_mps2[i]) * factors.horizontal[0] : Real(0);
    };
    const auto w = [&](std::size_t i) {
      return i < n && !ground.vertical_mps2.empty()
                 ? Real(ground.vertical_mps2[i]) * factors.vertical
                 : Real(0);
    };
    for (std::size_t i = 0; i < steps; ++i)
      interval(Real(ground.dt_s), a(i), a(i + 1), w(i), w(i + 1));
    residual_roof = (1 - alpha_) * plastic_ / (omega_ * omega_);
    ductility = roof_displacement * omega_ * omega_ / yields_at_;
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

  // Per omega^2, the spring's force is stiffness u + offset.
  Real stiffness() const { return yielding_ == 0 ? Real(1) : alpha_; }
  Real offset() const {
    return (1 - alpha_) * (yielding_ == 0 ? Real(-plastic_) : yielding_ * yields_at_);
  }

  /// u'' + c u' + k u = -(force + rate t)
  static State oscillate(const State& from, const Real& c, const Real& k, const Real& force,
                         const Real& rate, const Real& t) {
    State to = from;
    if (k == 0) {
      // c w = -(force + rate t) + rate / c is the velocity long after.
      const Real w0 = (rate / c - force) / c, w1 = -rate / c, decay = exp(-c * t);
      to.u_velocity = w0 + w1 * t + (from.u_velocity - w0) * decay;
      to.u = from.u + w0 * t + w1 * t * t / 2 + (from.u_velocity - w0) * (1 - decay) / c;
      return to;
    }
    const Real u0 = (c * rate / k - force) / k, u1 = -rate / k;
    const Real p = from.u - u0, pv = from.u_velocity - u1 + c / 2 * p;
    const Real square = k - c * c / 4, beta = sqrt(abs(square)), decay = exp(-c / 2 * t);
    const Real even = square > 0 ? Real(cos(beta * t)) : Real(cosh(beta * t)),
               odd = square > 0 ? Real(sin(beta * t)) : Real(sinh(beta * t));
    to.u = decay * (p * even + pv * odd / beta) + u0 + u1 * t;
    to.u_velocity = decay * ((pv - c / 2 * p) * even - (square * p + c / 2 * pv) * odd / beta) + u1;
    return to;
  }

  State at(const State& from, const Ground& ground, const Real& t) const {
    const Real m = mass();
    const Real force = ground.a + (offset() + weight() * (g_ + ground.w)) / m,
               rate = ground.a_rate + weight() / m * ground.w_rate;
    State to =
        oscillate(from, 2 * zeta_ * omega_ / m, stiffness() * omega_ * omega_ / m, force, rate, t);
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
    return -(2 * zeta_ * omega_ * s.u_velocity + stiffness() * omega_ * omega_ * s.u + offset());
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
  bool spring_holds(const State& s) const {
    if (yielding_ != 0) return yielding_ * s.u_velocity >= 0;
    return abs(omega_ * omega_ * s.u - plastic_) <= yields_at_ + Real(1e-40);
  }
  bool block_holds(const State& s, const Real& w) const {
    if (sigma_ != 0) return sigma_ * s.velocity >= 0;
    return abs(demand(s, w)) <= (lifted_ ? Real(0) : mu_static_) * normal(s, w) + Real(1e-40);
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
          return contact_holds(s, w) && block_holds(s, w) && spring_holds(s);
        };
        Real low = 0, high = until - gone;
        if (holds(high)) break;
        for (int i = 0; i < 160; ++i) {
          const Real middle = (low + high) / 2;
          (holds(middle) ? low : high) = middle;
        }
        move(state, ground, high, gone);
        gone += high;
        see(state, ground.w);
        change(state, ground.w);
        see(state, ground.w);
      }
      see(at(state, ground, until - gone), ground.w + ground.w_rate * (until - gone));
    }
    move(state, ground, h - gone, gone);
    u = state.u;
    u_velocity = state.u_velocity;
    slip = state.s;
    velocity = state.velocity;
    time += h;
    down = std::max(down, slip);
    up = std::max(up, Real(-slip));
  }

  /// Slip is monotone on the way.
  void watch(const State& state, const Ground& ground, const Real& t, const Real& gone) {
    while (crossed.size() < thresholds_m_.size()) {
      const Real threshold = thresholds_m_[crossed.size()] / cosine_;
      Real low = 0, high = t;
      if (abs(at(state, ground, t).s) < threshold) return;
      for (int i = 0; i < 160; ++i) {
        const Real middle = (low + high) / 2;
        (abs(at(state, ground, middle).s) < threshold ? low : high) = middle;
      }
      crossed.push_back({time + gone + high, abs(at(state, ground, high).velocity) * cosine_});
    }
  }

  void move(State& state, Ground& ground, const Real& t, const Real& gone) {
    watch(state, ground, t, gone);
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
    } else if (!spring_holds(s)) {
      if (yielding_ == 0) {
        yielding_ = s.u_velocity > 0 ? 1 : -1;
        ++yields;
      } else {
        plastic_ = omega_ * omega_ * s.u - yielding_ * yields_at_;
        yielding_ = 0;
      }
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
  std::vector<double> thresholds_m_;
  Real g_, mu_, mu_static_, r_, sine_, cosine_, zeta_, omega_;
  Real yields_at_, alpha_, plastic_ = 0;
  int sigma_ = 0, yielding_ = 0;
  bool lifted_ = false;
};

}  // namespace glissade::test
