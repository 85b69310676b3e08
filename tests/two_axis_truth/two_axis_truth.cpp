// SPDX-License-Identifier: GPL-3.0-or-later
#include "two_axis_truth/two_axis_truth.hpp"

#include <algorithm>
#include <stdexcept>

#include "two_axis_truth/radau_step.hpp"

namespace glissade::test {
namespace {

class History {
 public:
  History(const TruthScene& scene, Long tolerance, TwoAxisTruth& result)
      : bodies_(scene), tolerance_(tolerance), result_(result) {}

  void run(std::size_t samples) {
    const bool stops = bodies_.stops();  // else the history ends with the record
    const auto goes_on = [&](std::size_t i) {
      if (!stops) return i + 1 < samples;
      return i < samples || sliding_ || !bodies_.is_settled(now_);
    };
    for (std::size_t i = 0; goes_on(i); ++i) {
      bodies_.load_interval(i);
      for (Long t = 0; t < bodies_.dt();) t = sliding_ ? slide(t) : rest(t);
    }
    result_.along_m = bodies_.cos_slope() * now_.x[0];
    result_.across_m = now_.x[1];
  }

 private:
  Long rest(Long t) {
    const Long h = std::min(bodies_.dt() - t, 0.3L / std::max(bodies_.largest_omega(), 0.3L));
    const FreeBodies::Resting s = bodies_.resting(t, h, now_);
    const Long x = first_negative(s.cone);
    for (std::size_t n = 0; n < 2; ++n)
      for (std::size_t i = 0; i < bodies_.floors(n); ++i) {
        now_.u[n][i] = value(s.u[n][i], x);
        now_.rate[n][i] = rate(s.u[n][i], x) / h;
      }
    if (x == 1.0L) return h < bodies_.dt() - t ? t + h : bodies_.dt();
    sliding_ = true;
    ++result_.phases;
    step_ = bodies_.dt();
    return t + x * h;
  }

  Long slide(Long t) {
    const Long speed = length(now_.v);
    Long h = std::min(step_, bodies_.dt() - t);
    if (speed > 0.0L) {
      const FreeBodies::Motion m = bodies_.contact(t, now_);
      const Long braking = -dot(now_.v, m.block) / speed;
      if (braking > 0.0L && speed <= 1e-13L * peak_speed_) return stop(t, speed / braking, m);
      if (braking > 0.0L) h = std::min(h, 0.6L * speed / braking);
    }
    while (h > 1e-17L * bodies_.dt()) {
      Stages whole, first, second;
      Long factor = 0.25L;
      if (radau_(t, now_, h, whole) && radau_(t, now_, 0.5L * h, first) &&
          radau_(t + 0.5L * h, first.back(), 0.5L * h, second)) {
        const Two &v = second.back().v, &w = whole.back().v;
        const Long allowed = tolerance_ * std::max(peak_speed_, length(v));
        const Long error = length({v[0] - w[0], v[1] - w[1]}) / allowed;
        factor = std::clamp(0.8L * std::pow(error + 1e-20L, -1.0L / 9.0L), 0.1L, 4.0L);
        if (error <= 1.0L) {
          step_ = factor * h;
          const Long middle = take(t, 0.5L * h, first);
          if (middle < t + 0.5L * h) return middle;
          const Long end = take(middle, 0.5L * h, second);
          return bodies_.dt() - end < 1e-16L * bodies_.dt() ? bodies_.dt() : end;
        }
      }
      h *= std::min(factor, 0.5L);
    }
    throw std::runtime_error("TwoAxisTruth: no step is short enough");
  }

