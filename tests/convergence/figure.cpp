// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report.hpp"
#include "verification/gnuplot.hpp"

namespace glissade::convergence {
namespace {

constexpr const char *blue = "#0072b2", *green = "#00755a", *grey = "#555555", *red = "#b3361b";

/// A line of the figure, and its name above it, along it from the point at step `name_from`.
struct Line {
  const char *colour, *name;
  double name_slope_deg;
  std::size_t name_from;
  std::vector<double> values;  ///< by step; a logarithmic axis has no place for zero
};

std::string plot_lines(const std::vector<Line>& lines, double paper_value) {
  std::string labels = "unset label\n", blocks, plot;
  std::size_t count = 0;
  for (const Line& line : lines) {
    const std::string block = fmt::format("$line{}", count++);
    blocks += block + " << EOD\n";
    for (std::size_t step = 0; step < line.values.size(); ++step)
      if (line.values[step] > 0.0)
        blocks += fmt::format("{} {}\n", paper_substeps[step], line.values[step]);
    blocks += "EOD\n";
    plot += fmt::format("{} using 1:2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '{}', ", block,
                        line.colour);
    labels += fmt::format("set label '{}' at {},{} rotate by {} offset 0,0.8 tc rgb '{}'\n",
                          line.name, paper_substeps[line.name_from], line.values[line.name_from],
                          line.name_slope_deg, line.colour);
  }
  return blocks + labels +
         fmt::format("set label 'paper: {}' at {},{} right offset -1.2,0.4 tc rgb '{}'\n",
                     paper_value == 100.0 * paper_largest_error
                         ? fmt::format("{:g} %", paper_value)
                         : fmt::format("less than {:g} ms", paper_value),
                     paper_substeps[chosen_step], paper_value, red) +
         fmt::format(
             "plot {}'+' using ({}):({}) every ::0::0 with points pt 3 ps 1.6 lw 2 lc rgb '{}'\n",
             plot, paper_substeps[chosen_step], paper_value, red);
}

std::string error_panel(const Group& group) {
  const auto percents = [&](Measure measure, double ErrorSummary::*value) {
    std::vector<double> values;
    for (std::size_t step = 0; step < paper_substeps.size(); ++step)
      values.push_back(100.0 * (error_summary(group.cases, step, measure).*value));
    return values;
  };
  return fmt::format(
             "set title '{}: error of the residual slip'\nset ylabel 'error, %'\n"
             "set yrange [1e-4:1e5]\n",
             group.motions) +
         plot_lines({{blue, "largest, relative to the residual at P = 256", -15, 0,
                      percents(Measure::finest, &ErrorSummary::largest)},
                     {green, "largest, relative to the exact peak slip", -15, 0,
                      percents(Measure::exact_peak, &ErrorSummary::largest)},
                     {grey, "median, relative to the residual at P = 256", -15, 0,
                      percents(Measure::finest, &ErrorSummary::median)}},
                    100.0 * paper_largest_error);
}

std::string time_panel(std::span<const Group> groups) {
  std::vector<double> scheme(paper_substeps.size(), 0.0), exact = scheme;
  for (const Group& group : groups) {
    for (const Case& c : group.cases) {
      for (std::size_t step = 0; step < scheme.size(); ++step) {
        scheme[step] = std::max(scheme[step], 1e3 * c.scheme_s[step]);
        exact[step] = std::max(exact[step], 1e3 * c.exact_s);
      }
    }
  }
  return "set title 'processor time of the longest history'\nset ylabel 'time, ms'\n"
         "set yrange [0.1:300]\n" +
         plot_lines({{blue, "published scheme", 8, 0, scheme},
                     {green, "exact solution, from event to event", 0, 5, exact}},
                    1e3 * paper_longest_s);
}

}  // namespace

void draw(std::span<const Group> groups, const std::filesystem::path& svg) {
  std::string script =
      "set logscale x 2\nset logscale y\nset format y '%g'\nset xrange [0.8:320]\n"
      "set xtics 1,2,256\nset xlabel 'P, substeps of a sample interval'\nset border 3\nset tics "
      "nomirror\nunset key\nset samples 2\n"
      "set multiplot\n";
  const double width = 1.0 / static_cast<double>(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    script +=
        fmt::format("set origin {},0.4\nset size {},0.6\n", static_cast<double>(i) * width, width);
    script += error_panel(groups[i]);
  }
  script += "set origin 0,0\nset size 1,0.4\n" + time_panel(groups);
  verification::gnuplot_svg(svg, script, "1000,820");
}

}  // namespace glissade::convergence
