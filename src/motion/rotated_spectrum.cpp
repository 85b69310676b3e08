// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/rotated_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/in_parallel.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade {
namespace {

struct OrbitPoint {
  double x, y;
};
using PlanPath = std::vector<OrbitPoint>;

double cross(const OrbitPoint& a, const OrbitPoint& b, const OrbitPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

OrbitPoint operator+(const OrbitPoint& a, const OrbitPoint& b) { return {a.x + b.x, a.y + b.y}; }
OrbitPoint operator-(const OrbitPoint& a, const OrbitPoint& b) { return {a.x - b.x, a.y - b.y}; }
OrbitPoint operator*(double k, const OrbitPoint& a) { return {k * a.x, k * a.y}; }
double square(const OrbitPoint& p) { return p.x * p.x + p.y * p.y; }

/// An oscillator in plan: along both axes.
struct PlanState {
  OscillatorState first, second;
  OrbitPoint place() const { return {first.x, second.x}; }
  OrbitPoint velocity() const { return {first.y, second.y}; }
  PlanState after(const OscillatorStep& step, const OrbitPoint& a0, const OrbitPoint& a1) const {
    return {step.after(first, a0.x, a1.x), step.after(second, a0.y, a1.y)};
  }
};

/// A linear map that makes points that lie near a line about as wide as long: by the Cholesky
/// factor of their second moments.
class RoundMap {
 public:
  explicit RoundMap(const std::vector<PlanState>& path) {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const PlanState& state : path) {
      const OrbitPoint p = state.place();
      xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y;
    }
    constexpr double least = 1e-9;  // of a path on a line
    const double more = least * (xx + yy);
    x_ = 1.0 / std::sqrt(xx + more);
    slope_ = xy * x_ * x_;
    y_ = 1.0 / std::sqrt(yy - slope_ * xy + more);
  }
  OrbitPoint operator()(const OrbitPoint& p) const { return {x_ * p.x, y_ * (p.y - slope_ * p.x)}; }

 private:
  double x_, slope_, y_;
};

/// The radius of a circle in the hull of the points and their opposites, under the map; 0: none.
/// The support changes with the direction by the largest radius a radian at most; that of some of
/// the points is below it.
double inner_radius(const std::vector<PlanState>& path, const RoundMap& round) {
  constexpr int directions = 32;
  constexpr std::size_t some = 8;
  std::vector<OrbitPoint> points;
  for (std::size_t i = 0; i < path.size(); i += some) points.push_back(round(path[i].place()));
  double inner = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (int k = 0; k < directions; ++k) {
    const double angle = std::numbers::pi * k / directions, c = std::cos(angle),
                 s = std::sin(angle);
    double support = 0.0;
    for (const OrbitPoint& p : points) support = std::max(support, std::abs(p.x * c + p.y * s));
    inner = std::min(inner, support);
  }
  for (const OrbitPoint& p : points) largest = std::max(largest, square(p));
  return std::max(0.0, inner - std::sqrt(largest) * 0.5 * std::numbers::pi / directions);
}

/// Of the oscillator of a period in plan, with the period after the end of the motion: the points
/// that may be on the hull of all. Between samples an interval is followed only where it may leave
/// the circle that is inside the hull of the path at the samples: the root of the sum of squares of
/// place and velocity grows by the acceleration times the phase at most.
PlanPath outer_path(const Motion& motion, double period_s, double damping_ratio) {
  constexpr double most_phase = 0.02;  // of a part of an interval: the bound on the error
  const auto& [first, second] = motion.horizontal_mps2;
  const auto ground = [&](std::size_t i) {
    return i < first.size() ? OrbitPoint{first[i], second[i]} : OrbitPoint{0.0, 0.0};
  };
  PlanPath outer;
  if (period_s == 0.0) {
    for (std::size_t i = 0; i < first.size(); ++i) outer.push_back(ground(i));
    return outer;
  }
  const double phase = 2.0 * std::numbers::pi * motion.dt_s / period_s;
  const OscillatorStep whole = oscillator_step(phase, damping_ratio);
  const auto after =
      static_cast<std::size_t>(std::ceil(period_s / motion.dt_s)) + 1;  // its free vibration
  std::vector<PlanState> path(first.size() + after + 1);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    path[i + 1] = path[i].after(whole, ground(i), ground(i + 1));
  const RoundMap round(path);
  const double inner = inner_radius(path, round);
  const double parts = std::ceil(phase / most_phase);
  const OscillatorStep part_step = oscillator_step(phase / parts, damping_ratio);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const OrbitPoint from = ground(i), rise = (1.0 / parts) * (ground(i + 1) - from);
    const double push =
        phase * std::sqrt(std::max(square(round(from)), square(round(ground(i + 1)))));
    PlanState state = path[i];
    const double swing = std::sqrt(square(round(state.place())) + square(round(state.velocity())));
    if (swing + push < inner) continue;
    for (double part = 0.0; part < parts; ++part) {
      state = state.after(part_step, from + part * rise, from + (part + 1.0) * rise);
      if (square(round(state.place())) >= inner * inner) outer.push_back(state.place());
    }
  }
  return outer;
}

