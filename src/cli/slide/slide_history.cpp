// SPDX-License-Identifier: GPL-3.0-or-later
#include "slide/slide_history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "glissade/block/coupled.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "glissade/block/tipping.hpp"
#include "glissade/building/mode_rules.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/cases/case_scene.hpp"
#include "glissade/study/run/scene.hpp"

namespace glissade::cli {
namespace {

Block block_of(const SlideOptions& o) {
  Block block = glissade::block_of(o.c);
  if (o.one_way) block.directions = SlipDirections::downslope_only;
  return block;
}

GroundMotion ground_of(const Motion& motion) {
  return {motion.dt_s, motion.horizontal_mps2[0], motion.vertical_mps2};
}

Table history_table() {
  return {"history",
          "displacement and velocity of the block relative to the roof, in plan, downslope "
          "positive (flat roof: +x)",
          {{"time", "s", "Time, s"},
           {"roof_acceleration", "mps2", "Roof acceleration, m/s2"},
           {"displacement", "m", "Displacement, m"},
           {"velocity", "mps", "Velocity, m/s"}},
          {}};
}

/// Zero after the samples.
double acceleration_at(double time_s, double dt_s, std::span<const double> samples) {
  const double position = time_s / dt_s;
  const std::size_t i = static_cast<std::size_t>(position);
  const auto sample = [&](std::size_t k) { return k < samples.size() ? samples[k] : 0.0; };
  return std::lerp(sample(i), sample(i + 1), position - static_cast<double>(i));
}

void write_history(const std::string& file, const RoofAcceleration& roof,
                   const std::vector<SlipPoint>& history) {
  Table table = history_table();
  for (const SlipPoint& p : history)
    table.add({p.time_s,
               roof.horizontal_factor * acceleration_at(p.time_s, roof.dt_s, roof.horizontal_mps2),
               p.displacement_m, p.velocity_mps});
  write_text_file(file, to_csv(table));
}

/// On a rigid roof.
void write_plane_history(const std::string& file, const Motion& motion, double factor,
                         const Block& block) {
  const auto& [first, second] = motion.horizontal_mps2;
  std::vector<TwoAxisPoint> history;
  slide_two_axis({motion.dt_s, {first, second}, motion.vertical_mps2, factor, factor}, block,
                 history);
  Table table{"history",
              "displacement of the block relative to the roof, in plan, along the slope (downslope "
              "positive) and across it; acceleration along the two axes of the roof",
              {{"time", "s", "Time, s"},
               {"roof_acceleration_1", "mps2", "Roof acceleration, first axis, m/s2"},
               {"roof_acceleration_2", "mps2", "Roof acceleration, second axis, m/s2"},
               {"displacement_along", "m", "Displacement along the slope, m"},
               {"displacement_across", "m", "Displacement across the slope, m"}},
              {}};
  const auto add = [&](double time_s, const PlanVector& displacement) {
    table.add({time_s, factor * acceleration_at(time_s, motion.dt_s, first),
               factor * acceleration_at(time_s, motion.dt_s, second), displacement.along_m,
               displacement.across_m});
  };
  // Steps of sliding end at every sample; at the others the block rests.
  std::size_t sample = 0;
  PlanVector now;
  const auto rest_until = [&](double end_s) {
    for (; static_cast<double>(sample) * motion.dt_s < end_s; ++sample)
      add(static_cast<double>(sample) * motion.dt_s, now);
  };
  const double rounding_s = 1e-6 * motion.dt_s;
  for (const TwoAxisPoint& p : history) {
    rest_until(p.time_s - rounding_s);
    if (static_cast<double>(sample) * motion.dt_s < p.time_s + rounding_s) ++sample;
    now = p.displacement;
    add(p.time_s, now);
  }
  rest_until(static_cast<double>(first.size()) * motion.dt_s - rounding_s);
  write_text_file(file, to_csv(table));
}

/// The factor on the record at which the body begins to rock on its base; infinity: never.
double tipping_scale(const GroundMotion& ground, const Modes& building, const Oscillator& vertical,
                     const Block& block, const RigidBase& base, double scale) {
  const Block rocking = rocking_block(block, base);
  if (block.friction.along <= rocking.friction.along)
    return std::numeric_limits<double>::infinity();
  const auto followed_up_to = [&](double largest_scale) {
    const RoofMotion roof =
        roof_motion(ground, building, vertical, follow_roof({&rocking, 1}, largest_scale));
    return tipping_onset_factor(
        RoofAcceleration{roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2}, block, base);
  };
  // At a larger scale than the roof was followed for, its ring-down may be what tips first.
  const double found = followed_up_to(scale);
  return found > scale && std::isfinite(found) ? followed_up_to(found) : found;
}

/// One axis; the roof's motion does not depend on the block.
SlideHistory on_known_roof(const SlideOptions& o, const Motion& motion, double factor) {
  const Block block = block_of(o);
  const GroundMotion ground = ground_of(motion);
  const Modes building = building_axes(o.c, o.building)[0];
  const Oscillator vertical{o.c.vertical_period_s, o.c.vertical_damping};
  RoofMotionOptions follow = follow_roof({&block, 1}, factor);
  // Straight lines between so many samples of a period leave 1e-7 of the slip. A history, which has
  // a row for each, and a very long record are sampled as roof_motion() does by itself.
  constexpr double fine = 8000.0, most_samples = 1e7;
  const double shortest_s = shortest_period_s(building);
  const double periods =
      shortest_s > 0.0
          ? ground.dt_s * static_cast<double>(ground.horizontal_mps2.size()) / shortest_s
          : 0.0;
  if (o.history.empty() && fine * periods < most_samples)
    follow.steps_per_period = static_cast<int>(fine);
  const RoofMotion roof_table = roof_motion(ground, building, vertical, follow);
  const RoofAcceleration roof = excitation_of(block, roof_table, {factor, factor});

  SlideHistory h;
  if (o.method != "event") {
    constexpr double most_steps = 5e9;  // some ten seconds
    const double steps =
        static_cast<double>(o.substeps()) * static_cast<double>(roof_table.horizontal_mps2.size());
    if (steps > most_steps)
      throw InputError({"--substeps",
                        fmt::format("makes {:.2g} steps, more than {:g}", steps, most_steps),
                        "give fewer: the published scheme has 64", ""});
    h.slip = slide_rodriguez_nikl(roof, block, o.substeps());
  } else if (o.history.empty()) {
    h.slip = slide(roof, block);
  } else {
    std::vector<SlipPoint> points;
    h.slip = slide(roof, block, points);
    if (std::isfinite(h.slip.residual.along_m)) write_history(o.history, roof, points);
  }
  if (o.clearance_m) slide(roof, block, {&*o.clearance_m, 1}, {&h.crossing.emplace(), 1});
  h.ppa_g = factor * roof_table.peak_horizontal_mps2 / standard_gravity_mps2;
  if (o.cm_height_m) {
    h.tips_at =
        tipping_scale(ground, building, vertical, block, {*o.cm_height_m, *o.base_width_m}, factor);
  }
  return h;
}

void check_coupling(bool is_regular) {
  if (is_regular) return;
  throw InputError({"--mass-ratio",
                    "with this friction and slope the array locks against the roof it moves: the "
                    "coupled equations have no solution",
                    "give a smaller mass ratio, friction or slope", ""});
}

/// One axis; building and array are coupled, or the building yields.
SlideHistory on_coupled_building(const SlideOptions& o, const Motion& motion, double factor) {
  const Block block = block_of(o);
  check_coupling(coupling_is_regular(block, o.c.mass_ratio));
  const CoupledBuilding building{
      {o.c.period_s, o.c.damping}, o.c.mass_ratio, strength_of(o.c, o.c.period_s, nullptr)};
  const GroundMotion ground = ground_of(motion);
  const MotionFactors factors{factor, factor};
  std::vector<CoupledPoint> points;
  const CoupledResult r = o.history.empty()
                              ? slide_coupled(ground, factors, building, block)
                              : slide_coupled(ground, factors, building, block, points);
  if (!o.history.empty() && std::isfinite(r.slip.residual.along_m)) {
    Table table = history_table();
    for (const CoupledPoint& p : points)
      table.add({p.time_s, p.roof_acceleration_mps2, p.displacement_m, p.velocity_mps});
    write_text_file(o.history, to_csv(table));
  }
  SlideHistory h;
  h.slip = r.slip;
  h.ppa_g = r.peak_roof_acceleration_mps2 / standard_gravity_mps2;
  h.peak_base_shear = {r.peak_base_shear};
  h.peak_roof_displacement_m = {r.peak_roof_displacement_m};
  if (o.clearance_m) {
    slide_coupled(ground, factors, building, block, {&*o.clearance_m, 1},
                  {&h.crossing.emplace(), 1});
  }
  return h;
}

/// Two axes, several modes, or a law of friction that only the full model has.
SlideHistory in_full_model(const SlideOptions& o, const Motion& motion, double factor) {
  const Block block = block_of(o);
  const BiaxialBuilding building = biaxial_building(o.c, o.building, nullptr);
  check_coupling(coupling_is_regular(block, building));
  Block weakest = block;
  weakest.friction = std::min(block.friction.along, block.friction.across);
  const BuildingGround ground = building_ground(
      motion, {o.c.vertical_period_s, o.c.vertical_damping}, follow_roof({&weakest, 1}, factor));
  SlideHistory h;
  const std::span<const double> thresholds =
      o.clearance_m ? std::span<const double>(&*o.clearance_m, 1) : std::span<const double>();
  const std::span<Crossing> crossings =
      o.clearance_m ? std::span<Crossing>(&h.crossing.emplace(), 1) : std::span<Crossing>();
  const BuildingSlip r =
      slide_on_building(ground, {factor, factor}, building, block, thresholds, crossings);
  h.slip = r.slip;
  if (!o.history.empty() && std::isfinite(h.slip.residual.along_m))
    write_plane_history(o.history, motion, factor, block);
  if (o.c.period_s > 0.0) {
    const std::size_t axes = o.two_axes() ? 2 : 1;
    h.peak_base_shear.assign(r.peak_base_shear.begin(), r.peak_base_shear.begin() + axes);
    h.peak_roof_displacement_m.assign(r.peak_roof_displacement_m.begin(),
                                      r.peak_roof_displacement_m.begin() + axes);
  }
  return h;
}

}  // namespace

std::string model_of(const SlideOptions& o) {
  switch (kernel_for(o).kernel) {
    case Kernel::tables:
      return o.method == "event"
                 ? "one axis, building not coupled with the array: exact events (slide)"
                 : "one axis, the published scheme (slide_rodriguez_nikl)";
    case Kernel::coupled:
      return o.c.period_s > 0.0
                 ? "one axis, coupled with the building: exact events (slide_coupled)"
                 : "one axis on a rigid roof: exact events (slide_coupled)";
    case Kernel::full:
      break;
  }
  return fmt::format("full model: {}, coupled, error-controlled (slide_on_building)",
                     o.two_axes() ? "two axes" : "one axis");
}

SlideHistory run_history(const SlideOptions& o, const Motion& motion, double factor) {
  switch (kernel_for(o).kernel) {
    case Kernel::tables:
      return on_known_roof(o, motion, factor);
    case Kernel::coupled:
      return on_coupled_building(o, motion, factor);
    case Kernel::full:
      break;
  }
  return in_full_model(o, motion, factor);
}

}  // namespace glissade::cli
