// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/package.hpp"

namespace glissade {

/// Spectra, demand over the periods (of several), probability of exceedance.
std::vector<Figure> package_figures(const CalculationPackage& package);

}  // namespace glissade
