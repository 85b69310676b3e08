// SPDX-License-Identifier: GPL-3.0-or-later
#include "two_axes_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/block/two_axis_lanes.hpp"
#include "two_axis_link.hpp"

namespace glissade::bench {
namespace {

using test::Component;

constexpr std::size_t batch_size = 64;
constexpr double truth_tolerance = 1e-9;

Modes one_mass(double period_s) { return {period_s, 0.05}; }

/// Walls and frames, up to so many modes.
template <std::size_t count>
Modes cantilever(double period_s) {
  return Modes(governing_modes(cantilever_modes(period_s, 10.0, count)));
}

/// The roof of one mass as a sum of five modes, four of which do not move the array.
Modes one_mass_of_five(double period_s) {
  std::vector<Mode> modes{{period_s, 1.0, 0.8}};
  for (const double slower : {2.0, 2.5, 3.0, 3.5}) modes.push_back({period_s / slower, 0.0, 0.05});
  return Modes(modes);
}

void yield_at_2_mps2(TwoAxisScene& s) {
  s.building.yielding = {Yielding{2.0, 0.02}, Yielding{2.0, 0.02}};
}

/// What the array lies on.
struct Kind {
  const char* name;
  std::vector<double> periods_s;  ///< of the first axis
  double mass_ratio = 0.0;
  double across = 1.0;  ///< of the friction along the slope
  Modes (*building)(double period_s) = one_mass;
  void (*change)(TwoAxisScene&) = nullptr;  ///< of the model
};

using Scene = TwoAxisScene;

struct Batch {
  SampledGround sampled;
  BuildingGround ground;
  std::vector<Scene> scenes;

  BuildingSlip solve(const Scene& s, double tolerance) const {
    return slide_on_building(ground, s.factors, s.building, s.block, tolerance);
  }
};

std::vector<Scene> scenes_of(double pga_mps2, bool vertical, const Kind& kind) {
  std::vector<Scene> scenes;
  for (const double period_s : kind.periods_s)
    for (const double pga_g : {0.2, 0.5, 1.0, 1.5})
      for (const double friction : {0.1, 0.3, 0.5, 0.7})
        for (const double slope_deg : {0.0, 1.19, 4.0, 7.0})
          for (const double azimuth_deg : {0.0, 90.0, 215.0}) {
            const double factor = pga_g * standard_gravity_mps2 / pga_mps2;
            const Block block{.friction = {friction, kind.across * friction},
                              .slope_rad = slope_deg * rad_per_deg,
                              .azimuth_rad = azimuth_deg * rad_per_deg};
            if (friction <= std::tan(block.slope_rad)) continue;
            scenes.push_back(
                {{.horizontal = {kind.building(period_s), kind.building(0.8 * period_s)},
                  .yielding = {},
                  .mass_ratio = kind.mass_ratio},
                 block,
                 {factor, vertical ? factor : 0.0}});
            if (kind.change != nullptr) kind.change(scenes.back());
          }
  return scenes;
}

std::string describe(const Component& component, const Scene& s) {
  return fmt::format("{}, m/M {}, T {} s, factor {:.3g}, mu {}, slope {:.4g} deg to {:.3g} deg{}",
                     component.id, s.building.mass_ratio, s.building.horizontal[0][0].period_s,
                     s.factors.horizontal[0], s.block.friction.along,
                     s.block.slope_rad / rad_per_deg, s.block.azimuth_rad / rad_per_deg,
                     s.factors.vertical != 0.0 ? ", vertical" : "");
}

/// Both horizontal components of a record.
struct Pair {
  const Component *first, *second;
  double pga_mps2() const { return std::max(first->pga_mps2, second->pga_mps2); }
};

std::vector<Pair> pairs_of(const std::vector<Component>& components) {
  const auto record = [](const Component& c) { return c.id.substr(0, c.id.rfind('/')); };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i + 1 < components.size(); ++i)
    if (record(components[i]) == record(components[i + 1]))
      pairs.push_back({&components[i], &components[i + 1]});
  return pairs;
}

/// Batches, and what they are judged by.
struct Trial {
  const Kind& kind;
  std::vector<Batch> batches = {};
  std::vector<TrialBatch> judged = {};

