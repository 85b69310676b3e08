// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/record_edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"

namespace glissade {
namespace {

constexpr double step_tolerance = 1e-6;  ///< of a step

}  // namespace

std::vector<double> on_step(const std::string& name, const Samples& a, double dt_s, double step_s) {
  const double ratio = step_s / dt_s, intervals = static_cast<double>(a.size()) / ratio;
  if (intervals > static_cast<double>(most_samples))
    throw InputError(
        {name, fmt::format("step_s = {:g} s gives more than {} samples", step_s, most_samples),
         "give the shortest step of the record's components", ""});
  std::vector<double> samples(static_cast<std::size_t>(std::ceil(intervals - step_tolerance)));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double at = static_cast<double>(i) * ratio;
    const auto before = std::min(static_cast<std::size_t>(at), a.size() - 1);
    const double next = before + 1 < a.size() ? a[before + 1] : 0.0;  // then it is zero
    samples[i] = std::lerp(a[before], next, at - static_cast<double>(before));
  }
  return samples;
}

Record resampled(Record record, double step_s) {
  GLISSADE_EXPECTS(step_s > 0.0 && record.dt_s > 0.0);
  const double ratio = step_s / record.dt_s;
  if (std::abs(ratio - 1.0) <= step_tolerance) return record;
  if (ratio > 1.0)
    throw InputError(
        {record.name,
         fmt::format("step_s = {:g} s is longer than its step, {:g} s", step_s, record.dt_s),
         "give the shortest step of the record's components", ""});
  std::vector<double> samples = on_step(record.name, record.acceleration_mps2, record.dt_s, step_s);
  record.notes.push_back(
      fmt::format("resampled from {:g} to {:g} s, by straight lines", record.dt_s, step_s));
  record.dt_s = step_s;
  record.acceleration_mps2 = std::move(samples);
  return record;
}

Record ended_at(Record record, double end_s) {
  const Samples& a = record.acceleration_mps2;
  const double count = std::floor(end_s / record.dt_s + step_tolerance);
  if (!(count >= 1.0))
    throw InputError({record.name, fmt::format("nothing of it is before end_s = {:g} s", end_s),
                      "give a later end_s", ""});
  if (count >= static_cast<double>(a.size())) return record;
  record.notes.push_back(
      fmt::format("ended at {:g} s of {:g} s", end_s, record.dt_s * static_cast<double>(a.size())));
  record.acceleration_mps2 =
      std::vector<double>(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count));
  return record;
}

}  // namespace glissade
