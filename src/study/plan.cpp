// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "glissade/core/hash.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/study/chart.hpp"
#include "keep_records.hpp"
#include "plan_check.hpp"

namespace glissade {
namespace {

/// An uncertain quantity's place in the unit cube. Fixed for ever: a sample's numbers must not move
/// when another parameter becomes uncertain.
enum Dimension : std::uint32_t {
  friction_dimension,
  slope_dimension,
  period_dimension,
  damping_dimension,
  component_dimension,
  sign_dimension,
  friction_across_dimension,
  mass_ratio_dimension,
  azimuth_dimension,
  second_sign_dimension
};

constexpr std::uint64_t samples_per_unit = 16;  // large against a message, small against a run

std::vector<SamplePoint> draw_samples(const StudyConfig& config) {
  const PointSet points(config.sampling.method, config.seed);
  std::vector<SamplePoint> samples(config.sampling.samples);
  for (std::uint64_t i = 0; i < samples.size(); ++i) {
    const auto draw = [&](const Distribution& distribution, Dimension dimension) {
      return quantile(distribution, points.coordinate(i, dimension));
    };
    const auto coin = [&](Dimension dimension) { return points.coordinate(i, dimension) < 0.5; };
    SamplePoint& s = samples[i];
    // Tails outside the physical range (less than one in a million, io/study_file.hpp) are held at
    // its ends.
    s.friction = std::max(0.0, draw(config.friction.mu, friction_dimension));
    s.slope_deg = std::clamp(draw(config.roof.slope_deg, slope_dimension), -89.9, 89.9);
    s.period_s = std::max(0.0, draw(config.building.period_s, period_dimension));
    s.damping = std::clamp(draw(config.building.damping, damping_dimension), 0.0, 0.999);
    switch (config.orientation.component) {
      case ComponentChoice::first:
        s.component = 0;
        break;
      case ComponentChoice::second:
        s.component = 1;
        break;
      case ComponentChoice::random:
      case ComponentChoice::both:
        s.component = coin(component_dimension) ? 0 : 1;
        break;
    }
    const auto sign = [&](SignChoice choice, Dimension dimension) {
      if (choice == SignChoice::positive) return 1;
      if (choice == SignChoice::negative) return -1;
      return coin(dimension) ? 1 : -1;
    };
    s.sign = sign(config.orientation.sign, sign_dimension);
    s.mass_ratio = std::clamp(draw(config.building.mass_ratio, mass_ratio_dimension), 0.0, 1.0);
    if (config.model.axes == SlidingAxes::one) continue;
    s.friction_across =
        config.friction.across
            ? std::max(0.0, draw(*config.friction.across, friction_across_dimension))
            : s.friction;
    s.azimuth_deg = draw(config.roof.azimuth_deg, azimuth_dimension);
    s.second_sign = sign(config.orientation.second_sign, second_sign_dimension);
  }
  return samples;
}

bool values_repeat(std::vector<double> values) {
  const std::size_t count = values.size();
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return 2 * values.size() <= count;
}

/// Numbers the distinct roofs (component, period, damping, mass ratio) in the order in which they
/// come. A record's are kept where that saves roofs and takes no more memory than a hundred tables.
void number_buildings(Plan& plan) {
  constexpr std::size_t most_kept = 128;
  std::map<std::tuple<int, double, double, double>, std::size_t> numbers;
  for (const SamplePoint& s : plan.samples) {
    plan.building.push_back(
        numbers.try_emplace({s.component, s.period_s, s.damping, s.mass_ratio}, numbers.size())
            .first->second);
  }
  plan.roofs_are_kept = numbers.size() <= most_kept &&
                        (numbers.size() <= 2 || 2 * numbers.size() <= plan.samples.size());
}

/// At mean - 2 std of every coefficient.
FrictionRun design_run(const FrictionConfig& friction, std::size_t samples, SlidingAxes axes) {
  const auto describe_one = [](const Distribution& mu) {
    const double design = design_friction(mu);
    return fmt::format("mean - 2 std = {:.4g}{}", design,
                       design == 0.0 ? " (below zero: held at 0)" : "");
  };
  const double along = design_friction(friction.mu);
  FrictionRun run{"design", "mu = " + describe_one(friction.mu),
                  std::vector<double>(samples, along)};
  if (axes == SlidingAxes::one) return run;
  run.friction_across.assign(samples, friction.across ? design_friction(*friction.across) : along);
  if (friction.across) run.description += "; across the slope " + describe_one(*friction.across);
  return run;
}

std::vector<FrictionRun> friction_runs(const Plan& plan) {
  const FrictionConfig& friction = plan.config.friction;
  const SlidingAxes axes = plan.config.model.axes;
  FrictionRun sampled{"sampled", "mu " + describe(friction.mu), {}};
  if (friction.across) sampled.description += "; across the slope " + describe(*friction.across);
  if (plan.config.chart) {
    const std::vector<double>& mu = plan.config.chart->mu;
    sampled.label = "chart";
    sampled.description =
        fmt::format("mu {:g} to {:g}, {} values", mu.front(), mu.back(), mu.size());
  }
  for (const SamplePoint& sample : plan.samples) {
    sampled.friction.push_back(sample.friction);
    if (axes == SlidingAxes::two) sampled.friction_across.push_back(sample.friction_across);
  }
  std::vector<FrictionRun> runs{sampled};
  const bool uncertain = !is_fixed(friction.mu) || (friction.across && !is_fixed(*friction.across));
  if (friction.design_run && uncertain)
    runs.push_back(design_run(friction, plan.samples.size(), axes));
  for (FrictionRun& run : runs) run.repeats = values_repeat(run.friction);
  return runs;
}

/// The factor that gives each record intensity 1.
std::vector<double> factors_at_unit_level(const StudyConfig& config, const Suite& suite) {
  const IntensityConfig& intensity = config.intensity;
  std::vector<double> factors;
  const auto per_motion = [&](auto intensity_of) {
    for (const Motion& motion : suite.motions)
      factors.push_back(standard_gravity_mps2 / intensity_of(motion));
  };
  switch (intensity.measure) {
    case IntensityMeasure::sds_g: {
      const DesignTarget target = intensity.target ? *intensity.target : *suite.target;
      const TargetSpectrum spectrum(target);
      const auto unit_design = [&](double period) {
        return spectrum.design_sa_g(period) / spectrum.sds_g();
      };
      const double common = suite_average_factor(suite, unit_design, walters_periods_s());
      for (const Motion& motion : suite.motions) factors.push_back(common * motion.scale);
      break;
    }
    case IntensityMeasure::pga_g:
      per_motion([](const Motion& m) {
        return horizontal_pga_mps2(m, HorizontalCombination::geometric_mean);
      });
      break;
    case IntensityMeasure::sa_g: {
      const std::vector<double> period{intensity.sa_period_s};
      per_motion([&](const Motion& m) {
        return horizontal_spectrum_mps2(m, period, HorizontalCombination::geometric_mean).front();
      });
      break;
    }
    case IntensityMeasure::avg_sa_g:
      per_motion([&](const Motion& m) { return average_sa_mps2(m, intensity.avg_sa_periods_s); });
      break;
    case IntensityMeasure::ppa_g:
      factors.assign(suite.motions.size(), 0.0);
      break;
  }
  return factors;
}

std::vector<std::string> notes_on(const StudyConfig& config, const Suite& suite) {
  std::vector<std::string> notes;
  const auto count = [&](auto lacks) {
    return std::count_if(suite.motions.begin(), suite.motions.end(), lacks);
  };
  const auto flat = count([](const Motion& m) { return m.vertical_mps2.empty(); });
  if (config.vertical.use == VerticalChoice::if_available && flat > 0) {
    notes.push_back(
        fmt::format("{} of {} records have no vertical component: run with the horizontal alone",
                    flat, suite.motions.size()));
  }
  if (!config.friction.note.empty()) notes.push_back(config.friction.note);
  if (config.stop_at_largest_threshold) {
    notes.push_back(
        fmt::format("[clearance] stop_at_largest: a history is not run above the level that takes "
                    "it past {:g} m; its "
                    "slip there is told as infinite, and a recrossing there would not be seen",
                    config.thresholds_m.back()));
  }
  if (suite.motions.size() == 1 && config.chart) {
    notes.push_back(
        "one record: the mean, the percentiles and the envelope are all that record's slip");
  }
  const auto single = count([](const Motion& m) { return m.horizontal_mps2[1].empty(); });
  const ComponentChoice choice = config.orientation.component;
  if ((choice == ComponentChoice::random || choice == ComponentChoice::both) && single > 0) {
    notes.push_back(
        fmt::format("{} of {} records have one horizontal component: it is used throughout", single,
                    suite.motions.size()));
  }
  return notes;
}

/// Samples that SEAOC PV1-2012 does not prescribe for.
std::vector<std::string> notes_on_standards(const Plan& plan) {
  const auto& compare = plan.config.standards.compare;
  std::vector<std::string> notes;
  if (plan.config.chart ||
      std::find(compare.begin(), compare.end(), Standard::seaoc_pv1_2012) == compare.end())
    return notes;
  for (const FrictionRun& run : plan.runs) {
    std::size_t outside = 0;
    for (std::size_t i = 0; i < plan.samples.size(); ++i) {
      if (std::abs(plan.samples[i].slope_deg) >= seaoc_slope_limit_deg ||
          run.friction[i] <= seaoc_mu_limit)
        ++outside;
    }
    if (outside == 0) continue;
    notes.push_back(fmt::format(
        "{} friction: {:.0f} % of the samples are outside the range of SEAOC PV1's prescriptive "
        "value (slope under 3 "
        "degrees and mu above 0.4); they are compared with it all the same",
        run.label,
        100.0 * static_cast<double>(outside) / static_cast<double>(plan.samples.size())));
  }
  return notes;
}

std::vector<Skip> skips_of(const StudyConfig& config, const Plan& plan) {
  std::vector<Skip> skips;
  const std::uint64_t pairs = plan.suite.motions.size() * plan.samples.size();
  if (config.vertical.use == VerticalChoice::none) {
    skips.push_back({"vertical ground motion", "[vertical] use = \"none\"", pairs});
  }
  if (std::all_of(plan.samples.begin(), plan.samples.end(),
                  [](const SamplePoint& s) { return s.period_s == 0.0; })) {
    skips.push_back({"roof motions filtered by a building", "the building is rigid", pairs});
  }
  if (plan.runs.size() == 1 && !config.chart) {
    skips.push_back(
        {"run at the design friction",
         is_fixed(config.friction.mu) ? "friction is one number" : "[friction] design_run = false",
         pairs});
  }
  if (config.standards.compare.empty())
    skips.push_back({"comparison with standards", "none asked for", 0});
  return skips;
}

std::string hash_of(const Plan& plan) {
  Hasher hasher;
  hasher.text("glissade plan 4").text(plan.config.source_text).numbers(plan.factor_at_unit_level);
  for (const Motion& motion : plan.suite.motions) {
    hasher.text(motion.id).number(motion.scale).number(motion.dt_s);
    for (const auto& component : motion.horizontal_mps2) hasher.numbers(component);
    hasher.numbers(motion.vertical_mps2);
  }
  for (const SamplePoint& s : plan.samples) {
    hasher.number(s.slope_deg).number(s.period_s).number(s.damping);
    hasher.number(static_cast<double>(s.component)).number(static_cast<double>(s.sign));
    hasher.number(s.mass_ratio).number(s.azimuth_deg).number(static_cast<double>(s.second_sign));
  }
  for (const FrictionRun& run : plan.runs)
    hasher.text(run.label).numbers(run.friction).numbers(run.friction_across);
  return to_hex(hasher.value());
}

}  // namespace

Plan make_plan(const StudyConfig& config, Suite suite) {
  keep_records({config.file, config.suite_file, config.records}, suite);
  check_fit(config, suite);
  Plan plan;
  plan.config = config;
  plan.factor_at_unit_level = factors_at_unit_level(config, suite);
  plan.notes = notes_on(config, suite);
  plan.suite = std::move(suite);
  plan.kernel = cheapest_exact_kernel(config);
  plan.samples = config.chart ? chart_samples(config) : draw_samples(config);
  number_buildings(plan);
  plan.runs = friction_runs(plan);
  check_samples(plan);
  for (std::string& note : notes_on_standards(plan)) plan.notes.push_back(std::move(note));
  plan.skips = skips_of(config, plan);
  plan.hash = hash_of(plan);
  for (std::size_t record = 0; record < plan.suite.motions.size(); ++record) {
    for (std::uint64_t first = 0; first < plan.samples.size(); first += samples_per_unit) {
      plan.units.push_back(
          {record, first, std::min<std::uint64_t>(samples_per_unit, plan.samples.size() - first)});
    }
  }
  return plan;
}

std::uint64_t Plan::histories() const {
  return suite.motions.size() * samples.size() * config.intensity.levels.size() * runs.size();
}

}  // namespace glissade
