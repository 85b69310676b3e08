// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "glissade/core/file.hpp"

namespace glissade::bench {
namespace {

/// Two log-log panels side by side, above `foot` of the figure's height.
void gnuplot(const std::filesystem::path& svg, const char* title, double foot,
             const std::string& script) {
  const std::filesystem::path script_file = std::filesystem::path(svg).replace_extension(".gp");
  write_text_file(script_file,
                  fmt::format("set terminal svg size 1000,560 font 'Helvetica,14' background "
                              "'#ffffff'\nset output '{}'\nset grid lc rgb '#dddddd' lt 1 lw 0.7\n"
                              "set logscale xy\nset format xy '10^{{%T}}'\nset border 3\n"
                              "set style textbox opaque noborder margins 0.2,0.2\n"
                              "set tics nomirror\nset multiplot layout 1,2 title '{}' margins "
                              "0.09,0.98,{},0.9 spacing 0.1,0\n{}",
                              svg.string(), title, foot, script));
  if (std::system(fmt::format("gnuplot --default-settings '{}'", script_file.string()).c_str()) !=
      0)
    throw std::runtime_error("gnuplot failed on " + script_file.string());
  std::filesystem::remove(script_file);
}

/// By family, in the order of the table: colours that colour-blind readers can distinguish (Okabe &
/// Ito 2008).
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#b05090", "#333333", "#9a6a00"};
/// Points of gnuplot that greyscale distinguishes too.
constexpr std::array points{7, 5, 9, 13, 6, 4};

/// A family's points: (mean time of a history that slides, error, label).
struct Curve {
  std::string name, points;
  std::size_t count = 0;
};

/// "64" at P = 64, of the curve between the other two its last one only: the steps are those of the
/// one-way curve. Where the Newmark curves begin their first points are too close for labels, as
/// neighbouring steps are; curves by tolerance have the same ones, stated along the first.
std::string point_label(const SchemeResult& scheme) {
  const std::size_t sign = scheme.label.find(" = ");
  if (sign == std::string::npos) return "";
  const std::string step = scheme.label.substr(sign + 3);
  if (scheme.label.starts_with("tolerance") && scheme.family != "peak_slip_two_axes, rigid")
    return "";
  constexpr std::array unlabelled{"2", "8", "32", "128", "1e-3", "1e-5", "1e-7"};
  if (std::ranges::find(unlabelled, step) != unlabelled.end()) return "";
  if (scheme.family == "Newmark trapezoid" && step != "64") return "";
  return scheme.family.starts_with("Newmark trapezoid") && step == "1" ? "" : step;
}

/// An error of exactly zero is drawn at 1e-16.
std::vector<Curve> curves_of(const std::vector<SchemeResult>& results,
                             double SchemeResult::*error) {
  std::vector<Curve> curves;
  for (const SchemeResult& s : results) {
    if (s.judged == 0) continue;
    const double us = s.sliding.mean_us, shown = std::max(s.*error, 1e-16);
    if (curves.empty() || curves.back().name != s.family) curves.push_back({s.family, ""});
    Curve& curve = curves.back();
    curve.points += fmt::format("{} {} \"{}\"\n", us, shown, point_label(s));
    ++curve.count;
  }
  return curves;
}

/// The names of the curves below both panels, three in a row, and what else is in the figure.
std::string names_of(const std::vector<Curve>& curves, const std::string& note) {
  std::string script = fmt::format(
      "set label 'dashed: one pass over the samples; {}' at screen 0.03,0.02 left tc rgb "
      "'#555555'\n",
      note);
  for (std::size_t i = 0; i < curves.size(); ++i)
    script += fmt::format(
        "set label '{}' at screen {},{} left noenhanced tc rgb '{}' point pt {} ps 1 lc rgb '{}' "
        "offset 1,0\n",
        curves[i].name, 0.03 + 0.33 * static_cast<double>(i % 3),
        0.12 - 0.05 * static_cast<double>(i / 3), colours[i % colours.size()],
        points[i % points.size()], colours[i % colours.size()]);
  return script;
}

/// Error against time, median left, largest right, the floor first of the results.
void draw(const std::vector<SchemeResult>& results, const char* title, const std::string& note,
          const std::filesystem::path& svg) {
  const double floor_us = results.front().sliding.mean_us;
  std::string script =
      "set xrange [0.1:1e5]\nset yrange [1e-17:1e3]\nunset key\nset format x '%g'\n"
      "set xtics ('0.1' 0.1, '1' 1, '10' 10, '100' 100, '1,000' 1e3, '10,000' 1e4, '' 1e5)\n"
      "set ytics 1e-16,1e2\nunset mytics\nset xlabel 'mean time of a history that slides, µs'\n";
  for (const bool largest : {false, true}) {
    const std::vector<Curve> curves =
        curves_of(results, largest ? &SchemeResult::largest_error : &SchemeResult::median_error);
    script += fmt::format(
        "set ylabel '{1} relative error in peak slip'\nunset label\nunset arrow\n"
        "set arrow from {0},graph 0 to {0},graph 1 nohead dt 2 lc rgb '#555555'\n{2}",
        floor_us, largest ? "largest" : "median", largest ? "" : names_of(curves, note));
    std::string plot;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      script += fmt::format("$c{} << EOD\n{}EOD\n", i, curves[i].points);
      plot += fmt::format(
          "{0}$c{1} using 1:2 with {3} pt {4} ps 0.8 lc rgb '{2}', $c{1} "
          "using 1:2:3 with labels boxed {5} font ',10' tc rgb '{2}'",
          i == 0 ? "plot " : ", ", i, colours[i % colours.size()],
          curves[i].count > 1 ? "linespoints lw 2" : "points", points[i % points.size()],
          curves[i].name.starts_with("slide_two_ax")        ? "right offset -0.6,0"
          : curves[i].name.starts_with("Newmark trapezoid") ? "left offset 0.6,0.2"
                                                            : "offset 0.4,0.7");
    }
    script += plot + "\n";
  }
  gnuplot(svg, title, 0.26, script);
}

}  // namespace

