// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade::worked_examples {

/// Baker (2015), Earthquake Spectra 31(1):579-599, the counts of illustrate_msa_fits.m: 40 records
/// per stripe.
inline std::vector<Stripe> baker_2015() {
  return {{0.2, 40, 0}, {0.3, 40, 0},  {0.4, 40, 0},  {0.6, 40, 4},
          {0.7, 40, 6}, {0.8, 40, 13}, {0.9, 40, 12}, {1.0, 40, 16}};
}

/// MASTODON (Idaho National Laboratory), unit/src/TestMastodonUtils.C: probabilities 0.0001, 0.001,
/// 0.13 ... of 1,000 trials a level, in whole counts (0.1 rounds to 0).
inline std::vector<Stripe> mastodon() {
  return {{0.1, 1000, 0},   {0.2, 1000, 1},   {0.3, 1000, 130}, {0.4, 1000, 450},
          {0.5, 1000, 850}, {0.6, 1000, 970}, {0.7, 1000, 980}};
}

/// Bliss (1935), mortality of beetles by log10 of the dose of CS2, as in Dobson, An Introduction to
/// Generalized Linear Models. The dose itself is the intensity.
inline std::vector<Stripe> bliss_beetles() {
  return {{std::pow(10, 1.6907), 59, 6},  {std::pow(10, 1.7242), 60, 13},
          {std::pow(10, 1.7552), 62, 18}, {std::pow(10, 1.7842), 56, 28},
          {std::pow(10, 1.8113), 63, 52}, {std::pow(10, 1.8369), 59, 53},
          {std::pow(10, 1.8610), 62, 61}, {std::pow(10, 1.8839), 60, 60}};
}

/// Made up: nothing exceeds up to 0.6, everything from 0.8.
inline std::vector<Stripe> separated() {
  return {{0.2, 20, 0}, {0.4, 20, 0}, {0.6, 20, 0}, {0.8, 20, 20}, {1.0, 20, 20}, {1.2, 20, 20}};
}

}  // namespace glissade::worked_examples
