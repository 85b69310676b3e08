// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan/plan.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <span>

#include "glissade/core/contract.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/core/mathematics.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/study/plan/history_cost.hpp"
#include "glissade/study/run/history_table.hpp"
#include "plan/keep_records.hpp"
#include "plan/plan_check.hpp"
#include "words/plan_notes.hpp"
#include "words/plan_warnings.hpp"

namespace glissade {
namespace {

std::size_t block_of(const Plan& plan, std::size_t i) {
  return plan.cases.block(i, plan.config.sampling.blocks_in_turn());
}

/// Numbers the distinct roofs in the order in which they come, block by block of the samples, so
/// that more blocks change nothing in the first ones. A record's are kept where that saves roofs
/// and takes no more memory than a hundred tables.
void number_buildings(Plan& plan) {
  constexpr std::size_t most_kept = 128;
  const std::vector<CaseNumber> first = first_with_same_key(plan.cases.size(), [&](CaseNumber i) {
    const Case c = plan.cases[i];
    const bool mixed = !c.orientation.is_quarter_turn();
    std::vector<double> key{mixed ? c.orientation.ground_azimuth_deg : -1.0,
                            mixed ? 0.0 : along_axis(c.orientation, 0).component,
                            static_cast<double>(c.vertical), static_cast<double>(c.support)};
    for (const Parameter& p : parameters())
      if (p.moves_roof()) key.push_back(value_of(p, c));
    return key;
  });
  std::vector<CaseNumber> order(plan.cases.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return block_of(plan, i); });
  constexpr CaseNumber none = std::numeric_limits<CaseNumber>::max();
  std::vector<CaseNumber> building(plan.cases.size(), none);
  CaseNumber buildings = 0;
  for (const CaseNumber i : order) {
    // The first by number need not be the first by block.
    if (building[first[i]] == none) building[first[i]] = buildings++;
    building[i] = building[first[i]];
  }
  std::erase_if(order, [&](std::size_t i) { return plan.same_as[i] != i; });
  std::ranges::stable_sort(
      order, {}, [&](std::size_t i) { return std::pair(block_of(plan, i), building[i]); });
  plan.order = std::move(order);
  plan.building = std::move(building);
  list_by_building(plan, buildings);
  plan.roofs_are_kept =
      buildings <= most_kept && (buildings <= 2 || buildings <= plan.order.size() / 2);
  std::vector<double> frictions;
  for (const std::size_t i : plan.order) frictions.push_back(plan.cases[i].friction);
  std::ranges::sort(frictions);
  frictions.erase(std::ranges::unique(frictions).begin(), frictions.end());
  plan.frictions_repeat = 2 * frictions.size() <= plan.order.size();
}

/// Predicted microseconds of a case of each record, on the mean and on the dearest building.
std::vector<HistoryCost> record_costs(const Plan& plan) {
  // Of two arrays: both are run again by the reference scheme, 2 to 3 ms each.
  const double both_arrays_us = plan.config.has_neighbours() ? 5000.0 : 0.0;
  const StudyConfig& config = plan.config;
  constexpr double histories_of_search = 4.0;  // of one capacity, on average
  const double searched =
      config.by_stripes ? 0.0
                        : histories_of_search * static_cast<double>(config.thresholds_m().size());
  std::map<double, HistoryCost> by_step;
  std::vector<HistoryCost> costs;
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    const Motion& motion = plan.motion(record);
    const auto [of_step, is_new] = by_step.try_emplace(motion.dt_s);
    if (is_new) of_step->second = history_cost(plan.kernel.kernel, config, motion.dt_s);
    const double histories = static_cast<double>(motion.horizontal_mps2[0].size()) / 8000.0 *
                             (static_cast<double>(plan.levels_of(record).size()) + searched);
    costs.push_back({(of_step->second.mean_us + both_arrays_us) * histories,
                     (of_step->second.largest_us + both_arrays_us) * histories});
  }
  return costs;
}

double total_us(const Plan& plan, std::span<const HistoryCost> costs) {
  double us = 0.0;
  for (const HistoryCost& of_record : costs)
    us += of_record.mean_us * static_cast<double>(plan.order.size());
  return us;
}

