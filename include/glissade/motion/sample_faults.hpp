// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace glissade {

/// What the samples of a component show that no ground does: all of one value, flat for most of the
/// record, cut at the range of the recorder, one sample far above all others. Warnings: a person
/// looks at the record.
std::vector<std::string> sample_faults(std::span<const double> acceleration_mps2);

}  // namespace glissade
