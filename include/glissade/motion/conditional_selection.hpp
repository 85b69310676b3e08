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

inline constexpr std::size_t conditional_starts = 60;

struct ConditionalSelection {
  std::vector<SelectedRecord> records;  ///< misfit to the mean, smallest first
  std::size_t candidates = 0;
  std::vector<LeftOutRecord> left_out;         ///< in the order of the library
  std::vector<std::vector<double>> spectra_g;  ///< by record and period, scaled: RotD50, 5 %
  std::vector<double> mean, sigma;             ///< of ln Sa (g) of the records, by period; n - 1
  double objective = 0.0;                      ///< what the selection makes small

  /// Largest |selected mean - target mean| of ln Sa, and largest |selected sigma - target sigma|
  /// over target sigma, over the periods.
  double mean_error(const SpectrumDistribution& target) const;
  double sigma_error(const SpectrumDistribution& target) const;
};

/// Selects records whose spectra have the mean and the standard deviation of the target (Jayaram,
/// Lin & Baker 2011). Each is scaled to Sa of the target at its period (RotD50), by a factor from
/// 1/max_scale to max_scale; `Motion::scale` is ignored. A start is a set of spectra drawn from the
/// target, and of each spectrum the closest candidate that is left; from there the best exchange of
/// one record is made until none improves the objective,
///   sum over the periods of (mean - target mean)^2 + 2 (sigma - target sigma)^2
/// (weights of Baker & Lee 2018). The best of all starts is kept; that no other set is better is
/// not proved. More starts begin with the same ones and give no larger objective. The result
/// depends on the records, the seed and the starts only. Throws InputError as select_records()
/// does.
/// @param starts >= 1
ConditionalSelection select_conditional(const Suite& library, const ConditionalTarget& target,
                                        const SelectionCriteria& criteria, std::uint64_t seed,
                                        std::size_t starts = conditional_starts);

}  // namespace glissade
