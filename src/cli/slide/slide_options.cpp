// SPDX-License-Identifier: GPL-3.0-or-later
#include "slide/slide_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "glissade/core/error.hpp"
#include "output_rule.hpp"

namespace glissade::cli {
namespace {

void require_number(ProblemList& problems, bool ok, const char* option, double value,
                    const char* rule) {
  if (!ok || !std::isfinite(value))
    problems.add({option, fmt::format("{:g} {}", value, rule), "", ""});
}

/// Conditions on the model's extensions, each and together.
void check_model(const SlideOptions& o, ProblemList& problems) {
  const auto require = [&](bool ok, const char* option, double value, const char* rule) {
    require_number(problems, ok, option, value, rule);
  };
  require(o.mass_ratio >= 0.0 && o.mass_ratio <= 1.0, "--mass-ratio", o.mass_ratio,
          "is not the array's mass over the building's: it must be from 0 to 1");
  require(o.period_ratio > 0.0, "--period-ratio", o.period_ratio, "must be > 0");
  require(std::abs(o.azimuth_deg) <= 360.0, "--azimuth-deg", o.azimuth_deg,
          "must be from -360 to 360");
  if (o.mu_across) {
    require(*o.mu_across > 0.0 && *o.mu_across <= 10.0, "--across-mu", *o.mu_across,
            "is not an axis of a friction ellipse: it must be above 0, at most 10");
  }
  if (o.two_axes() && o.mu == 0.0) {
    problems.add({"--mu", "0 leaves the friction ellipse without an axis",
                  "on two axes give friction above 0", ""});
  }
  if (o.yield_coefficient)
    require(*o.yield_coefficient > 0.0, "--yield-coefficient", *o.yield_coefficient, "must be > 0");
  require(o.hardening_ratio >= 0.0 && o.hardening_ratio < 1.0, "--hardening-ratio",
          o.hardening_ratio, "must be a ratio in [0, 1)");
  require(o.vertical_period_s >= 0.0, "--vertical-period-s", o.vertical_period_s, "must be >= 0");
  require(o.vertical_damping() >= 0.0 && o.vertical_damping() < 1.0, "--vertical-damping",
          o.vertical_damping(), "must be a ratio in [0, 1)");
  require(o.law.static_over_sliding >= 1.0, "--static-over-sliding", o.law.static_over_sliding,
          "must be >= 1: static friction is not below sliding friction");
  require(o.law.fast_over_slow > 0.0, "--fast-over-slow", o.law.fast_over_slow, "must be > 0");
  require(o.law.rate_s_per_m >= 0.0, "--rate-s-per-m", o.law.rate_s_per_m, "must be >= 0");

  if ((o.law.fast_over_slow != 1.0) != (o.law.rate_s_per_m != 0.0)) {
    problems.add({o.law.rate_s_per_m == 0.0 ? "--fast-over-slow" : "--rate-s-per-m",
                  "is one half of how friction depends on speed",
                  "give --fast-over-slow (mu_fast / mu_slow) and --rate-s-per-m (the rate a, s/m)",
                  ""});
  }
  const auto needs = [&](bool given, const char* option, bool met, const char* what) {
    if (given && !met) problems.add({option, what, "leave it out, or give the other", ""});
  };
  needs(o.azimuth_deg != 0.0, "--azimuth-deg", o.two_axes(), "needs --second");
  needs(o.period_ratio != 1.0, "--period-ratio", o.two_axes(), "needs --second");
  needs(o.mu_across.has_value(), "--across-mu", o.two_axes(), "needs --second");
  needs(o.hardening_ratio != 0.0, "--hardening-ratio", o.yield_coefficient.has_value(),
        "needs --yield-coefficient");
  needs(o.vertical_period_s != 0.0, "--vertical-period-s", !o.vertical.empty(), "needs --vertical");
  needs(o.given_vertical_damping.has_value(), "--vertical-damping", o.vertical_period_s != 0.0,
        "needs --vertical-period-s above 0");
  needs(o.given_damping.has_value(), "--damping", o.period_s != 0.0,
        "has no effect without a building: --period-s above 0");
  needs(o.given_substeps.has_value(), "--substeps", o.method != "event",
        "needs --method rodriguez-nikl");
  needs(o.mass_ratio != 0.0, "--mass-ratio", o.period_s > 0.0,
        "has no effect without a building: --period-s above 0");
  needs(o.yield_coefficient.has_value(), "--yield-coefficient", o.period_s > 0.0,
        "needs a building: --period-s above 0");

  const Kernel kernel = kernel_for(o).kernel;
  if (kernel == Kernel::tables) return;
  const auto refuse = [&](bool given, const char* option) {
    if (given) {
      problems.add(
          {option,
           "needs one axis, Coulomb friction and a linear building that is not coupled with "
           "the array only",
           "leave it out", ""});
    }
  };
  refuse(o.method != "event", "--method");
  refuse(o.cm_height_m.has_value(), "--centre-of-mass-height-m");
  if (kernel == Kernel::full) {
    refuse(!o.history.empty(), "--history");
    refuse(o.one_way, "--one-way");
  }
}

}  // namespace

KernelChoice kernel_for(const SlideOptions& o) {
  StudyConfig config;
  config.model.axes = o.two_axes() ? SlidingAxes::two : SlidingAxes::one;
  const auto set = [&](const char* table, const char* key, double value) {
    config.quantities.at(table, key) = {{value}, {}};
  };
  set("friction", "static_over_sliding", o.law.static_over_sliding);
  set("friction", "fast_over_slow", o.law.fast_over_slow);
  set("friction", "rate_s_per_m", o.law.rate_s_per_m);
  set("building", "period_s", o.period_s);
  set("building", "mass_ratio", o.mass_ratio);
  set("building", "yield_coefficient", o.yield_coefficient.value_or(0.0));
  set("vertical", "period_s", o.vertical_period_s);
  config.vertical = {o.vertical.empty() ? VerticalChoice::none : VerticalChoice::required};
  return cheapest_exact_kernel(config);
}

void check(const SlideOptions& o) {
  ProblemList problems;
  const auto require = [&](bool ok, const char* option, double value, const char* rule) {
    require_number(problems, ok, option, value, rule);
  };
  require(o.mu >= 0.0 && o.mu <= 10.0, "--mu", o.mu,
          "is not a coefficient of friction: it must be from 0 to 10");
  require(std::abs(o.slope_deg) < 90.0, "--slope-deg", o.slope_deg,
          "is not a roof: it must be between -90 and 90");
  require(o.period_s >= 0.0, "--period-s", o.period_s, "must be >= 0 (0: rigid building)");
  require(o.damping() >= 0.0 && o.damping() < 1.0, "--damping", o.damping(),
          "must be a ratio in [0, 1)");
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
  if (o.clearance_m) require(*o.clearance_m > 0.0, "--clearance-m", *o.clearance_m, "must be > 0");
  require(o.substeps() >= 1, "--substeps", o.substeps(), "must be at least 1");
  if (o.method != "event" && o.method != "rodriguez-nikl") {
    problems.add({"--method", o.method + " is not a method", "give event or rodriguez-nikl", ""});
  }
  if (!o.history.empty() && o.method != "event") {
    problems.add({"--history", "is written by the event method only", "leave out --method", ""});
  }
  if (o.history == "/dev/stdout") {
    problems.add({"--history", "/dev/stdout is where the result is printed", "give a file", ""});
  }
  try {
    check_output_file(o.history, "--history", o.overwrite);
  } catch (const InputError& error) {
    problems.add(error);
  }
  check_model(o, problems);
  problems.throw_if_any();
}

void add_options(CLI::App& command, SlideOptions& o) {
  command
      .add_option(
          "record", o.record,
          "horizontal acceleration along the slope: PEER AT2, or text of one or two columns")
      ->required();
  command.add_option("--vertical", o.vertical, "vertical acceleration, up positive");
  command.add_option("--second", o.second,
                     "second horizontal component, a quarter turn on: the array slides along two "
                     "axes");
  command.add_option("--mu", o.mu, "coefficient of friction")->required();
  command
      .add_option("--slope-deg", o.slope_deg, "roof slope; positive: the surface falls toward +x")
      ->required();
  CLI::Option* scale = command.add_option("--scale", o.scale, "factor on all components [1]");
  command.add_option("--pga-g", o.pga_g, "scale so that the horizontal peaks at this")
      ->excludes(scale);
  command.add_option("--period-s", o.period_s, "building period; 0: rigid");
  command.add_option("--damping", o.given_damping, "building damping ratio [0.05]");
  command.add_option("--period-ratio", o.period_ratio,
                     "with --second: building period along the second axis over the first [1]");
  command.add_option("--mass-ratio", o.mass_ratio,
                     "array mass over building mass: above 0 building and array are coupled [0]");
  command.add_option("--yield-coefficient", o.yield_coefficient,
                     "the building yields: yield force over its weight");
  command.add_option("--hardening-ratio", o.hardening_ratio,
                     "stiffness after yielding over before [0]");
  command.add_option("--vertical-period-s", o.vertical_period_s,
                     "period of the roof's vertical motion; 0: rigid [0]");
  command.add_option("--vertical-damping", o.given_vertical_damping, "its damping ratio [0.05]");
  command.add_option("--azimuth-deg", o.azimuth_deg,
                     "with --second: from the first component to where the roof falls, toward the "
                     "second [0]");
  command.add_option("--across-mu", o.mu_across,
                     "with --second: coefficient of friction across the slope [as --mu]");
  command.add_option("--static-over-sliding", o.law.static_over_sliding,
                     "friction at rest over sliding friction [1]");
  command.add_option("--fast-over-slow", o.law.fast_over_slow,
                     "friction of fast over slow sliding; --mu is the slow one [1]");
  command.add_option("--rate-s-per-m", o.law.rate_s_per_m,
                     "rate a of mu_fast - (mu_fast - mu_slow) exp(-a speed), s/m");
  command.add_option("--clearance-m", o.clearance_m,
                     "also report when and how fast the array first reaches this displacement");
  command.add_option("--centre-of-mass-height-m", o.cm_height_m,
                     "height of the centre of mass above the roof: checks for tipping");
  command.add_option("--base-width-m", o.base_width_m,
                     "width of the base along the slope, the centre of mass midway");
  command.add_option("--method", o.method,
                     "event (exact) or rodriguez-nikl (published time stepping)");
  command.add_option("--substeps", o.given_substeps, "substeps P of rodriguez-nikl [64]");
  command.add_flag("--one-way", o.one_way, "no upslope slip (classical Newmark)");
  command.add_option("--dt-s", o.dt_s, "time step of files without one; overrides an AT2 header");
  command.add_option("--units", o.units, "units of files that do not state theirs: g, m/s2, cm/s2");
  command.add_option("--history", o.history, "write the slip history to this CSV file (one axis)");
  add_overwrite(command, o.overwrite);
  command.add_flag("--json", o.json, "print one JSON object");
}

}  // namespace glissade::cli
