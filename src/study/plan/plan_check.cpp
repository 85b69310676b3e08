// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>

#include "glissade/block/on_building.hpp"
#include "glissade/building/mode_rules.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/study/cases/case_scene.hpp"

namespace glissade {
namespace {

/// What the parts of a model require of each other.
void check_model(const StudyConfig& config, const std::vector<Suite>& suites,
                 ProblemList& problems) {
  const std::string file = config.file.string();
  const KernelChoice choice = cheapest_exact_kernel(config);
  if (choice.kernel != Kernel::tables && config.intensity.measure == IntensityMeasure::ppa_g) {
    problems.add(
        {file,
         "measure = \"ppa_g\" scales by the peak of a roof that the array does not move: " +
             choice.reason,
         config.intensity.of_roof ? "measure by factor or pga_g, or set [model] axes = 1"
                                  : "measure by sds_g, pga_g, sa_g or avg_sa_g, or set [model] "
                                    "axes = 1",
         ""});
  }
  if (config.intensity.target) return;
  const bool by_r = config.quantities.at("building", "response_modification").largest() > 0.0;
  const IntensityMeasure measure = config.intensity.measure;
  for (std::size_t i = 0; i < suites.size(); ++i) {
    if (suites[i].target || !(by_r || measure.is_of_design_spectrum())) continue;
    problems.add(
        {config.suite_files[i].string(),
         measure == IntensityMeasure::sds_g
             ? "has no [target], and measure = \"sds_g\" needs the shape of a design spectrum"
         : measure == IntensityMeasure::mce_fraction
             ? "has no [target], and measure = \"mce_fraction\" is in parts of its MCE: motions "
               "that are used as they are have measure = \"factor\", with levels = [1.0]"
             : "has no [target], and building.response_modification divides the "
               "elastic demand of a design spectrum",
         "give the suite a [target], or add target = { edition = \"asce7_16\", ss_g = "
         "..., s1_g = ..., site_class = \"D\" } to [intensity]",
         ""});
  }
}

/// What needs the ground, or a building below the motions.
void check_roof_motions(const StudyConfig& config, const std::vector<Suite>& suites,
                        ProblemList& problems) {
  const auto roof = std::ranges::find(suites, true, &Suite::of_roof);
  if (roof == suites.end()) return;
  const std::string where =
      config.suite_files[static_cast<std::size_t>(roof - suites.begin())].string();
  const auto refuse = [&](const std::string& what, const char* remedy) {
    problems.add({where, "has motions of a roof: " + what, remedy, ""});
  };
  if (!std::ranges::all_of(suites, &Suite::of_roof))
    refuse("the other suites of the study are of the ground", "make a study for each");
  const IntensityMeasure measure = config.intensity.measure;
  if (measure != IntensityMeasure::factor && measure != IntensityMeasure::pga_g &&
      measure != IntensityMeasure::ppa_g)
    refuse(fmt::format("measure = \"{}\" is of the ground", measure.key()),
           "measure by factor (levels = [1.0]: as they are), or by pga_g, their own peak");
  const Quantities without;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    const bool is_of_building = p.table == std::string("building") ||
                                (p.table == std::string("vertical") && p.key != std::string("use"));
    if (is_of_building && !config.quantities[i].is_always(without[i].values.front()))
      refuse(fmt::format("{}.{} is of a building below them", p.table, p.key),
             "leave it out: the building is in the motions");
  }
  for (const auto& [is_there, table] :
       {std::pair{config.base_shear, "[base_shear]"},
        {config.intensity_measures.has_value(), "[intensity_measures]"},
        {config.normalise_by_pgv, "suite.normalise"}})
    if (is_there)
      refuse(std::string(table) + " is of the ground, or of a building on it", "leave it out");
}

void check_motion(const StudyConfig& config, const Motion& motion, const std::string& where,
                  ProblemList& problems) {
  const bool has_second = !motion.horizontal_mps2[1].empty();
  const auto uses = [&](VerticalChoice use) {
    return std::ranges::find(config.vertical, use) != config.vertical.end();
  };
  if (config.two_axes() && !has_second) {
    problems.add({where,
                  "record " + motion.id +
                      " has no second horizontal component, which [model] axes = 2 needs",
                  "leave the record out ([suite] records), or set axes = 1", ""});
  } else if (config.orientation.choice == OrientationChoice::random &&
             config.orientation.component == ComponentChoice::second && !has_second) {
    problems.add({where, "record " + motion.id + " has no second horizontal component",
                  "set component = \"first\" or \"random\" in [orientation]", ""});
  } else if (config.orientation.choice == OrientationChoice::azimuths && !has_second) {
    problems.add(
        {where,
         "record " + motion.id +
             " has no second horizontal component to turn ([orientation] choice = \"azimuths\")",
         "leave the record out, or set choice = \"all_permutations\"", ""});
  }
  if (uses(VerticalChoice::required) && motion.vertical_mps2.empty()) {
    problems.add({where,
                  "record " + motion.id +
                      " has no vertical component although [vertical] use = \"required\"",
                  "set use = \"if_available\", or leave the record out", ""});
  }
  if (horizontal_pga_mps2(motion, HorizontalCombination::srss) == 0.0) {
    problems.add(
        {where, "record " + motion.id + " is zero throughout", "leave it out of the suite", ""});
  }
}

BiaxialBuilding elastic_building(const Plan& plan, Case c) {
  c.response_modification = c.yield_coefficient = 0.0;
  return biaxial_building(c, plan.config.building, nullptr);
}

bool is_regular(const Plan& plan, const Case& c) {
  if (c.mass_ratio == 0.0) return true;
  const BiaxialBuilding building = elastic_building(plan, c);
  return coupling_is_regular(block_of(c), building) &&
         (c.neighbour_friction == 0.0 || coupling_is_regular(neighbour_block(c), building));
}

double longest_step_s(const Plan& plan) {
  double step_s = 0.0;
  for (std::size_t i = 0; i < plan.records.size(); ++i)
    step_s = std::max(step_s, plan.motion(i).dt_s);
  return step_s;
}

/// Of the modes of a building of several; `least` where none is below that.
double shortest_period_s(const StudyConfig& config, const Case& c, double least) {
  const BuildingModel& model = config.building;
  const double first_s = c.period_s * (config.two_axes() ? std::min(1.0, c.period_ratio) : 1.0);
  const bool may_be_shorter = model.kind == BuildingModel::Kind::modes || first_s < least ||
                              shortest_governing_period_s < least;
  if (model.is_one_mass() || !may_be_shorter) return least;
  double shortest_s = least;
  const std::array<Modes, 2> axes = building_axes(c, model);
  for (std::size_t axis = 0; axis < (config.two_axes() ? 2 : 1); ++axis)
    for (const Mode& mode : axes[axis]) shortest_s = std::min(shortest_s, mode.period_s);
  return shortest_s;
}

std::optional<std::string> problem_of(const Plan& plan, const Case& c, double step_s) {
  constexpr double shortest_s = 0.01;
  const bool two_axes = plan.config.two_axes();
  const double shorter_s = c.period_s * (two_axes ? std::min(1.0, c.period_ratio) : 1.0);
  if (c.yields() && shorter_s < shortest_s) {
    return fmt::format(
        "a rigid building does not yield, and a building period is {:g} s: give "
        "periods of {:g} s or more, or leave out the building's strength",
        c.period_s, shortest_s);
  }
  for (const auto& [key, period_s] :
       {std::pair{"building", shorter_s}, {"vertical", c.vertical_period_s}})
    if (period_s > 0.0 && period_s < shortest_s)
      return fmt::format(
          "{}.period_s of {:.3g} s: what has a period below {:g} s moves with the ground; give 0",
          key, period_s, shortest_s);
  if (const std::string text =
          unresolved_mode(shortest_period_s(plan.config, c, 2.0 * step_s), step_s);
      !text.empty())
    return fmt::format(
        "building.period_s of {:.3g} s: {}: leave that mode out, or take records of "
        "shorter steps",
        c.period_s, text);
  if (two_axes && !(c.friction > 0.0 && c.friction_across > 0.0)) {
    return fmt::format(
        "friction.mu is {:g} along the slope and {:g} across, and must be above 0 on two axes: of "
        "friction that is drawn the design value is mean - 2 std, and 0 where that is below 0; "
        "give a larger mean or a smaller std",
        c.friction, c.friction_across);
  }
  if (plan.kernel.kernel != Kernel::tables && !is_regular(plan, c)) {
    const Modes axis = elastic_building(plan, c).horizontal[0];
    return fmt::format(
        "with mu = {:.3g}, a slope of {:.3g} degrees and a mass ratio of {:.3g}{} "
        "friction locks the array against the roof it moves, and the coupled "
        "equations have no solution: take a smaller mass ratio, friction or slope",
        c.friction, c.slope_deg, c.mass_ratio,
        axis.is_one_mass() ? ""
                           : fmt::format(" ({:.3g} at the array, by the modes)",
                                         c.mass_ratio * axis.accelerance()));
  }
  return std::nullopt;
}

double longest_period_s(const Plan& plan) {
  double longest_s = 0.0;
  for (const Case& c : plan.cases.all())
    longest_s = std::max(longest_s, c.period_s * std::max(1.0, c.period_ratio));
  return longest_s;
}

/// On each motion of a suite at MCE.
std::vector<double> mce_factors(const Plan& plan, std::size_t suite, double sds_g) {
  std::vector<double> factors;
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    if (plan.records[record].suite != suite) continue;
    factors.push_back(plan.config.intensity.measure == IntensityMeasure::sds_g
                          ? plan.factor_at_unit_level[record] * mce_over_dbe * sds_g
                          : plan.motion(record).scale);
  }
  return factors;
}

}  // namespace

