// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/core/units.hpp"
#include "glissade/design/of_project.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/scaling_rule.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/sampling/pull_test.hpp"
#include "glissade/study/plan/plan.hpp"

namespace glissade {
namespace {

/// The lowest ratio of the suite's average spectrum to the design spectrum in (from, to], at the
/// periods of the spectra and, between two of them, at `to`.
double lowest_ratio(const SuiteSpectra& spectra, double from_s, double to_s) {
  const std::vector<double>& periods_s = spectra.periods_s;
  const auto ratio = [&](std::size_t i) { return spectra.average_g[i] / spectra.target_g[i]; };
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < periods_s.size(); ++i) {
    if (periods_s[i] > from_s && periods_s[i] <= to_s) lowest = std::min(lowest, ratio(i));
    if (periods_s[i - 1] < to_s && to_s < periods_s[i])
      lowest = std::min(lowest,
                        std::lerp(ratio(i - 1), ratio(i),
                                  (to_s - periods_s[i - 1]) / (periods_s[i] - periods_s[i - 1])));
  }
  expect_of_project(std::isfinite(lowest), "spectra of longer periods");
  return lowest;
}

/// Of a suite scaled by a clause of ASCE 7, which scaling meets but for the
/// number of motions.
std::vector<DesignCheck> clause_checks(const SuiteSpectra& spectra) {
  const ScalingRuleText& text = text_of(spectra.rule);
  const RuleRatios ratios{spectra.to_target.lowest, spectra.to_target.highest, spectra.mean_ratio};
  constexpr double rounding = 1e-9;
  std::vector<DesignCheck> checks{
      {fmt::format("average {} spectrum of the suite over the design spectrum, {:.3g} to {:.3g} s",
                   text.combination, spectra.range.from_s, spectra.range.to_s),
       fmt::format("{:.3f} or more (at {:.3g} s), on average {:.3f}", ratios.lowest.ratio,
                   ratios.lowest.period_s, ratios.mean),
       fmt::format("{}: {}", text.clause, text.spectrum),
       missing_factor(spectra.rule, ratios) <= 1.0 + rounding}};
  const std::size_t motions = spectra.records_g.size();
  if (std::string unmet = unmet_by(motions, spectra.rule); !unmet.empty())
    checks.push_back({"number of motions for the rule of scaling", fmt::format("{}", motions),
                      std::move(unmet), false});
  return checks;
}

std::vector<DesignCheck> spectrum_checks(const Project& project, const Results& demand) {
  const SuiteSpectra& spectra = demand.suites.front().spectra;
  if (spectra.rule != ScalingRule::walters_2012) return clause_checks(spectra);
  const SpectralRatio lowest = spectra.to_target.lowest;
  std::vector<DesignCheck> checks{
      {"average SRSS spectrum of the suite over the design spectrum, 0 to 2 s",
       fmt::format("{:.3f} or more (at {:.3g} s)", lowest.ratio, lowest.period_s),
       fmt::format(
           "1 or more at the periods of the scaling rule (Walters et al. 2012), {:g} or more "
           "between them",
           least_over_target),
       lowest.ratio >= least_over_target}};
  const double longest_s = judged_to_s(periods_of(project).back());
  if (longest_s <= longest_scaled_period_s) return checks;
  const double known_s = spectra.periods_s.back(), to_s = std::min(longest_s, known_s);
  constexpr double rounding = 5e-4;  // the spectra are at other periods than those of the scaling
  const double ratio = lowest_ratio(spectra, longest_scaled_period_s, to_s);
  checks.push_back(
      {fmt::format(
           "average SRSS spectrum of the suite over the design spectrum, 2 to {:.3g} s, {}", to_s,
           to_s == longest_s
               ? "1.5 times the longest period"
               : fmt::format(
                     "where the shown spectra end (1.5 times the longest period is {:.3g} s)",
                     longest_s)),
       fmt::format("{:.3f} or more{}", ratio,
                   project.without_target ? "" : "; the studies scale the suite to there"),
       fmt::format("{:g} or more (by no clause)", least_over_target_beyond),
       ratio >= least_over_target_beyond - rounding});
  return checks;
}

/// A weaker roof is of a model that is too soft or too simple, or of a weaker earthquake.
DesignCheck roof_check(const DesignClearance& design) {
  constexpr double least = 0.8;
  const RoofPeak& roof = *std::ranges::min_element(design.roof, {}, &RoofPeak::over_standards);
  return {"median peak acceleration of the roof at DBE",
          fmt::format("{:.3f} g{}, {:.2f} times that of ASCE 7-16{}", roof.median_g,
                      roof.asce7_22_g ? fmt::format(" (period {:.3g} s)", roof.period_s) : "",
                      roof.median_g / roof.asce7_16_g,
                      roof.asce7_22_g ? fmt::format(" and {:.2f} times that of ASCE 7-22",
                                                    roof.median_g / *roof.asce7_22_g)
                                      : ""),
          fmt::format("{:g} or more of the acceleration of a roof by ASCE 7-16, 13.3.1, {:.3f} "
                      "g{}; the limit is of this program and has no source",
                      least, roof.asce7_16_g,
                      roof.asce7_22_g
                          ? fmt::format(", and by ASCE 7-22, 13.3.1, {:.3f} g", *roof.asce7_22_g)
                          : ""),
          roof.over_standards() >= least};
}

/// Of the design friction, mean - 2 std, which is above what any number of tests supports: 7 tests
/// with a standard deviation of 8 % of the mean support 0.87 of it, 4 of them 0.70.
constexpr double least_supported = 0.75;

/// The spectrum of which a site-specific one has 80 % or more (ASCE 7-16, 21.3, recalled): classes
/// D and E have their own coefficients there.
DesignSpectrum general_spectrum(const DesignTarget& mapped, SiteClass site) {
  const bool is_7_16 = mapped.edition == AsceEdition::asce7_16;
  const bool is_d = is_7_16 && (site == SiteClass::d || site == SiteClass::unknown);
  const bool is_e = is_7_16 && site == SiteClass::e;
  constexpr double last_of_class_e_g = 0.75;  // its F_a holds from there to 1 g, where it is 1
  const double table_ss_g = is_e ? std::min(mapped.ss_g, last_of_class_e_g) : mapped.ss_g;
  const double fa =
      is_e && mapped.ss_g >= 1.0 ? 1.0 : site_coefficient_fa(mapped.edition, site, table_ss_g);
  const double fv = is_d   ? (mapped.s1_g < 0.2 ? 2.4 : 2.5)
                    : is_e ? (mapped.s1_g <= 0.1 ? 4.2 : 4.0)
                           : site_coefficient_fv(mapped.edition, site, mapped.s1_g);
  return {fa * mapped.ss_g / mce_over_dbe, fv * mapped.s1_g / mce_over_dbe, mapped.tl_s};
}

DesignCheck site_specific_check(const ProjectSite& site) {
  constexpr double least = 0.8;
  const TargetSpectrum given(site.target);
  SpectralRatio lowest{std::numeric_limits<double>::infinity(), 0.0};
  for (const SiteClass site_class : site.mapped->site_classes) {
    const DesignSpectrum general = general_spectrum(*site.mapped, site_class);
    std::vector<double> periods_s = site.target.period_s;
    for (const double corner_s : {general.t0_s(), general.ts_s(), general.tl_s})
      if (corner_s <= site.target.period_s.back()) periods_s.push_back(corner_s);
    for (const double period_s : periods_s) {
      const double ratio = given.design_sa_g(period_s) / general.sa_g(period_s);
      if (ratio < lowest.ratio) lowest = {ratio, period_s};
    }
  }
  return {"site-specific spectrum over that of S_S, S_1 and site class",
          fmt::format("{:.3f} or more (at {:.3g} s)", lowest.ratio, lowest.period_s),
          fmt::format("{:g} or more ({}, 21.3, with F_a and F_v of that section)", least,
                      edition_name(site.target.edition)),
          lowest.ratio >= least};
}

/// S_DS of a spectrum by points is 90 % of its largest S_a (ASCE 7-16, 21.4): at least 80 % of that
/// of the maps, and all of it with exception 2, behind which there is no site-specific analysis.
DesignCheck design_value_check(const ProjectSite& site) {
  const bool is_mapped = takes_exception_2(*site.mapped);
  const double least = is_mapped ? 1.0 : 0.8;
  double mapped_g = 0.0;
  for (const SiteClass site_class : site.mapped->site_classes)
    mapped_g = std::max(mapped_g, general_spectrum(*site.mapped, site_class).sds_g);
  const double ratio = TargetSpectrum(site.target).sds_g() / mapped_g;
  return {"S_DS of the spectrum, 90 % of its largest S_a, over that of S_S, S_1 and site class",
          fmt::format("{:.3f}", ratio),
          fmt::format("{:g} or more ({}, 21.4{})", least, edition_name(site.target.edition),
                      is_mapped ? "; exception 2 of 11.4.8 leaves S_DS as it is: give a spectrum "
                                  "whose largest S_a is S_DS / 0.9"
                                : ""),
          ratio >= least * (1.0 - 1e-9)};
}

/// Exception 2 of ASCE 7-16, 11.4.8, multiplies C_s beyond 1.5 T_S by 1.5: of a spectrum S_D1
/// (supplement 3, recalled). Whether the suite, as it is scaled, meets that spectrum too.
DesignCheck exception_2_check(const Project& project, const SpectraByRule& spectra,
                              const std::vector<double>& factors, const PeriodRange& range) {
  constexpr double by_exception = 1.5;
  const TargetSpectrum mapped(project.site.mapped.value_or(project.site.target));
  const DesignSpectrum required{mapped.sds_g(), by_exception * mapped.sd1_g(),
                                project.site.target.tl_s};
  const RuleRatios ratios =
      ratios_by_rule(spectra, factors, [&](double period_s) { return required.sa_g(period_s); });
  return {fmt::format("average {} spectrum of the suite over the design spectrum with {:g} S_D1, "
                      "{:.3g} to {:.3g} s",
                      text_of(project.scaling_rule).combination, by_exception, range.from_s,
                      range.to_s),
          fmt::format("{:.3f} or more (at {:.3g} s), on average {:.3f}", ratios.lowest.ratio,
                      ratios.lowest.period_s, ratios.mean),
          fmt::format("{:g} of what is required over the design spectrum: exception 2 of ASCE "
                      "7-16, 11.4.8, multiplies C_s at long periods by {:g}, and so S_D1 of a "
                      "spectrum (by site.spectrum, with ss_g, s1_g and site_class; its largest S_a "
                      "is S_DS / 0.9, so that S_DS stays)",
                      least_over_target, by_exception),
          missing_factor(project.scaling_rule, ratios) <= 1.0 / least_over_target};
}

/// The average of the suite in the results, at the periods of the rule that they have.
DesignCheck exception_2_check(const Project& project, const SuiteSpectra& spectra) {
  const TargetSpectrum given(project.site.target);
  SpectraByRule average{{}, {{}}};
  for (std::size_t i = 0; i < spectra.periods_s.size(); ++i) {
    const double period_s = spectra.periods_s[i];
    if (period_s < spectra.range.from_s || period_s > spectra.range.to_s) continue;
    average.periods_s.push_back(period_s);
    average.rows_g.front().push_back(spectra.average_g[i] / spectra.target_g[i] *
                                     given.design_sa_g(period_s));
  }
  expect_of_project(!average.periods_s.empty(), "spectra at the periods of the rule of scaling");
  return exception_2_check(project, average, {1.0}, spectra.range);
}

}  // namespace