  /// Takes a step, or the part of it up to a change of contact. Returns when it ends.
  Long take(Long t, Long h, Stages& y) {
    const auto normal = [&](Long after, const State& s) {
      return bodies_.contact(t + after, s).normal;
    };
    const State from = now_;
    bool changes = false;
    const auto root = [&](std::size_t i, const auto& f, int evaluations) {
      const Long low = i == 0 ? 0.0L : h * radau_.node(i - 1), high = h * radau_.node(i);
      return root_between(low, f(low, i == 0 ? from : y[i - 1]), high, f(high, y[i]), evaluations,
                          [&](Long after) {
                            Stages part;
                            if (!radau_(t, from, after, part)) throw std::runtime_error("no event");
                            return f(after, part.back());
                          });
    };
    for (std::size_t i = 0; i < RadauIIA::stages && !changes; ++i) {
      if ((normal(h * radau_.node(i), y[i]) < 0.0L) == bodies_.lifted) continue;
      changes = true;
      h = root(i, normal, 40);
      radau_(t, from, h, y);
    }
    const std::array<Long (*)(const State&, Long), 3> rates = {
        [](const State& s, Long c) { return c * c * s.x[0] * s.v[0] + s.x[1] * s.v[1]; },
        [](const State& s, Long) { return s.v[0]; }, [](const State& s, Long) { return s.v[1]; }};
    for (const auto& rate_of : rates) {
      const auto f = [&](Long, const State& s) { return rate_of(s, bodies_.cos_slope()); };
      for (std::size_t i = 0; i < RadauIIA::stages; ++i) {
        if (!(f(0, i == 0 ? from : y[i - 1]) * f(0, y[i]) < 0.0L)) continue;
        Stages part;
        if (radau_(t, from, root(i, f, 8), part)) raise_peaks(part.back());
      }
    }
    now_ = y.back();
    raise_peaks(now_);
    raise_peaks(bodies_.contact(t + h, now_));
    peak_speed_ = std::max(peak_speed_, length(now_.v));
    if (changes) bodies_.lifted = !bodies_.lifted;
    result_.uplift = result_.uplift || bodies_.lifted;
    return t + h;
  }

  void raise_peaks(const State& s) {
    const Two x{bodies_.cos_slope() * s.x[0], s.x[1]};
    result_.peak_m = std::max(result_.peak_m, length(x));
    result_.peak_along_m = std::max(result_.peak_along_m, std::abs(x[0]));
    result_.peak_across_m = std::max(result_.peak_across_m, std::abs(x[1]));
  }

  void raise_peaks(const FreeBodies::Motion& m) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (!bodies_.moves(k)) continue;
      Long &shear = result_.sliding_shear[k], &roof = result_.sliding_roof_m[k];
      shear = std::max(shear, std::abs(bodies_.base_shear(k, m)));
      roof = std::max(roof, std::abs(now_.u[k][bodies_.floors(k) - 1]));
    }
  }

  /// The rest of the way, too short to be curved. What the static friction does not hold goes on.
  Long stop(Long t, Long left, const FreeBodies::Motion& m) {
    for (std::size_t k = 0; k < 2; ++k) {
      now_.x[k] += 0.5L * left * now_.v[k];
      now_.v[k] = 0;
      for (std::size_t i = 0; i < bodies_.floors(k); ++i) {
        now_.u[k][i] += left * now_.rate[k][i];
        now_.rate[k][i] += left * (m.floor[k][i] - bodies_.ground(k, t));
      }
    }
    raise_peaks(now_);
    t = std::min(t + left, bodies_.dt());
    sliding_ = !(bodies_.resting(t, bodies_.dt(), now_).cone[0] > 0.0L);
    step_ = bodies_.dt();
    return t;
  }

  FreeBodies bodies_;
  RadauStep radau_{bodies_};
  Long tolerance_;
  TwoAxisTruth& result_;
  State now_;
  bool sliding_ = false;
  Long step_ = 0, peak_speed_ = 0;
};

}  // namespace

TwoAxisTruth::TwoAxisTruth(const TruthScene& scene, double tolerance) {
  History(scene, tolerance, *this).run(scene.ground_mps2[0].size());
}

}  // namespace glissade::test
