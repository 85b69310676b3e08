// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "chapters.hpp"
#include "glissade/sampling/distribution.hpp"
#include "glissade/sampling/point_set.hpp"

namespace glissade::verification {
namespace {

/// In sixteenths (Joe & Kuo 2008 direction numbers, points in Gray-code order).
constexpr std::array<std::array<int, 4>, 16> first_sobol_points = {{{0, 0, 0, 0},
                                                                    {8, 8, 8, 8},
                                                                    {12, 4, 4, 4},
                                                                    {4, 12, 12, 12},
                                                                    {6, 6, 10, 14},
                                                                    {14, 14, 2, 6},
                                                                    {10, 2, 14, 10},
                                                                    {2, 10, 6, 2},
                                                                    {3, 5, 15, 7},
                                                                    {11, 13, 7, 15},
                                                                    {15, 1, 11, 3},
                                                                    {7, 9, 3, 11},
                                                                    {5, 3, 5, 9},
                                                                    {13, 11, 13, 1},
                                                                    {9, 7, 1, 13},
                                                                    {1, 15, 9, 5}}};

Case unscrambled() {
  int differing = 0;
  for (std::uint32_t i = 0; i < 16; ++i)
    for (std::uint32_t d = 0; d < 4; ++d)
      differing += sobol_coordinate(i, d) == first_sobol_points[i][d] / 16.0 ? 0 : 1;
  return all_equal({"ex8: first 16 Sobol points in four dimensions", "coordinates",
                    "worked example, exact sixteenths"},
                   {differing, 64});
}

/// Every dyadic box of volume 1/1024 that splits two dimensions holds exactly one of 1,024 points:
/// what the scramble must keep.
Case still_a_net() {
  const PointSet points(SamplingMethod::sobol, 11);
  int boxes = 0, wrong = 0;
  for (int bits = 0; bits <= 10; ++bits) {
    std::vector<int> count(1024, 0);
    for (std::uint64_t i = 0; i < 1024; ++i) {
      const auto cell = [&](std::uint32_t d, int b) {
        return static_cast<int>(points.coordinate(i, d) * (1 << b));
      };
      ++count[(cell(0, bits) << (10 - bits)) + cell(1, 10 - bits)];
    }
    boxes += 1024;
    wrong += static_cast<int>(std::ranges::count_if(count, [](int n) { return n != 1; }));
  }
  return all_equal({"1,024 scrambled points, dimensions 1 and 2",
                    "dyadic boxes of volume 1/1024 that hold one point",
                    "a (0, 10, 2)-net stays one under nested scrambling (Owen 1995)"},
                   {wrong, boxes});
}

/// ln of slip in cm after Ambraseys & Menu (1988): ln 10 x 0.90 + ln[(1 - r)^2.53 r^-1.09], r =
/// yield / peak roof acceleration, with friction, slope, amplification of the building and peak
/// ground acceleration from the four coordinates.
double log_slip(const PointSet& points, std::uint64_t i) {
  const double mu = quantile(Normal{0.55, 0.04}, points.coordinate(i, 0));
  const double slope = quantile(Uniform{0.0, 0.08}, points.coordinate(i, 1));
  const double amplification = quantile(Uniform{1.5, 3.0}, points.coordinate(i, 2));
  const double pga_g = quantile(Uniform{0.8, 1.2}, points.coordinate(i, 3));
  const double r = std::tan(std::atan(mu) - slope) / (amplification * pga_g);
  return std::log(10.0) * 0.90 + 2.53 * std::log(1.0 - r) - 1.09 * std::log(r);
}

enum class Estimate { mean_log_slip, exceedance };

double variance(SamplingMethod method, std::uint64_t n, Estimate what) {
  constexpr int replicates = 200;
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t seed = 1; seed <= replicates; ++seed) {
    const PointSet points(method, seed);
    double estimate = 0.0;
    for (std::uint64_t i = 0; i < n; ++i) {
      const double value = log_slip(points, i);
      estimate += (what == Estimate::mean_log_slip ? value
                   : value > std::log(10.0)        ? 1.0
                                                   : 0.0) /
                  static_cast<double>(n);
    }
    sum += estimate;
    squares += estimate * estimate;
  }
  return (squares - sum * sum / replicates) / (replicates - 1);
}

Case gain(std::uint64_t n, Estimate what, double at_least, const std::string& statistics) {
  const double ratio =
      variance(SamplingMethod::monte_carlo, n, what) / variance(SamplingMethod::sobol, n, what);
  return within({fmt::format("{} samples, 200 scrambles", n),
                 what == Estimate::mean_log_slip ? "mean of ln slip" : "P(slip > 10 cm)",
                 statistics + " in another 4-D slip surrogate"},
                {"variance, plain / scrambled Sobol", ratio, at_least, INFINITY});
}

}  // namespace

Chapter sampling() {
  return {
      "6. Sampling",
      "published Sobol points; Owen 1995",
      R"(Sobol points are compared with their published table. Scrambled points must give a smaller variance than
plain Monte Carlo at equal cost. The variance ratios are for slip after Ambraseys & Menu (1988), as a
function of friction, slope, amplification and peak ground acceleration. Those of the reference are of
another surrogate, so that a third of them is permitted; each has an uncertainty factor of 1.3 (95 %).)",
      {unscrambled(), still_a_net(), gain(128, Estimate::mean_log_slip, 188, "564"),
       gain(512, Estimate::mean_log_slip, 1270, "3,809"),
       gain(2048, Estimate::mean_log_slip, 3031, "9,092"),
       gain(128, Estimate::exceedance, 1.4, "4.1"), gain(512, Estimate::exceedance, 1.9, "5.6"),
       gain(2048, Estimate::exceedance, 5.0, "14.9")}};
}

}  // namespace glissade::verification
