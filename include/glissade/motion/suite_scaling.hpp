// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade {

/// The periods over which Walters et al. (2012) hold the suite average above the target: 0, then 0.05 to 2 s
/// in steps of 0.05 s refined at short periods.
std::vector<double> walters_periods_s();

/// The one factor on the whole suite (each motion's own `scale` applied first) for which the average over motions
/// of the SRSS spectra of their horizontals (5 %) is nowhere below `target_sa_g` over `periods_s` and touches it
/// at one period at least (Walters et al. 2012).
double suite_average_factor(const Suite& suite, const std::function<double(double)>& target_sa_g,
                            const std::vector<double>& periods_s);

struct SuiteScaling {
  std::vector<double> factors;        ///< per motion, to be multiplied on its components
  double largest_factor = 0.0;
  double controlling_period_s = 0.0;  ///< where the average touches the target
};

/// One factor per motion, as Walters: each motion's SRSS spectrum is first brought as close as a factor can to the
/// target (least squares in ln Sa over the periods), then one common factor lifts the average to the target. Motions that
/// would exceed `max_factor` are held there and the others make up for them; InputError if that is not possible.
SuiteScaling scale_suite_to_target(const Suite& suite, const std::function<double(double)>& target_sa_g,
                                   const std::vector<double>& periods_s, double max_factor);

}  // namespace glissade
