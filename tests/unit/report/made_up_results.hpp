// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/results.hpp"

namespace glissade {

/// A made-up but plausible study, by formula: 12 records x 16 samples x 20 levels of S_DS. Slip is
/// (x / C_ij)^2 x 0.3 m with lognormal C_ij = 0.9 g exp(a_i + b_j), log standard deviations 0.35 by
/// record and 0.2 by sample, so the capacity for a threshold c is C_ij sqrt(c / 0.3 m). The design
/// run has 0.8 of the capacities.
Results made_up_results();

/// The same, and how fast the array first reaches each threshold.
Results made_up_impact_results();

/// A made-up design chart, by formula, over S_DS, with both standards: levels 0.5, 1, 1.5 g, slopes
/// 0 to 7 degrees by 0.5, friction 0.1 to 0.8 by 0.05, building periods 0.2, 0.5, 1 s. Record i = 0
/// ... 9 slides (0.55 + 0.1 i) p(T) 0.25 m max(0, x - y)^2 / y, with y = mu - tan(slope) and p =
/// 0.7, 1, 0.4: of the factor by record the mean is 1, the 84th percentile (type 7) 1.306, the 95th
/// 1.405, the largest 1.45. At 0.5 s a flat roof with mu = 0.5 slides 0.125 m in the mean at 1 g.
Results made_up_chart_results();
/// The same of one record of factor 1 on a rigid building, over the peak roof acceleration from 0
/// to 1.5 g by 0.1, without standards: the shape of the first paper's study.
Results made_up_one_record_chart();

}  // namespace glissade
