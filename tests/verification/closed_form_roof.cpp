// SPDX-License-Identifier: GPL-3.0-or-later
#include "closed_form_roof.hpp"

#include <fmt/format.h>

#include <cmath>

#include "closed_forms/measured.hpp"
#include "closed_forms/oscillator.hpp"

namespace glissade::verification {

using namespace closed_forms;

std::vector<Case> roof_after_steps() {
  std::vector<Case> cases;
  for (const double damping : {0.02, 0.05, 0.3}) {
    const StepPeak peak = roof_peak_after_step(0.4, damping);
    const RoofMotion roof = roof_motion({peak.time_s / 25, std::vector<double>(1000, 1.0)},
                                        {.horizontal = {0.4, damping}}, {});
    double worst = 0.0;
    for (std::size_t i = 0; i < roof.horizontal_mps2.size(); ++i)
      worst =
          worse(worst, std::abs(roof.horizontal_mps2[i] -
                                roof_after_step(0.4, damping, static_cast<double>(i) * roof.dt_s)));
    const std::string name = fmt::format(
        "suddenly applied ground acceleration of 1 m/s2, period 0.4 s, damping {}", damping);
    cases.push_back(limit(
        {name, "roof acceleration, m/s2", "1 - exp(-z w t) [cos W t - z / sqrt(1 - z^2) sin W t]"},
        {"largest difference", worst, 1e-12}));
    cases.push_back(compare(
        {name, "peak roof acceleration, m/s2", "1 + exp(-z (pi - 2 asin z) / sqrt(1 - z^2))"},
        {roof.peak_horizontal_mps2, peak.value, 1e-13}));
  }
  return cases;
}

std::vector<Case> transmissibility() {
  std::vector<Case> cases;
  for (const double damping : {0.05, 0.2}) {
    const double peak = ratio_of_peak(damping);
    for (const double ratio : {0.3, peak, 3.0}) {
      const std::string name = fmt::format("steady state, T / T_ground = {:.6g}{}, damping {}",
                                           ratio, ratio == peak ? " (the largest)" : "", damping);
      cases.push_back(
          limit({name, "roof / ground acceleration, complex, 12 samples a cycle",
                 "(1 + 2 i z r) / (1 - r^2 + 2 i z r), summed over the images of the sampled sine"},
                {"relative difference",
                 std::abs(transmission_of_roof(ratio, damping, 12) /
                              sampled_transmission(ratio, damping, 12) -
                          1.0),
                 1e-11}));
      cases.push_back(compare(
          {name, "roof / ground acceleration, extrapolated from 100 and 200 samples a cycle",
           "sqrt((1 + (2 z r)^2) / ((1 - r^2)^2 + (2 z r)^2)), Chopra section 3.6"},
          {extrapolated([&](int n) { return std::abs(transmission_of_roof(ratio, damping, n)); },
                        100),
           std::abs(transmission(ratio, damping)), 1e-6}));
    }
  }
  return cases;
}

}  // namespace glissade::verification
