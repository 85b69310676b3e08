// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/plan_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/units.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/sampling/pull_test.hpp"
#include "glissade/study/cases/probable.hpp"
#include "glissade/study/plan/one_mass.hpp"
#include "plan/plan_check.hpp"
#include "words/plan_notes.hpp"

namespace glissade {
namespace {

using Warnings = std::vector<std::string>;

Warnings one_axis(const Plan& plan) {
  if (plan.config.two_axes()) return {};
  return {
      "the array slides along one axis only (model.axes = 1): under both horizontal components "
      "it slides farther"};
}

/// Keys whose absence gives less displacement than most roofs have. Stated as 0 they are meant.
Warnings not_stated(const Plan& plan) {
  const Quantities& q = plan.config.quantities;
  const auto is_left_out = [&](const char* table, const char* key) {
    return !q.at(table, key).is_stated && q.at(table, key).is_always(0.0);
  };
  Warnings warnings;
  if (is_left_out("building", "period_s") && !plan.suites.front().of_roof)
    warnings.emplace_back(
        "building.period_s is not stated: the building is taken as rigid; on a flexible one the "
        "array slides farther. Give the period, period_s = 0 for a rigid building, or in the suite "
        "motions = \"roof\" where the motions are those of a roof");
  if (is_left_out("roof", "slope_deg"))
    warnings.emplace_back(
        "roof.slope_deg is not stated: the roof is taken as flat; on a slope the array slides "
        "farther. Give the slope, or slope_deg = 0 for a flat roof");
  if (is_left_out("building", "mass_ratio") && plan.config.base_shear)
    warnings.emplace_back(
        "building.mass_ratio is not stated: the array has no mass, and the base shear is that of "
        "the building alone. Give the ratio, or mass_ratio = 0");
  return warnings;
}

/// Of a building that may have several storeys.
Warnings one_mass(const Plan& plan) {
  const double longest_s = plan.config.quantities.at("building", "period_s").largest();
  std::string text = longest_s > longest_one_mass_period_s ? one_mass_text(plan.config) : "";
  if (text.empty()) return {};
  return {text + ". Give building.storeys (1: it has one), alpha or modes"};
}

/// The factor on a record at level 1; 0 where it is not known before the roofs are computed.
double factor_at_unit_level(const Plan& plan, std::size_t record) {
  const bool is_rigid = plan.config.quantities.at("building", "period_s").is_always(0.0);
  if (plan.config.intensity.measure != IntensityMeasure::ppa_g || !is_rigid)
    return plan.factor_at_unit_level[record];
  double peak_mps2 = 0.0;  // of the stronger component: of the other the factor is larger
  for (const auto& component : plan.motion(record).horizontal_mps2)
    for (const double a : component) peak_mps2 = std::max(peak_mps2, std::abs(a));
  return peak_mps2 > 0.0 ? standard_gravity_mps2 / peak_mps2 : 0.0;
}

/// Records that are far from the strength to which they are scaled.
Warnings scaled_records(const Plan& plan) {
  constexpr std::size_t most_named = 5;
  const IntensityConfig& intensity = plan.config.intensity;
  const auto in_unit = [&](double level) {
    const std::string unit = intensity.measure.unit();
    return fmt::format("{:.4g}{}", level, unit == "-" ? "" : " " + unit);
  };
  std::vector<std::pair<double, std::string>> scaled;  // by the largest factor
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    const auto factor = [&, unit = factor_at_unit_level(plan, record)](double level) {
      return unit * intensity.measure.factor_of_level(level);
    };
    const std::span<const double> levels = plan.levels_of(record);
    const auto first = std::ranges::find_if(
        levels, [&](double level) { return factor(level) > most_probable_factor; });
    if (first == levels.end()) continue;
    const double largest = factor(levels.back());
    scaled.emplace_back(-largest,
                        fmt::format("{} {:.3g} times at {}{}", plan.motion(record).id, largest,
                                    in_unit(levels.back()),
                                    *first < levels.back() ? ", from " + in_unit(*first) : ""));
  }
  if (scaled.empty()) return {};
  std::ranges::stable_sort(scaled, {}, &std::pair<double, std::string>::first);
  std::string named;
  for (std::size_t i = 0; i < std::min(most_named, scaled.size()); ++i)
    named += (i > 0 ? "; " : "") + scaled[i].second;
  if (scaled.size() > most_named) named += fmt::format("; and {} more", scaled.size() - most_named);
  return {fmt::format(
      "scaled by more than {:g}, the limit of Baker & Lee (2018): {} of {}: {}. A weak motion "
      "scaled so far has another spectrum and duration than a strong one: take stronger records, "
      "or lower levels",
      most_probable_factor, scaled.size(), counted(plan.records.size(), "record"), named)};
}

Warnings without_target(const Plan& plan) {
  if (!plan.config.is_without_target()) return {};
  return {
      "NOT FOR DESIGN: the clearance is of a suite that need not meet a design spectrum "
      "(without_target = true)"};
}

Warnings strong_levels(const Plan& plan) {
  const IntensityConfig& intensity = plan.config.intensity;
  const double highest = intensity.levels.back();
  const std::string unit = intensity.measure.unit();
  const double most = unit == "g"                                           ? most_probable_g
                      : intensity.measure == IntensityMeasure::mce_fraction ? 5.0
                      : intensity.measure.key() == std::string("pgv_mps")   ? 4.0
                                                                            : highest;
  if (highest <= most) return {};
  return {fmt::format("the highest level, {} of {:g}{}, is above {:g}: no site is known for it",
                      intensity.measure.key(), highest, unit == "-" ? "" : " " + unit, most)};
}

/// Levels in parts of the MCE are of a suite that meets it.
Warnings missed_targets(const Plan& plan) {
  const bool clearance = gives_clearance(plan);
  const bool is_concerned = clearance
                                ? !plan.config.is_without_target()
                                : plan.config.intensity.measure == IntensityMeasure::mce_fraction;
  if (!is_concerned) return {};
  Warnings warnings;
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite) {
    if (const auto found = missed_target(plan, suite))
      warnings.push_back(clearance ? found->what + ": " + found->remedy
                                   : "level 1 is not the MCE: " + found->what);
  }
  return warnings;
}

