// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/report/figure.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

struct SpectraTexts {
  std::string suite;
  std::string scaled;  ///< "scaled to MCE"
  std::string target;  ///< in the key
  double to_s = 0.0;   ///< the longest period that is drawn; 0: all
};
/// The suite's spectra, their average and the target.
Figure spectra_figure(const SuiteSpectra& spectra, const SpectraTexts& texts);

}  // namespace glissade
