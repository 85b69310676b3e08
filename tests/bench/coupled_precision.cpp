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

/// Levels of PGA of one building, 0.1 g apart, which share tables.
constexpr int levels = 20;
constexpr double level_g = 0.1;

/// Yields in most of the scenes.
constexpr double yield_coefficient = 0.2, hardening_ratio = 0.05;

struct Batch {
  CoupledGround ground;
  std::vector<CoupledScene> scenes;
};

CoupledResult solve(const GroundMotion& ground, const CoupledScene& scene) {
  return slide_coupled(ground, scene.factors, scene.building, scene.block);
}

/// At no level yet.
std::vector<CoupledScene> buildings(const std::vector<double>& mass_ratios) {
  std::vector<CoupledScene> scenes;
  for (const double mass_ratio : mass_ratios)
    for (const double period_s : {0.2, 0.5, 1.0})
      for (const double friction : {0.1, 0.3, 0.5, 0.7})
        for (const double slope_deg : {0.0, 1.19, -1.19, 4.0, -4.0, 7.0, -7.0}) {
          const Block block{.friction = friction, .slope_rad = slope_deg * rad_per_deg};
          if (resting_deceleration_mps2(block) > 0.0)
            scenes.push_back({{{period_s, 0.05}, mass_ratio, {}}, block, {}});
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

  void add(const Component& component, bool vertical, CoupledScene scene) {
    GroundMotion motion{component.dt_s, component.horizontal_mps2, {}};
    if (vertical) motion.vertical_mps2 = component.vertical_mps2;
    Batch batch{CoupledGround(motion), {}};
    TrialBatch truth{component.horizontal_mps2, {}, {}};
    for (int level = 1; level <= levels; ++level) {
      const double factor = level * level_g * standard_gravity_mps2 / component.pga_mps2;
      scene.factors = {factor, vertical ? factor : 0.0};
      const SlipResult slip = solve(motion, scene).slip;
      if (!is_for_trial(slip.peak_displacement_m, slip.uplift)) continue;
      batch.scenes.push_back(scene);
      truth.truth_m.push_back(slip.peak_displacement_m);
      truth.scenes.push_back(describe(component, scene));
    }
    if (batch.scenes.empty()) return;
    batches.push_back(batch);
    judged.push_back(truth);
  }

  BatchScheme one_by_one(const std::string& family, const std::string& label, auto peak_m) const {
    return {family, label, [this, peak_m](std::size_t b) {
              std::vector<double> peaks_m;
              for (const CoupledScene& scene : batches[b].scenes)
                peaks_m.push_back(peak_m(batches[b].ground.motion(), scene));
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
    return {family, "20 levels", [this](std::size_t b) {
              std::vector<CoupledPeak> peaks(batches[b].scenes.size());
              CoupledGround ground = batches[b].ground;  // without tables
              coupled_slip(ground, batches[b].scenes, peaks);
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
               const std::vector<double>& mass_ratios, const Yielding& yielding = {}) {
  Trial trial;
  const std::size_t count = all.components.size();
  const std::size_t stride = std::max<std::size_t>(count * levels / histories, 1);
  const bool vertical = shaking == Shaking::vertical_too;
  const std::vector<CoupledScene> candidates = buildings(mass_ratios);
  const std::vector<std::size_t> order = scattered(candidates.size(), 0);
  for (std::size_t i = 0; i < count; i += stride) {
    const Component& component = all.components[i];
    CoupledScene scene = candidates[order[i % order.size()]];
    scene.building.yielding = yielding;
    if (!vertical || !component.vertical_mps2.empty()) trial.add(component, vertical, scene);
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
  const std::vector<double> masses{0.05, 0.1, 0.3};
  const Trial linear = trial_of(all, histories, Shaking::horizontal, masses);
  std::vector<BatchScheme> schemes{one_pass(linear.judged), linear.kernel("coupled_slip"),
                                   linear.events("slide_coupled")};
  for (int substeps = 1; substeps <= (quick ? 4 : 64); substeps *= 4)
    schemes.push_back(linear.link(substeps));
  run(linear, schemes);

  const Trial massless = trial_of(all, histories, Shaking::horizontal, {0.0});
  run(massless, {massless.kernel("coupled_slip, m/M 0"), massless.events("slide_coupled, m/M 0")});
  const Trial lifted = trial_of(all, histories, Shaking::vertical_too, masses);
  run(lifted, {lifted.kernel("coupled_slip, vertical"), lifted.events("slide_coupled, vertical")});
  const Trial yields = trial_of(all, histories, Shaking::horizontal, masses,
                                yielding_for(YieldCoefficient{yield_coefficient}, hardening_ratio));
  run(yields, {yields.kernel("coupled_slip, yielding"), yields.events("slide_coupled, yielding")});
  return results;
}

}  // namespace glissade::bench