bool gives_clearance(const Plan& plan) {
  return plan.config.clearance || (plan.config.chart && plan.records.size() > 1 &&
                                   plan.config.intensity.measure.is_of_design_spectrum());
}

FirstPeriods first_periods(const StudyConfig& config) {
  FirstPeriods periods{std::numeric_limits<double>::infinity(), 0.0,
                       config.intensity.to_one_and_a_half};
  const auto take = [&](double period_s) {
    periods.shortest_s = std::min(periods.shortest_s, period_s);
    periods.longest_s = std::max(periods.longest_s, period_s);
  };
  const PlannedCases cases(config);
  for (const Case& c : cases.all()) {
    if (config.building.kind == BuildingModel::Kind::modes) {
      for (const Modes& axis : building_axes(c, config.building)) take(axis.period_s());
    } else {
      take(c.period_s);
      if (config.two_axes()) take(c.period_s * c.period_ratio);
    }
  }
  if (!(periods.shortest_s > 0.0))
    throw InputError({config.file.string(),
                      fmt::format("intensity.scaling_rule = \"{}\" is of the building's first "
                                  "periods, and a building is rigid (period_s = 0)",
                                  text_of(config.intensity.scaling_rule).key),
                      "give periods above 0, or scaling_rule = \"walters_2012\"", ""});
  return periods;
}

