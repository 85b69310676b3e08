// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/block/coupled.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "model_scene.hpp"

namespace glissade {
namespace {

/// What the parts of a model ask of each other.
void check_model(const StudyConfig& config, const Suite& suite, ProblemList& problems) {
  const std::string file = config.file.string();
  const KernelChoice choice = cheapest_exact_kernel(config);
  const std::optional<StrengthConfig>& strength = config.building.strength;
  if (strength && strength->response_modification && !config.intensity.target && !suite.target) {
    problems.add({file,
                  "building.response_modification divides the elastic demand of a design spectrum, "
                  "and neither study nor suite gives one",
                  "give yield_coefficient instead, or a target", ""});
  }
  if (choice.kernel == Kernel::tables) return;
  if (config.base) {
    problems.add({file,
                  "the tipping check of [array] holds where the roof does not feel the array: " +
                      choice.reason,
                  "leave out [array], or the model's extension", ""});
  }
  if (config.intensity.measure == IntensityMeasure::ppa_g) {
    problems.add(
        {file,
         "measure = \"ppa_g\" scales by the peak of a roof that does not feel the array: " +
             choice.reason,
         "measure by sds_g, pga_g, sa_g or avg_sa_g", ""});
  }
}

bool is_regular(const Plan& plan, std::size_t run, std::size_t sample) {
  if (plan.kernel.kernel == Kernel::full) {
    return coupling_is_regular(two_axis_block(plan, run, sample), biaxial_building(plan, sample));
  }
  const SamplePoint& s = plan.samples[sample];
  return coupling_is_regular(
      {.friction = plan.runs[run].friction[sample], .slope_rad = s.slope_deg * rad_per_deg},
      s.mass_ratio);
}

/// Where the array's friction would lock it against the roof it moves, the coupled equations have
/// no solution.
void check_coupling(const Plan& plan) {
  if (plan.kernel.kernel == Kernel::tables) return;
  for (std::size_t run = 0; run < plan.runs.size(); ++run) {
    for (std::size_t i = 0; i < plan.samples.size(); ++i) {
      if (is_regular(plan, run, i)) continue;
      const SamplePoint& s = plan.samples[i];
      throw InputError({plan.config.file.string(),
                        fmt::format("with mu = {:.3g}, a slope of {:.3g} degrees and a mass ratio "
                                    "of {:.3g} friction locks the array against the roof it moves",
                                    plan.runs[run].friction[i], s.slope_deg, s.mass_ratio),
                        "the coupled equations have no solution there: take a smaller mass ratio, "
                        "friction or slope",
                        ""});
    }
  }
}

/// Both half-axes of an ellipse of friction are above zero.
void check_ellipse(const Plan& plan) {
  for (const FrictionRun& run : plan.runs) {
    for (std::size_t i = 0; i < run.friction_across.size(); ++i) {
      if (run.friction[i] > 0.0 && run.friction_across[i] > 0.0) continue;
      throw InputError({plan.config.file.string(),
                        fmt::format("{} friction: an axis of the friction ellipse is zero (mu {:g} "
                                    "along the slope, {:g} across)",
                                    run.label, run.friction[i], run.friction_across[i]),
                        "give friction above zero in both directions", ""});
    }
  }
}

/// A spring that yields has a yield displacement, which a building as good as rigid has not.
void check_strength(const Plan& plan) {
  constexpr double shortest_s = 0.01;
  if (!plan.config.building.strength) return;
  const auto is_shorter = [&](const SamplePoint& s) {
    return s.period_s * std::min(1.0, plan.config.building.period_ratio) < shortest_s;
  };
  const auto shorter = std::find_if(plan.samples.begin(), plan.samples.end(), is_shorter);
  if (shorter == plan.samples.end()) return;
  throw InputError({plan.config.file.string(),
                    fmt::format("a rigid building does not yield, and a building period is {:g} s",
                                shorter->period_s),
                    fmt::format("give periods of {:g} s or more, or leave out the building's "
                                "strength",
                                shortest_s),
                    ""});
}

}  // namespace

void check_fit(const StudyConfig& config, const Suite& suite) {
  ProblemList problems;
  const std::string where = config.suite_file.string();
  if (suite.motions.empty())
    problems.add({where, "the suite has no motions", "add at least one record", ""});
  if (config.intensity.measure == IntensityMeasure::sds_g && !config.intensity.target &&
      !suite.target) {
    problems.add({config.file.string(),
                  "measure = \"sds_g\" needs the shape of a design spectrum and neither study nor "
                  "suite gives one",
                  "add target = { edition = \"asce7_10\", ss_g = ..., s1_g = ..., site_class = "
                  "\"D\" } to [intensity]",
                  ""});
  }
  check_model(config, suite, problems);
  for (const Motion& motion : suite.motions) {
    if (config.orientation.component == ComponentChoice::second &&
        motion.horizontal_mps2[1].empty()) {
      problems.add({where, "record " + motion.id + " has no second horizontal component",
                    "set component = \"first\" or \"random\" in [orientation]", ""});
    }
    if (config.vertical.use == VerticalChoice::required && motion.vertical_mps2.empty()) {
      problems.add({where,
                    "record " + motion.id +
                        " has no vertical component although [vertical] use = \"required\"",
                    "set use = \"if_available\", or leave the record out", ""});
    }
    if (config.model.axes == SlidingAxes::two && motion.horizontal_mps2[1].empty()) {
      problems.add({where,
                    "record " + motion.id +
                        " has no second horizontal component, which [model] axes = 2 needs",
                    "leave the record out ([suite] records), or set axes = 1", ""});
    }
    if (horizontal_pga_mps2(motion, HorizontalCombination::srss) == 0.0) {
      problems.add(
          {where, "record " + motion.id + " is zero throughout", "leave it out of the suite", ""});
    }
  }
  problems.throw_if_any();
}

void check_samples(const Plan& plan) {
  check_strength(plan);
  check_ellipse(plan);
  check_coupling(plan);
}

}  // namespace glissade
