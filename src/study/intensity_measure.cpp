// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/intensity_measure.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/rotated_spectrum.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/study/config.hpp"

namespace glissade {
namespace {

/// How one number comes from a record, of which there are two horizontals as a rule.
constexpr const char *of_peaks = ", geometric mean of both horizontals",
                     *of_spectra = ", geometric mean of both horizontals, 5 %",
                     *of_directions = ", RotD50, 5 %",
                     *of_suite = "";  // it is no number of a record

struct MeasureRow {
  const char *key, *unit, *own_key, *meaning, *definition;
  std::string (*symbol)(const IntensityConfig&);
  /// Of one record at level 1; null: see factors_at_unit_level().
  double (*factor)(const IntensityConfig&, const Motion&);
  double power = 1.0;  ///< of the motion, to which the intensity is proportional
};

double geometric_mean_sa_mps2(const Motion& motion, double period_s) {
  return horizontal_spectrum_mps2(motion, {&period_s, 1}, HorizontalCombination::geometric_mean)
      .front();
}

const std::array rows = {
    MeasureRow{"sds_g", "g", "target",
               "design spectral acceleration S_DS: each suite is scaled as a whole until its "
               "average spectrum (5 %) meets the design spectrum by intensity.scaling_rule",
               of_suite, [](const IntensityConfig&) -> std::string { return "S_DS"; }, nullptr},
    MeasureRow{"ppa_g", "g", nullptr,
               "peak roof acceleration along the slope's plan direction (depends on the building)",
               of_suite,
               [](const IntensityConfig&) -> std::string { return "peak roof acceleration"; },
               nullptr},
    MeasureRow{"mce_fraction", "-", nullptr,
               "factor on the suite as its file scales it, to the MCE of its [target]; 2/3 is the "
               "design earthquake",
               of_suite, [](const IntensityConfig&) -> std::string { return "fraction of MCE"; },
               [](const IntensityConfig&, const Motion& m) { return m.scale; }},
    MeasureRow{"pga_g", "g", nullptr, "peak ground acceleration", of_peaks,
               [](const IntensityConfig& c) -> std::string {
                 return c.of_roof ? "peak roof acceleration" : "peak ground acceleration";
               },
               [](const IntensityConfig&, const Motion& m) {
                 return standard_gravity_mps2 /
                        horizontal_pga_mps2(m, HorizontalCombination::geometric_mean);
               }},
    MeasureRow{"sa_g", "g", "sa_period_s", "spectral acceleration at sa_period_s", of_spectra,
               [](const IntensityConfig& c) { return fmt::format("Sa({:g} s)", c.sa_period_s); },
               [](const IntensityConfig& c, const Motion& m) {
                 return standard_gravity_mps2 / geometric_mean_sa_mps2(m, c.sa_period_s);
               }},
    MeasureRow{"avg_sa_g", "g", "avg_sa_periods_s",
               "geometric mean of the spectral accelerations at avg_sa_periods_s", of_spectra,
               [](const IntensityConfig& c) {
                 return fmt::format("average Sa, {:g} to {:g} s", c.avg_sa_periods_s.front(),
                                    c.avg_sa_periods_s.back());
               },
               [](const IntensityConfig& c, const Motion& m) {
                 return standard_gravity_mps2 / average_sa_mps2(m, c.avg_sa_periods_s);
               }},
    MeasureRow{"pgv_mps", "m/s", nullptr, "peak ground velocity", of_peaks,
               [](const IntensityConfig&) -> std::string { return "peak ground velocity"; },
               [](const IntensityConfig&, const Motion& m) {
                 return 1.0 / horizontal_pgv_mps(m, HorizontalCombination::geometric_mean);
               }},
    MeasureRow{"arias_mps", "m/s", nullptr, "Arias intensity", of_peaks,
               [](const IntensityConfig&) -> std::string { return "Arias intensity"; },
               [](const IntensityConfig&, const Motion& m) {
                 return 1.0 / std::sqrt(arias_intensity_mps(m));
               },
               2.0},
    MeasureRow{"factor", "-", nullptr,
               "factor on the motions as the suite's file gives them: 1 leaves them alone",
               of_suite,
               [](const IntensityConfig&) -> std::string { return "factor on the motions"; },
               [](const IntensityConfig&, const Motion& m) { return m.scale; }},
    MeasureRow{"sa_rotd50_g", "g", "sa_period_s", "spectral acceleration at sa_period_s",
               of_directions,
               [](const IntensityConfig& c) { return fmt::format("Sa({:g} s)", c.sa_period_s); },
               [](const IntensityConfig& c, const Motion& m) {
                 return standard_gravity_mps2 /
                        rotated_spectrum(m, {&c.sa_period_s, 1}).rotd50_mps2.front();
               }},
};

const MeasureRow& row_of(std::size_t row) { return rows.at(row); }

/// Walters's rule and what is beyond it, on the suite as its file scales its
/// records.
double walters_factor(const IntensityConfig& intensity, const Suite& suite,
                      const SpectrumRows& rows_g, const std::function<double(double)>& target_g) {
  double common = suite_average_factor(suite, target_g, rows_g);
  if (intensity.scaled_to_s <= longest_scaled_period_s) return common;
  std::vector<double> scales;
  for (const Motion& motion : suite.motions) scales.push_back(motion.scale);
  const SpectralRatio beyond = lowest_ratio_to_target(
      suite, scales, target_g, periods_beyond_scaled_s(intensity.scaled_to_s));
  return std::max(common, least_over_target_beyond / beyond.ratio);
}

std::vector<double> factors_at_unit_sds(const IntensityConfig& intensity, const Suite& suite,
                                        const SpectraByRule& spectra) {
  const TargetSpectrum spectrum(intensity.target ? *intensity.target : *suite.target);
  const auto unit_design = [&](double period) {
    return spectrum.design_sa_g(period) / spectrum.sds_g();
  };
  std::vector<double> factors;
  for (const Motion& motion : suite.motions) factors.push_back(motion.scale);
  const double common =
      intensity.scaling_rule == ScalingRule::walters_2012
          ? walters_factor(intensity, suite, spectra.rows_g, unit_design)
          : missing_factor(intensity.scaling_rule, ratios_by_rule(spectra, factors, unit_design));
  for (double& factor : factors) factor *= common;
  return factors;
}

}  // namespace

std::size_t IntensityMeasure::count() { return rows.size(); }

std::optional<IntensityMeasure> IntensityMeasure::named(const std::string& key) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (key == rows[i].key) return IntensityMeasure(i);
  }
  return std::nullopt;
}