/// Of the rule by which suites are scaled, or are to be.
Warnings few_for_rule(const Plan& plan) {
  if (!plan.config.intensity.measure.is_of_design_spectrum()) return {};
  Warnings warnings;
  for (const Suite& suite : plan.suites)
    for (const std::string& warning :
         too_few_for(plan.config.intensity.scaling_rule, suite.motions.size()))
      warnings.push_back(suite.name + ": " + warning);
  return warnings;
}

/// Of the targets, each once.
Warnings target_values(const Plan& plan) {
  Warnings warnings;
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite) {
    const DesignTarget* target = plan.target_of(suite);
    if (target == nullptr) continue;
    for (std::string& warning : improbable_values(*target)) {
      if (std::ranges::find(warnings, warning) == warnings.end())
        warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

Warnings improbable_periods(const Plan& plan) {
  PeriodsByAxis periods;
  for (const Case& c : plan.cases.all()) periods.take(c);
  return improbable_building(plan.config.building, periods, plan.config.two_axes());
}

/// By the least and the largest value of each parameter.
Warnings improbable_parameters(const Plan& plan) {
  const std::span<const Parameter> all = parameters();
  std::vector<std::pair<double, double>> ends(all.size(), {infinity, -infinity});
  bool is_rigid = true;
  for (const Case& c : plan.cases.all()) {
    is_rigid &= c.period_s == 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double value = value_of(all[i], c);
      if (value == value_of(all[i], Case())) continue;
      ends[i] = {std::min(ends[i].first, value), std::max(ends[i].second, value)};
    }
  }
  Warnings warnings;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [least, most] = ends[i];
    if (least > most || (is_rigid && all[i].table == std::string("building"))) continue;
    if (std::string text = improbable_value(all[i], most); !text.empty())
      warnings.push_back(std::move(text));
    if (std::string text = improbable_value(all[i], least); least < most && !text.empty())
      warnings.push_back(std::move(text));
  }
  return warnings;
}

