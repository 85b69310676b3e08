// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// The lowest ratio of the suite's average spectrum to the design spectrum in (from, to].
double lowest_ratio(const SuiteSpectra& spectra, double from_s, double to_s) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spectra.periods_s.size(); ++i) {
    if (spectra.periods_s[i] > from_s && spectra.periods_s[i] <= to_s)
      lowest = std::min(lowest, spectra.average_srss_g[i] / spectra.target_g[i]);
  }
  return lowest;
}

std::vector<DesignCheck> spectrum_checks(const Project& project, const Results& demand) {
  const SuiteSpectra& spectra = demand.suites.front().spectra;
  const SpectralRatio lowest = spectra.to_target.lowest;
  std::vector<DesignCheck> checks{
      {"average SRSS spectrum of the suite over the design spectrum, 0 to 2 s",
       fmt::format("{:.3f} or more (at {:.3g} s)", lowest.ratio, lowest.period_s),
       "0.99 or more (Walters et al. 2012: nowhere below)", lowest.ratio >= 0.99}};
  const double longest_s = 1.5 * project.building.period_s.back();
  if (longest_s <= 2.0) return checks;
  const double known_s = spectra.periods_s.back();
  const double ratio = lowest_ratio(spectra, 2.0, std::min(longest_s, known_s));
  checks.push_back(
      {fmt::format("the same from 2 s to {:.3g} s, 1.5 times the longest period", longest_s),
       fmt::format("{:.3f} or more{}", ratio,
                   longest_s > known_s ? fmt::format(", not known beyond {:g} s", known_s) : ""),
       "0.9 or more (ASCE 7-16, 16.2, recalled)", ratio >= 0.9 && longest_s <= known_s});
  return checks;
}

/// What the project states that makes the result smaller, or that is improbable.
std::vector<std::string> choices_of(const Project& project, const DesignClearance& design) {
  std::vector<std::string> texts;
  const auto add = [&](bool met, const std::string& text) {
    if (met) texts.push_back(text);
  };
  const bool site_7_16 = project.site.target.edition == AsceEdition::asce7_16;
  const bool by_7_16 = project.standard == Standard::asce7_16;
  add(project.peer_reviewed,
      "standard.peer_reviewed = true: the least value of the standard is not applied");
  add(site_7_16 != by_7_16,
      "the standard that is applied is not that of the site's edition of ASCE 7: its least value "
      "differs");
  add(project.importance < importance_factor(project.site.risk),
      fmt::format("the importance factor {:g} is below that of risk category {}",
                  project.importance, to_string(project.site.risk)));
  add(!is_within_standard(project, design),
      "the project is outside the conditions of its standard, or does not state them all: an "
      "unanchored array then needs the approval of the authority");
  add(project.friction.std == 0.0,
      "the friction has no scatter (std 0): its design value is the mean");
  add(project.friction.design() > 1.0,
      fmt::format("a friction of {:.3g} is improbable", project.friction.design()));
  return texts;
}

}  // namespace

std::vector<DesignCheck> checks_of(const Project& project, const Results& demand,
                                   const DesignClearance& design) {
  std::vector<DesignCheck> checks = spectrum_checks(project, demand);
  const std::size_t records = demand.records.size();
  checks.push_back({"records", fmt::format("{}", records),
                    fmt::format("{} or more; of fewer the largest counts in place of the mean "
                                "(SEAOC PV1-2012, recalled)",
                                least_records),
                    records >= least_records});
  const auto vertical = std::ranges::count_if(demand.records, &RecordSummary::has_vertical);
  checks.push_back({"records with vertical motion", fmt::format("{} of {}", vertical, records),
                    "all", static_cast<std::size_t>(vertical) == records});
  for (const auto& [name, level] : {std::pair{"DBE", 0u}, std::pair{"MCE", 1u}}) {
    const HistoryTable& histories = demand.histories;
    const double share = mean_of(histories, histories.fields.uplift, {0, histories.cases}, level);
    checks.push_back({fmt::format("histories at {} in which the array lifts off", name),
                      fmt::format("{:.2g} %", 100.0 * share), "0 %: uplift is outside the model",
                      share == 0.0});
  }
  const bool finite = std::ranges::all_of(
      design.demand, [](const PeriodDemand& d) { return std::isfinite(d.largest_m); });
  checks.push_back(
      {"histories without a finite displacement", finite ? "none" : "some", "none", finite});
  const ProjectFriction& mu = project.friction;
  if (mu.lower_bound) {
    checks.push_back({"design friction", fmt::format("{:.3f}", mu.design()),
                      fmt::format("not above {:.3f}, which this number of tests supports with 95 % "
                                  "confidence",
                                  *mu.lower_bound),
                      mu.design() <= *mu.lower_bound});
  }
  return checks;
}

std::vector<std::string> warnings_on(const Project& project, const Results& demand,
                                     const DesignClearance& design) {
  std::vector<std::string> warnings = choices_of(project, design);
  warnings.insert(warnings.end(), demand.warnings.begin(), demand.warnings.end());
  for (const DesignCheck& check : design.checks) {
    if (!check.is_met)
      warnings.push_back(fmt::format("a check is not met: {}: {}; required: {}", check.what,
                                     check.found, check.criterion));
  }
  if (design.period_s == design.demand.front().period_s ||
      design.period_s == design.demand.back().period_s)
    warnings.push_back(
        fmt::format("the displacement is largest at an end of the range of periods, {:.3g} s: "
                    "outside the range it may be larger",
                    design.period_s));
  for (const ProjectSeparation& s : design.separations) {
    if (s.available_m && *s.available_m < s.required.value_m)
      warnings.push_back("the clearance at hand is not sufficient " + s.required.what);
  }
  return warnings;
}

}  // namespace glissade
