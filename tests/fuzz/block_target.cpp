// SPDX-License-Identifier: GPL-3.0-or-later
// The sliding block. The bytes are a scene:
//   0: bit 0 slope; bits 1-2 friction: any, in twentieths, critical, any power of two; bit 3 one
//      way; bits 4-5 samples (SampleKind); bit 6 vertical; bit 7 plateaus
//   1: step, 1 s to 1 us; 2-3, 4-5: slope to 89.9 degrees either way; friction
//   6, 7: factors on horizontal and vertical, in sixteenths
//   then samples: with plateaus a byte of length first; horizontal; vertical
#include <cmath>

#include "bytes.hpp"
#include "solvers.hpp"

namespace {

using namespace glissade;
using fuzz::Bytes;
using fuzz::check;

enum class SampleKind { hundredths_of_g, twentieths_of_g, any_double, steps };

/// A few bits for the kind, so that samples meet thresholds and each other exactly, often.
double take_sample(Bytes& bytes, SampleKind kind, double previous) {
  constexpr double g = standard_gravity_mps2, largest_mps2 = 1e5;  // 10,000 g
  switch (kind) {
    case SampleKind::hundredths_of_g:
      return g * bytes.take<std::int16_t>() / 100.0;
    case SampleKind::twentieths_of_g:
      return g * bytes.take<std::int8_t>() / 20.0;
    case SampleKind::any_double: {
      const auto value = bytes.take<double>();
      return std::isfinite(value) ? std::clamp(value, -largest_mps2, largest_mps2) : 0.0;
    }
    case SampleKind::steps:
      return previous + g * bytes.take<std::int8_t>() / 100.0;
  }
  return 0.0;
}

struct Scene {
  Block block;
  std::vector<double> horizontal, vertical;
  double dt_s = 0.0, horizontal_factor = 1.0, vertical_factor = 1.0;
  RoofAcceleration roof() const {
    return {dt_s, horizontal, vertical, horizontal_factor, vertical_factor};
  }
};

double take_friction(Bytes& bytes, unsigned kind, double slope_rad) {
  const auto raw = bytes.take<std::uint16_t>();
  switch (kind % 4) {
    case 0:
      return raw / 20000.0;  // to 3.3
    case 1:
      return (raw % 40) / 20.0;  // meets the thresholds of samples in twentieths of g
    case 2:                      // critical, or a few of its last digits off
      return std::max(0.0, std::tan(std::abs(slope_rad)) + (raw % 9 - 4) * 1e-16);
    default:
      return std::ldexp(1.0, raw % 256 - 200);  // from 6e-61 to 4e16
  }
}

Scene take_scene(Bytes bytes) {
  const auto flags = bytes.take<std::uint8_t>();
  Scene scene;
  scene.dt_s = std::pow(10.0, -6.0 * bytes.take<std::uint8_t>() / 255.0);
  const double steepness = bytes.take<std::int16_t>() / 32767.5;
  scene.block.slope_rad = flags & 1 ? steepness * 89.9 * rad_per_deg : 0.0;
  scene.block.friction = take_friction(bytes, flags >> 1, scene.block.slope_rad);
  if (flags & 8) scene.block.directions = SlipDirections::downslope_only;
  scene.horizontal_factor = bytes.take<std::int8_t>() / 16.0;
  scene.vertical_factor = bytes.take<std::int8_t>() / 16.0;
  const auto kind = static_cast<SampleKind>(flags >> 4 & 3);
  const bool has_vertical = (flags & 64) != 0;
  double a = 0.0, w = 0.0;
  do {
    const auto repeat = flags & 128 ? bytes.take<std::uint8_t>() % 8 : 0;  // plateaus
    a = take_sample(bytes, kind, a);
    if (has_vertical) w = take_sample(bytes, kind, w);
    scene.horizontal.insert(scene.horizontal.end(), 1 + repeat, a);
    if (has_vertical) scene.vertical.insert(scene.vertical.end(), 1 + repeat, w);
  } while (bytes.left() > 0 && scene.horizontal.size() < 8192);
  return scene;
}

double largest(const std::vector<double>& samples, double factor) {
  double peak = 0.0;
  for (const double x : samples) peak = std::max(peak, std::abs(factor * x));
  return peak;
}

fuzz::Rounding rounding_of(const Scene& scene, const SlipResult& r) {
  const double a = largest(scene.horizontal, scene.horizontal_factor),
               w = largest(scene.vertical, scene.vertical_factor);
  const double record_s = scene.dt_s * static_cast<double>(scene.horizontal.size());
  return {(1 + scene.block.friction.along) * (standard_gravity_mps2 + a + w),
          record_s + r.slip_duration_s,
          standard_gravity_mps2 * (scene.block.friction.along * std::cos(scene.block.slope_rad) -
                                   std::sin(std::abs(scene.block.slope_rad)))};
}

void check_result(const Scene& scene, const SlipResult& r) {
  for (const double value : {r.peak_displacement_m, r.residual.along_m, r.peak_downslope_m,
                             r.peak_upslope_m, r.peak_velocity_mps, r.slip_duration_s}) {
    check(std::isfinite(value), "every number is finite");
  }
  check(r.peak_downslope_m >= 0.0 && r.peak_upslope_m >= 0.0, "peaks are not negative");
  check(r.peak_displacement_m == std::max(r.peak_downslope_m, r.peak_upslope_m),
        "the peak is the larger of both sides");
  check(-r.peak_upslope_m <= r.residual.along_m && r.residual.along_m <= r.peak_downslope_m,
        "the residual lies between the peaks");
  check(r.slip_phases <= 4 * (scene.horizontal.size() + 1), "work per sample is bounded");
  check(r.peak_displacement_m == 0.0 || r.slip_phases > 0, "what has not slid has not moved");
  if (scene.block.directions == SlipDirections::downslope_only)
    check(r.peak_upslope_m == 0.0, "one-way slip does not go upslope");
  if (cannot_slip(scene.block, largest(scene.horizontal, scene.horizontal_factor),
                  largest(scene.vertical, scene.vertical_factor)))
    check(r.slip_phases == 0, "what cannot slip does not");
}

/// theory.md, 1.7. Exact, but for the mirror of a flat roof, which knows no direction to
/// begin with and is left out.
void check_mirror(Scene scene, const SlipResult& r) {
  if (scene.block.slope_rad == 0.0) return;
  scene.block.slope_rad *= -1;
  scene.horizontal_factor *= -1;
  const SlipResult m = slide(scene.roof(), scene.block);
  check(m.peak_downslope_m == r.peak_downslope_m && m.peak_upslope_m == r.peak_upslope_m &&
            m.residual.along_m == r.residual.along_m,
        "the mirror image slips the same");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Scene scene = take_scene(Bytes(data, size));
  const SlipResult r = slide(scene.roof(), scene.block);
  check_result(scene, r);
  check_mirror(scene, r);
  fuzz::check_history(scene.roof(), scene.block, r);
  fuzz::check_other_solvers(scene.roof(), scene.block, r, rounding_of(scene, r));
  return 0;
}