/// The convex hull of the points and their opposites, counter-clockwise (Andrew 1979), without
/// corners that rounding makes of points on one line.
PlanPath hull_of(PlanPath points, double largest_radius) {
  const double rounding = 1e-13 * largest_radius * largest_radius;
  const std::size_t own = points.size();
  for (std::size_t i = 0; i < own; ++i) points.push_back({-points[i].x, -points[i].y});
  std::ranges::sort(points, {}, [](const OrbitPoint& p) { return std::pair(p.x, p.y); });
  PlanPath hull;
  const auto chain = [&hull, rounding](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), *p) <= rounding)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // the other chain begins with it
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

/// The directions along which one vertex has the largest value: r cos(theta - phi) there.
struct SupportArc {
  double r, phi, begin, end;
};

std::vector<SupportArc> arcs_of(const PlanPath& hull) {
  const std::size_t n = hull.size();
  const auto normal = [&](std::size_t i) {
    const OrbitPoint &from = hull[i % n], &to = hull[(i + 1) % n];
    return std::atan2(-(to.x - from.x), to.y - from.y);
  };
  std::vector<SupportArc> arcs;
  for (std::size_t i = 0; i < n; ++i) {
    const double begin = normal(i + n - 1);
    double end = normal(i);
    while (end < begin) end += 2.0 * std::numbers::pi;
    double phi = std::atan2(hull[i].y, hull[i].x);
    const double middle = 0.5 * (begin + end);
    phi += 2.0 * std::numbers::pi * std::round((middle - phi) / (2.0 * std::numbers::pi));
    arcs.push_back({std::hypot(hull[i].x, hull[i].y), phi, begin, end});
  }
  return arcs;
}

/// The angle of an arc along which the support is more than m.
double angle_above(const SupportArc& arc, double m) {
  if (arc.r <= m) return 0.0;
  const double half = std::acos(m / arc.r);
  return std::max(0.0, std::min(arc.end, arc.phi + half) - std::max(arc.begin, arc.phi - half));
}

/// The value that the support is above along half of all directions.
double median_support(const std::vector<SupportArc>& arcs, double largest) {
  double low = 0.0, high = largest;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double m = 0.5 * (low + high);
    double above = 0.0;
    for (const SupportArc& arc : arcs) above += angle_above(arc, m);
    (above > std::numbers::pi ? low : high) = m;
  }
  return high;
}

}  // namespace

RotatedSpectrum rotated_spectrum(const Motion& motion, std::span<const double> periods_s,
                                 double damping_ratio) {
  if (motion.horizontal_mps2[1].empty())
    throw InputError({motion.id, "has one horizontal: no spectrum over all directions",
                      "give its second horizontal, or leave it out", ""});
  RotatedSpectrum spectrum{std::vector<double>(periods_s.size()),
                           std::vector<double>(periods_s.size())};
  in_parallel(periods_s.size(), [&](std::size_t i) {
    GLISSADE_EXPECTS(periods_s[i] >= 0.0);
    const PlanPath path = outer_path(motion, periods_s[i], damping_ratio);
    double largest = 0.0;
    for (const OrbitPoint& p : path) largest = std::max(largest, square(p));
    largest = std::sqrt(largest);
    spectrum.rotd100_mps2[i] = largest;
    if (largest > 0.0)
      spectrum.rotd50_mps2[i] = median_support(arcs_of(hull_of(path, largest)), largest);
  });
  return spectrum;
}

}  // namespace glissade