/// Units of even predicted cost: some hundreds where the study (or a block of its samples) has that
/// many cases, so that many ranks share even a small one, none so small that its message and its
/// roofs cost more, and none so large that a run which is killed loses, or one that is stopped
/// takes, more than half a second.
void cut_units(Plan& plan) {
  constexpr double least_us = 1e3, most_us = 5e5;
  constexpr std::size_t roofs_at_once = 16;
  const std::size_t blocks = plan.config.sampling.blocks_in_turn().count;
  const bool makes_roofs = plan.kernel.kernel == Kernel::tables && !plan.roofs_are_kept;
  const std::vector<HistoryCost> costs = record_costs(plan);
  const double unit_us = std::clamp(
      total_us(plan, costs) / (units_wanted(plan.kernel.kernel) * static_cast<double>(blocks)),
      least_us, most_us);
  std::vector<WorkUnit> units;
  std::size_t begin = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    std::size_t end = begin;
    while (end < plan.order.size() && block_of(plan, plan.order[end]) == block) ++end;
    for (std::size_t record = 0; record < plan.records.size(); ++record) {
      const auto& [mean_us, largest_us] = costs[record];
      const double cases =
          std::max(1.0, std::min(std::round(unit_us / mean_us), std::floor(most_us / largest_us)));
      std::size_t count = static_cast<std::size_t>(
          std::min(cases, static_cast<double>(std::max<std::size_t>(1, plan.order.size()))));
      if (makes_roofs) count = (count + roofs_at_once - 1) / roofs_at_once * roofs_at_once;
      for (std::size_t first = begin; first < end; first += count)
        units.push_back({record, first, std::min(count, end - first)});
    }
    plan.unit_ends.push_back(units.size());
    begin = end;
  }
  plan.units = std::move(units);
}

/// The factor on each record at level 1.
void scale_suites(Plan& plan, std::vector<std::vector<double>> spectra_g) {
  const IntensityConfig& intensity = plan.config.intensity;
  plan.scaling_spectra.resize(plan.suites.size());
  for (std::size_t i = 0; i < spectra_g.size(); ++i) {
    SpectraByRule& of_suite = plan.scaling_spectra[plan.records[i].suite];
    of_suite.rows_g.push_back(std::move(spectra_g[i]));
    if (of_suite.periods_s.empty())
      of_suite.periods_s = periods_by_rule_s(intensity.scaling_rule, plan.first_periods);
  }
  for (std::size_t s = 0; s < plan.suites.size(); ++s) {
    const std::vector<double> factors =
        intensity.measure.factors_at_unit_level(intensity, plan.suites[s], plan.scaling_spectra[s]);
    plan.factor_at_unit_level.insert(plan.factor_at_unit_level.end(), factors.begin(),
                                     factors.end());
  }
}

void hash_target(Hasher& hasher, const std::optional<DesignTarget>& target) {
  if (!target) return;
  hasher.text("target").number(static_cast<double>(target->edition)).number(target->ss_g);
  hasher.number(target->s1_g).number(target->tl_s);
  for (const auto site_class : target->site_classes) hasher.number(static_cast<double>(site_class));
  if (!target->is_mapped()) {
    hasher.number(target->sds_g).number(target->sd1_g);
    hasher.numbers(target->period_s).numbers(target->design_sa_g);
  }
}

/// What rests on the cases.
void list_cases(Plan& plan) {
  plan.cases.store_draws();  // until the plan is made
  check_cases(plan);
  plan.same_as = same_as(plan.cases, std::cref(plan.cases), plan.config.two_axes(),
                         plan.config.sampling.blocks_in_turn());
  number_buildings(plan);
  check_clearance(plan);
  plan.warnings = warnings_on(plan);
  plan.notes = notes_on(plan);
  plan.warnings_of_run = plan.warnings.size();
  plan.notes_of_run = plan.notes.size();
  const Remarks of_analyses = remarks_on_analyses(plan);
  std::ranges::move(texts_of(of_analyses.warnings), std::back_inserter(plan.warnings));
  std::ranges::copy(of_analyses.notes, std::back_inserter(plan.notes));
  plan.skips = skips_of(plan);
}

/// With what the results say of a suite and its motions.
void hash_suite(Hasher& hasher, const Suite& suite) {
  hasher.text(suite.name).text(suite.description);
  hasher.number(static_cast<double>(suite.nearest_to_target));
  if (suite.of_roof) hasher.text("of_roof");
  hash_target(hasher, suite.target);
}