namespace {

/// Of a suite that its file scales.
std::optional<MissedTarget> missed_rule(const Plan& plan, std::size_t suite,
                                        const std::vector<double>& factors,
                                        const std::function<double(double)>& mce_g) {
  constexpr double rounding = 1e-3;  // of factors in the file
  const ScalingRule rule = plan.config.intensity.scaling_rule;
  SpectraByRule spectra{periods_by_rule_s(rule, plan.first_periods), {}};
  for (const Motion& motion : plan.suites[suite].motions)
    spectra.rows_g.push_back(spectrum_by_rule_g(motion, rule, spectra.periods_s));
  const RuleRatios ratios = ratios_by_rule(spectra, factors, mce_g);
  const double missing = missing_factor(rule, ratios);
  if (missing <= 1.0 + rounding) return {};
  const ScalingRuleText& text = text_of(rule);
  const PeriodRange range = period_range(rule, plan.first_periods);
  return MissedTarget{fmt::format("from {:.3g} to {:.3g} s the suite's average {} spectrum is at "
                                  "least {:.3g} times its MCE target (at {:.3g} s), on average "
                                  "{:.3g} times; {} wants its {}",
                                  range.from_s, range.to_s, text.combination, ratios.lowest.ratio,
                                  ratios.lowest.period_s, ratios.mean, text.clause, text.spectrum),
                      fmt::format("multiply the suite's scales by {:.4g}, measure by sds_g, which "
                                  "scales it",
                                  missing)};
}

}  // namespace

