// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/block/tipping.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/csv.hpp"
#include "glissade/io/record_file.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/motion.hpp"
#include "glissade/study/scene.hpp"

namespace glissade::cli {
namespace {

struct SlideOptions {
  std::string record, vertical, second, units, method = "event", history;
  double mu = 0.0, slope_deg = 0.0, period_s = 0.0, damping = 0.05, mass_ratio = 0.0;
  std::optional<double> scale, pga_g, dt_s, cm_height_m, base_width_m;
  int substeps = 64;
  bool one_way = false, json = false;
};

void check(const SlideOptions& o) {
  ProblemList problems;
  const auto require = [&](bool ok, const std::string& option, double value, const char* rule) {
    if (!ok || !std::isfinite(value))
      problems.add({option, fmt::format("{:g} {}", value, rule), "", ""});
  };
  require(o.mu >= 0.0 && o.mu <= 10.0, "--mu", o.mu,
          "is not a coefficient of friction: it must be from 0 to 10");
  require(std::abs(o.slope_deg) < 90.0, "--slope-deg", o.slope_deg,
          "is not a roof: it must lie between -90 and 90");
  require(o.period_s >= 0.0, "--period-s", o.period_s, "must be >= 0 (0: rigid building)");
  require(o.damping >= 0.0 && o.damping < 1.0, "--damping", o.damping, "must be a ratio in [0, 1)");
  if (o.scale) require(*o.scale > 0.0, "--scale", *o.scale, "must be > 0");
  if (o.pga_g) require(*o.pga_g > 0.0, "--pga-g", *o.pga_g, "must be > 0");
  if (o.dt_s) require(*o.dt_s > 0.0, "--dt-s", *o.dt_s, "must be > 0");
  if (o.cm_height_m)
    require(*o.cm_height_m > 0.0, "--centre-of-mass-height-m", *o.cm_height_m, "must be > 0");
  if (o.base_width_m)
    require(*o.base_width_m > 0.0, "--base-width-m", *o.base_width_m, "must be > 0");
  if (o.cm_height_m.has_value() != o.base_width_m.has_value()) {
    problems.add({o.cm_height_m ? "--centre-of-mass-height-m" : "--base-width-m",
                  "is one half of what the tipping check needs",
                  o.cm_height_m ? "give --base-width-m too" : "give --centre-of-mass-height-m too",
                  ""});
  }
  require(o.substeps >= 1, "--substeps", o.substeps, "must be at least 1");
  if (o.method != "event" && o.method != "rodriguez-nikl") {
    problems.add({"--method", o.method + " is not a method", "give event or rodriguez-nikl", ""});
  }
  if (!o.history.empty() && o.method != "event") {
    problems.add({"--history", "is written by the event method only", "leave out --method", ""});
  }
  if (o.history == "/dev/stdout") {
    problems.add({"--history", "/dev/stdout is where the result is printed", "give a file", ""});
  }
  if (std::filesystem::is_regular_file(o.history)) {
    problems.add({"--history", o.history + " is there already and is not written over",
                  "give a new file", ""});
  }
  if (!o.second.empty()) {
    problems.add({"--second", "the two-axis model is not in this version",
                  "leave it out: one axis along the slope", ""});
  }
  if (o.mass_ratio != 0.0) {
    problems.add({"--mass-ratio", "the coupled building is not in this version",
                  "leave it out: the array's mass is neglected", ""});
  }
  problems.throw_if_any();
}

Motion read_motion(const SlideOptions& o) {
  RecordFileOptions file;
  file.dt_s = o.dt_s;
  if (!o.units.empty()) file.units = parse_acceleration_units(o.units);
  const TimedRecord horizontal{read_record(o.record, file), 0.0};
  std::optional<TimedRecord> vertical;
  if (!o.vertical.empty()) vertical = TimedRecord{read_record(o.vertical, file), 0.0};
  return assemble_motion({}, horizontal, std::nullopt, vertical);
}

/// The factor on the record at which the body begins to rock on its base; infinity: never.
double tipping_scale(const GroundMotion& ground, const Building& building, const Block& block,
                     const RigidBase& base, double scale) {
  const Block rocking = rocking_block(block, base);
  if (block.friction <= rocking.friction) return std::numeric_limits<double>::infinity();
  const auto followed_up_to = [&](double largest_scale) {
    const RoofMotion roof =
        roof_motion(ground, building, follow_roof({&rocking, 1}, largest_scale));
    return tipping_onset_factor(
        RoofAcceleration{roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2}, block, base);
  };
  // At a larger scale than the roof was followed for, its ring-down may be what tips first.
  const double found = followed_up_to(scale);
  return found > scale && std::isfinite(found) ? followed_up_to(found) : found;
}

std::string tipping_text(const Block& block, const RigidBase& base, double tipping_scale,
                         double scale, double pga_g) {
  const double most = rocking_block(block, base).friction;
  if (block.friction <= most) {
    return fmt::format(
        "  cannot tip: friction lets it slide first (mu <= width / (2 height) = {:.4g})", most);
  }
  if (!std::isfinite(tipping_scale)) return "  tips       at no scale";
  const std::string onset =
      fmt::format("a scale of {:.4g} (PGA {:.4g} g)", tipping_scale, pga_g / scale * tipping_scale);
  if (scale <= tipping_scale) return "  tips       not before " + onset;
  return "TIPPING: from " + onset +
         " on the body rocks on its base; the model does not hold for this history.";
}

std::string history_csv(const RoofAcceleration& roof, const std::vector<SlipPoint>& history) {
  CsvTable table({"time_s", "roof_acceleration_mps2", "displacement_m", "velocity_mps"});
  const std::size_t n = roof.horizontal_mps2.size();
  for (const SlipPoint& point : history) {
    const double position = point.time_s / roof.dt_s;
    const std::size_t i = static_cast<std::size_t>(position);
    const auto sample = [&](std::size_t k) {
      return k < n ? roof.horizontal_factor * roof.horizontal_mps2[k] : 0.0;
    };
    const double acceleration =
        sample(i) + (position - static_cast<double>(i)) * (sample(i + 1) - sample(i));
    table.cell(point.time_s)
        .cell(acceleration)
        .cell(point.displacement_m)
        .cell(point.velocity_mps)
        .end_row();
  }
  return "# displacement and velocity of the block relative to the roof, in plan, downslope "
         "positive (flat roof: +x)\n" +
         table.text();
}

void run(const SlideOptions& o) {
  check(o);
  const Motion motion = read_motion(o);
  const double pga = peak_ground_acceleration_mps2(motion.horizontal_mps2[0]);
  if (o.pga_g && pga == 0.0)
    throw InputError(
        {o.record, "is zero throughout and cannot be scaled to --pga-g", "give --scale", ""});
  const double factor = o.pga_g ? *o.pga_g * standard_gravity_mps2 / pga : o.scale.value_or(1.0);

  const Block block{
      .friction = o.mu,
      .slope_rad = o.slope_deg * rad_per_deg,
      .directions = o.one_way ? SlipDirections::downslope_only : SlipDirections::both};
  const GroundMotion ground{motion.dt_s, motion.horizontal_mps2[0], motion.vertical_mps2};
  const Building building{{o.period_s, o.damping}, {}};
  const RoofMotion roof_table = roof_motion(ground, building, follow_roof({&block, 1}, factor));
  const RoofAcceleration roof = felt_by(block, roof_table, {factor, factor});

  std::vector<SlipPoint> history;
  const SlipResult r = o.method != "event" ? slide_rodriguez_nikl(roof, block, o.substeps)
                       : o.history.empty() ? slide(roof, block)
                                           : slide(roof, block, history);
  if (!std::isfinite(r.residual_displacement_m) || !std::isfinite(r.peak_velocity_mps)) {
    throw InputError({o.record, fmt::format("the factor {:g} on the motion overflows", factor),
                      "give a smaller --scale or --pga-g", ""});
  }
  if (!o.history.empty()) write_text_file(o.history, history_csv(roof, history));

  std::optional<RigidBase> base;
  if (o.cm_height_m) base = {*o.cm_height_m, *o.base_width_m};
  const double tips_at = base ? tipping_scale(ground, building, block, *base, factor) : 0.0;

  const double pga_g = factor * pga / standard_gravity_mps2;
  const double ppa_g = factor * roof_table.peak_horizontal_mps2 / standard_gravity_mps2;
  if (o.json) {
    nlohmann::ordered_json json{{"peak_displacement_m", r.peak_displacement_m},
                                {"residual_displacement_m", r.residual_displacement_m},
                                {"peak_downslope_m", r.peak_downslope_m},
                                {"peak_upslope_m", r.peak_upslope_m},
                                {"peak_velocity_mps", r.peak_velocity_mps},
                                {"slip_phases", r.slip_phases},
                                {"slip_duration_s", r.slip_duration_s},
                                {"uplift", r.uplift},
                                {"free_sliding", r.free_sliding},
                                {"samples", motion.horizontal_mps2[0].size()},
                                {"dt_s", motion.dt_s},
                                {"pga_g", pga_g},
                                {"ppa_g", ppa_g},
                                {"scale", factor},
                                {"mu", o.mu},
                                {"slope_deg", o.slope_deg},
                                {"period_s", o.period_s},
                                {"damping", o.damping},
                                {"vertical", !motion.vertical_mps2.empty()},
                                {"method", o.method}};
    if (base) {
      json["tips"] = factor > tips_at;
      json["tipping_scale"] = std::isfinite(tips_at) ? nlohmann::ordered_json(tips_at) : nullptr;
    }
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("{}: {} samples at {:g} s, PGA {:.4g} g, peak roof acceleration {:.4g} g\n", o.record,
             motion.horizontal_mps2[0].size(), motion.dt_s, pga_g, ppa_g);
  fmt::print(
      "Displacement relative to the roof, in plan (downslope positive; on a flat roof +x):\n");
  fmt::print("  peak       {:10.4f} m  ({:.2f} in)\n", r.peak_displacement_m,
             r.peak_displacement_m / inch_m);
  fmt::print("  residual   {:10.4f} m\n", r.residual_displacement_m);
  fmt::print("  downslope  {:10.4f} m\n  upslope    {:10.4f} m\n", r.peak_downslope_m,
             r.peak_upslope_m);
  fmt::print("  velocity   {:10.4f} m/s\n", r.peak_velocity_mps);
  fmt::print("  slides     {:10.4f} s in {} phases\n", r.slip_duration_s, r.slip_phases);
  if (base) fmt::print("{}\n", tipping_text(block, *base, tips_at, factor, pga_g));
  if (r.uplift)
    fmt::print(
        "UPLIFT: the normal force falls below zero; the model does not hold for this history.\n");
  if (r.free_sliding)
    fmt::print(
        "FREE SLIDING: friction cannot stop the block (tan(slope) >= mu); displacements are those "
        "at the record's end.\n");
}

}  // namespace

void add_slide(CLI::App& program) {
  auto o = std::make_shared<SlideOptions>();
  CLI::App* command = program.add_subcommand("slide", "How far a block slides on one record");
  command
      ->add_option(
          "record", o->record,
          "horizontal acceleration along the slope: PEER AT2, or text of one or two columns")
      ->required();
  command->add_option("--vertical", o->vertical, "vertical acceleration, up positive");
  command->add_option("--second", o->second, "second horizontal component (two-axis model)");
  command->add_option("--mu", o->mu, "coefficient of friction")->required();
  command
      ->add_option("--slope-deg", o->slope_deg, "roof slope; positive: the surface falls toward +x")
      ->required();
  CLI::Option* scale = command->add_option("--scale", o->scale, "factor on all components [1]");
  command->add_option("--pga-g", o->pga_g, "scale so that the horizontal peaks at this")
      ->excludes(scale);
  command->add_option("--period-s", o->period_s, "building period; 0: rigid");
  command->add_option("--damping", o->damping, "building damping ratio");
  command->add_option("--mass-ratio", o->mass_ratio,
                      "array mass over building mass (coupled model)");
  command->add_option("--centre-of-mass-height-m", o->cm_height_m,
                      "height of the centre of mass above the roof: checks for tipping");
  command->add_option("--base-width-m", o->base_width_m,
                      "width of the base along the slope, the centre of mass midway");
  command->add_option("--method", o->method,
                      "event (exact) or rodriguez-nikl (published time stepping)");
  command->add_option("--substeps", o->substeps, "substeps P of rodriguez-nikl");
  command->add_flag("--one-way", o->one_way, "no upslope slip (classical Newmark)");
  command->add_option("--dt-s", o->dt_s,
                      "time step of files that do not tell it; overrides an AT2 header");
  command->add_option("--units", o->units, "units of text files: g, m/s2, cm/s2 [g]");
  command->add_option("--history", o->history, "write the slip history to this CSV file");
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] { run(*o); });
}

}  // namespace glissade::cli
