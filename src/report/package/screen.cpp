// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "glissade/core/wrap.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/package.hpp"
#include "glissade/study/plan/one_mass.hpp"
#include "package/tables.hpp"
#include "package/units.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// "label      value", within 80 columns.
std::string line(const std::string& label, const std::string& value) {
  return fmt::format("{:<11}{}\n", label, value);
}

/// Of the building with the lowest ratio to what the standards have.
std::string roof_acceleration_text(const DesignClearance& design) {
  const RoofPeak& roof = *std::ranges::min_element(design.roof, {}, &RoofPeak::over_standards);
  return fmt::format("median {:.2f} g, 84th {:.2f} g at DBE; ASCE 7-16 {:.2f} g{}; ratio {:.2f}",
                     roof.median_g, roof.p84_g, roof.asce7_16_g,
                     roof.asce7_22_g ? fmt::format(", 7-22 {:.2f} g", *roof.asce7_22_g) : "",
                     roof.over_standards());
}

std::string inputs_lines(const CalculationPackage& package) {
  const Project& p = package.project;
  const SiteValues& site = package.design.site;
  const SpectralRatios& ratios = package.demand.suites.front().spectra.to_target;
  return line("Site",
              fmt::format("S_MS {:.3f} g, S_M1 {:.3f} g, S_DS {:.3f} g, S_D1 {:.3f} g, category {}",
                          site.sms_g(), site.sm1_g(), site.sds_g, site.sd1_g,
                          category_text(p.site, site))) +
         line("Building",
              p.of_roof ? "none is computed: the motions are those of its roof"
                        : fmt::format("period {}, {}", range_text(p.building.period_s, " s"),
                                      p.building.alpha.empty()
                                          ? "mass ratio " + range_text(p.building.mass_ratio, "")
                                          : "modes of a cantilever, alpha " +
                                                range_text(p.building.alpha, ""))) +
         line("Roof", fmt::format("slope {}; friction {:.3f}, std {:.3f}, design {:.3f}",
                                  range_text(p.slope_deg, " deg"), p.friction.mean, p.friction.std,
                                  p.friction.design())) +
         line("Motions", p.of_roof ? fmt::format("{} of the roof, factor {:g}",
                                                 counted_records(package.demand), p.roof_factor)
                                   : fmt::format("{}, {:.2f} to {:.2f} times the design spectrum",
                                                 counted_records(package.demand),
                                                 ratios.lowest.ratio, ratios.highest.ratio)) +
         line("Roof peak", roof_acceleration_text(package.design));
}

std::string demand_lines(const CalculationPackage& package) {
  const bool of_roof = package.project.of_roof;
  std::string text = fmt::format(
      "\nDisplacement at DBE, governing orientation{}\n{:>10}{:>12}{:>12}{:>12}{:>12}\n",
      of_roof ? " and slope"
              : std::string(", slope and ") +
                    (package.project.building.alpha.empty() ? "mass ratio" : "\u03b1_0"),
      of_roof ? "" : "period, s", "mean", "84th", "95th", "largest");
  for (const PeriodDemand& d : package.design.demand) {
    text += fmt::format("{:>10}{:>12}{:>12}{:>12}{:>12}\n",
                        of_roof ? "" : fmt::format("{:.3g}", d.period_s), length_in(d.mean_m),
                        length_in(d.p84_m), length_in(d.p95_m), length_in(d.largest_m));
  }
  const bool is_skewed = std::ranges::any_of(
      package.design.demand, [](const PeriodDemand& d) { return d.p84_m < d.mean_m; });
  if (is_skewed) text += std::string("  ") + percentile_note + "\n";
  const std::string open = open_percentile(package.demand);
  return open.empty() ? text : text + wrapped(open);
}

std::string governing_lines(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  const ProjectBuilding& building = package.project.building;
  const bool is_too_little = !package.project.of_roof && building.alpha.empty() &&
                             !one_mass_sentence(building.storeys, building.period_s.back()).empty();
  const std::string analysis = length_in_both(design.analysis_m) +
                               (is_too_little ? "; too little: one mass (see WARNING)" : "");
  std::string text =
      "\n" + line("Analysis", fmt::format("{:g} x the largest {}: {}", design.factor,
                                          design.of_largest ? "record" : "mean", analysis));
  for (const PrescribedValue& value : design.prescribed) {
    text += fmt::format(
        "{:<15}prescribes {}; {}\n", standard_name(value.standard),
        length_in_both(value.prescribed.value_m),
        value.may_be_used() ? "conditions are met" : "conditions NOT met or not stated");
    // Those of the project's standard are an open item.
    if (value.not_met() != of_standard(package.project, design).not_met() && !value.may_be_used())
      text += std::string(15, ' ') + wrapped(value.not_met(), terminal_width, 15) + "\n";
  }
  text +=
      line("GOVERNING", fmt::format("{}, rounded up to {}", length_in_both(design.governing_m, 1),
                                    length_in_both(design.rounded_m)));
  text += line("", "by " + governed_by(package));
  if (design.floor_governs) text += line("", "after peer review the analysis alone: " + analysis);
  return text + wrapped(deciding_sentence(design), terminal_width, 0) + "\n";
}

std::string separation_lines(const CalculationPackage& package) {
  std::string text = "\nSeparations\n";
  for (const ProjectSeparation& s : package.design.separations) {
    std::string verdict;
    if (s.available_m)
      verdict =
          fmt::format("available {}: {}", length_in(*s.available_m), verdict_text(s, package));
    const std::string required = fmt::format("  {:.1f} x  {:>10}  {}", s.required.factor,
                                             length_in(s.required.value_m), s.text());
    const bool fits = required.size() + 2 + verdict.size() <= terminal_width;
    text += required +
            (verdict.empty() ? "" : (fits ? "  " : "\n" + std::string(21, ' ')) + verdict) + "\n";
  }
  text += wrapped(verdict_sentence(package));
  for (const std::string& item : open_items(package.design)) text += wrapped("Open: " + item + ".");
  text += "\nProbability that the governing displacement is exceeded\n";
  const DisplacementExceedance& governing = package.design.compared.front();
  for (const ExceedanceAt& e : {governing.dbe, governing.mce})
    text +=
        fmt::format("  {}  {}{}{}\n", e.level, format_share(e.probability), in_brackets(e.interval),
                    package.project.of_roof ? "" : fmt::format(", period {:.3g} s", e.period_s));
  text += wrapped(accepted_sentence(package.design), terminal_width, 2) + "\n";
  return text +
         (package.probability.hazard || package.project.of_roof
              ? wrapped(hazard_sentence(package), terminal_width, 0)
              : "Annual rates are not computed: give [hazard] (glissade explain hazard)") +
         "\n";
}

}  // namespace

std::string package_screen(const CalculationPackage& package) {
  const LengthUnits units(package.project.units);
  std::string text = wrapped(package.project.title.name, terminal_width, 0) + "\n" +
                     governing_lines(package) + separation_lines(package) + "\n";
  for (const std::string& warning : other_warnings(package.design))
    text += wrapped("WARNING: " + warning, terminal_width, 2) + "\n";
  return text + inputs_lines(package) + demand_lines(package);
}

}  // namespace glissade
