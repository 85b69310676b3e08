// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace glissade::bench {

/// Largest |value|, one pass in the widest vectors the machine has (Highway's run-time dispatch):
/// the least that anything which looks at every sample once can cost. Finite values.
double max_pass(std::span<const double> values);

/// The vectors it runs in: "AVX3_ZEN4", "NEON" ...
std::string max_pass_target();

}  // namespace glissade::bench
