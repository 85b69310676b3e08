// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "glissade/fragility/bootstrap.hpp"

namespace glissade {

/// Whether capacities follow the lognormal that is fitted to them. NaN where there is no test: no
/// maximum of the likelihood, or fewer than three records.
struct GoodnessOfFit {
  double distance = std::numeric_limits<double>::quiet_NaN();     ///< Cramér-von Mises, see below
  double p_value = std::numeric_limits<double>::quiet_NaN();      ///< least_p_value to 1
  double correlation = std::numeric_limits<double>::quiet_NaN();  ///< of one record's normal scores
  double largest_gap = std::numeric_limits<double>::quiet_NaN();  ///< observed share - curve ...
  double gap_intensity = std::numeric_limits<double>::quiet_NaN();  ///< ... where it is largest
};

/// A fragility is reported not to be lognormal where p is below the first, and the largest gap of a
/// probability at least the second: many samples show departures that matter to nobody.
inline constexpr double goodness_of_fit_level = 0.05, goodness_of_fit_gap = 0.05;
/// The data and 199 replicates: a p that is this is an upper bound.
inline constexpr double least_p_value = 1.0 / 200;
bool departs_from_lognormal(const GoodnessOfFit& fit);

/// Cramér-von Mises distance between the shares of capacities and the fitted curve, the integral of
/// (observed share - u)^2 over the curve's probability u from 0 to its value where the capacities
/// are censored (Pettitt & Stephens 1976, Biometrika 63(2):291-298). Its distribution for
/// capacities that are lognormal is found by parametric bootstrap with the fit made again on each
/// replicate (Stute, González Manteiga & Presedo Quindimil 1993, Metrika 40:243-256). Records are
/// the independent unit: in a replicate the capacities of a record have the correlation of normal
/// scores that those of the data have. Histories that slide freely are left out.
/// `options.replicates` beyond 199 are not used. @param rows exact, or above one highest level.
/// @param stratified the histories of a record are stratified samples (Sobol points), which scatter
/// less: in a replicate a record of more than 64 has 64, one in each of equal parts of probability
/// @param unit_of by record: the event, whose records' capacities are correlated too; empty: none
GoodnessOfFit lognormal_goodness_of_fit(const std::vector<Bracket>& rows,
                                        const BootstrapOptions& options, bool stratified = false,
                                        const std::vector<std::size_t>& unit_of = {});

}  // namespace glissade
