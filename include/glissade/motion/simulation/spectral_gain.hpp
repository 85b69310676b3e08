// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace glissade {

/// A zero-phase amplitude gain over frequency: ln-ln linear between its points, constant outside.
/// Not published.
struct SpectralGain {
  std::vector<double> frequencies_hz;  ///< increasing, > 0
  std::vector<double> values;          ///< > 0, one per frequency

  double operator()(double frequency_hz) const;
};

/// The gains of a suite; both horizontals have the same.
struct SuiteGain {
  SpectralGain horizontal, vertical;
};

/// Multiplies the Fourier transform of the signal by the gain. The signal is padded with at least
/// 20 s of zeros, so that a gain that is smooth above 0.25 Hz has no circular convolution error;
/// the part outside the original duration is cut.
std::vector<double> apply_gain(std::span<const double> signal, double dt_s,
                               const SpectralGain& gain);

}  // namespace glissade