  void add(const Pair& pair, bool vertical, std::size_t start) {
    const Component &x = *pair.first, &y = *pair.second;
    Batch batch;
    batch.sampled = {x.dt_s, {x.horizontal_mps2, y.horizontal_mps2}, {}};
    batch.ground.horizontal = {std::make_shared<GroundTable>(x.dt_s, x.horizontal_mps2),
                               std::make_shared<GroundTable>(x.dt_s, y.horizontal_mps2)};
    if (vertical) {
      batch.sampled.vertical_mps2 = x.vertical_mps2;
      batch.ground.vertical = std::make_shared<const MotionTable>(
          tabulate_rigid(std::make_shared<GroundTable>(x.dt_s, x.vertical_mps2)));
    }
    TrialBatch truth{x.horizontal_mps2, {}, {}};
    const std::vector<Scene> candidates = scenes_of(pair.pga_mps2(), vertical, kind);
    for (const std::size_t i : scattered(candidates.size(), start)) {
      const SlipResult slip = batch.solve(candidates[i], truth_tolerance).slip;
      if (!is_for_trial(slip.peak_displacement_m, slip.uplift)) continue;
      batch.scenes.push_back(candidates[i]);
      truth.truth_m.push_back(slip.peak_displacement_m);
      truth.scenes.push_back(describe(x, candidates[i]));
      if (batch.scenes.size() == batch_size) break;
    }
    if (batch.scenes.empty()) return;
    batches.push_back(batch);
    judged.push_back(truth);
  }

  BatchScheme one_by_one(const std::string& family, const std::string& label, auto peak_m) const {
    return {fmt::format("{}, {}", family, kind.name), label, [this, peak_m](std::size_t b) {
              std::vector<double> peaks_m;
              for (const Scene& scene : batches[b].scenes)
                peaks_m.push_back(peak_m(batches[b], scene));
              return peaks_m;
            }};
  }

  /// At tolerance 10^-digits.
  BatchScheme on_building(int digits) const {
    return one_by_one(
        "slide_on_building", fmt::format("tolerance = 1e-{}", digits),
        [tolerance = std::pow(10.0, -digits)](const Batch& batch, const Scene& scene) {
          return batch.solve(scene, tolerance).slip.peak_displacement_m;
        });
  }

  /// All scenes of a batch at once.
  BatchScheme lanes(int digits) const {
    return {fmt::format("peak_slip_two_axes, {}", kind.name),
            fmt::format("tolerance = 1e-{}", digits),
            [this, tolerance = std::pow(10.0, -digits)](std::size_t b) {
              const Batch& batch = batches[b];
              std::vector<BuildingPeak> peaks(batch.scenes.size());
              peak_slip_two_axes(batch.ground, batch.scenes, peaks, tolerance);
              std::vector<double> peaks_m;
              for (const BuildingPeak& peak : peaks) peaks_m.push_back(peak.peak_displacement_m);
              return peaks_m;
            }};
  }

  BatchScheme two_axis(int digits) const {
    return one_by_one("slide_two_axis", fmt::format("tolerance = 1e-{}", digits),
                      [tolerance = std::pow(10.0, -digits)](const Batch& batch, const Scene& s) {
                        const SampledGround& g = batch.sampled;
                        return slide_two_axis({g.dt_s, g.horizontal_mps2, g.vertical_mps2,
                                               s.factors.horizontal[0], s.factors.vertical},
                                              s.block, tolerance)
                            .peak_displacement_m;
                      });
  }

  BatchScheme link(int substeps) const {
    return one_by_one("Newmark, friction spring", fmt::format("P = {}", substeps),
                      [substeps](const Batch& batch, const Scene& s) {
                        return two_axis_link_peak_m(batch.sampled, s.factors, s.building, s.block,
                                                    substeps);
                      });
  }
};

Trial trial_of(const test::StandardScenes& all, std::size_t histories, const Kind& kind) {
  Trial trial{kind};
  const std::vector<Pair> pairs = pairs_of(all.components);
  const std::size_t count = 2 * pairs.size();
  const std::size_t stride =
      test::thinning(count, std::max<std::size_t>(histories / batch_size, 1));
  for (std::size_t i = 0; i < count; i += stride) {
    const bool vertical = i >= pairs.size();
    const Pair& pair = pairs[i % pairs.size()];
    if (!vertical || !pair.first->vertical_mps2.empty()) trial.add(pair, vertical, 37 * i);
  }
  return trial;
}

}  // namespace

