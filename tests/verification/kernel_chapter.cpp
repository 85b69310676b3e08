// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chapters.hpp"
#include "glissade/block/peak_slip.hpp"
#include "glissade/io/suite_file.hpp"
#include "unit/block/oscillator_reference.hpp"
#include "unit/block/reference.hpp"

namespace glissade::verification {
namespace {

/// Slopes of 0 and 4 degrees, mu 0.1 to 0.5, at 0.5 and 1.5 times the motion.
template <class Visit>
void for_each_block(Visit visit) {
  for (const double slope_deg : {0.0, 4.0})
    for (const double mu : {0.1, 0.3, 0.5})
      for (const double factor : {0.5, 1.5})
        visit(Block{.friction = mu, .slope_rad = slope_deg * rad_per_deg}, factor);
}

double difference(const SlipPeak& r, double down, double up) {
  const double size = std::max(down, up);
  return std::max(std::abs(r.peak_downslope_m - down), std::abs(r.peak_upslope_m - up)) / size;
}

Case rigid(const Suite& suite, bool vertical) {
  double worst = 0.0;
  for (const Motion& m : suite.motions) {
    const std::span<const double> up =
        vertical ? std::span<const double>(m.vertical_mps2) : std::span<const double>();
    const RoofTable roof(m.dt_s, m.horizontal_mps2[0], up);
    for_each_block([&](const Block& block, double factor) {
      if (block.friction.along == 0.3) return;  // 50 digits are slow
      const SlipPeak r = peak_slip(roof, block, {factor, factor});
      if (r.uplift || r.peak_displacement_m < 1e-4) return;
      const test::Reference exact({m.dt_s, m.horizontal_mps2[0], up, factor, factor}, block);
      worst = worse(worst,
                    difference(r, static_cast<double>(exact.down), static_cast<double>(exact.up)));
    });
  }
  return limit({fmt::format("7 motions of suite level 2 on a rigid roof, {} vertical",
                            vertical ? "with" : "without"),
                "both peaks", "equation of motion solved in 50 digits, events bisected"},
               {"largest relative difference", worst, 1e-11});
}

Case building(const Motion& m, double dt_s, double period_s) {
  std::vector<double> a;  // every so many samples
  const auto stride = static_cast<std::size_t>(std::lround(dt_s / m.dt_s));
  for (std::size_t i = 0; i < m.horizontal_mps2[0].size(); i += stride)
    a.push_back(m.horizontal_mps2[0][i]);
  const RoofTable roof =
      tabulate_roof({dt_s, a}, {.horizontal = {period_s, 0.05}},
                    {.quiet_horizontal_mps2 = 0.1, .settle_deceleration_mps2 = 0.3});
  const MotionTable& table = *roof.horizontal;
  const double ring_down_s =
      static_cast<double>(table.end - table.ground->quiet_from()) * table.step_s();
  double worst = 0.0;
  for_each_block([&](const Block& block, double factor) {
    const test::OscillatorReference exact(dt_s, a, period_s, 0.05, factor, block, ring_down_s, 16);
    if (std::max(exact.down, exact.up) < 1e-3) return;
    worst = worse(worst, difference(peak_slip(roof, block, {factor, 0.0}), exact.down, exact.up));
  });
  return limit(
      {fmt::format("a level 2 motion at dt = {} s on a building of {} s, {} node{} an interval",
                   dt_s, period_s, parts_needed({period_s, 0.05}, dt_s),
                   parts_needed({period_s, 0.05}, dt_s) == 1 ? "" : "s"),
       "both peaks", "the oscillator in closed form between samples, events bisected"},
      {"largest relative difference", worst, 1e-6});
}

Case every_interval(const Suite& suite) {
  int differing = 0, cases = 0;
  for (const Motion& m : suite.motions) {
    for (const double period_s : {0.0, 0.3}) {
      const RoofTable roof =
          tabulate_roof({m.dt_s, m.horizontal_mps2[1], m.vertical_mps2},
                        {.horizontal = {period_s, 0.05}}, {.quiet_horizontal_mps2 = 0.1});
      for_each_block([&](const Block& block, double factor) {
        const SlipPeak one = peak_slip(roof, block, {factor, factor});
        const SlipPeak other =
            peak_slip(roof, block, {factor, factor}, EventSearch::every_interval);
        ++cases;
        differing += one.peak_downslope_m == other.peak_downslope_m &&
                             one.peak_upslope_m == other.peak_upslope_m &&
                             one.slip_phases == other.slip_phases
                         ? 0
                         : 1;
      });
    }
  }
  return all_equal({"the same and a building of 0.3 s, with vertical", "both peaks, phases",
                    "the kernel looking into every interval", ReferenceFrom::this_code},
                   {differing, cases});
}

}  // namespace

Chapter table_kernel(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level2.toml");
  Chapter chapter{
      "3.4 Kernel",
      "equation of motion in 50 digits",
      R"(`peak_slip()`, which studies use for one axis, finds the same events in tables of velocity and displacement.
On a rigid roof it is exact. On a building the velocity is a quintic between nodes and exact at them.)",
      {rigid(suite, false), rigid(suite, true)}};
  for (const double period_s : {0.05, 0.2, 0.5, 1.0})
    chapter.cases.push_back(building(suite.motions.front(), 0.01, period_s));
  chapter.cases.push_back(every_interval(suite));
  return chapter;
}

}  // namespace glissade::verification
