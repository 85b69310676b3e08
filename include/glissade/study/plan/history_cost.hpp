// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/plan/plan.hpp"

namespace glissade {

/// Microseconds of a history of 8,000 samples on the buildings of a study: history_us(), more on a
/// building of a short period, which is tabulated in parts of the step, and on one that is hardly
/// damped, which goes on making the array slide, twice a cycle.
struct HistoryCost {
  double mean_us = 0.0, largest_us = 0.0;
};
HistoryCost history_cost(Kernel kernel, const StudyConfig& config, double step_s);

/// Predicted seconds of one core of the fits of fragilities with their resamples.
double predicted_fit_seconds(const Plan& plan);

}  // namespace glissade
