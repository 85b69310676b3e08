// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sliding schemes side by side: time per history over all scenes, error over every eleventh
// against the equation of motion solved in 50 digits. Times are for comparison within one run:
// machines differ.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "glissade/block/rodriguez_nikl.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/intensity.hpp"
#include "unit/block/reference.hpp"

namespace {

using namespace glissade;

constexpr std::size_t samples = 8000;  // 40 s at 200 Hz

struct Scene {
  std::vector<double> horizontal_mps2, vertical_mps2;
  double dt_s = 0.0, factor = 0.0;
  Block block;

  RoofAcceleration roof(bool vertical) const {
    return {dt_s, horizontal_mps2,
            vertical ? std::span<const double>(vertical_mps2) : std::span<const double>(), factor,
            factor};
  }
};

/// First component of the built-in Level 2 motions, cut or padded to 8,000 samples; PGA 0.2 to 2 g,
/// mu 0.3 to 0.7, slope 0 to 4 degrees.
const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> made;
    const Suite suite = load_suite(GLISSADE_SOURCE_DIR "/suites/synthetic_level2.toml");
    for (const Motion& motion : suite.motions) {
      Scene scene{motion.horizontal_mps2[0], motion.vertical_mps2, motion.dt_s, 0.0, {}};
      scene.horizontal_mps2.resize(samples, 0.0);
      scene.vertical_mps2.resize(samples, 0.0);
      const double pga = peak_ground_acceleration_mps2(scene.horizontal_mps2);
      for (const double pga_g : {0.2, 0.5, 1.0, 1.5, 2.0}) {
        for (const double mu : {0.3, 0.5, 0.7}) {
          for (const double slope_deg : {0.0, 1.19, 4.0}) {
            scene.factor = pga_g * standard_gravity_mps2 / pga;
            scene.block = {.friction = mu, .slope_rad = slope_deg * rad_per_deg};
            made.push_back(scene);
          }
        }
      }
    }
    return made;
  }();
  return all;
}

/// Exact peak displacement of every eleventh scene; zero where it slips less than 1 mm or lifts
/// off.
const std::vector<double>& exact_peaks_m(bool vertical) {
  const auto solve = [](bool with_vertical) {
    std::vector<double> peaks;
    for (std::size_t i = 0; i < scenes().size(); i += 11) {
      const Scene& s = scenes()[i];
      const test::Reference exact(s.roof(with_vertical), s.block);
      const double peak = std::max(static_cast<double>(exact.down), static_cast<double>(exact.up));
      peaks.push_back(peak > 1e-3 && !slide(s.roof(with_vertical), s.block).uplift ? peak : 0.0);
    }
    return peaks;
  };
  static const std::vector<double> without = solve(false), with = solve(true);
  return vertical ? with : without;
}

template <class Method>
void run(benchmark::State& state, bool vertical, Method method) {
  std::vector<double> errors;
  const std::vector<double>& exact = exact_peaks_m(vertical);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Scene& s = scenes()[11 * i];
    if (exact[i] > 0.0)
      errors.push_back(
          std::abs(method(s.roof(vertical), s.block).peak_displacement_m / exact[i] - 1.0));
  }
  std::sort(errors.begin(), errors.end());
  for (auto _ : state) {
    for (const Scene& s : scenes())
      benchmark::DoNotOptimize(method(s.roof(vertical), s.block).peak_displacement_m);
  }
  const double histories =
      static_cast<double>(state.iterations()) * static_cast<double>(scenes().size());
  state.counters["history"] =
      benchmark::Counter(histories, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["sample"] = benchmark::Counter(
      histories * samples, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["median_error"] = errors[errors.size() / 2];
  state.counters["max_error"] = errors.back();
}

void event(benchmark::State& state) {
  run(state, state.range(0) != 0,
      [](const RoofAcceleration& r, const Block& b) { return slide(r, b); });
}

void rodriguez_nikl(benchmark::State& state) {
  const int substeps = static_cast<int>(state.range(0));
  run(state, false, [substeps](const RoofAcceleration& r, const Block& b) {
    return slide_rodriguez_nikl(r, b, substeps);
  });
}

}  // namespace

BENCHMARK(event)->ArgName("vertical")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(rodriguez_nikl)
    ->ArgName("substeps")
    ->RangeMultiplier(4)
    ->Range(1, 256)
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
