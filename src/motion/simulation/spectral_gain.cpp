// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/spectral_gain.hpp"

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "glissade/core/contract.hpp"

namespace glissade {

double SpectralGain::operator()(double frequency_hz) const {
  GLISSADE_EXPECTS(!values.empty() && values.size() == frequencies_hz.size());
  if (frequency_hz <= frequencies_hz.front()) return values.front();
  if (frequency_hz >= frequencies_hz.back()) return values.back();
  const auto above = static_cast<std::size_t>(
      std::upper_bound(frequencies_hz.begin(), frequencies_hz.end(), frequency_hz) -
      frequencies_hz.begin());
  const double weight = std::log(frequency_hz / frequencies_hz[above - 1]) /
                        std::log(frequencies_hz[above] / frequencies_hz[above - 1]);
  return values[above - 1] * std::pow(values[above] / values[above - 1], weight);
}

std::vector<double> apply_gain(std::span<const double> signal, double dt_s,
                               const SpectralGain& gain) {
  constexpr double padding_s = 20.0;
  const std::size_t size =
      std::bit_ceil(signal.size() + static_cast<std::size_t>(std::ceil(padding_s / dt_s)));
  std::vector<double> transform(size, 0.0);
  std::copy(signal.begin(), signal.end(), transform.begin());
  gsl_fft_real_radix2_transform(transform.data(), 1, size);
  // GSL's half-complex order: real parts 0 ... size/2, then imaginary parts backwards.
  for (std::size_t k = 0; k <= size / 2; ++k) {
    const double factor = gain(static_cast<double>(k) / (static_cast<double>(size) * dt_s));
    transform[k] *= factor;
    if (k > 0 && k < size / 2) transform[size - k] *= factor;
  }
  gsl_fft_halfcomplex_radix2_inverse(transform.data(), 1, size);
  transform.resize(signal.size());
  return transform;
}

}  // namespace glissade