std::vector<std::string> records_with_uplift(const Results& results, std::size_t level) {
  const HistoryTable& histories = results.histories;
  std::vector<std::string> ids;
  for (std::size_t record = 0; record < histories.records; ++record) {
    for (std::size_t i = 0; i < histories.cases; ++i) {
      if (histories.fields.uplift.empty() ||
          histories.fields.uplift[histories.at(record, i, level)] == 0)
        continue;
      ids.push_back(results.records[record].id);
      break;
    }
  }
  return ids;
}

std::vector<DesignCheck> checks_before_analysis(const Project& project, std::size_t records) {
  std::vector<DesignCheck> checks;
  checks.push_back({"records", fmt::format("{}", records),
                    fmt::format("{} or more; of fewer the largest counts in place of the mean "
                                "(SEAOC PV1-2012); {} by ASCE 7-16, 16.2.2, for structures",
                                least_records, motions_by_16_2),
                    records >= least_records});
  if (project.site.mapped) {
    checks.push_back(site_specific_check(project.site));
    checks.push_back(design_value_check(project.site));
  }
  const ProjectFriction& mu = project.friction;
  const bool is_supported = mu.lower_bound && *mu.lower_bound >= least_supported * mu.design();
  checks.push_back(
      {"friction that the tests support with 95 % confidence",
       mu.lower_bound ? fmt::format("{:.3f}, where the design friction is {:.3f}", *mu.lower_bound,
                                    mu.design())
                      : "not known: the number of tests is not stated (friction.tests)",
       fmt::format("{:g} of the design friction or more (a limit of this program): fewer tests "
                   "support less",
                   least_supported),
       is_supported});
  if (mu.tests) {
    const auto others = mu.traces.size() - std::ranges::count_if(mu.traces, meets_provision);
    const bool is_known =
        !mu.traces.empty() && std::ranges::all_of(mu.traces, [](const TraceFriction& test) {
          return std::isfinite(test.speed_mps);
        });
    checks.push_back({"pull tests behind the friction",
                      fmt::format("{}", *mu.tests) +
                          (is_known ? "" : "; their travel or speed is not known") +
                          (others == 0 ? ""
                                       : fmt::format("; {} of {} in all directions are shorter "
                                                     "or at another speed",
                                                     others, mu.traces.size())),
                      fmt::format("{} or more: {}", least_pull_tests, pull_test_provision()),
                      *mu.tests >= least_pull_tests && others == 0});
  }
  return checks;
}

