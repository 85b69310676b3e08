// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/report/package.hpp"

namespace glissade {

/// The roof in plan with the required separations to scale, each with what is available.
std::string separations_sketch(const CalculationPackage& package);

}  // namespace glissade
