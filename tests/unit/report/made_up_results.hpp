// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/results.hpp"

namespace glissade {

/// A made-up but plausible study, by formula: 12 records x 16 samples x 20 levels of S_DS. Slip is
/// (x / C_ij)^2 x 0.3 m with lognormal C_ij = 0.9 g exp(a_i + b_j), log standard deviations 0.35 by
/// record and 0.2 by sample, so the capacity for a threshold c is C_ij sqrt(c / 0.3 m). The design
/// run has 0.8 of the capacities.
Results made_up_results();

}  // namespace glissade
