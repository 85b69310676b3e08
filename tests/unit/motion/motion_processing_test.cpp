// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/motion_processing.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "glissade/core/error.hpp"
#include "glissade/motion/intensity.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

MATCHER_P(IsNear, tolerance, "") {
  return std::abs(std::get<0>(arg) - std::get<1>(arg)) <= tolerance;
}

/// Of what an impulse becomes: the gain of the filter at a frequency, exactly.
double gain_of(const ButterworthBand& band, double hz, double dt_s) {
  constexpr std::size_t half = 40'000;
  std::vector<double> impulse(2 * half + 1, 0.0);
  impulse[half] = 1.0;
  const std::vector<double> response = band_passed(impulse, dt_s, band);
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < response.size(); ++i) {
    const double at = static_cast<double>(i) - static_cast<double>(half);
    sum += response[i] * std::polar(1.0, -2.0 * std::numbers::pi * hz * dt_s * at);
  }
  EXPECT_NEAR(sum.imag(), 0.0, 1e-10) << "no phase shift";
  return sum.real();
}

TEST(butterworth, the_gain_of_both_ways_is_that_of_its_formula_and_one_half_at_a_corner) {
  constexpr double dt_s = 0.01, low_hz = 0.5, high_hz = 20.0;
  const auto w = [](double hz) { return std::tan(std::numbers::pi * hz * dt_s); };
  for (const int order : {1, 2, 3, 4, 5, 8}) {
    const ButterworthBand high_pass{low_hz, {}, order}, low_pass{{}, high_hz, order},
        band{low_hz, high_hz, order};
    EXPECT_NEAR(gain_of(high_pass, low_hz, dt_s), 0.5, 1e-10) << order;
    EXPECT_NEAR(gain_of(low_pass, high_hz, dt_s), 0.5, 1e-10) << order;
    for (const double hz : {0.0, 0.1, 0.5, 1.0, 7.0, 20.0, 30.0, 49.0}) {
      // Squared, as the filter acts twice: 1 / (1 + (w / w_c)^2n).
      const double expected =
          1.0 / (1.0 + std::pow(w(hz) / w(high_hz), 2 * order)) *
          (hz == 0.0 ? 0.0 : 1.0 / (1.0 + std::pow(w(low_hz) / w(hz), 2 * order)));
      EXPECT_NEAR(gain_of(band, hz, dt_s), expected, 1e-9) << order << " at " << hz;
    }
  }
}

// scipy.signal.butter(2, 0.5) is b = (1, 2, 1) / (2 + sqrt 2), a = (1, 0, (2 - sqrt 2) /
// (2 + sqrt 2)): the formula at half of the Nyquist frequency, where w = 1.
TEST(butterworth, a_low_pass_at_a_quarter_of_the_rate_has_the_coefficients_of_the_formula) {
  const double root = std::sqrt(2.0), b = 1.0 / (2.0 + root), a2 = (2.0 - root) / (2.0 + root);
  std::vector<double> forwards{b, 2.0 * b, b - a2 * b, -2.0 * a2 * b, -a2 * (b - a2 * b)};
  forwards.resize(400, 0.0);
  for (std::size_t i = 5; i < forwards.size(); ++i) forwards[i] = -a2 * forwards[i - 2];
  std::vector<double> expected(forwards.size(), 0.0);  // its autocorrelation
  for (std::size_t lag = 0; lag < 50; ++lag)
    for (std::size_t i = 0; i + lag < forwards.size(); ++i)
      expected[lag] += forwards[i] * forwards[i + lag];
  std::vector<double> impulse(1001, 0.0);
  impulse[500] = 1.0;
  const std::vector<double> found = band_passed(impulse, 1.0, {{}, 0.25, 2});
  for (std::size_t lag = 0; lag < 50; ++lag) {
    EXPECT_NEAR(found[500 + lag], expected[lag], 1e-14);
    EXPECT_NEAR(found[500 - lag], expected[lag], 1e-14);
  }
}