Warnings improbable_buildings(const Plan& plan) {
  double steepest_deg = 0.0;
  for (const Case& c : plan.cases.all())
    steepest_deg = std::max(steepest_deg, std::abs(c.slope_deg));
  Warnings warnings;
  for (const std::string& text :
       {improbable_slope(steepest_deg), unmarked_numbers(plan.config.unmarked_numbers)})
    if (!text.empty()) warnings.push_back(text);
  return warnings;
}

/// A clearance and a chart are of the worst period, which may lie between those that are listed.
Warnings period_gaps(const Plan& plan) {
  const Quantity& periods = plan.config.quantities.at("building", "period_s");
  if (!(plan.config.clearance || plan.config.chart) || periods.is_drawn()) return {};
  const std::string gaps = gaps_between(periods.values);
  return gaps.empty() ? Warnings() : Warnings{gaps};
}

Warnings low_friction(const Plan& plan) {
  for (const char* key : {"mu", "across_mu"}) {
    const Quantity& mu = plan.config.quantities.at("friction", key);
    if (mu.is_drawn() && design_friction(*mu.drawn) <= 0.0)
      return {fmt::format("the design value of friction.{}, mean - 2 std, is not above 0", key)};
  }
  return {};
}

/// Of what is drawn the mean, as a tail may be wide.
Warnings high_friction(const Plan& plan) {
  for (const char* key : {"mu", "across_mu"}) {
    const Quantity& mu = plan.config.quantities.at("friction", key);
    const double largest = mu.is_drawn() ? mean(*mu.drawn) : mu.largest();
    if (std::string text = improbable_friction(fmt::format("friction.{}", key), largest);
        !text.empty())
      return {std::move(text)};
  }
  return {};
}

Warnings free_sliding(const Plan& plan) {
  const auto free = std::ranges::count_if(plan.cases.all(), slides_freely);
  if (free == 0 || plan.config.rare) return {};  // of wider distributions it is no share
  return {fmt::format(
      "{:.3g} % of the cases slide without an earthquake: tan(slope) is friction or more",
      100.0 * static_cast<double>(free) / static_cast<double>(plan.cases.size()))};
}

/// Each counts as a record of its own in means and intervals; of multiple stripes those of one.
Warnings same_motions(const Plan& plan) {
  if (!plan.config.by_stripes) return copied_records(plan);
  Warnings warnings;
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite)
    std::ranges::move(copied_records(plan, suite), std::back_inserter(warnings));
  return warnings;
}

/// A stripe whose file scales its records to another level than the one at which they are run.
Warnings other_stripes(const Plan& plan) {
  constexpr double most_apart = 1.25;
  if (!plan.config.by_stripes) return {};
  Warnings warnings;
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite) {
    std::vector<double> ratios;
    bool is_scaled = false;
    for (std::size_t record = 0; record < plan.records.size(); ++record) {
      const double factor = plan.factor_at_unit_level[record], scale = plan.motion(record).scale;
      if (plan.records[record].suite != suite || factor == 0.0) continue;
      is_scaled |= scale != 1.0;
      ratios.push_back(
          factor * plan.config.intensity.measure.factor_of_level(plan.levels_of(record).front()) /
          scale);
    }
    if (!is_scaled) continue;
    const double ratio = quantile_of(std::move(ratios), 0.5);
    if (ratio <= most_apart && ratio >= 1.0 / most_apart) continue;
    warnings.push_back(fmt::format(
        "the suite {} is run at the level {:g}, {:.3g} times what its file scales it to: its "
        "records were selected for another level",
        plan.suites[suite].name, plan.config.intensity.levels[suite], ratio));
  }
  return warnings;
}

