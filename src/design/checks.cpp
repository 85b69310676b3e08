// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"
#include "glissade/design/of_project.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/sampling/pull_test.hpp"
#include "glissade/study/plan/one_mass.hpp"

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
  const double longest_s = 1.5 * periods_of(project).back();
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
  constexpr double least = 0.5;
  const RoofPeak& roof = *std::ranges::min_element(design.roof, {}, &RoofPeak::over_standards);
  return {"median peak acceleration of the roof at DBE",
          fmt::format("{:.3f} g{}, {:.2f} times that of ASCE 7-16{}", roof.median_g,
                      roof.asce7_22_g ? fmt::format(" (period {:.3g} s)", roof.period_s) : "",
                      roof.median_g / roof.asce7_16_g,
                      roof.asce7_22_g ? fmt::format(" and {:.2f} times that of ASCE 7-22",
                                                    roof.median_g / *roof.asce7_22_g)
                                      : ""),
          fmt::format("{:g} or more of the acceleration of a roof by ASCE 7-16, 13.3.1, {:.3f} "
                      "g{}; the limit is of this program",
                      least, roof.asce7_16_g,
                      roof.asce7_22_g
                          ? fmt::format(", and by ASCE 7-22, 13.3.1, {:.3f} g", *roof.asce7_22_g)
                          : ""),
          roof.over_standards() >= least};
}

constexpr double most_rounding_m = foot_m;
/// Of the design friction, mean - 2 std, which is above what any number of tests supports: 7 tests
/// with a standard deviation of 8 % of the mean support 0.87 of it, 4 of them 0.70.
constexpr double least_supported = 0.75;

/// Outside of what buildings have. All limits are recalled.
std::vector<std::string> improbable_values(const ProjectBuilding& building, UnitSystem units) {
  constexpr double most_storeys = 163.0;                        // Burj Khalifa
  constexpr double least_storey_m = 2.2, most_storey_m = 8.0;   // height of a storey
  constexpr double most_single_storey_m = 30.0;                 // a hall
  constexpr double least_period_s = 0.02, most_period_s = 0.5;  // for each storey
  std::vector<std::string> texts;
  const double ta_s = building.approximate_period_s.value_or(building.period_s.front());
  if (ta_s < building.period_s.front() || ta_s > building.period_s.back())
    texts.push_back(fmt::format("building.period_bounds leave out T_a itself, {:.3g} s", ta_s));
  if (!building.storeys) return texts;
  const double storeys = *building.storeys;
  if (storeys > most_storeys)
    texts.push_back(fmt::format("{:g} storeys are more than any building has", storeys));
  const double most_m = storeys == 1.0 ? most_single_storey_m : most_storey_m;
  const double storey_m = building.height_m.value_or(0.0) / storeys;
  if (building.height_m && (storey_m < least_storey_m || storey_m > most_m))
    texts.push_back(fmt::format("{:g} storeys in a height of {}: {} for each is improbable",
                                storeys, both_units(*building.height_m, units),
                                both_units(storey_m, units)));
  const auto add_period = [&](double period_s, bool is_improbable) {
    if (is_improbable)
      texts.push_back(fmt::format("a building period of {:.3g} s is improbable with {:g} storeys",
                                  period_s, storeys));
  };
  const double shortest_s = building.period_s.front(), longest_s = building.period_s.back();
  add_period(shortest_s, shortest_s > most_period_s * storeys);
  add_period(longest_s, longest_s < least_period_s * storeys);
  return texts;
}

/// Of pull tests: a direction that is not the least favourable, and values to check.
std::vector<std::string> choices_of(const ProjectFriction& friction) {
  std::vector<std::string> texts;
  for (const DirectionFriction& d : friction.tested) {
    if (d.sliding.tests < 2)
      texts.push_back(fmt::format(
          "direction {} of the pull tests has one test, which gives no design friction: it is not "
          "used",
          d.direction));
    if (d.sliding.mean_minus_2_std < friction.design())
      texts.push_back(fmt::format(
          "friction.direction = \"{}\" has the design friction {:.3f}, direction {} only {:.3f}: "
          "the array slides in both",
          friction.direction, friction.design(), d.direction, d.sliding.mean_minus_2_std));
    for (const std::string& note : outliers_in(d)) texts.push_back("pull tests " + note);
    if (!d.note.empty()) texts.push_back("pull tests, " + d.note);
  }
  return texts;
}

