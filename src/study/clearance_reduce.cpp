// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/study/clearance_study.hpp"

namespace glissade {
namespace {

double integral_of_squares(const std::vector<double>& a) {
  return std::inner_product(a.begin(), a.end(), a.begin(), 0.0);
}

ClearanceRecord summary_of(const Motion& motion, std::size_t suite) {
  const auto& [first, second] = motion.horizontal_mps2;
  return {.suite = suite,
          .id = motion.id,
          .event = motion.event,
          .station = motion.station,
          .magnitude = motion.magnitude,
          .distance_km = motion.distance_km,
          .scale = motion.scale,
          .dt_s = motion.dt_s,
          .has_vertical = !motion.vertical_mps2.empty(),
          .stronger = integral_of_squares(second) > integral_of_squares(first) ? 1u : 0u};
}

/// As scaled to MCE, from 0 to 2 s.
SuiteSpectra spectra_of(const Suite& suite) {
  constexpr int points = 200;
  SuiteSpectra spectra;
  for (int i = 0; i <= points; ++i) spectra.periods_s.push_back(2.0 * i / points);
  spectra.average_srss_g.assign(spectra.periods_s.size(), 0.0);
  for (const Motion& motion : suite.motions) {
    std::vector<double> srss =
        horizontal_spectrum_mps2(motion, spectra.periods_s, HorizontalCombination::srss);
    for (std::size_t p = 0; p < srss.size(); ++p) {
      srss[p] *= motion.scale / standard_gravity_mps2;
      spectra.average_srss_g[p] += srss[p] / static_cast<double>(suite.motions.size());
    }
    spectra.srss_g.push_back(std::move(srss));
  }
  if (suite.target) {
    const TargetSpectrum target(*suite.target);
    for (const double period : spectra.periods_s)
      spectra.target_g.push_back(target.mce_sa_g(period));
  }
  return spectra;
}

}  // namespace

ClearanceResults reduce(const ClearancePlan& plan, const std::vector<ClearanceUnit>& units) {
  const ClearanceConfig& c = plan.config;
  const std::size_t conditions = c.grid.count(), orientations = plan.orientations.size();
  ClearanceResults results{
      .study_name = c.name,
      .study_description = c.description,
      .program_version = GLISSADE_VERSION,
      .plan_hash = plan.hash,
      .study_text = c.source_text,
      .seed = c.seed,
      .grid = c.grid,
      .orientations = plan.orientations,
      .same_as = {plan.same_as.begin(), plan.same_as.end()},
      .suites = {},
      .records = {},
      .friction = {c.friction[0].design(), c.friction[1].design()},
      .displacement = c.displacement,
      .clearance_factor = c.clearance_factor,
      .statements = c.statements,
      .histories = std::vector<ClearanceHistory>(plan.records.size() * orientations * conditions)};
  for (const Suite& suite : plan.suites)
    results.suites.push_back({suite.name, suite.description, spectra_of(suite)});
  for (const PlannedRecord& record : plan.records) {
    results.records.push_back(
        summary_of(plan.suites[record.suite].motions[record.motion], record.suite));
  }
  std::vector<const ClearanceUnit*> by_unit(plan.units(), nullptr);
  for (const ClearanceUnit& unit : units) {
    GLISSADE_EXPECTS(unit.unit < by_unit.size() && by_unit[unit.unit] == nullptr);
    GLISSADE_EXPECTS(unit.histories.size() == conditions);
    by_unit[unit.unit] = &unit;
  }
  auto to = results.histories.begin();
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    for (const std::size_t same : plan.same_as) {
      const auto run = std::ranges::find(plan.run, same) - plan.run.begin();
      const ClearanceUnit* unit = by_unit[record * plan.run.size() + static_cast<std::size_t>(run)];
      GLISSADE_EXPECTS(unit != nullptr);
      to = std::copy(unit->histories.begin(), unit->histories.end(), to);
    }
  }
  // A mirrored history ends on the other side.
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    for (std::size_t o = 0; o < orientations; ++o) {
      if (plan.orientations[o].across_sign == plan.orientations[plan.same_as[o]].across_sign)
        continue;
      for (std::size_t i = 0; i < conditions; ++i) {
        double& across =
            results.histories[(record * orientations + o) * conditions + i].residual_across_m;
        across = across == 0.0 ? 0.0 : -across;
      }
    }
  }
  return results;
}

}  // namespace glissade