std::vector<DesignCheck> checks_of_scaling(const Project& project, const Plan& demand) {
  if (project.of_roof || !takes_exception_2(project.site.mapped.value_or(project.site.target)))
    return {};
  std::vector<double> factors = demand.factor_at_unit_level;
  for (double& factor : factors) factor *= dbe_level(project);
  return {exception_2_check(project, demand.scaling_spectra.front(), factors,
                            period_range(project.scaling_rule, demand.first_periods))};
}

std::string separations_not_stated(const Project& project) {
  std::vector<std::string> names;
  const std::vector<Separation> all = separations_of(project.standard, 1.0);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!project.available_m[i]) names.push_back(all[i].what);
  if (names.empty()) return "";
  return fmt::format(
      "available separations are not stated ([clearances]), without which the verdict is \"not "
      "stated\": {}",
      fmt::join(names, ", "));
}

std::string not_met_text(const DesignCheck& check) {
  return fmt::format("a check is not met: {}: {}; required: {}", check.what, check.found,
                     check.criterion);
}

std::vector<DesignCheck> checks_of(const Project& project, const Results& demand,
                                   const DesignClearance& design) {
  std::vector<DesignCheck> checks;
  if (!project.of_roof) checks = spectrum_checks(project, demand);
  if (!project.of_roof && takes_exception_2(project.site.mapped.value_or(project.site.target)))
    checks.push_back(exception_2_check(project, demand.suites.front().spectra));
  checks.push_back(roof_check(design));
  const std::size_t records = demand.records.size();
  std::vector<std::string> without_vertical;
  for (const RecordSummary& record : demand.records) {
    if (!record.has_vertical) without_vertical.push_back(record.id);
  }
  const bool governs_without = design.vertical == VerticalChoice::none;
  checks.push_back({"records with vertical motion",
                    fmt::format("{} of {}{}{}", records - without_vertical.size(), records,
                                without_vertical.empty() ? "" : "; without: ",
                                fmt::join(without_vertical, ", ")) +
                        (governs_without ? "; without it the displacement is larger" : ""),
                    "all, or a displacement that is larger without (give the missing files, or a "
                    "suite without these records)",
                    governs_without || without_vertical.empty()});
  const std::vector<std::string> lifted = records_with_uplift(demand, at_dbe);
  checks.push_back({"records at DBE under which the array lifts off",
                    lifted.empty() ? "none"
                                   : fmt::format("{} of {}: {}", lifted.size(), records,
                                                 fmt::join(lifted, ", ")),
                    "none: uplift is outside the model; the array requires attachment against it, "
                    "or an analysis by other means",
                    lifted.empty()});
  if (project.standard == Standard::seaoc_pv1_2012) {
    constexpr double least_s = 30.0;  // recalled
    const auto is_short = [&](const RecordSummary& record) {
      return record.dt_s * static_cast<double>(record.samples) < least_s;
    };
    const auto too_short = std::ranges::count_if(demand.records, is_short);
    checks.push_back(
        {"records shorter than 30 s", fmt::format("{} of {}", too_short, records),
         "none: " + analysis_provision(project.standard) +
             (project.of_roof
                  ? ""
                  : "; here the motions are of the ground, and the roof's are computed"),
         too_short == 0});
  }
  const bool finite = std::ranges::all_of(
      design.demand, [](const PeriodDemand& d) { return std::isfinite(d.largest_m); });
  checks.push_back(
      {"histories without a finite displacement", finite ? "none" : "some", "none", finite});
  const std::vector<DesignCheck> known = checks_before_analysis(project, records);
  checks.insert(checks.end(), known.begin(), known.end());
  return checks;
}

}  // namespace glissade