/// What is said of a spectrum by points that nothing stands beside; else empty.
std::string unchecked_spectrum(const ProjectSite& site) {
  if (site.target.period_s.empty() || site.mapped) return "";
  return site.target.edition == AsceEdition::asce7_22
             ? "the spectrum is taken for the multi-period one of ASCE 7-22, 11.4.5.1; whether one "
               "of a site-specific analysis is 80 % of that or more (21.3) is "
               "not checked"
             : "whether the site-specific spectrum is 80 % of that of the site class or more "
               "(ASCE 7-16, 21.3) is not checked: give site.ss_g, s1_g and "
               "site_class beside the spectrum";
}

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
          fmt::format("{:g} or more (ASCE 7-16, 21.3, with F_a and F_v of that section)", least),
          lowest.ratio >= least};
}

/// Of a value whose conditions are not all met.
std::string conditions_text(const PrescribedValue& value) {
  return fmt::format(
      "conditions of the standard are not met or not stated ({}): an unanchored array "
      "then requires the approval of the authority",
      value.not_met());
}

std::string improbable_hazard(const Project& project) {
  const double sms_g = site_values(project.site).sms_g();
  const double rate = HazardCurve(project.hazard->points).annual_rate(sms_g);
  return improbable_mce_rate(rate, fmt::format("S_MS, {:.3g} g,", sms_g));
}

}  // namespace

std::string both_units(double length_m, UnitSystem units) {
  const bool is_long = length_m > 2.0;
  const std::string us = is_long ? fmt::format("{:.3g} ft", length_m / foot_m)
                                 : fmt::format("{:.1f} in", length_m / inch_m);
  const std::string si = fmt::format("{:.3g} m", length_m);
  return units == UnitSystem::si ? si + " (" + us + ")" : us + " (" + si + ")";
}

namespace {

std::vector<DesignWarning> warnings_on(const Project& project) {
  std::vector<DesignWarning> warnings;
  const auto add = [&](bool met, const std::string& text, bool is_reservation = false) {
    if (met) warnings.push_back({text, is_reservation});
  };
  const auto add_all = [&](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) warnings.push_back({text});
  };
  const bool site_7_16 = project.site.target.edition == AsceEdition::asce7_16;
  const bool by_7_16 = project.standard == Standard::asce7_16;
  add(project.peer_reviewed,
      "standards.peer_reviewed = true: the least value of the standard is not applied");
  add(site_7_16 != by_7_16,
      "the standard that is applied is not that of the site's edition of ASCE 7: its least value "
      "differs");
  add(project.importance < importance_factor(project.site.risk),
      fmt::format("the importance factor {:g} is below that of risk category {}",
                  project.importance, to_string(project.site.risk)));
  const auto prescribed = prescribed_values(project, site_values(project.site));
  const auto standard = std::ranges::find(prescribed, project.standard, &PrescribedValue::standard);
  add(!standard->may_be_used(), conditions_text(*standard), true);
  add(site_7_16 && !project.site.target.is_mapped() && project.site.target.period_s.empty() &&
          project.site.target.hazard_analysis.empty(),
      "S_DS and S_D1 are stated without S_S, S_1 and site class: whether ASCE 7-16, 11.4.8 "
      "requires a ground motion hazard analysis is not checked");
  const std::string unchecked = unchecked_spectrum(project.site);
  add(!unchecked.empty(), unchecked, project.site.target.edition != AsceEdition::asce7_22);
  add(!project.of_roof && !project.site.states_tl && project.site.target.period_s.empty(),
      fmt::format("site.tl_s is not stated: T_L = {:g} s is assumed", project.site.target.tl_s));
  add(project.friction.mean < 2.0 * project.friction.std,
      fmt::format("mean - 2 std of the friction is {:.3g}: 0 is taken",
                  project.friction.mean - 2.0 * project.friction.std));
  const auto add_found = [&](const std::string& text) { add(!text.empty(), text); };
  if (!project.of_roof) {
    add_all(improbable_values(project.building, project.units));
    add_found(gaps_between(project.building.period_s));
    add_found(improbable_mass_ratio(project.building.mass_ratio.back()));
    add_found(improbable_damping(project.building.damping));
    if (project.building.alpha.empty())
      add_found(one_mass_sentence(project.building.storeys, project.building.period_s.back()));
  }
  std::vector<std::optional<double>> available_m = project.available_m;
  for (const ProjectGap& gap : project.gaps) available_m.emplace_back(gap.available_m);
  for (const auto& clearance_m : available_m)
    add(clearance_m && *clearance_m > largest_probable_clearance_m,
        fmt::format("a clearance of {} is more than a roof has",
                    both_units(clearance_m.value_or(0.0), project.units)));
  add(project.round_up_m > most_rounding_m,
      fmt::format("displacements are rounded up to steps of {}",
                  both_units(project.round_up_m, project.units)));
  add(project.friction.std == 0.0,
      "the friction has no scatter (std 0): its design value is the mean");
  add(project.friction.mean > most_probable_friction,
      fmt::format("a mean friction of {:.3g} is above {:g}: no roof is known for it",
                  project.friction.mean, most_probable_friction));
  add_found(unmarked_numbers(project.unmarked_numbers));
  add_all(choices_of(project.friction));
  if (project.hazard) {
    add_found(improbable_hazard(project));
    add_found(improbable_rates(HazardCurve(project.hazard->points)));
    add_found(improbable_design_life(project.hazard->design_life_years));
  }
  add_found(improbable_slope(project.slope_deg.front()));
  return warnings;
}

}  // namespace