TEST(baseline, a_polynomial_of_its_degree_is_removed_and_what_is_orthogonal_to_it_stays) {
  constexpr std::size_t n = 5000;
  for (int degree = 0; degree <= 5; ++degree) {
    std::vector<double> polynomial(n), sum(n);
    std::vector<double> wave(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double t = 0.01 * static_cast<double>(i);
      for (int k = 0; k <= degree; ++k) polynomial[i] += (k + 1) * std::pow(0.02 * t - 0.3, k);
      wave[i] = std::sin(3.0 * t);
      sum[i] = polynomial[i] + wave[i];
    }
    const auto without = [&](const std::vector<double>& a) {
      return without_baseline({"r", 0.01, a, ""}, degree).acceleration_mps2.copy();
    };
    EXPECT_THAT(without(polynomial), Pointwise(IsNear(1e-10), std::vector<double>(n, 0.0)));
    EXPECT_THAT(without(sum), Pointwise(IsNear(1e-10), without(wave)));
    const std::vector<double> once = without(wave);
    EXPECT_THAT(without(once), Pointwise(IsNear(1e-12), once));
    EXPECT_NEAR(std::accumulate(once.begin(), once.end(), 0.0), 0.0, 1e-9);
  }
  EXPECT_EQ(without_baseline({"r", 0.01, {3.0}, ""}, 5).acceleration_mps2[0], 0.0);
}

Motion two_components(std::vector<double> first, std::vector<double> second) {
  Motion motion;
  motion.id = "m";
  motion.dt_s = 0.1;
  motion.horizontal_mps2 = {std::move(first), std::move(second)};
  return motion;
}

// A motion of 2 m/s2 along 40 degrees is 2 cos 10 along 30 and 2 sin 10 along 120 degrees.
TEST(motion_processing,
     rotation_gives_the_components_along_the_stated_azimuth_and_keeps_the_energy) {
  constexpr double degree = std::numbers::pi / 180.0;
  const auto along = [](double azimuth_deg) {
    return 2.0 * std::cos((40.0 - azimuth_deg) * degree);
  };
  for (const double second_deg : {90.0, 270.0, 87.0}) {  // the last one is not quite perpendicular
    const Motion given = two_components({along(0.0), 0.0}, {along(second_deg), 0.0});
    const Motion turned = processed(given, {.rotate_to_deg = 30.0}, {{0.0, second_deg}, {}});
    EXPECT_NEAR(turned.horizontal_mps2[0][0], along(30.0), 1e-14);
    EXPECT_NEAR(turned.horizontal_mps2[1][0], along(120.0), 1e-14);
    EXPECT_THAT(turned.processing, ElementsAre(HasSubstr("to 30 and 120")));
  }
  const Motion given = two_components({1.0, -2.0, 0.5}, {0.3, 4.0, -1.0});
  const MotionDirections directions{{67.0, 337.0}, 155.0};
  const auto energy = [](const Motion& m) {
    double sum = 0.0;
    for (const Samples& a : m.horizontal_mps2)
      for (const double x : a) sum += x * x;
    return sum;
  };
  for (const MotionProcessing& p :
       {MotionProcessing{.rotate_to_deg = 200.0}, MotionProcessing{.rotate_to = FaultAxis::normal},
        MotionProcessing{.rotate_to = FaultAxis::parallel}})
    EXPECT_NEAR(energy(processed(given, p, directions)), energy(given), 1e-13);
  const Motion normal = processed(given, {.rotate_to = FaultAxis::normal}, directions),
               parallel = processed(given, {.rotate_to = FaultAxis::parallel}, directions);
  EXPECT_THAT(normal.processing, ElementsAre(HasSubstr("to 245 (fault-normal) and 335")));
  EXPECT_THAT(parallel.horizontal_mps2[1].copy(),
              Pointwise(IsNear(1e-14), normal.horizontal_mps2[0].copy()));
}

