// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/fragility/hazard.hpp"

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

/// Baker, seismic-hazard-and-risk (github.com/bakerjw), chapter9/illustrate_fragility.m: a hazard
/// curve at 100 intensities from 0.001 to 2, equally spaced in the logarithm, and at 2.1.
inline std::vector<HazardPoint> baker_hazard() {
  const std::vector<double> rates = {
      2.5169495459e-2, 2.4300597335e-2, 2.3436547256e-2, 2.2579246247e-2, 2.1730515845e-2,
      2.0892083782e-2, 2.0065571514e-2, 1.9252483750e-2, 1.8454200087e-2, 1.7671968801e-2,
      1.6906902773e-2, 1.6159977505e-2, 1.5432031106e-2, 1.4723766127e-2, 1.4035753038e-2,
      1.3368435182e-2, 1.2722134954e-2, 1.2097061010e-2, 1.1493316260e-2, 1.0910906417e-2,
      1.0349748918e-2, 9.8096819778e-3, 9.2904736376e-3, 8.7918306220e-3, 8.3134068859e-3,
      7.8548117360e-3, 7.4156174418e-3, 6.9953662727e-3, 6.5935769198e-3, 6.2097502802e-3,
      5.8433745973e-3, 5.4939299700e-3, 5.1608922491e-3, 4.8437363569e-3, 4.5419390665e-3,
      4.2549812872e-3, 3.9823499037e-3, 3.7235392189e-3, 3.4780520494e-3, 3.2454005239e-3,
      3.0251066288e-3, 2.8167025459e-3, 2.6197308227e-3, 2.4337444104e-3, 2.2583066028e-3,
      2.0929909055e-3, 1.9373808575e-3, 1.7910698288e-3, 1.6536608089e-3, 1.5247662013e-3,
      1.4040076341e-3, 1.2910157950e-3, 1.1854302950e-3, 1.0868995664e-3, 9.9508079323e-4,
      9.0963987667e-4, 8.3025143190e-4, 7.5659881443e-4, 6.8837417206e-4, 6.2527851804e-4,
      5.6702182083e-4, 5.1332310514e-4, 4.6391055931e-4, 4.1852164361e-4, 3.7690319465e-4,
      3.3881152091e-4, 3.0401248514e-4, 2.7228156947e-4, 2.4340391986e-4, 2.1717436673e-4,
      1.9339741947e-4, 1.7188723282e-4, 1.5246754400e-4, 1.3497157972e-4, 1.1924193298e-4,
      1.0513041001e-4, 9.2497848238e-5, 8.1213906535e-5, 7.1156829436e-5, 6.2213187459e-5,
      5.4277595795e-5, 4.7252413977e-5, 4.1047429266e-5, 3.5579526635e-5, 3.0772348269e-5,
      2.6555945523e-5, 2.2866426241e-5, 1.9645600229e-5, 1.6840625568e-5, 1.4403658288e-5,
      1.2291507710e-5, 1.0465299572e-5, 8.8901488096e-6, 7.5348436143e-6, 6.3715421434e-6,
      5.3754830109e-6, 4.5247104337e-6, 3.7998146710e-6, 3.1836881739e-6, 2.6612976449e-6,
      1.0000000000e-9};
  std::vector<HazardPoint> points;
  for (std::size_t i = 0; i < rates.size(); ++i)
    points.push_back(
        {i < 100 ? 1e-3 * std::pow(2000.0, static_cast<double>(i) / 99) : 2.1, rates[i]});
  return points;
}

}  // namespace glissade::worked_examples