std::vector<SchemeResult> two_axes_precision(const test::StandardScenes& all, std::size_t histories,
                                             bool quick) {
  const std::vector<double> periods_s{0.2, 0.5, 1.0}, tall_s{0.5, 1.0};
  const std::vector<Kind> kinds{
      {"rigid", {0.0}},
      {"m/M 0", periods_s},
      {"m/M 0, one mass of 5 modes", periods_s, 0.0, 1.0, one_mass_of_five},
      {"m/M 0, 1 mode", tall_s, 0.0, 1.0, cantilever<1>},
      {"m/M 0, 3 modes", tall_s, 0.0, 1.0, cantilever<3>},
      {"m/M 0, 5 modes", tall_s, 0.0, 1.0, cantilever<5>},
      {"m/M 0.05", periods_s, 0.05},
      {"m/M 0.05, base shear", periods_s, 0.05, 1.0, one_mass,
       [](Scene& s) { s.base_shear = true; }},
      {"m/M 0.05, static friction", periods_s, 0.05, 1.0, one_mass,
       [](Scene& s) { s.block.law.static_over_sliding = 1.2; }},
      {"m/M 0.05, friction by speed", periods_s, 0.05, 1.0, one_mass,
       [](Scene& s) {
         s.block.law = {1.0, 1.5, 20.0};
       }},
      {"m/M 0.05, yielding", periods_s, 0.05, 1.0, one_mass, yield_at_2_mps2},
      {"m/M 0.05, yielding, friction by speed", periods_s, 0.05, 1.0, one_mass,
       [](Scene& s) {
         yield_at_2_mps2(s);
         s.block.law = {1.0, 1.5, 20.0};
       }},
      {"m/M 0.05, friction falls below the slope", periods_s, 0.05, 1.0, one_mass,
       [](Scene& s) {
         s.block.law = {1.0, 0.5, 20.0};
         s.block.slope_rad = std::atan(0.6 * s.block.friction.along);
       }},
      {"m/M 0.05, 3 modes, base shear", tall_s, 0.05, 1.0, cantilever<3>,
       [](Scene& s) { s.base_shear = true; }},
      {"m/M 0.05, 1 mode", tall_s, 0.05, 1.0, cantilever<1>},
      {"m/M 0.05, 3 modes", tall_s, 0.05, 1.0, cantilever<3>},
      {"m/M 0.05, 5 modes", tall_s, 0.05, 1.0, cantilever<5>},
      {"m/M 0.05, ellipse", periods_s, 0.05, 0.8}};
  const std::vector<int> tolerances = quick ? std::vector{3, 6} : std::vector{3, 4, 5, 6, 7, 8};
  std::vector<SchemeResult> results;
  for (const Kind& kind : kinds) {
    const Trial trial = trial_of(all, histories, kind);
    const bool first = &kind == &kinds.front(),
               stepped = kind.mass_ratio > 0.0 && kind.across == 1.0 && kind.building == one_mass &&
                         kind.change == nullptr;
    std::vector<BatchScheme> schemes;
    if (first) {
      schemes.push_back(one_pass(trial.judged));
      for (const int digits : tolerances) schemes.push_back(trial.two_axis(digits));
    }
    for (const int digits : tolerances) schemes.push_back(trial.on_building(digits));
    for (const int digits : tolerances) schemes.push_back(trial.lanes(digits));
    for (int substeps = 1; stepped && substeps <= (quick ? 4 : 64); substeps *= 4)
      schemes.push_back(trial.link(substeps));
    for (const SchemeResult& result : run_trial(trial.judged, schemes, quick ? 1 : 2))
      results.push_back(result);
  }
  return results;
}

}  // namespace glissade::bench
