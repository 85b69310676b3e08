// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "at_one_g.hpp"
#include "link_comparison.hpp"
#include "verification/gnuplot.hpp"

namespace glissade::verification {
namespace {

/// Exact slip over a fine grid of friction, and the models' points.
void draw_roof(const std::vector<LinkRun>& runs, const Motion& first, double slope_deg,
               const std::filesystem::path& file) {
  std::string script = "$exact << EOD\n";
  const double lowest = slope_deg == 0.0 ? 0.02 : 0.1, highest = slope_deg == 0.0 ? 0.7 : 0.6;
  constexpr int points = 300;
  for (int i = 0; i <= points; ++i) {
    const double mu = lowest + (highest - lowest) * i / points;
    const SlipResult r = slide(at_one_g(first), LinkScene{mu, slope_deg}.block());
    script += fmt::format("{} {} {}\n", mu, 1e3 * r.peak_displacement_m,
                          1e3 * std::abs(r.residual.along_m));
  }
  script += "EOD\n$models << EOD\n";
  for (const LinkRun& run : runs) {
    if (run.motion > 0 || run.scene.slope_deg != slope_deg) continue;
    const test::LinkSlip &link = run.by_model[paper_link], &scheme = run.by_model[scheme_64];
    script += fmt::format("{} {} {} {} {}\n", run.scene.friction, 1e3 * link.peak_displacement_m,
                          1e3 * std::abs(link.residual.along_m), 1e3 * scheme.peak_displacement_m,
                          1e3 * std::abs(scheme.residual.along_m));
  }
  script += fmt::format(
      "EOD\nset title '{}'\nset xlabel 'friction coefficient'\nset ylabel 'relative deflection in "
      "plan, mm'\nset logscale y\nset format y '%g'\nset xrange [0:0.75]\n"
      "set key bottom left reverse Left\nset yrange [{}]\n"
      "plot $exact using 1:2 with lines lw 5 lc rgb '#8fb4d9' title 'PRD, exact', "
      "$exact using 1:3 with lines lw 1.6 lc rgb '#b3361b' title 'RRD, exact', "
      "$models using 1:2 with points pt 4 ps 1.5 lw 1.6 lc rgb '#1f5a96' title 'PRD, elastic "
      "link', "
      "$models using 1:3 with points pt 6 ps 0.9 lw 1.6 lc rgb '#b3361b' title 'RRD, elastic "
      "link', "
      "$models using 1:4 with points pt 2 ps 0.7 lw 1.4 lc rgb '#111111' title 'PRD and RRD, "
      "published scheme, P = 64', $models using 1:5 with points pt 2 ps 0.7 lw 1.4 lc rgb "
      "'#111111' "
      "notitle\n",
      slope_deg == 0.0 ? "flat roof" : "slope of 4 degrees",
      slope_deg == 0.0 ? "0.01:1000" : "1:3000");
  gnuplot_svg(file, script);
}

}  // namespace

void draw_links(const std::vector<LinkRun>& runs, const Motion& first,
                const std::filesystem::path& figures) {
  draw_roof(runs, first, 0.0, figures / "first_paper_flat.svg");
  draw_roof(runs, first, 4.0, figures / "first_paper_4deg.svg");
}

}  // namespace glissade::verification
