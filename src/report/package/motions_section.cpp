// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "glissade/motion/suite_scaling.hpp"
#include "package/sections.hpp"
#include "package/tables.hpp"

namespace glissade {
namespace {

Html suite_html(const SuiteSummary& suite) {
  return enclosed("<p>", "Suite: " + suite.name + (suite.description.empty() ? "" : ": "), "") +
         given_text(suite.description) + ".</p>\n";
}

Html roof_motions_html(const CalculationPackage& package) {
  const SuiteSummary& suite = package.demand.suites.front();
  return suite_html(suite) +
         paragraph(fmt::format(
             "Its motions are those of the roof on which the array stands, of a "
             "model of the building or recorded in it; they are used without a building and "
             "without "
             "a design spectrum. At DBE each is multiplied by {:g} (and by its scale in the "
             "suite), "
             "at MCE by 1.5 times that: a building that yields would have other motions there. "
             "The orientations swap and mirror the "
             "components: slopes along either axis of the building, in either direction.",
             package.project.roof_factor)) +
         page_table(motions_table(package.demand.records, package.files, package.project.of_roof)) +
         page_table(scaled_motions_table(package));
}

}  // namespace

Html motions_html(const CalculationPackage& package, const std::vector<DrawnFigure>& figures) {
  if (package.project.of_roof) return roof_motions_html(package);
  const SuiteSpectra& spectra = package.demand.suites.front().spectra;
  const SpectralRatios& ratios = spectra.to_target;
  const double to_s = judged_to_s(periods_of(package.project).back());
  const std::string beyond =
      to_s > longest_scaled_period_s && !package.project.without_target
          ? fmt::format(
                ", and nowhere below {:g} times it from there to {:.3g} s, 1.5 times the "
                "longest building period of the demand study (by no clause)",
                least_over_target_beyond, to_s)
          : "";
  const bool by_walters = spectra.rule == ScalingRule::walters_2012;
  const std::string rule =
      by_walters ? "its average SRSS spectrum is the design spectrum or more at each period of the "
                   "scaling rule, 0 to 2 s (Walters et al. 2012)" +
                       beyond +
                       ". This is the rule of the paper, and none of ASCE 7: that of an edition is "
                       "suite.scaling_rule of the project"
                 : fmt::format("it meets {}: its {}, here from {:.3g} to {:.3g} s, at DBE and MCE",
                               text_of(spectra.rule).clause, text_of(spectra.rule).spectrum,
                               spectra.range.from_s, spectra.range.to_s);
  return suite_html(package.demand.suites.front()) +
         paragraph(fmt::format(
             "The suite, with its own scales, is multiplied by one factor, {:.4g} "
             "to "
             "DBE, so that {}. {} the lowest is {:.3f} times the design spectrum (at {:.3g} s), "
             "the highest "
             "{:.3f} times (at {:.3g} s){}. MCE is 1.5 times DBE.",
             package.demand.records.front().factor_at_unit_level * dbe_level(package.project) /
                 package.demand.records.front().suite_scale,
             rule, by_walters ? "Between these periods" : "There", ratios.lowest.ratio,
             ratios.lowest.period_s, ratios.highest.ratio, ratios.highest.period_s,
             by_walters ? "" : fmt::format(", the mean {:.3f} times", spectra.mean_ratio))) +
         page_table(motions_table(package.demand.records, package.files, package.project.of_roof)) +
         page_table(scaled_motions_table(package)) + page_table(record_spectra_table(package)) +
         figure_html(figures.front(), 1);
}

}  // namespace glissade