/// The target of the study replaces it.
Warnings other_targets(const Plan& plan) {
  Warnings warnings;
  for (const Suite& suite : plan.suites) {
    const auto& target = plan.config.intensity.target;
    if (target && suite.target && to_string(*target) != to_string(*suite.target))
      warnings.push_back(fmt::format("the suite {} is made for {}; it is used for {}", suite.name,
                                     to_string(*suite.target), to_string(*target)));
  }
  return warnings;
}

Warnings motions(const Plan& plan) {
  constexpr std::size_t most_named = 5;
  Warnings warnings;
  std::size_t more = 0;
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    const Motion& motion = plan.motion(record);
    for (const std::string& value : improbable_values(motion, plan.suites.front().of_roof)) {
      if (warnings.size() < most_named)
        warnings.push_back(fmt::format("record {}: {}", motion.id, value));
      else
        ++more;
    }
  }
  if (more > 0)
    warnings.push_back(
        fmt::format("and {} more of this kind: `glissade suite show` names all", more));
  return warnings;
}

/// Records whose event is not known, beside others: they may be of one.
Warnings missing_events(const Plan& plan) {
  const std::vector<std::string> events = events_of(plan);
  std::vector<std::string> ids;
  for (std::size_t record = 0; record < events.size(); ++record)
    if (events[record].empty()) ids.push_back(plan.motion(record).id);
  if (ids.empty() || ids.size() == events.size()) return {};
  constexpr std::size_t most = 5;
  const std::size_t more = ids.size() - std::min(most, ids.size());
  ids.resize(ids.size() - more);
  return {fmt::format(
      "the suites state events, but not of {} ({}{}): each of these counts as an event of its own, "
      "and intervals are too narrow if it is not. State `event` of each record",
      counted(ids.size() + more, "record"), fmt::join(ids, ", "),
      more > 0 ? fmt::format(" and {} more", more) : "")};
}

/// Of analyses that give probabilities: they need the scatter between records, which is less in a
/// suite of those nearest to a target.
Warnings nearest_records(const Plan& plan) {
  Warnings warnings;
  if (!plan.config.fragility && !plan.config.rare && !plan.config.verdict) return warnings;
  for (const Suite& suite : plan.suites) {
    if (suite.nearest_to_target)
      warnings.push_back(fmt::format(
          "the records of the suite {} were selected as the nearest to a target spectrum: they "
          "scatter less than recorded motions, so that small probabilities are too small, and the "
          "log standard deviation and all intervals too narrow. Remedy: records of a conditional "
          "spectrum (glissade suite select --sa-g), with a suite for each level (suite.stripes)",
          suite.name));
  }
  return warnings;
}

/// A roof has its own axes. Components that are swapped or mirrored are those of a slope along
/// either axis, in either direction; turned to other azimuths they are of no slope along an axis.
Warnings turned_roofs(const Plan& plan) {
  if (!plan.suites.front().of_roof || plan.config.orientation.choice != OrientationChoice::azimuths)
    return {};
  return {
      "the motions are of a roof, along the axes of its building, and [orientation] turns them: "
      "choice = \"as_recorded\" keeps them, \"all_permutations\" is of slopes along both axes"};
}

}  // namespace

std::vector<std::string> warnings_on(const Plan& plan) {
  std::vector<std::string> warnings;
  for (const auto warning : {without_target,
                             not_stated,
                             one_mass,
                             one_axis,
                             strong_levels,
                             scaled_records,
                             missed_targets,
                             few_for_rule,
                             target_values,
                             improbable_periods,
                             improbable_parameters,
                             improbable_buildings,
                             period_gaps,
                             low_friction,
                             high_friction,
                             free_sliding,
                             other_targets,
                             same_motions,
                             other_stripes,
                             motions,
                             missing_events,
                             nearest_records,
                             turned_roofs}) {
    for (std::string& text : warning(plan)) warnings.push_back(std::move(text));
  }
  for_each_analysis(Analyses(), [&](auto analysis) {
    if constexpr (requires { analysis.plan_warnings(plan); })
      std::ranges::move(analysis.plan_warnings(plan), std::back_inserter(warnings));
  });
  return warnings;
}

}  // namespace glissade