std::optional<MissedTarget> missed_target(const Plan& plan, std::size_t suite) {
  if (plan.suites[suite].of_roof) return {};  // they are what was designed for
  const bool by_sds = plan.config.intensity.measure == IntensityMeasure::sds_g;
  if (!plan.config.intensity.measure.is_of_design_spectrum())
    return MissedTarget{"levels of " + std::string(plan.config.intensity.measure.key()) +
                            (plan.config.intensity.measure == IntensityMeasure::factor
                                 ? " multiply the motions as given, "
                                 : " scale each record by itself, ") +
                            "not the suite to a design spectrum",
                        "measure by sds_g, which scales the suite, or by mce_fraction"};
  const DesignTarget* target = plan.target_of(suite);
  if (target == nullptr)
    return MissedTarget{"the suite has no [target] that it could meet",
                        "give the suite its [target], or the study intensity.target"};
  const TargetSpectrum spectrum(*target);
  const std::vector<double> factors = mce_factors(plan, suite, spectrum.sds_g());
  const auto mce_g = [&](double period_s) { return spectrum.mce_sa_g(period_s); };
  if (plan.config.intensity.scaling_rule != ScalingRule::walters_2012)
    return by_sds ? std::nullopt : missed_rule(plan, suite, factors, mce_g);
  if (!by_sds) {
    const SpectralRatio lowest = ratios_to_target(plan.suites[suite], factors, mce_g).lowest;
    if (lowest.ratio < least_over_target)
      return MissedTarget{
          fmt::format("the suite's average SRSS spectrum is {:.3g} times its MCE target at {:.3g} "
                      "s; from 0 to 2 s it must be {:g} times or more",
                      lowest.ratio, lowest.period_s, least_over_target),
          fmt::format("multiply the suite's scales by {:.4g}, measure by sds_g, which scales it",
                      1.0 / lowest.ratio)};
  }
  // Walters's rule ends at 2 s, and is of buildings to 2 s.
  const double longest_s = longest_period_s(plan), to_s = judged_to_s(longest_s);
  if (to_s <= longest_scaled_period_s || !gives_clearance(plan)) return {};
  const SpectralRatio lowest =
      lowest_ratio_to_target(plan.suites[suite], factors, mce_g, periods_beyond_scaled_s(to_s));
  constexpr double rounding = 1e-12;
  if (lowest.ratio >= least_over_target_beyond * (1.0 - rounding)) return {};
  const double missing = least_over_target_beyond / lowest.ratio;
  return MissedTarget{
      fmt::format("the suite's average SRSS spectrum is {:.3g} times its target at {:.3g} s; "
                  "for a building period of {:g} s it must be {:g} times or more from {:g} s to "
                  "{:g} s, 1.5 times that period",
                  lowest.ratio, lowest.period_s, longest_s, least_over_target_beyond,
                  longest_scaled_period_s, to_s),
      to_s > longest_possible_scaled_s
          ? "check the period: no building has such a one"
          : "take records that reach it (`glissade suite select`), " +
                (by_sds ? fmt::format(
                              "set intensity.scaled_to_s = {:g}, which multiplies all by {:.4g}",
                              to_s, missing)
                        : fmt::format("multiply the suite's scales by {:.4g}", missing)),
      // Walters et al. (2012) scale to 2 s for buildings of up to 2 s.
      longest_s > longest_scaled_period_s};
}