void hash_motion(Hasher& hasher, const Motion& motion) {
  hasher.text(motion.id).text(motion.event).text(motion.station);
  hasher.number(motion.magnitude).number(motion.distance_km).number(motion.vs30_mps);
  hasher.number(motion.scale).number(motion.dt_s);
  for (const auto& component : motion.horizontal_mps2) hasher.numbers(component);
  hasher.numbers(motion.vertical_mps2);
  for (const std::string& text : motion.contradictions) hasher.text(text);
  for (const std::string& text : motion.processing) hasher.text(text);
}

void hash_case(Hasher& hasher, const Case& c) {
  for (const Parameter& p : parameters()) hasher.number(value_of(p, c));
  hasher.number(static_cast<double>(c.support)).number(static_cast<double>(c.vertical));
  hasher.number(c.orientation.ground_azimuth_deg);
  hasher.number(static_cast<double>(c.orientation.across_sign));
}

std::string hash_of(const Plan& plan) {
  Hasher hasher;
  hasher.text("glissade plan 7").text(plan.config.hashed_text).numbers(plan.factor_at_unit_level);
  const auto& own = plan.config.intensity.target;
  if (own && !own->is_mapped()) hash_target(hasher, own);  // else it is in the study's text
  if (plan.config.hazard) {
    for (const HazardPoint& p : plan.config.hazard->curve.points())
      hasher.number(p.intensity).number(p.annual_rate);
  }
  for (const Suite& suite : plan.suites) {
    hash_suite(hasher, suite);
    for (const Motion& motion : suite.motions) hash_motion(hasher, motion);
  }
  for (const Case& c : plan.cases.all()) hash_case(hasher, c);
  return to_hex(hasher.value());
}

std::string motions_text(const Plan& plan) {
  std::string text;
  for (std::size_t s = 0; s < plan.suites.size(); ++s) {
    const std::string file = plan.config.suite_files[s].filename().string();
    Hasher suite;
    hash_suite(suite, plan.suites[s]);
    text += file + ", name, description and target " + to_hex(suite.value()) + "\n";
    for (const Motion& motion : plan.suites[s].motions) {
      Hasher hasher;
      hash_motion(hasher, motion);
      text += file + ", motion " + motion.id + " " + to_hex(hasher.value()) + "\n";
    }
  }
  return text;
}

}  // namespace

void list_by_building(PlanLists& lists, std::size_t buildings) {
  std::vector<CaseNumber> by_building = lists.order.copy(), first_on(buildings + 1, 0);
  std::ranges::stable_sort(by_building, {}, [&](std::size_t i) { return lists.building[i]; });
  for (const std::size_t i : lists.order) ++first_on[lists.building[i] + 1];
  std::partial_sum(first_on.begin(), first_on.end(), first_on.begin());
  lists.by_building = std::move(by_building);
  lists.first_on = std::move(first_on);
}

const DesignTarget* Plan::target_of(std::size_t suite) const {
  const auto& own = config.intensity.target;
  if (own) return &*own;
  const auto& suites_own = suites[suite].target;
  return suites_own ? &*suites_own : nullptr;
}

std::vector<std::string> events_of(const Plan& plan) {
  std::vector<std::string> events;
  for (std::size_t i = 0; i < plan.records.size(); ++i) events.push_back(plan.motion(i).event);
  return events;
}

std::uint64_t Plan::histories() const {
  return records.size() * order.size() * depth_of(config, Depth::levels);
}

double Plan::predicted_seconds() const { return 1e-6 * total_us(*this, record_costs(*this)); }

double units_wanted(Kernel kernel) { return kernel == Kernel::tables ? 512.0 : 256.0; }

std::vector<std::size_t> longest_first(const Plan& plan, std::size_t block) {
  const std::size_t begin = block == 0 ? 0 : plan.unit_ends[block - 1];
  std::vector<std::size_t> units(plan.unit_ends[block] - begin);
  std::iota(units.begin(), units.end(), begin);
  const std::vector<HistoryCost> costs = record_costs(plan);
  std::ranges::stable_sort(units, std::greater{}, [&](std::size_t i) {
    const WorkUnit& unit = plan.units[i];
    return costs[unit.record].mean_us * static_cast<double>(unit.count);
  });
  return units;
}

