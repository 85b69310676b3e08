// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/motion/record.hpp"

// Changes of a record that a suite asks for; each leaves a note on it.
namespace glissade {

/// With a shorter step, by straight lines between its samples. Throws InputError where step_s is
/// longer than its step, which would lose frequencies, and where the samples would be too many.
Record resampled(Record record, double step_s);

/// Samples of the step dt_s at another one, along the straight lines between them. `name` for the
/// InputError where they would be too many.
std::vector<double> on_step(const std::string& name, const Samples& samples, double dt_s,
                            double step_s);

/// Without what is at and after end_s, from its first sample. Throws InputError where nothing is
/// left.
Record ended_at(Record record, double end_s);

}  // namespace glissade