// Of a constant acceleration the shares are those of time: 10 to 90 % of 10 s, in whole samples.
TEST(motion_processing, trimming_keeps_the_stated_shares_of_arias_intensity) {
  Motion constant = two_components(std::vector<double>(100, 1.0), std::vector<double>(100, 2.0));
  constant.vertical_mps2 = std::vector<double>(100, 3.0);
  const auto [from_s, to_s] =
      arias_times_s(0.1, constant.horizontal_mps2[0], constant.horizontal_mps2[1], {0.1, 0.9});
  EXPECT_NEAR(from_s, 0.1 * (99.0 * 3.0 + 1.0) / 3.0 * 0.1, 1e-12);  // the last falls to zero
  const Motion trimmed = processed(constant, {.arias_percent = std::array{10.0, 90.0}}, {});
  const auto begin = static_cast<std::size_t>(std::floor(from_s / 0.1)),
             end = static_cast<std::size_t>(std::ceil(to_s / 0.1));
  for (const Samples& a :
       {trimmed.horizontal_mps2[0], trimmed.horizontal_mps2[1], trimmed.vertical_mps2})
    EXPECT_EQ(a.size(), end - begin + 1);
  EXPECT_THAT(trimmed.processing, ElementsAre(HasSubstr("from 10 to 90 %")));
  EXPECT_THAT(trimmed.contradictions, ElementsAre());

  Motion spiked = constant;
  std::vector<double> with_spike(100, 1.0);
  with_spike[1] = 5.0;
  spiked.horizontal_mps2[0] = with_spike;
  EXPECT_THAT(processed(spiked, {.arias_percent = std::array{20.0, 90.0}}, {}).contradictions,
              ElementsAre(HasSubstr("takes its peak of 0.51 g away: 0.306 g")));
}

TEST(motion_processing, a_filter_keeps_its_zeros_before_and_after_and_removes_an_offset) {
  Motion motion = two_components(std::vector<double>(200, 1.0), std::vector<double>(200, -0.5));
  const ButterworthBand band{0.25, {}, 4};
  const Motion filtered = processed(motion, {.band_pass = band}, {});
  const std::size_t pad = 120;  // 0.75 * 4 / 0.25 s
  ASSERT_EQ(filtered.horizontal_mps2[0].size(), 200 + 2 * pad);
  EXPECT_LT(std::abs(filtered.horizontal_mps2[0][pad + 100]), 0.01);
  EXPECT_THAT(filtered.processing,
              ElementsAre(HasSubstr("high-pass 0.25 Hz, Butterworth of order 4 forwards and "
                                    "backwards (gain 1/2 at each corner), with 12 s of zeros")));
}

TEST(motion_processing, a_longer_step_needs_a_filter_and_a_shorter_one_follows_the_lines) {
  const Motion motion = two_components({0.0, 1.0, 3.0, 2.0}, {});
  const Motion fine = processed(motion, {.step_s = 0.05}, {});
  EXPECT_EQ(fine.dt_s, 0.05);
  EXPECT_THAT(fine.horizontal_mps2[0].copy(),
              Pointwise(IsNear(1e-14), std::vector{0.0, 0.5, 1.0, 2.0, 3.0, 2.5, 2.0, 1.0}));
  EXPECT_THROW(processed(motion, {.step_s = 0.2}, {}), InputError);
  const Motion coarse =
      processed(motion, {.band_pass = ButterworthBand{{}, 1.25, 4}, .step_s = 0.2}, {});
  EXPECT_EQ(coarse.dt_s, 0.2);
  EXPECT_EQ(coarse.processing.size(), 2u);
}

TEST(motion_processing, what_a_motion_does_not_have_is_named) {
  const auto message = [](const Motion& motion, const MotionProcessing& p,
                          const MotionDirections& d) -> std::string {
    try {
      processed(motion, p, d);
    } catch (const InputError& error) {
      return error.problems().front().what;
    }
    return "";
  };
  const Motion one = two_components({1.0}, {}), both = two_components({1.0}, {1.0}),
               zero = two_components({0.0, 0.0}, {});
  const MotionProcessing turn{.rotate_to_deg = 0.0}, normal{.rotate_to = FaultAxis::normal};
  EXPECT_THAT(message(one, turn, {{0.0, 90.0}, {}}), HasSubstr("one horizontal"));
  EXPECT_THAT(message(both, turn, {{0.0, {}}, {}}), HasSubstr("are not known"));
  EXPECT_THAT(message(both, turn, {{0.0, 80.0}, {}}), HasSubstr("not perpendicular"));
  EXPECT_THAT(message(both, normal, {{0.0, 90.0}, {}}), HasSubstr("strike is not known"));
  EXPECT_THAT(message(zero, {.arias_percent = std::array{5.0, 95.0}}, {}),
              HasSubstr("zero throughout"));
  EXPECT_THAT(message(both, {.band_pass = ButterworthBand{0.1, 5.0, 4}}, {}),
              HasSubstr("5 Hz, is not below 5 Hz"));
  EXPECT_THAT(message(both, {.band_pass = ButterworthBand{1e-9, {}, 4}}, {}),
              HasSubstr("more than 20000000 samples"));
}

}  // namespace
}  // namespace glissade
