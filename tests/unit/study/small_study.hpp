// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cmath>

#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/execute.hpp"
#include "unit/block/reference.hpp"
#include "unit/study/by_rule.hpp"

namespace glissade::test {

/// Three made-up three-component motions of 6 s.
inline Suite small_suite() {
  Suite suite;
  suite.name = "small";
  for (unsigned i = 0; i < 3; ++i) {
    Motion m;
    m.id = "motion" + std::to_string(i);
    m.dt_s = 0.01;
    m.scale = 1.0 + 0.5 * i;
    m.horizontal_mps2 = {made_up_record(600, 10 * i + 1, 3.0),
                         made_up_record(600, 10 * i + 2, 2.0)};
    m.vertical_mps2 = made_up_record(600, 10 * i + 3, 1.0);
    suite.motions.push_back(m);
  }
  suite.target = DesignTarget{AsceEdition::asce7_10, 1.5, 0.6, {SiteClass::d}, 8.0};
  return suite;
}

/// Forty samples of everything uncertain on a sds_g study of eight levels.
inline StudyConfig small_config() {
  StudyConfig c;
  c.name = "small";
  c.seed = 5;
  c.file = "study.toml";
  c.source_text = c.hashed_text = "small study";
  c.suite_files = {"suite.toml"};
  c.model.axes = SlidingAxes::one;
  c.intensity.measure = IntensityMeasure::sds_g;
  c.intensity.levels = {0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0};
  c.quantities.at("building", "period_s") = drawn(Uniform{0.1, 0.8});
  c.quantities.at("roof", "slope_deg") = drawn(Discrete{{0.0, 1.19, 4.0}, {1.0, 1.0, 1.0}});
  c.quantities.at("friction", "mu") = drawn(TruncatedNormal{0.4, 0.05, 0.0, INFINITY});
  c.sampling.samples = 40;
  c.sampling.method = SamplingMethod::monte_carlo;
  c.sampling.bootstrap_replicates = 200;
  c.fragility = FragilityConfig{.thresholds_m = {0.02, 0.1, 1.0}};
  c.standards.compare = {Standard::seaoc_pv1_2012, Standard::asce7_16};
  return c;
}

inline Plan small_plan(const StudyConfig& config) { return make_plan(config, {small_suite()}); }

inline std::vector<UnitResult> execute_all(const Plan& plan, Skipping skipping = Skipping::all) {
  RoofStore roofs(plan, skipping);
  std::vector<UnitResult> units;
  for (std::size_t u = plan.units.size(); u > 0; --u)  // any order
    units.push_back(execute(plan, u - 1, roofs));
  return units;
}

inline Results run(const Plan& plan, Skipping skipping = Skipping::all) {
  return reduce(plan, execute_all(plan, skipping));
}

inline WorkCount total_count(const std::vector<UnitResult>& units) {
  WorkCount total;
  for (const UnitResult& unit : units) total += unit.count;
  return total;
}

/// Factor on a record at a level.
inline double factor_of(const Plan& plan, std::size_t record, double level) {
  return plan.config.intensity.measure.factor_of_level(level) * plan.factor_at_unit_level[record];
}

/// A case's component of a record, with its sign and factor, and the vertical.
struct CaseGround {
  GroundMotion motion;
  MotionFactors factors;
};
inline CaseGround ground_of(const Plan& plan, std::size_t record, const Case& c, double level) {
  const Motion& m = plan.motion(record);
  const SignedComponent along = along_axis(c.orientation, 0);
  const double factor = factor_of(plan, record, level);
  CaseGround ground{{m.dt_s, m.horizontal_mps2[static_cast<std::size_t>(along.component)]},
                    {along.sign * factor, factor}};
  if (c.vertical != VerticalChoice::none) ground.motion.vertical_mps2 = m.vertical_mps2;
  return ground;
}

/// Every number and flag of the histories, NaN as its bits are.
inline std::vector<std::uint64_t> bits_of(const HistoryTable& table) {
  std::vector<std::uint64_t> bits;
  for_each_history_field([&](auto field) {
    for (const auto value : table.fields.*field.of) {
      if constexpr (sizeof value == sizeof(std::uint64_t)) {
        bits.push_back(std::bit_cast<std::uint64_t>(value));
      } else {
        bits.push_back(value);
      }
    }
  });
  return bits;
}

/// Calls check(record, case, level) for every history.
template <class Check>
void for_each_history(const HistoryTable& table, Check check) {
  for (std::size_t record = 0; record < table.records; ++record)
    for (std::size_t c = 0; c < table.cases; ++c)
      for (std::size_t level = 0; level < table.levels; ++level) check(record, c, level);
}

}  // namespace glissade::test
