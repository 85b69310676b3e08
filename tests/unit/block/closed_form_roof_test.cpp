// SPDX-License-Identifier: GPL-3.0-or-later
// The roof under the block: absolute acceleration of a linear building. Derivations in
// closed_forms/oscillator.hpp.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "closed_forms/measured.hpp"
#include "closed_forms/oscillator.hpp"
#include "glissade/building/roof_motion.hpp"

namespace glissade {
namespace closed_form_roof_test {

using namespace closed_forms;

TEST(roof_after_a_step, follows_the_closed_form_and_has_its_peak) {
  for (const double damping : {0.0, 0.02, 0.05, 0.3, 0.9}) {
    const double period = 0.4;
    const StepPeak peak = roof_peak_after_step(period, damping);
    // steps that put the peak on a sample
    const double dt = peak.time_s / 25;
    const RoofMotion roof =
        roof_motion({dt, std::vector<double>(1000, 1.0)}, {.horizontal = {period, damping}}, {});
    SCOPED_TRACE(damping);
    for (std::size_t i = 0; i < roof.horizontal_mps2.size(); ++i)
      ASSERT_NEAR(roof.horizontal_mps2[i],
                  roof_after_step(period, damping, static_cast<double>(i) * roof.dt_s), 1e-12);
    EXPECT_NEAR(roof.peak_horizontal_mps2, peak.value, 1e-13);
  }
}

TEST(roof_under_a_harmonic, has_the_transmissibility_of_the_sampled_harmonic_to_rounding) {
  for (const double damping : {0.05, 0.2})
    for (const double ratio : {0.3, 0.9, 1.0, 1.4, 3.0})
      for (const int n : {12, 50}) {
        const std::complex<double> expected = sampled_transmission(ratio, damping, n);
        EXPECT_LT(std::abs(transmission_of_roof(ratio, damping, n) / expected - 1.0), 1e-11)
            << "damping " << damping << " ratio " << ratio << " n " << n;
      }
}

TEST(roof_under_a_harmonic, has_the_transmissibility_of_the_sine_to_second_order) {
  for (const double ratio : {0.5, 1.0, 2.0}) {
    const double expected = std::abs(transmission(ratio, 0.05));
    const auto error = [&](int n) {
      return std::abs(transmission_of_roof(ratio, 0.05, n)) / expected - 1;
    };
    EXPECT_NEAR(error(100), -std::pow(2 * std::numbers::pi / 100, 2) / 12, 1e-6);
    EXPECT_NEAR((4 * error(200) - error(100)) / 3, 0.0, 1e-6);
  }
}

TEST(roof_under_a_harmonic, is_loudest_at_the_ratio_of_the_peak) {
  for (const double damping : {0.05, 0.2}) {
    const double ratio = ratio_of_peak(damping);
    // The sampled sine is smaller by sinc^2, whatever the building; its images are below 1e-6.
    const double sinc = std::sin(std::numbers::pi / 50) / (std::numbers::pi / 50);
    const auto gain = [&](double r) {
      return std::abs(transmission_of_roof(r, damping, 50)) / (sinc * sinc);
    };
    const double z = 2 * damping * ratio;
    const double formula = std::sqrt((1 + z * z) / (std::pow(1 - ratio * ratio, 2) + z * z));
    EXPECT_NEAR(gain(ratio), formula, 1e-6);
    EXPECT_LT(gain(0.99 * ratio), gain(ratio));
    EXPECT_LT(gain(1.01 * ratio), gain(ratio));
  }
}

}  // namespace closed_form_roof_test
}  // namespace glissade