std::vector<std::size_t> units_of(const Plan& plan, const PlanPart& part) {
  std::vector<std::size_t> all, units;
  for (std::size_t block = 0; block < plan.unit_ends.size(); ++block)
    std::ranges::copy(longest_first(plan, block), std::back_inserter(all));
  if (part.is_all()) return all;
  for (std::size_t i = part.number - 1; i < all.size(); i += part.count) units.push_back(all[i]);
  return units;
}

Plan begin_plan(const StudyConfig& config, std::vector<Suite> suites) {
  GLISSADE_EXPECTS(!suites.empty());
  GLISSADE_EXPECTS(config.suite_files.empty() || config.suite_files.size() == suites.size());
  Plan plan;
  plan.config = config;
  // Suites that come from no file are called by their names in messages.
  if (config.suite_files.empty()) {
    for (const Suite& suite : suites) plan.config.suite_files.emplace_back(suite.name);
  }
  plan.suites = std::move(suites);
  plan.config.intensity.of_roof = plan.suites.front().of_roof;
  for (std::size_t s = 0; s < plan.suites.size(); ++s) {
    keep_records({config.file, plan.config.suite_files[s], config.records}, plan.suites[s]);
    if (config.normalise_by_pgv) normalise_by_pgv(plan.suites[s]);
    for (std::size_t m = 0; m < plan.suites[s].motions.size(); ++m) plan.records.push_back({s, m});
  }
  check_fit(plan.config, plan.suites);
  const IntensityConfig& intensity = plan.config.intensity;
  if (intensity.measure.is_of_design_spectrum() &&
      intensity.scaling_rule != ScalingRule::walters_2012)
    plan.first_periods = first_periods(plan.config);
  return plan;
}

std::size_t spectra_to_scale(const Plan& plan) {
  return plan.config.intensity.measure == IntensityMeasure::sds_g ? plan.records.size() : 0;
}

std::vector<double> spectrum_to_scale(const Plan& plan, std::size_t record) {
  const ScalingRule rule = plan.config.intensity.scaling_rule;
  return spectrum_by_rule_g(plan.motion(record), rule, periods_by_rule_s(rule, plan.first_periods));
}

void scale_plan(Plan& plan, std::vector<std::vector<double>> spectra_g) {
  scale_suites(plan, std::move(spectra_g));
  check_factors(plan);
  plan.kernel = cheapest_exact_kernel(plan.config);
  plan.cases = PlannedCases(plan.config);
}

void finish_plan(Plan& plan) {
  list_cases(plan);
  plan.motions_text = motions_text(plan);
  plan.hash = hash_of(plan);
  cut_units(plan);
  plan.cases.drop_draws();
}

Plan make_plan(const StudyConfig& config, std::vector<Suite> suites) {
  Plan plan = begin_plan(config, std::move(suites));
  std::vector<std::vector<double>> spectra_g;
  for (std::size_t i = 0; i < spectra_to_scale(plan); ++i)
    spectra_g.push_back(spectrum_to_scale(plan, i));
  scale_plan(plan, std::move(spectra_g));
  finish_plan(plan);
  return plan;
}

std::string fingerprint(const Plan& plan) {
  constexpr std::size_t most_cases = 4096;
  Hasher hasher;
  hasher.text(mathematics()).text(plan.config.hashed_text).numbers(plan.factor_at_unit_level);
  const std::size_t step = std::max<std::size_t>(1, plan.cases.size() / most_cases);
  for (std::size_t i = 0; i < plan.cases.size(); i += step) hash_case(hasher, plan.cases[i]);
  return to_hex(hasher.value());
}

Plan first_blocks(Plan plan, std::size_t units) {
  const auto end = std::ranges::find(plan.unit_ends, units);
  GLISSADE_EXPECTS(end != plan.unit_ends.end());
  const auto blocks = static_cast<std::size_t>(end - plan.unit_ends.begin()) + 1;
  if (blocks == plan.unit_ends.size()) return plan;
  plan.config.sampling = plan.config.sampling.first_blocks(blocks);
  plan.cases = PlannedCases(plan.config);
  list_cases(plan);
  plan.cases.drop_draws();
  plan.unit_ends.resize(blocks);
  plan.units =
      std::vector(plan.units.begin(), plan.units.begin() + static_cast<std::ptrdiff_t>(units));
  return plan;
}

}  // namespace glissade