std::vector<std::string> copied_records(const Plan& plan, std::optional<std::size_t> suite) {
  std::map<double, std::vector<std::string>> ids;
  for (std::size_t i = 0; i < plan.records.size(); ++i) {
    if (!suite || plan.records[i].suite == *suite)
      ids[arias_intensity_mps(plan.motion(i))].push_back(plan.motion(i).id);
  }
  std::vector<std::string> sentences;
  for (const auto& [arias_mps, same] : ids) {
    if (same.size() > 1)
      sentences.push_back(fmt::format("records {} are the same motion: it counts {} times",
                                      fmt::join(same, ", "), same.size()));
  }
  return sentences;
}

void check_clearance(const Plan& plan) {
  if (!gives_clearance(plan)) return;
  ProblemList copies;
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite) {
    for (const std::string& sentence : copied_records(plan, suite))
      copies.add({plan.config.suite_files[suite].string(), sentence,
                  "keep one of them: mean, percentiles and intervals are of different records",
                  ""});
  }
  copies.throw_if_any();
  if (plan.config.is_without_target()) return;
  const std::string table = plan.config.clearance ? "clearance" : "chart";
  ProblemList problems;
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite) {
    const auto found = missed_target(plan, suite);
    if (!found || !found->is_refused) continue;
    problems.add({plan.config.suite_files[suite].string(),
                  fmt::format("[{}]: {}", table, found->what),
                  fmt::format("{}, or set {}.without_target = true, which every output states",
                              found->remedy, table),
                  ""});
  }
  problems.throw_if_any();
}

void check_fit(const StudyConfig& config, const std::vector<Suite>& suites) {
  ProblemList problems;
  check_roof_motions(config, suites, problems);
  problems.throw_if_any();
  check_model(config, suites, problems);
  std::vector<std::string> events;
  for (const Suite& suite : suites)
    for (const Motion& motion : suite.motions) events.push_back(motion.event);
  const std::size_t units = unit_count(event_units(events), events.size());
  for_each_analysis(Analyses(), [&](auto analysis) {
    if constexpr (requires { analysis.check(config, units, problems); })
      analysis.check(config, units, problems);
  });
  for (std::size_t i = 0; i < suites.size(); ++i) {
    const std::string where = config.suite_files[i].string();
    if (suites[i].motions.empty())
      problems.add({where, "the suite has no motions", "add at least one record", ""});
    for (const Motion& motion : suites[i].motions) check_motion(config, motion, where, problems);
  }
  problems.throw_if_any();
}

void check_factors(const Plan& plan) {
  const IntensityConfig& intensity = plan.config.intensity;
  const double highest = intensity.measure.factor_of_level(intensity.levels.back());
  ProblemList problems;
  for (std::size_t i = 0; i < plan.records.size(); ++i) {
    const double factor = highest * plan.factor_at_unit_level[i];
    if (factor <= largest_acceleration) continue;
    problems.add({plan.config.suite_files[plan.records[i].suite].string(),
                  fmt::format("record {} would be multiplied by {:.3g} at the highest level",
                              plan.motion(i).id, factor),
                  "give lower levels, or leave the record out ([suite] records)", ""});
  }
  problems.throw_if_any();
}

void check_cases(const Plan& plan) {
  const double step_s = longest_step_s(plan);
  for (const Case& c : plan.cases.all()) {
    if (const auto problem = problem_of(plan, c, step_s))
      throw InputError({plan.config.file.string(), *problem, "", ""});
  }
}

}  // namespace glissade
