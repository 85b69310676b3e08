// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/motion_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/rotated_spectrum.hpp"
#include "glissade/motion/walters_level.hpp"

namespace glissade {
namespace {

/// Of which the target has the largest mapped values; -1: of none.
int level_of(const DesignTarget& target) {
  for (int level = 0; level <= 4; ++level) {
    const WaltersLevel& most = walters_level(level);
    if (target.ss_g == most.ss_g && target.s1_g == most.s1_g) return level;
  }
  return -1;
}

double integral_of_squares(std::span<const double> a) {
  return std::inner_product(a.begin(), a.end(), a.begin(), 0.0);
}

/// Periods at which spectra are shown: 0, then 0.02 to 4 s, equally spaced in the logarithm.
std::vector<double> shown_periods_s() {
  std::vector<double> periods{0.0};
  constexpr int count = 80;
  for (int i = 0; i < count; ++i) periods.push_back(0.02 * std::pow(200.0, i / (count - 1.0)));
  return periods;
}

/// Without its spectra.
RecordSummary summary_of(const Plan& plan, std::size_t record) {
  const Motion& motion = plan.motion(record);
  const auto& [first, second] = motion.horizontal_mps2;
  RecordSummary r;
  r.suite = plan.records[record].suite;
  r.id = motion.id;
  r.event = motion.event;
  r.station = motion.station;
  r.processing = fmt::format("{}", fmt::join(motion.processing, "; "));
  r.magnitude = motion.magnitude;
  r.distance_km = motion.distance_km;
  r.vs30_mps = motion.vs30_mps;
  r.suite_scale = motion.scale;
  r.factor_at_unit_level = plan.factor_at_unit_level[record];
  r.pga_g =
      horizontal_pga_mps2(motion, HorizontalCombination::geometric_mean) / standard_gravity_mps2;
  r.pgv_mps = horizontal_pgv_mps(motion, HorizontalCombination::geometric_mean);
  r.pgd_m = horizontal_pgd_m(motion, HorizontalCombination::geometric_mean);
  r.duration_s = significant_duration_s(motion.dt_s, first, second);
  r.arias_mps = arias_intensity_mps(motion);
  r.dt_s = motion.dt_s;
  r.samples = first.size();
  r.has_second = !second.empty();
  r.has_vertical = !motion.vertical_mps2.empty();
  r.stronger = integral_of_squares(second) > integral_of_squares(first) ? 1 : 0;
  return r;
}

/// By S_DS at the level nearest 1 g, of a chart at the one it shows; else 0: as the suite file
/// scales it, beside its MCE target.
double reference_level(const StudyConfig& config) {
  const std::vector<double>& levels = config.intensity.levels;
  if (config.intensity.measure != IntensityMeasure::sds_g) return 0.0;
  if (config.chart) return config.chart->shown_level;
  return *std::ranges::min_element(
      levels, [](double a, double b) { return std::abs(a - 1.0) < std::abs(b - 1.0); });
}

bool is_by_sds(const Plan& plan) {
  return plan.config.intensity.measure == IntensityMeasure::sds_g;
}

/// Of measures that are not of a design spectrum too.
bool is_by_walters(const Plan& plan) {
  return !plan.config.intensity.measure.is_of_design_spectrum() ||
         plan.config.intensity.scaling_rule == ScalingRule::walters_2012;
}

PeriodRange rule_range(const Plan& plan) {
  return period_range(plan.config.intensity.scaling_rule, plan.first_periods);
}

void insert(double period_s, std::vector<double>& periods) {
  const auto at = std::ranges::lower_bound(periods, period_s);
  if (at == periods.end() || *at != period_s) periods.insert(at, period_s);
}

/// The same, with the listed periods of buildings, and to where the rule of the scaling goes; of a
/// suite that its file scales to MCE from 0 to 2 s by 0.01 s.
std::vector<double> suite_periods_s(const Plan& plan) {
  std::vector<double> periods = shown_periods_s();
  const IntensityConfig& intensity = plan.config.intensity;
  if (intensity.measure == IntensityMeasure::mce_fraction) {
    constexpr std::size_t count = 200;
    periods.assign(count + 1, 0.0);
    for (std::size_t i = 1; i <= count; ++i)
      periods[i] = 2.0 * static_cast<double>(i) / static_cast<double>(count);
  }
  const double to_s =
      is_by_walters(plan) ? (is_by_sds(plan) ? intensity.scaled_to_s : 0.0) : rule_range(plan).to_s;
  if (to_s > longest_scaled_period_s) {
    constexpr double growth = 1.07;
    for (double t_s = growth * periods.back(); t_s < to_s; t_s *= growth) periods.push_back(t_s);
    insert(to_s, periods);
  }
  if (is_by_sds(plan))
    for (const double of_building : plan.config.quantities.at("building", "period_s").values)
      if (of_building <= periods.back()) insert(of_building, periods);
  return periods;
}

/// On each motion, as the suite is shown.
std::vector<double> shown_factors(const Plan& plan, std::size_t suite) {
  std::vector<double> factors;
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    if (plan.records[record].suite != suite) continue;
    factors.push_back(is_by_sds(plan)
                          ? reference_level(plan.config) * plan.factor_at_unit_level[record]
                          : plan.motion(record).scale);
  }
  return factors;
}

/// The target that a suite is shown with; it has one.
std::function<double(double)> shown_target(const Plan& plan, std::size_t suite) {
  return [&plan, shape = TargetSpectrum(*plan.target_of(suite))](double period_s) {
    return is_by_sds(plan)
               ? reference_level(plan.config) * shape.design_sa_g(period_s) / shape.sds_g()
               : shape.mce_sa_g(period_s);
  };
}

/// By a rule that is not Walters's.
SpectraByRule rule_spectra(const Plan& plan, std::size_t suite) {
  if (is_by_sds(plan)) return plan.scaling_spectra[suite];
  const ScalingRule rule = plan.config.intensity.scaling_rule;
  SpectraByRule spectra{periods_by_rule_s(rule, plan.first_periods), {}};
  for (const Motion& motion : plan.suites[suite].motions)
    spectra.rows_g.push_back(spectrum_by_rule_g(motion, rule, spectra.periods_s));
  return spectra;
}

/// Where the average of a suite is lowest and highest relative to its target;
/// empty where it is not shown with one.
std::vector<double> ratios_of(const Plan& plan, std::size_t suite) {
  if (plan.target_of(suite) == nullptr || (is_by_sds(plan) && reference_level(plan.config) <= 0.0))
    return {};
  const std::vector<double> factors = shown_factors(plan, suite);
  const auto target = shown_target(plan, suite);
  if (!is_by_walters(plan)) {
    const RuleRatios found = ratios_by_rule(rule_spectra(plan, suite), factors, target);
    return {found.lowest.ratio, found.lowest.period_s, found.highest.ratio, found.highest.period_s,
            found.mean};
  }
  const SpectralRatios found = is_by_sds(plan)
                                   ? ratios_to_target(plan.suites[suite], factors, target,
                                                      plan.scaling_spectra[suite].rows_g)
                                   : ratios_to_target(plan.suites[suite], factors, target);
  return {found.lowest.ratio, found.lowest.period_s, found.highest.ratio, found.highest.period_s};
}

/// The spectra of a record: as recorded sa_g and velocities of a roof, then the
/// SRSS, or RotD100, in m/s^2.
std::vector<double> spectra_of(const Plan& plan, std::size_t record) {
  const Motion& motion = plan.motion(record);
  const std::vector<double> periods = shown_periods_s();
  std::vector<double> numbers =
      horizontal_spectrum_mps2(motion, periods, HorizontalCombination::geometric_mean);
  for (double& sa : numbers) sa /= standard_gravity_mps2;
  const std::vector<double> velocities = horizontal_roof_velocity_mps(motion, periods);
  numbers.insert(numbers.end(), velocities.begin(), velocities.end());
  const std::vector<double> together =
      is_by_walters(plan) || !is_of_16_2(plan.config.intensity.scaling_rule)
          ? horizontal_spectrum_mps2(motion, suite_periods_s(plan), HorizontalCombination::srss)
          : rotated_spectrum(motion, suite_periods_s(plan)).rotd100_mps2;
  numbers.insert(numbers.end(), together.begin(), together.end());
  return numbers;
}

SuiteSummary suite_of(const Plan& plan, std::size_t suite, const std::vector<double>& ratios,
                      std::span<const std::vector<double>> of_records) {
  SuiteSpectra spectra;
  spectra.periods_s = suite_periods_s(plan);
  spectra.reference_level = reference_level(plan.config);
  const std::size_t periods = spectra.periods_s.size();
  spectra.average_g.assign(periods, 0.0);
  const std::vector<double> factors = shown_factors(plan, suite);
  const double motions = static_cast<double>(factors.size());
  std::size_t record = 0;
  while (plan.records[record].suite != suite) ++record;
  for (const double factor : factors) {
    const std::vector<double>& numbers = of_records[record++];
    std::vector<double> srss(numbers.end() - static_cast<std::ptrdiff_t>(periods), numbers.end());
    for (std::size_t p = 0; p < periods; ++p) {
      srss[p] *= factor / standard_gravity_mps2;
      spectra.average_g[p] += srss[p] / motions;
    }
    spectra.records_g.push_back(std::move(srss));
  }
  const Suite& of = plan.suites[suite];
  SuiteSummary summary{.name = of.name, .description = of.description, .of_roof = of.of_roof};
  if (const DesignTarget* design = plan.target_of(suite)) {
    summary.target = to_string(*design);
    if (design->is_mapped()) {
      summary.target_is_envelope = design->site_classes.size() > 1;
      summary.intensity_level = level_of(*design);
    }
    const auto target = shown_target(plan, suite);
    for (const double period : spectra.periods_s) spectra.target_g.push_back(target(period));
  }
  if (!ratios.empty()) spectra.to_target = {{ratios[0], ratios[1]}, {ratios[2], ratios[3]}};
  if (!is_by_walters(plan)) {
    spectra.rule = plan.config.intensity.scaling_rule;
    spectra.range = rule_range(plan);
    if (!ratios.empty()) spectra.mean_ratio = ratios[4];
  }
  summary.spectra = std::move(spectra);
  return summary;
}

}  // namespace

std::size_t motion_part_count(const Plan& plan) { return plan.suites.size() + plan.records.size(); }

std::vector<double> motion_part(const Plan& plan, std::size_t part) {
  const std::size_t suites = plan.suites.size();
  return part < suites ? ratios_of(plan, part) : spectra_of(plan, part - suites);
}

void put_motions(const Plan& plan, const std::vector<std::vector<double>>& parts,
                 Results& results) {
  const std::size_t suites = plan.suites.size();
  const std::span of_records = std::span(parts).subspan(suites);
  for (std::size_t s = 0; s < suites; ++s)
    results.suites.push_back(suite_of(plan, s, parts[s], of_records));
  results.record_periods_s = shown_periods_s();
  const auto periods = static_cast<std::ptrdiff_t>(results.record_periods_s.size());
  for (std::size_t record = 0; record < plan.records.size(); ++record) {
    RecordSummary summary = summary_of(plan, record);
    const auto numbers = of_records[record].begin();
    summary.sa_g.assign(numbers, numbers + periods);
    summary.roof_velocity_mps.assign(numbers + periods, numbers + 2 * periods);
    results.records.push_back(std::move(summary));
  }
}

}  // namespace glissade
