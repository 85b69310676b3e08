// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "case.hpp"

namespace glissade::verification {

/// The roof of a linear building after a step of ground acceleration, and under a harmonic.
std::vector<Case> roof_after_steps();
std::vector<Case> transmissibility();

}  // namespace glissade::verification
