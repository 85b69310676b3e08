// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "chapters.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/execute.hpp"
#include "glissade/study/run/reduce.hpp"

namespace glissade::verification {
namespace {

Results run(const Plan& plan) {
  std::vector<UnitResult> units;
  for (std::size_t u = 0; u < plan.units.size(); ++u) units.push_back(execute(plan, u));
  return reduce(plan, units);
}

/// One motion, rigid building, everything fixed, levels of PGA.
StudyConfig fixed_study(double slope_deg, double friction, VerticalChoice vertical) {
  StudyConfig config;
  config.model.axes = SlidingAxes::one;
  config.name = "verification";
  config.seed = 1;
  config.intensity.measure = *IntensityMeasure::named("pga_g");
  for (int i = 1; i <= 16; ++i) config.intensity.levels.push_back(0.125 * i);
  config.quantities.at("roof", "slope_deg") = {{slope_deg}, {}};
  config.quantities.at("friction", "mu") = {{friction}, {}};
  config.friction.values = {FrictionValue::as_drawn};
  config.orientation = {.component = ComponentChoice::first, .sign = SignChoice::positive};
  config.vertical = {vertical};
  config.sampling.samples = 1;
  config.fragility = FragilityConfig{{0.01, 0.03, 0.1}};
  return config;
}

Suite one_motion(const Suite& suite) {
  Suite one = suite;
  one.motions.resize(1);
  return one;
}

Case fixed_everything(const Suite& suite) {
  const Plan plan =
      make_plan(fixed_study(2.39, 0.4, VerticalChoice::required), {one_motion(suite)});
  const Results results = run(plan);
  const Motion& m = plan.motion(0);
  const double pga = horizontal_pga_mps2(m, HorizontalCombination::geometric_mean);
  double worst = 0.0;
  for (std::size_t j = 0; j < results.levels.size(); ++j) {
    const double factor = results.levels[j] * (standard_gravity_mps2 / pga);
    const SlipResult direct = slide({m.dt_s, m.horizontal_mps2[0], m.vertical_mps2, factor, factor},
                                    {.friction = 0.4, .slope_rad = 2.39 * rad_per_deg});
    worst = worse(worst,
                  std::abs(results.histories.displacement_m(0, 0, j) - direct.peak_displacement_m) /
                      (direct.peak_displacement_m + 1e-6));
  }
  return limit({"one motion, rigid building, everything fixed, 16 levels", "peak slip",
                "slide() on the scaled motion: the scalar reference beside the kernel",
                ReferenceFrom::this_code},
               {"largest difference, relative to the slip and 1 um", worst, 1e-11});
}

Case capacity_gives_clearance(const Suite& suite) {
  const Plan plan =
      make_plan(fixed_study(2.39, 0.4, VerticalChoice::required), {one_motion(suite)});
  const Results results = run(plan);
  const Motion& m = plan.motion(0);
  double worst = 0.0;
  for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
    const double factor = results.histories.capacity(0, 0, t) * plan.factor_at_unit_level[0];
    const double slip = slide({m.dt_s, m.horizontal_mps2[0], m.vertical_mps2, factor, factor},
                              {.friction = 0.4, .slope_rad = 2.39 * rad_per_deg})
                            .peak_displacement_m;
    worst = worse(worst, std::abs(slip / results.thresholds_m[t] - 1.0));
  }
  return limit({"the same study, clearances 0.01, 0.03 and 0.1 m", "slip at the capacity",
                "the clearance; capacities are found to 1e-4", ReferenceFrom::this_code},
               {"largest relative difference", worst, 1e-3});
}

/// Flat roof, no vertical: PRD(lambda x, lambda mu) = lambda PRD(x, mu), and so capacity(lambda c;
/// lambda mu) = lambda capacity(c; mu).
std::vector<Case> similitude(const Suite& suite) {
  StudyConfig one = fixed_study(0.0, 0.25, VerticalChoice::none),
              two = fixed_study(0.0, 0.5, VerticalChoice::none);
  for (double& level : two.intensity.levels) level *= 2.0;
  for (double& threshold : two.fragility->thresholds_m) threshold *= 2.0;
  const Results a = run(make_plan(one, {suite})), b = run(make_plan(two, {suite}));
  const auto &x = a.histories.fields.peak_displacement_m,
             &y = b.histories.fields.peak_displacement_m;
  int differing = 0;
  for (std::size_t i = 0; i < x.size(); ++i) differing += y[i] == 2.0 * x[i] ? 0 : 1;
  double worst = 0.0;
  const auto &c = a.histories.fields.capacity, &d = b.histories.fields.capacity;
  for (std::size_t i = 0; i < c.size(); ++i)
    worst = worse(worst, std::abs(d[i] / (2.0 * c[i]) - 1.0));
  const auto fitted = [](const Results& r) { return r.runs[0].fragilities[1].capacities.curve; };
  const std::string
      name = "flat roof, no vertical, seven motions: friction, levels and clearances doubled",
      law = "PRD(x, mu) = x F(mu/x)";
  return {all_equal({name, "peak slips, doubled", law}, {differing, static_cast<int>(x.size())}),
          limit({name, "capacities, doubled", law + "; capacities are found to 1e-4"},
                {"largest relative difference", worst, 2e-4}),
          limit({name, "fragility median at the second clearance, doubled", law},
                {"relative difference", std::abs(fitted(b).median / (2.0 * fitted(a).median) - 1.0),
                 2e-4}),
          limit({name, "fragility log_std at the second clearance", law},
                {"difference", std::abs(fitted(b).log_std - fitted(a).log_std), 2e-4})};
}

Case suite_meets_design_spectrum(const Suite& suite) {
  StudyConfig config = fixed_study(0.0, 0.5, VerticalChoice::none);
  config.intensity.measure = IntensityMeasure::sds_g;
  const Plan plan = make_plan(config, {suite});
  Suite scaled = plan.suites.front();
  for (std::size_t i = 0; i < scaled.motions.size(); ++i)
    scaled.motions[i].scale = 1.4 * plan.factor_at_unit_level[i];
  const TargetSpectrum target(*suite.target);
  const double lift = suite_average_factor(
      scaled, [&](double t) { return 1.4 / target.sds_g() * target.design_sa_g(t); },
      walters_periods_s());
  return compare({"suite level 2 run at S_DS = 1.4 g",
                  "factor that brings the average SRSS spectrum to the design spectrum",
                  "by definition of the level", ReferenceFrom::this_code},
                 {lift, 1.0, 1e-12});
}

/// In the limit of no clearance it is reached just above the yield acceleration, mu g on a flat
/// roof: the fragility in PGA is the distribution of friction.
std::vector<Case> friction_comes_back(const Suite& suite) {
  StudyConfig config = fixed_study(0.0, 0.4, VerticalChoice::none);
  config.quantities.at("friction", "mu") = {{}, LogNormal{0.4, 0.1}};
  config.sampling.samples = 1024;
  config.fragility->thresholds_m = {1e-12};
  Suite one = one_motion(suite);
  one.motions.front().horizontal_mps2[1] = {};
  const Results results = run(make_plan(config, {one}));
  const FragilityCurve curve = results.runs[0].fragilities[0].capacities.curve;
  const std::string
      name =
          "one motion on a flat rigid roof, lognormal friction, clearance 1e-12 m, 1,024 samples",
      law = "yield acceleration mu g: the distribution of friction";
  return {compare({name, "fragility median, PGA in g", law}, {curve.median, 0.4, 1e-3}),
          compare({name, "fragility log_std", law}, {curve.log_std, 0.1, 5e-3})};
}

}  // namespace

Chapter end_to_end(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level2.toml");
  return {"9. End to end", "similitude; the distribution of friction",
          "Whole studies (plan, execute, reduce) with known results.",
          joined({{fixed_everything(suite), capacity_gives_clearance(suite)},
                  similitude(suite),
                  {suite_meets_design_spectrum(suite)},
                  friction_comes_back(suite)})};
}

}  // namespace glissade::verification