void draw_schemes(const WorkPrecision& measured, const std::filesystem::path& svg) {
  draw(measured.schemes, "Error in peak slip over run time: one axis, roof motion given",
       "at the points: substeps per sample", svg);
}

void draw_trial(const std::vector<SchemeResult>& results, const char* title,
                const std::filesystem::path& svg) {
  // At most four curves by tolerance or step.
  constexpr std::array curves{"peak_slip_two_axes, rigid", "peak_slip_two_axes, m/M 0.05",
                              "slide_on_building, m/M 0.05"};
  std::vector<SchemeResult> shown;
  std::ranges::copy_if(results, std::back_inserter(shown), [&](const SchemeResult& s) {
    const bool is_of_two_axes =
        s.family.starts_with("slide_two_ax") || s.family.starts_with("slide_on_building");
    return !is_of_two_axes || std::ranges::find(curves, s.family) != curves.end();
  });
  draw(shown, title, "at the points: substeps per sample, or tolerance", svg);
}

void draw_fragility(const FragilityError& measured, const std::filesystem::path& svg) {
  constexpr std::array colours{"#d55e00", "#777777", "#0072b2"};
  std::string script =
      "unset key\nset xlabel 'histories'\nset format x '10^{%L}'\nset yrange [5e-5:0.3]\n";
  for (const bool of_median : {true, false}) {
    script += fmt::format(
        "set ylabel 'rms relative error of {}'\nunset label\nunset arrow\n"
        "set arrow from graph 0,first 0.01 to graph 1,first 0.01 nohead dt 2 lc rgb '#555555'\n"
        "set label '1 %' at graph 0.99,first 0.01 right offset 0,0.5 tc rgb '#555555'\n",
        of_median ? "the median" : "log\\_std");
    std::string plot;
    const std::vector<Estimator> all = estimators();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::vector<FragilityErrorRow> rows = rows_of(measured, all[i]);
      const auto error = [&](const FragilityErrorRow& row) {
        return of_median ? row.median : row.log_std;
      };
      const std::string block = fmt::format("$estimator{}", i);
      script += block + " << EOD\n";
      for (const FragilityErrorRow& row : rows)
        script += fmt::format("{} {} {} {}\n", row.histories, error(row).rms, error(row).low,
                              error(row).high);
      script += "EOD\n";
      const auto label = [&](const std::string& text, const FragilityErrorRow& row,
                             const char* where) {
        script += fmt::format("set label '{}' at {},{} {} tc rgb '{}'\n", text, row.histories,
                              error(row).rms, where, colours[i]);
      };
      if (all[i].method == SamplingMethod::sobol)
        label(all[i].name(), rows[rows.size() / 2], "right offset -2,-1");
      else if (all[i].fitted_on == FittedOn::counts)
        label("plain Monte Carlo, counts", rows.front(), "left offset -5,1.8");
      else
        label(all[i].name(), rows[rows.size() / 3], "offset 2,1.2");
      plot += fmt::format("{}{} using 1:2:3:4 with yerrorlines lw 2 pt 7 ps 0.5 lc rgb '{}'",
                          i == 0 ? "plot " : ", ", block, colours[i]);
    }
    script += plot + "\n";
  }
  gnuplot(svg, "Error of a fragility over its histories: slip of 0.3 m, seven motions", 0.12,
          script);
}

}  // namespace glissade::bench
