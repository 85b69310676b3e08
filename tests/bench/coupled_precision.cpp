// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupled_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupled_link.hpp"
#include "glissade/block/coupled_slip.hpp"

namespace glissade::bench {
namespace {

using test::Component;

/// As many as go side by side.
constexpr std::size_t batch_size = 16;

/// Yields in most of the scenes.
constexpr double yield_coefficient = 0.2, hardening_ratio = 0.05;

struct Batch {
  GroundMotion ground;
  std::vector<CoupledScene> scenes;
};

CoupledResult solve(const GroundMotion& ground, const CoupledScene& scene) {
  return slide_coupled(ground, scene.factors, scene.building, scene.block);
}

std::vector<CoupledScene> scenes_of(const Component& component, bool vertical) {
  std::vector<CoupledScene> scenes;
  for (const double mass_ratio : {0.05, 0.1, 0.3})
    for (const double period_s : {0.2, 0.5, 1.0})
      for (const double pga_g : {0.2, 0.5, 1.0, 1.5})
        for (const double friction : {0.1, 0.3, 0.5, 0.7})
          for (const double slope_deg : {0.0, 1.19, -1.19, 4.0, -4.0, 7.0, -7.0}) {
            const double factor = pga_g * standard_gravity_mps2 / component.pga_mps2;
            const Block block{.friction = friction, .slope_rad = slope_deg * rad_per_deg};
            if (resting_deceleration_mps2(block) > 0.0)
              scenes.push_back(
                  {{{period_s, 0.05}, mass_ratio, {}}, block, {factor, vertical ? factor : 0.0}});
          }
  return scenes;
}

std::string describe(const Component& component, const CoupledScene& s) {
  return fmt::format("{}, m/M {}, T {} s, factor {:.3g}, mu {}, slope {:.4g} deg{}", component.id,
                     s.building.mass_ratio, s.building.horizontal.period_s, s.factors.horizontal,
                     s.block.friction, s.block.slope_rad / rad_per_deg,
                     s.factors.vertical != 0.0 ? ", vertical" : "");
}

/// Batches, and what they are judged by.
struct Trial {
  std::vector<Batch> batches;
  std::vector<TrialBatch> judged;

  void add(const Component& component, bool vertical, const Yielding& yielding, std::size_t start) {
    Batch batch{{component.dt_s, component.horizontal_mps2, {}}, {}};
    if (vertical) batch.ground.vertical_mps2 = component.vertical_mps2;
    TrialBatch truth{component.horizontal_mps2, {}, {}};
    const std::vector<CoupledScene> candidates = scenes_of(component, vertical);
    for (const std::size_t i : scattered(candidates.size(), start)) {
      CoupledScene scene = candidates[i];
      scene.building.yielding = yielding;
      const SlipResult slip = solve(batch.ground, scene).slip;
      if (!is_for_trial(slip.peak_displacement_m, slip.uplift)) continue;
      batch.scenes.push_back(scene);
      truth.truth_m.push_back(slip.peak_displacement_m);
      truth.scenes.push_back(describe(component, scene));
      if (batch.scenes.size() == batch_size) break;
    }
    if (batch.scenes.empty()) return;
    batches.push_back(batch);
    judged.push_back(truth);
  }

  BatchScheme one_by_one(const std::string& family, const std::string& label, auto peak_m) const {
    return {family, label, [this, peak_m](std::size_t b) {
              std::vector<double> peaks_m;
              for (const CoupledScene& scene : batches[b].scenes)
                peaks_m.push_back(peak_m(batches[b].ground, scene));
              return peaks_m;
            }};
  }

  /// It is the truth, and not judged.
  BatchScheme events(const std::string& family) const {
    BatchScheme scheme =
        one_by_one(family, "events", [](const GroundMotion& ground, const CoupledScene& s) {
          return solve(ground, s).slip.peak_displacement_m;
        });
    scheme.problem = Problem::none;
    return scheme;
  }

  BatchScheme kernel(const std::string& family) const {
    return {family, "batches of 16", [this](std::size_t b) {
              std::vector<CoupledPeak> peaks(batches[b].scenes.size());
              coupled_slip(batches[b].ground, batches[b].scenes, peaks);
              std::vector<double> peaks_m;
              for (const CoupledPeak& peak : peaks)
                peaks_m.push_back(peak.slip.peak_displacement_m);
              return peaks_m;
            }};
  }

  BatchScheme link(int substeps) const {
    return one_by_one("Newmark, friction spring", fmt::format("P = {}", substeps),
                      [substeps](const GroundMotion& ground, const CoupledScene& s) {
                        return coupled_link_peak_m(ground, s.factors, s.building, s.block,
                                                   substeps);
                      });
  }
};

enum class Shaking { horizontal, vertical_too };

Trial trial_of(const test::StandardScenes& all, std::size_t histories, Shaking shaking,
               const Yielding& yielding) {
  Trial trial;
  const std::size_t count = all.components.size();
  const std::size_t stride = std::max<std::size_t>(count * batch_size / histories, 1);
  const bool vertical = shaking == Shaking::vertical_too;
  for (std::size_t i = 0; i < count; i += stride) {
    const Component& component = all.components[i];
    if (!vertical || !component.vertical_mps2.empty())
      trial.add(component, vertical, yielding, 37 * i);
  }
  return trial;
}

}  // namespace

std::vector<SchemeResult> coupled_precision(const test::StandardScenes& all, std::size_t histories,
                                            bool quick) {
  const std::size_t rounds = quick ? 1 : 3;
  std::vector<SchemeResult> results;
  const auto run = [&](const Trial& trial, const std::vector<BatchScheme>& schemes) {
    for (const SchemeResult& result : run_trial(trial.judged, schemes, rounds))
      results.push_back(result);
  };
  const Trial linear = trial_of(all, histories, Shaking::horizontal, {});
  std::vector<BatchScheme> schemes{one_pass(linear.judged), linear.kernel("coupled_slip"),
                                   linear.events("slide_coupled")};
  for (int substeps = 1; substeps <= (quick ? 4 : 64); substeps *= 4)
    schemes.push_back(linear.link(substeps));
  run(linear, schemes);

  const Trial lifted = trial_of(all, histories, Shaking::vertical_too, {});
  run(lifted, {lifted.kernel("coupled_slip, vertical"), lifted.events("slide_coupled, vertical")});
  const Trial yields = trial_of(all, histories, Shaking::horizontal,
                                yielding_for(YieldCoefficient{yield_coefficient}, hardening_ratio));
  run(yields, {yields.kernel("coupled_slip, yielding"), yields.events("slide_coupled, yielding")});
  return results;
}

}  // namespace glissade::bench
