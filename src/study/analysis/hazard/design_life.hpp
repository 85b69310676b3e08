// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/analysis/hazard.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// Slip over the design life, by Monte Carlo of a compound Poisson process: earthquakes come at the
/// rates of the hazard curve, each with a record drawn from all. What is drawn for a sample
/// (friction, slope, building) is the array's for the whole life: drawn anew for each earthquake
/// it would average out, which gives less. Residual and peak displacement of an earthquake are
/// linear between the levels of its history. Fills in what HazardRun has of the life.
void add_design_life(const HazardConfig& hazard, const Results& results, CaseSlice cases,
                     const BootstrapOptions& options, HazardRun& run);

}  // namespace glissade
