// SPDX-License-Identifier: GPL-3.0-or-later
#include "schemes.hpp"

#include <array>
#include <span>

#include "glissade/block/peak_slip.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "max_pass.hpp"
#include "newmark_trapezoid.hpp"

namespace glissade::bench {
namespace {

/// A scheme that takes the samples as they are: nothing to prepare.
auto on_samples(PeakScheme peak) {
  return [peak = std::move(peak)](const Roof&) { return peak; };
}

/// The kernel on the roof's samples, linear between them, as the other schemes take them.
PeakScheme kernel_on_samples(const Roof& roof) {
  // A free slider is reported at the end of the record, and its table ends there.
  const auto table = [&](bool vertical, std::size_t samples) {
    const std::span<const double> a = roof.motion.horizontal_mps2, w = roof.motion.vertical_mps2;
    return RoofTable(roof.motion.dt_s, a.first(samples),
                     vertical && !w.empty() ? w.first(samples) : std::span<const double>());
  };
  const std::size_t all = roof.motion.horizontal_mps2.size(), record = roof.motion.record_samples;
  const std::array tables{table(false, all), table(true, all), table(false, record),
                          table(true, record)};
  return [=](const History& h) {
    const bool ends_with_record = h.excitation.horizontal_mps2.size() < all;
    return peak_slip(tables[(h.vertical ? 1u : 0u) + (ends_with_record ? 2u : 0u)], h.block,
                     {h.factor, h.factor})
        .peak_displacement_m;
  };
}

/// The kernel as a study runs it: on the oscillator itself, not on samples of its motion.
PeakScheme kernel_on_oscillator(const Roof& roof) {
  GroundMotion ground = roof.input.ground;
  const RoofTable with = tabulate_roof(ground, roof.input.building, roof.input.follow);
  ground.vertical_mps2 = {};
  const RoofTable without = tabulate_roof(ground, roof.input.building, roof.input.follow);
  return [=](const History& h) {
    return peak_slip(h.vertical ? with : without, h.block, {h.factor, h.factor})
        .peak_displacement_m;
  };
}

std::string substeps_label(int substeps) { return "P = " + std::to_string(substeps); }

}  // namespace

std::vector<Scheme> schemes(bool quick) {
  std::vector<Scheme> all;
  all.push_back({.family = "one maximum-pass",
                 .label = max_pass_target(),
                 .on_roof = on_samples(
                     [](const History& h) { return max_pass(h.excitation.horizontal_mps2); }),
                 .problem = Problem::none,
                 .exact = true});
  all.push_back({.family = "slide",
                 .label = "events",
                 .on_roof = on_samples([](const History& h) {
                   return slide(h.excitation, h.block).peak_displacement_m;
                 }),
                 .exact = true});
  all.push_back(
      {.family = "peak_slip", .label = "samples", .on_roof = kernel_on_samples, .exact = true});
  all.push_back({.family = "peak_slip, oscillator",
                 .label = "as in a study",
                 .on_roof = kernel_on_oscillator,
                 .problem = Problem::oscillator,
                 .exact = true});
  for (int substeps = 1; substeps <= (quick ? 4 : 256); substeps *= 2) {
    all.push_back(
        {.family = "Rodriguez-Nikl et al. 2019",
         .label = substeps_label(substeps),
         .on_roof = on_samples([substeps](const History& h) {
           return slide_rodriguez_nikl(h.excitation, h.block, substeps).peak_displacement_m;
         })});
  }
  for (const bool one_way : {false, true}) {
    for (int substeps = 1; substeps <= (quick ? 4 : 64); substeps *= 4) {
      all.push_back({.family = one_way ? "Newmark trapezoid, one-way" : "Newmark trapezoid",
                     .label = substeps_label(substeps),
                     .on_roof = on_samples([=](const History& h) {
                       Block block = h.block;
                       if (one_way) block.directions = SlipDirections::downslope_only;
                       return newmark_trapezoid_peak_m(h.excitation, block, substeps);
                     }),
                     .problem = one_way ? Problem::one_way_samples : Problem::samples});
    }
  }
  return all;
}

}  // namespace glissade::bench
