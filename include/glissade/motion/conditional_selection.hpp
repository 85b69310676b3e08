// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glissade/motion/conditional_spectrum.hpp"
#include "glissade/motion/record_selection.hpp"

namespace glissade {

/// What records are selected for: the spectra of an earthquake and site where Sa at one period is
/// known.
struct ConditionalTarget {
  std::size_t period = 0;          ///< of the known Sa, among the periods
  double sa_g = 0.0;               ///< > 0
  SpectrumDistribution predicted;  ///< not knowing it
  SpectrumDistribution spectrum;   ///< knowing it

  double period_s() const { return spectrum.periods_s[period]; }
  double epsilon() const { return epsilon_of(predicted, period, sa_g); }
};

struct ConditionalSelection {
  std::vector<SelectedRecord> records;  ///< misfit to the mean, smallest first
  std::size_t candidates = 0;
  std::vector<LeftOutRecord> left_out;         ///< in the order of the library
  std::vector<std::vector<double>> spectra_g;  ///< by record and period, scaled: RotD50, 5 %
  std::vector<double> mean, sigma;             ///< of ln Sa (g) of the records, by period; n - 1

  /// Largest |selected mean - target mean| of ln Sa, and largest |selected sigma - target sigma|
  /// over target sigma, over the periods.
  double mean_error(const SpectrumDistribution& target) const;
  double sigma_error(const SpectrumDistribution& target) const;
};

/// Selects records whose spectra have the mean and the standard deviation of the target (Jayaram,
/// Lin & Baker 2011). Each is scaled to Sa of the target at its period (RotD50), by a factor from
/// 1/max_scale to max_scale; `Motion::scale` is ignored. Of 20 sets of spectra drawn from the
/// target the set that is closest to it is taken, of each spectrum the closest candidate that is
/// left; then the best exchange of one record is made until none improves
///   sum over the periods of (mean - target mean)^2 + 2 (sigma - target sigma)^2
/// (weights of Baker & Lee 2018). That no other set is better is not proved. The result depends on
/// the records and the seed only. Throws InputError as select_records() does.
ConditionalSelection select_conditional(const Suite& library, const ConditionalTarget& target,
                                        const SelectionCriteria& criteria, std::uint64_t seed);

}  // namespace glissade