const char* IntensityMeasure::key() const { return row_of(row_).key; }
const char* IntensityMeasure::unit() const { return row_of(row_).unit; }
std::string IntensityMeasure::meaning() const {
  return std::string(row_of(row_).meaning) + row_of(row_).definition;
}
const char* IntensityMeasure::own_key() const { return row_of(row_).own_key; }
std::string IntensityMeasure::symbol(const IntensityConfig& c) const {
  return row_of(row_).symbol(c);
}

std::string IntensityMeasure::definition(const IntensityConfig& c) const {
  return symbol(c) + row_of(row_).definition;
}

std::vector<double> IntensityMeasure::factors_at_unit_level(const IntensityConfig& intensity,
                                                            const Suite& suite,
                                                            const SpectraByRule& spectra) const {
  if (*this == sds_g) return factors_at_unit_sds(intensity, suite, spectra);
  std::vector<double> factors;
  for (const Motion& motion : suite.motions)
    factors.push_back(*this == ppa_g ? 0.0 : row_of(row_).factor(intensity, motion));
  return factors;
}

double IntensityMeasure::factor_of_level(double level) const {
  const double power = row_of(row_).power;
  return power == 1.0 ? level : std::pow(level, 1.0 / power);
}

std::string unit_suffix(const std::string& unit) {
  if (unit == "-") return "";
  return unit == "m/s" ? "_mps" : "_" + unit;
}

}  // namespace glissade
