// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/rotd50.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/motion/response_spectrum.hpp"

namespace glissade {

std::vector<double> rotd50_spectrum(double dt_s, std::span<const double> first,
                                    std::span<const double> second,
                                    std::span<const double> periods_s) {
  GLISSADE_EXPECTS(first.size() == second.size());
  constexpr std::size_t orientations = 6;
  std::array<std::vector<double>, orientations> spectra;
  std::vector<double> rotated(first.size());
  for (std::size_t k = 0; k < orientations; ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / orientations;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    std::transform(first.begin(), first.end(), second.begin(), rotated.begin(),
                   [&](double x, double y) { return cosine * x + sine * y; });
    spectra[k] = pseudo_acceleration_spectrum(dt_s, rotated, periods_s);
  }
  std::vector<double> median(periods_s.size());
  for (std::size_t p = 0; p < periods_s.size(); ++p) {
    std::vector<double> values(orientations);
    std::transform(spectra.begin(), spectra.end(), values.begin(),
                   [&](const auto& spectrum) { return spectrum[p]; });
    median[p] = quantile_of(std::move(values), 0.5);
  }
  return median;
}

}  // namespace glissade
