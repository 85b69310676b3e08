// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "glissade/core/error.hpp"
#include "glissade/motion/improbable.hpp"

namespace glissade {
namespace {

constexpr double whole_number_tolerance = 1e-6;
constexpr double largest_whole_number = 1e15;  // whose neighbours are distinct doubles

std::optional<std::size_t> whole_number(double value) {
  const double nearest = std::round(value);
  if (!(std::abs(value - nearest) <= whole_number_tolerance) || nearest < 0.0 ||
      nearest > largest_whole_number) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(nearest);
}

void check_record(const Record& record, ProblemList& problems) {
  if (!(std::isfinite(record.dt_s) && record.dt_s > 0.0)) {
    problems.add({record.name, fmt::format("dt_s = {} is not a positive number", record.dt_s),
                  "give the time between samples in seconds", ""});
  }
  const Samples& samples = record.acceleration_mps2;
  if (samples.empty())
    problems.add({record.name, "the record has no samples", "check the file", ""});
  const auto bad = std::ranges::find_if_not(
      samples, [](double a) { return std::abs(a) <= most_acceleration_mps2; });
  if (bad != samples.end()) {
    problems.add({record.name, fmt::format("sample {} is {} m/s2", bad - samples.begin() + 1, *bad),
                  "replace it by a finite number, or correct the units", ""});
  }
}

/// Position of a component on the time axis of the motion.
struct Placement {
  std::size_t start = 0;   ///< sample of the motion at which the component begins
  std::size_t stride = 1;  ///< samples of the motion per sample of the component
};

Placement place(const TimedRecord& component, double dt_s, ProblemList& problems) {
  const Record& record = component.record;
  Placement placement;
  if (const auto stride = whole_number(record.dt_s / dt_s)) {
    placement.stride = *stride;
  } else {
    problems.add({record.name,
                  fmt::format("dt_s = {} is not a whole multiple of the finest component's {}",
                              record.dt_s, dt_s),
                  "resample the component to that step", ""});
  }
  if (const auto start = whole_number(component.start_s / dt_s)) {
    placement.start = *start;
  } else {
    const double nearest_s = std::max(0.0, std::round(component.start_s / dt_s)) * dt_s;
    problems.add(
        {record.name,
         fmt::format("start_s = {} is not a whole number >= 0 of the motion's samples (dt_s = {})",
                     component.start_s, dt_s),
         fmt::format("the nearest is {:.10g}", nearest_s), ""});
  }
  return placement;
}

/// As a double, which does not overflow.
double end_of(const Record& record, const Placement& placement) {
  return static_cast<double>(placement.start) +
         static_cast<double>(record.acceleration_mps2.size()) *
             static_cast<double>(placement.stride);
}

/// Samples of the component on the time axis of the motion, interpolated between its own samples
/// (also over the interval after the last one, which ends at zero).
Samples on_clock(const Record& record, const Placement& placement, std::size_t length) {
  const Samples& samples = record.acceleration_mps2;
  if (placement.stride == 1 && samples.size() == length) return samples;  // begins at 0
  std::vector<double> result(length, 0.0);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double here = samples[n];
    const double next = n + 1 < samples.size() ? samples[n + 1] : 0.0;
    for (std::size_t k = 0; k < placement.stride; ++k) {
      const double fraction = static_cast<double>(k) / static_cast<double>(placement.stride);
      result[placement.start + n * placement.stride + k] = std::lerp(here, next, fraction);
    }
  }
  return result;
}

struct Component {
  const char* name;
  const TimedRecord& timed;
  Samples& samples;  ///< in the motion
  Placement placement;

  double duration_s() const {
    return timed.record.dt_s * static_cast<double>(timed.record.acceleration_mps2.size());
  }
  double end_s() const { return timed.start_s + duration_s(); }
};

/// A file that was cut short, or was read with a wrong step, ends earlier than the others.
void compare_clocks(const std::vector<Component>& components, Motion& motion) {
  constexpr double most_apart_s = 1.0;
  const auto by_end = [](const Component& c) { return c.end_s(); };
  const auto [first, last] = std::ranges::minmax_element(components, {}, by_end);
  const bool is_stated =
      std::ranges::any_of(components, [](const Component& c) { return c.timed.start_s > 0.0; });
  const auto differs = [&](const Component& c) {
    return c.timed.record.dt_s != components.front().timed.record.dt_s ||
           c.duration_s() != components.front().duration_s();
  };
  motion.starts_are_assumed = !is_stated && std::ranges::any_of(components, differs);
  if (last->end_s() - first->end_s() > most_apart_s)
    motion.contradictions.push_back(fmt::format(
        "its {} component ends at {:.4g} s, its {} at {:.4g} s: is a file cut short, or its step "
        "wrong? It is taken as zero from its end on{}",
        first->name, first->end_s(), last->name, last->end_s(),
        is_stated ? "" : ", and all are assumed to start together"));
}

/// "first and vertical component: less its mean".
void collect_notes(const std::vector<Component>& components, Motion& motion) {
  std::vector<std::string> seen;
  for (const Component& component : components) {
    for (const std::string& note : component.timed.record.notes) {
      if (std::ranges::find(seen, note) != seen.end()) continue;
      seen.push_back(note);
      std::string names;
      for (const Component& other : components)
        if (std::ranges::find(other.timed.record.notes, note) != other.timed.record.notes.end())
          names += (names.empty() ? "" : " and ") + std::string(other.name);
      motion.notes.push_back(names + " component: " + note);
    }
  }
}

}  // namespace

Motion assemble_motion(Motion metadata, const TimedRecord& first,
                       const std::optional<TimedRecord>& second,
                       const std::optional<TimedRecord>& vertical) {
  Motion motion = std::move(metadata);
  motion.horizontal_mps2 = {};
  motion.vertical_mps2 = {};
  std::vector<Component> components;
  components.push_back({"first", first, motion.horizontal_mps2[0], {}});
  if (second) components.push_back({"second", *second, motion.horizontal_mps2[1], {}});
  if (vertical) components.push_back({"vertical", *vertical, motion.vertical_mps2, {}});

  ProblemList problems;
  for (const Component& component : components) check_record(component.timed.record, problems);
  problems.throw_if_any();

  motion.dt_s = first.record.dt_s;
  for (const Component& component : components) {
    motion.dt_s = std::min(motion.dt_s, component.timed.record.dt_s);
  }
  double length = 0.0;
  for (Component& component : components) {
    const Record& record = component.timed.record;
    component.placement = place(component.timed, motion.dt_s, problems);
    const double end = end_of(record, component.placement);
    length = std::max(length, end);
    if (end > static_cast<double>(most_samples)) {
      problems.add({record.name,
                    fmt::format("would end after {} samples of the motion's step, dt_s = {}, the "
                                "finest component's (the most is {})",
                                end, motion.dt_s, most_samples),
                    "check dt_s and start_s of all components", ""});
    }
  }
  problems.throw_if_any();
  compare_clocks(components, motion);
  collect_notes(components, motion);

  for (const Component& component : components) {
    component.samples =
        on_clock(component.timed.record, component.placement, static_cast<std::size_t>(length));
  }
  return motion;
}

}  // namespace glissade
