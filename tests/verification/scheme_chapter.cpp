// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "chapters.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "glissade/io/suite_file.hpp"
#include "gnuplot.hpp"

namespace glissade::verification {
namespace {

/// Error of the residual slip relative to the peak slip, over all scenes that slip.
struct Errors {
  int substeps;
  double median, largest;
};

std::vector<Errors> errors_by_substeps(const Suite& suite) {
  std::vector<Errors> errors;
  for (int substeps = 1; substeps <= 512; substeps *= 2) {
    std::vector<double> relative;
    for (const Motion& m : suite.motions)
      for (const double mu : {0.1, 0.3, 0.5})
        for (const double slope_deg : {-4.0, 0.0, 4.0}) {
          const RoofAcceleration roof{m.dt_s, m.horizontal_mps2[0], m.vertical_mps2, m.scale,
                                      m.scale};
          const Block block{mu, slope_deg * rad_per_deg};
          const SlipResult exact = slide(roof, block);
          if (exact.peak_displacement_m == 0.0) continue;
          const SlipResult stepped = slide_rodriguez_nikl(roof, block, substeps);
          relative.push_back(std::abs(stepped.residual.along_m - exact.residual.along_m) /
                             exact.peak_displacement_m);
        }
    std::ranges::sort(relative);
    errors.push_back({substeps, relative[relative.size() / 2], relative.back()});
  }
  return errors;
}

/// Slope of the least-squares line of ln error over -ln P, from P = 4 up.
double order(const std::vector<Errors>& errors, double Errors::*which) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Errors& e : errors) {
    if (e.substeps < 4) continue;
    const double u = -std::log(e.substeps), v = std::log(e.*which);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

void draw(const std::vector<Errors>& errors, const std::filesystem::path& figures) {
  std::string script = "$data << EOD\n";
  for (const Errors& e : errors)
    script += fmt::format("{} {} {}\n", e.substeps, e.median, e.largest);
  script += fmt::format(
      "EOD\nset logscale xy\nset xrange [0.8:640]\nset yrange [1e-4:3]\nset format y '%g'\n"
      "set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512)\n"
      "set xlabel 'substeps P per sample interval'\nset ylabel 'error of residual slip / peak "
      "slip'\nset key top right\n"
      "plot $data using 1:3 with linespoints lw 2 pt 5 ps 0.6 lc rgb '#b3361b' title 'largest of "
      "the scenes', "
      "$data using 1:2 with linespoints lw 2 pt 7 ps 0.6 lc rgb '#1f5a96' title 'median of the "
      "scenes', "
      "{}/x with lines lw 1.2 dt 2 lc rgb '#555555' title 'first order, 1/P'\n",
      errors[3].median * errors[3].substeps);
  gnuplot_svg(figures / "published_scheme.svg", script);
}

}  // namespace

Chapter published_scheme(const Folders& folders) {
  const auto errors = errors_by_substeps(load_suite(folders.suites / "synthetic_level2.toml"));
  draw(errors, folders.figures);
  const std::string source = "slide(); first order of an explicit step, 1";
  return {
      "3.2 Sliding block: the published scheme",
      "Rodriguez-Nikl et al. 2019, Fig. 5",
      R"(The scheme of Rodriguez-Nikl et al. (2019) must converge to the exact solution with first order. 63 scenes:
the seven motions of suite level 2 with their verticals, slopes of -4, 0 and 4 degrees, friction 0.1, 0.3
and 0.5. The error is that of the residual slip, relative to the exact peak displacement.)",
      {within({"63 scenes, P from 4 to 512", "median error of residual slip", source,
               ReferenceFrom::this_code},
              {"observed order", order(errors, &Errors::median), 0.85, 1.15}),
       within({"63 scenes, P from 4 to 512", "largest error of residual slip", source,
               ReferenceFrom::this_code},
              {"observed order", order(errors, &Errors::largest), 0.85, 1.15}),
       limit({"63 scenes, P = 64, the paper's choice", "median error of residual slip / peak slip",
              "Rodriguez-Nikl et al. 2019, fig. 5: worst 0.48 % with their motion"},
             {"relative difference", errors[6].median, 0.0048})},
      "![Error of the published scheme over its substeps](figures/published_scheme.svg)\n"};
}

}  // namespace glissade::verification
