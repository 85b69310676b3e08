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

/// An oscillator along one axis: omega^2 u, and the velocity by omega.
struct PlanAxis {
  double x = 0.0, y = 0.0;
  void move(const OscillatorStep& s, double a0, double a1) {
    const double from = x;
    x = s.xx * from + s.xy * y - (s.x_start * a0 + s.x_end * a1);
    y = -s.xy * from + s.yy * y - (s.y_start * a0 + s.y_end * a1);
  }
};

/// Of the oscillator of a period in plan, with the period after the end of the motion.
PlanPath path_of(const Motion& motion, double period_s, double damping_ratio) {
  constexpr double most_phase = 0.02;  // of a part of an interval: the bound on the error
  const auto& [first, second] = motion.horizontal_mps2;
  PlanPath path;
  if (period_s == 0.0) {
    for (std::size_t i = 0; i < first.size(); ++i) path.push_back({first[i], second[i]});
    return path;
  }
  const double phase = 2.0 * std::numbers::pi * motion.dt_s / period_s;
  const double parts = std::ceil(phase / most_phase);
  const OscillatorStep step = oscillator_step(phase / parts, damping_ratio);
  const auto after =
      static_cast<std::size_t>(std::ceil(period_s / motion.dt_s)) + 1;  // its free vibration
  const auto at = [](const Samples& a, std::size_t i) { return i < a.size() ? a[i] : 0.0; };
  const std::size_t intervals = first.size() + after;
  path.reserve(intervals * static_cast<std::size_t>(parts));
  PlanAxis along, across;
  for (std::size_t i = 0; i < intervals; ++i) {
    const double x0 = at(first, i), dx = (at(first, i + 1) - x0) / parts, y0 = at(second, i),
                 dy = (at(second, i + 1) - y0) / parts;
    for (double part = 0.0; part < parts; ++part) {
      along.move(step, x0 + part * dx, x0 + (part + 1.0) * dx);
      across.move(step, y0 + part * dy, y0 + (part + 1.0) * dy);
      path.push_back({along.x, across.x});
    }
  }
  return path;
}

double square(const OrbitPoint& p) { return p.x * p.x + p.y * p.y; }

/// Without points that are inside a circle within the hull of all. The support changes with the
/// direction by the largest radius a radian at most; that of some of the points is below it.
void drop_inner(PlanPath& path, double largest_radius) {
  constexpr int directions = 32;
  constexpr std::size_t some = 8;
  double inner = std::numeric_limits<double>::infinity();
  for (int k = 0; k < directions; ++k) {
    const double angle = std::numbers::pi * k / directions, c = std::cos(angle),
                 s = std::sin(angle);
    double largest = 0.0;
    for (std::size_t i = 0; i < path.size(); i += some)
      largest = std::max(largest, std::abs(path[i].x * c + path[i].y * s));
    inner = std::min(inner, largest);
  }
  inner -= largest_radius * 0.5 * std::numbers::pi / directions;
  if (inner > 0.0)
    std::erase_if(path, [&](const OrbitPoint& p) { return square(p) < inner * inner; });
}

/// The convex hull of the points and their opposites, counter-clockwise (Andrew 1979).
PlanPath hull_of(PlanPath points) {
  const std::size_t own = points.size();
  for (std::size_t i = 0; i < own; ++i) points.push_back({-points[i].x, -points[i].y});
  std::ranges::sort(points, {}, [](const OrbitPoint& p) { return std::pair(p.x, p.y); });
  PlanPath hull;
  const auto chain = [&hull](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), *p) <= 0.0)
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
    PlanPath path = path_of(motion, periods_s[i], damping_ratio);
    double largest = 0.0;
    for (const OrbitPoint& p : path) largest = std::max(largest, square(p));
    largest = std::sqrt(largest);
    drop_inner(path, largest);
    spectrum.rotd100_mps2[i] = largest;
    if (largest > 0.0) spectrum.rotd50_mps2[i] = median_support(arcs_of(hull_of(path)), largest);
  });
  return spectrum;
}

}  // namespace glissade
