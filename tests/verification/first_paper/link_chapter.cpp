// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "at_one_g.hpp"
#include "glissade/io/suite_file.hpp"
#include "link_comparison.hpp"
#include "verification/chapters.hpp"

namespace glissade::verification {
namespace {

/// How far the link may be off: it begins to slide with the velocity of its ringing spring, which
/// is at most 2 mu g / omega as its force stays within +-mu N, and keeps the difference while it
/// slides.
double bound_m(const LinkRun& run, const test::ElasticLink& link) {
  const Block block = run.scene.block();
  const double omega = explicit_step(link, block) / link.longest_substep_s;
  return 2.0 * block.friction.along * block.gravity_mps2 / omega * run.exact.slip_duration_s;
}

double largest_share_of_bound(const std::vector<LinkRun>& runs, Model model) {
  const auto share = [&](const LinkRun& run) {
    return residual_error_m(run, model) / bound_m(run, *link_models()[model].link);
  };
  return worse(spread(runs, {Roof::flat}, share).largest,
               spread(runs, {Roof::sloping}, share).largest);
}

double mean_error_m(const std::vector<LinkRun>& runs, Roof roof, Model model) {
  return spread(runs, {roof}, [&](const LinkRun& run) { return residual_error_m(run, model); })
      .mean;
}

double mean_error_of_peak(const std::vector<LinkRun>& runs, Roof roof, Model model) {
  return spread(runs, {roof},
                [&](const LinkRun& run) {
                  return residual_error_m(run, model) / run.exact.peak_displacement_m;
                })
      .mean;
}

/// Exponent of the mean error over 1/stiffness, from 100 to 10,000 N/mm.
double order_in_stiffness(const std::vector<LinkRun>& runs, Roof roof) {
  return std::log(mean_error_m(runs, roof, fine_step) / mean_error_m(runs, roof, stiffest)) /
         std::log(100.0);
}

/// On 4 deg, by how much the link beyond its stability limit slips too far, at least.
double smallest_divergence(const std::vector<LinkRun>& runs) {
  double smallest = INFINITY;
  for (const LinkRun& run : runs)
    if (run.scene.slope_deg > 0.0)
      smallest = std::min(
          smallest, run.by_model[unstable].peak_displacement_m / run.exact.peak_displacement_m);
  return smallest;
}

/// On a slope at rest, and under motions at the lowest friction the paper has there.
std::vector<Case> in_equilibrium(const std::vector<LinkRun>& runs) {
  const std::vector<double> still(1001, 0.0);
  double low_friction = 0.0;
  for (const LinkRun& run : runs)
    if (run.scene.slope_deg == 4.0 && run.scene.friction == 0.1)
      low_friction = worse(
          low_friction, residual_error_m(run, paper_link) / std::abs(run.exact.residual.along_m));
  return {compare({"still slope of 4 deg, mu 0.1, 10 s, the paper's link", "slip, m",
                   "static equilibrium, where the paper found SAP 2000 in error"},
                  {test::slide_on_elastic_link({0.01, still}, {0.1, 4.0 * rad_per_deg}, {})
                       .peak_displacement_m,
                   0.0, 1e-12, Metric::absolute}),
          limit({"slope of 4 deg, mu 0.1, the paper's link, 7 motions", "residual slip",
                 "slide(); there SAP 2000 was off; 1.69 %, the paper's mean on the flat roof",
                 ReferenceFrom::this_code},
                {"largest relative difference", low_friction, 0.0169})};
}

std::vector<Case> cases(const std::vector<LinkRun>& runs) {
  std::vector<Case> all;
  for (const Model model : {soft, paper_link, fine_step, stiff, stiffest})
    all.push_back(
        limit({link_models()[model].name, "residual slip",
               "slide(); 2 mu g / omega, the velocity error of a vibrating link, "
               "times the time of sliding",
               ReferenceFrom::this_code},
              {"largest share of that bound, of 112", largest_share_of_bound(runs, model), 1.0}));
  const std::string series = "elastic link from 100 to 10,000 N/mm, ";
  const std::string quantity = "mean error of residual slip over 1/stiffness";
  all.push_back(within({series + "flat roof", quantity, "slide(); 1/2, as of a velocity over omega",
                        ReferenceFrom::this_code},
                       {"observed order", order_in_stiffness(runs, Roof::flat), 0.4, 0.6}));
  all.push_back(within(
      {series + "4 deg", quantity, "slide(); between 1/2 and the 1 of the springs' own deflection",
       ReferenceFrom::this_code},
      {"observed order", order_in_stiffness(runs, Roof::sloping), 0.4, 1.0}));
  for (const Roof roof : {Roof::flat, Roof::sloping})
    all.push_back(
        limit({link_models()[stiffest].name + (roof == Roof::flat ? ", flat" : ", 4 deg"),
               "mean error of residual slip / peak slip",
               "slide(); a tenth of the 1.2 % of the paper's link, and twice that allowed",
               ReferenceFrom::this_code},
              {"mean relative difference", mean_error_of_peak(runs, roof, stiffest), 0.0024}));
  for (const Roof roof : {Roof::flat, Roof::sloping})
    all.push_back(
        limit({link_models()[scheme_64].name + (roof == Roof::flat ? ", flat" : ", 4 deg"),
               "mean error of residual slip / peak slip",
               "slide(); worst 0.48 % in the paper's fig. 5", ReferenceFrom::this_code},
              {"mean relative difference", mean_error_of_peak(runs, roof, scheme_64), 0.0048}));
  all.push_back(
      within({link_models()[unstable].name + ", 4 deg: omega dt = 3.13", "peak slip",
              "an explicit scheme is stable for omega dt < 2: it fails"},
             {"smallest ratio to slide(), of 42", smallest_divergence(runs), 10.0, INFINITY}));
  for (const Case& c : in_equilibrium(runs)) all.push_back(c);
  return all;
}

}  // namespace

Chapter first_paper_link(const Folders& folders) {
  const Suite suite = load_suite(folders.suites / "synthetic_level4.toml");
  const std::vector<LinkRun> runs = run_links(suite);
  draw_links(runs, suite.motions.front(), folders.figures);
  return {
      "1.2 Comparison with SAP 2000",
      "the exact solution, and the comparison in the paper",
      R"(The paper compares the residual displacement (RRD) of its scheme with that of SAP 2000, on a flat roof and
on 4 degrees. Which of the two has the error? The same cases are solved by `slide()`, which is exact, by
the published scheme, and by the link element of SAP 2000 as the paper describes it (tests/elastic_link):
weight 1 N, springs of 100 N/mm, no damping, explicit Newmark steps of 1 ms (gamma 1/2, beta 0). SAP 2000
itself was not run. PRD is the peak displacement.

The motions are the first horizontal components of suite level 4, each scaled to 1.0 g. Their step is
5 ms, that of the paper 10 ms: P = 32 has the substep of the paper. The slip of the link is without the
deflection of its spring. Its friction is elastic-plastic, or has the rounded curve of Wen (CSI Analysis
Reference Manual).

**Cause of the difference.** When the link stops sliding, it vibrates about the static force. It then
starts to slide again earlier, with a velocity of up to 2 mu g / omega. The error decreases with the square
root of the stiffness; a smaller substep alone changes little, so that agreement of two substeps does not
show it. The paper found similar results with 1,000 N/mm and does not state the substep. With 1 ms that is
unstable (omega dt > 2).

**Source of the error.** On the flat roof it is mainly the link: the difference remains when the exact
solution replaces the scheme. An error that is small relative to the peak is large relative to a residual.

**On 4 degrees** the link of the paper was not in equilibrium at the start, and had errors at low friction.
A link that starts in equilibrium agrees there too. With the curve of Wen it creeps down the slope.)",
      cases(runs),
      "![Flat roof: peak and residual displacement over friction](figures/first_paper_flat.svg)\n"
      "![Slope of 4 degrees: the same](figures/first_paper_4deg.svg)\n",
      link_tables(runs),
      link_findings(runs),
      {link_scenes(runs)}};
}

}  // namespace glissade::verification