std::vector<std::string> choices_of(const Project& project) {
  return texts_of(warnings_on(project));
}

const PrescribedValue& of_standard(const Project& project, const DesignClearance& design) {
  const auto value =
      std::ranges::find(design.prescribed, project.standard, &PrescribedValue::standard);
  GLISSADE_EXPECTS(value != design.prescribed.end());
  return *value;
}

std::vector<std::string> reservations_on(const Project& project, const DesignClearance& design) {
  std::vector<std::string> found;
  if (std::string unchecked = unchecked_spectrum(project.site);
      !unchecked.empty() && project.site.target.edition != AsceEdition::asce7_22)
    found.push_back(std::move(unchecked));
  if (std::string required = hazard_analysis_required(project.site.target);
      !required.empty() && project.site.target.hazard_analysis.empty())
    found.push_back(required + ": state site.hazard_analysis");
  if (const PrescribedValue& value = of_standard(project, design); !value.may_be_used())
    found.push_back(conditions_text(value));
  for (const DesignCheck& check : design.checks)
    if (!check.is_met) found.push_back(not_met_text(check));
  return found;
}

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

namespace {

/// Levels of the demand study.
constexpr std::size_t at_dbe = 0, at_mce = 1;

}  // namespace

std::vector<DesignCheck> checks_before_analysis(const Project& project, std::size_t records) {
  std::vector<DesignCheck> checks;
  checks.push_back({"records", fmt::format("{}", records),
                    fmt::format("{} or more; of fewer the largest counts in place of the mean "
                                "(SEAOC PV1-2012); 11 by ASCE 7-16, 16.2.2, for structures",
                                least_records),
                    records >= least_records});
  if (project.site.mapped) checks.push_back(site_specific_check(project.site));
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

std::string not_met_text(const DesignCheck& check) {
  return fmt::format("a check is not met: {}: {}; required: {}", check.what, check.found,
                     check.criterion);
}

std::vector<DesignCheck> checks_of(const Project& project, const Results& demand,
                                   const DesignClearance& design) {
  std::vector<DesignCheck> checks;
  if (!project.of_roof) checks = spectrum_checks(project, demand);
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

std::vector<DesignWarning> warnings_on(const Project& project, const Results& demand,
                                       const DesignClearance& design) {
  std::vector<DesignWarning> warnings;
  const auto add = [&](std::string text) { warnings.push_back({std::move(text)}); };
  std::ranges::for_each(texts_of(demand.warnings), add);
  std::ranges::move(warnings_on(project), std::back_inserter(warnings));
  for (const DesignCheck& check : design.checks) {
    if (!check.is_met) warnings.push_back({not_met_text(check), true});
  }
  if (const auto lifted = records_with_uplift(demand, at_mce); !lifted.empty())
    add(fmt::format(
        "at the MCE the array lifts off under {} of {} records ({}): the probability of exceedance "
        "at the MCE is outside the model; the required clearance is of the DBE",
        lifted.size(), demand.records.size(), fmt::join(lifted, ", ")));
  for (const StudiedFriction& mu : frictions_of(project)) {
    if (mu.what != bound_name(project.friction)) continue;
    const double clearance_m = required_m(project, demand, mu.value);
    if (clearance_m > design.governing_m)
      add(fmt::format(
          "with friction {:.3f} ({}) the required displacement, {}, is above the governing one",
          mu.value, mu.what, both_units(clearance_m, project.units)));
  }
  const bool moves = design.demand.back().largest_m > 0.0 || design.analysis_m > 0.0;
  if (project.of_roof) return warnings;
  if (moves && design.demand.size() == 1) {
    add(fmt::format(
        "one building period is given, {:.3g} s: at others the displacement may be larger",
        design.period_s));
  } else if (moves && (design.period_s == design.demand.front().period_s ||
                       design.period_s == design.demand.back().period_s)) {
    add(fmt::format(
        "the displacement is largest at an end of the range of periods, {:.3g} s: outside the "
        "range it may be larger; where the period may be outside, widen {}",
        design.period_s,
        project.building.approximate_period_s ? "building.period_bounds" : "building.period_s"));
  }
  return warnings;
}

}  // namespace glissade
