// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases.hpp"

#include <algorithm>
#include <cmath>

#include "bench/timing.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"

namespace glissade::convergence {
namespace {

std::span<const double> without_padding(std::span<const double> samples) {
  while (!samples.empty() && samples.back() == 0.0) samples = samples.first(samples.size() - 1);
  return samples;
}

/// Does `work`, three times if it is short; the shortest processor time.
template <class Work>
SlipResult timed(bool is_short, double& seconds, const Work& work) {
  SlipResult result;
  seconds = std::numeric_limits<double>::infinity();
  for (int run = 0; run < (is_short ? 3 : 1); ++run) {
    const double start = bench::core_seconds();
    result = work();
    seconds = std::min(seconds, bench::core_seconds() - start);
  }
  return result;
}

bool is_clear(const Case& c, ClearBy by) {
  if (by == ClearBy::any) return true;
  const double residual_m = by == ClearBy::exact ? c.exact_residual_m : c.residual_m.back();
  return std::abs(residual_m) >= clear_share * c.exact_peak_m;
}

}  // namespace

std::vector<Scene> paper_scenes() {
  std::vector<Scene> scenes;
  for (const double slope_deg : {-7.0, -4.0, 0.0, 4.0, 7.0})
    for (const double mu : {0.0, 0.1, 0.5})
      for (const double ppa_g : {0.0, 0.18, 1.0, 1.44}) scenes.push_back({slope_deg, mu, ppa_g});
  return scenes;
}

std::vector<Case> run_cases(const Motion& motion, std::span<const int> substeps) {
  const std::span<const double> samples = without_padding(motion.horizontal_mps2[0]);
  double peak_mps2 = 0.0;
  for (const double a : samples) peak_mps2 = std::max(peak_mps2, std::abs(a));
  GLISSADE_EXPECTS(peak_mps2 > 0.0);
  std::vector<Case> cases;
  for (const Scene& scene : paper_scenes()) {
    const RoofAcceleration roof{
        motion.dt_s, samples, {}, scene.ppa_g * standard_gravity_mps2 / peak_mps2, 0.0};
    const Block block{.friction = scene.mu, .slope_rad = scene.slope_deg * rad_per_deg};
    Case& c = cases.emplace_back(Case{.record = motion.id, .scene = scene});
    for (const int p : substeps) {
      const SlipResult slip = timed(p <= 16, c.scheme_s.emplace_back(),
                                    [&] { return slide_rodriguez_nikl(roof, block, p); });
      c.residual_m.push_back(slip.residual.along_m);
    }
    const SlipResult exact = timed(true, c.exact_s, [&] { return slide(roof, block); });
    c.exact_residual_m = exact.residual.along_m;
    c.exact_peak_m = exact.peak_displacement_m;
  }
  return cases;
}

double error_of(const Case& c, std::size_t step, Measure measure) {
  const double truth = measure == Measure::finest ? c.residual_m.back() : c.exact_residual_m;
  const double scale = measure == Measure::exact_peak ? c.exact_peak_m : std::abs(truth);
  return scale == 0.0 ? std::nan("") : std::abs(c.residual_m[step] - truth) / scale;
}

ErrorSummary error_summary(std::span<const Case> cases, std::size_t step, Measure measure,
                           ClearBy clear) {
  ErrorSummary summary;
  std::vector<double> errors;
  for (const Case& c : cases) {
    const double error = error_of(c, step, measure);
    if (std::isnan(error) || !is_clear(c, clear)) continue;
    if (errors.empty() || error > summary.largest) {
      summary.largest = error;
      summary.worst = &c;
    }
    errors.push_back(error);
  }
  summary.counted = errors.size();
  summary.median = median(std::move(errors));
  return summary;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  const std::size_t upper = values.size() / 2;
  return values.size() % 2 == 1 ? values[upper] : 0.5 * (values[upper - 1] + values[upper]);
}

}  // namespace glissade::convergence
