// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figure_text.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "gnuplot.hpp"
#include "impact.hpp"

namespace glissade {
namespace {

/// Percentiles of fewer records' histories would be of those records alone.
constexpr std::size_t fewest_records = 3;

/// Speeds at one threshold and level.
struct SpeedPoint {
  double threshold_m = 0.0, p16_mps = 0.0, median_mps = 0.0, p84_mps = 0.0;
};

/// Over the thresholds that enough records reach at this level.
std::vector<SpeedPoint> points_at(const Results& results, const RunResults& run,
                                  std::size_t level) {
  const std::size_t records = results.records.size(), samples = run.cases,
                    thresholds = results.thresholds_m.size();
  std::vector<SpeedPoint> points;
  for (std::size_t t = 0; t < thresholds; ++t) {
    std::vector<double> speeds;
    std::size_t reaching = 0;
    for (std::size_t i = 0; i < records; ++i) {
      const std::size_t before = speeds.size();
      for (std::size_t j = 0; j < samples; ++j) {
        const double speed =
            results.histories.fields
                .crossing_speed_mps[results.histories.at(i, run.first_case + j, level) *
                                        thresholds +
                                    t];
        if (!std::isnan(speed)) speeds.push_back(speed);
      }
      reaching += speeds.size() > before ? 1 : 0;
    }
    if (reaching < fewest_records) continue;
    points.push_back({results.thresholds_m[t], quantile_of(speeds, 0.16), quantile_of(speeds, 0.5),
                      quantile_of(speeds, 0.84)});
  }
  return points;
}

struct LevelCurve {
  double level;
  std::vector<SpeedPoint> points;
};

/// At up to three of the levels at which there is anything to show.
std::vector<LevelCurve> curves_of(const Results& results, const RunResults& run) {
  std::vector<LevelCurve> all, shown;
  std::vector<double> levels;
  for (std::size_t l = 0; l < results.levels.size(); ++l) {
    LevelCurve curve{results.levels[l], points_at(results, run, l)};
    if (curve.points.empty()) continue;
    levels.push_back(curve.level);
    all.push_back(std::move(curve));
  }
  for (const double level : some_levels(levels, 3))
    shown.push_back(*std::ranges::find(all, level, &LevelCurve::level));
  return shown;
}

/// The opposite axis: kinetic energy by mass, in round numbers that stand apart.
std::string energy_beside(double largest_mps) {
  std::string ticks;
  double last_mps = 0.0;
  for (int power = -5; power < 5; ++power) {
    for (const int digit : {1, 2, 3, 5, 7}) {
      const double energy = digit * std::pow(10.0, power), speed = std::sqrt(2.0 * energy);
      if (speed > largest_mps || speed - last_mps < 0.07 * largest_mps) continue;
      ticks += fmt::format("{}{:g}", ticks.empty() ? "0, " : ", ", energy);
      last_mps = speed;
    }
  }
  return fmt::format(
      "set link y2 via y*y/2 inverse sqrt(2*y)\n"
      "set y2tics ({}) out nomirror\n"
      "set y2label {}\n",
      ticks, gnuplot::quoted("Kinetic energy by mass, v²/2 (J/kg)"));
}

}  // namespace

Figure impact_figure(const Results& results, const RunResults& run) {
  Figure figure;
  figure.name = "impact";
  figure.title = "How fast the array is when it first gets to a clearance";
  figure.caption =
      "Speed (left) and kinetic energy for each kilogram that moves together (right: what a "
      "parapet there must take up). " +
      impact_explained() +
      " Points: median over all histories (records and samples together) that get there, at three "
      "levels of intensity at most; shaded, and the thin bars: 16th to 84th percentile. Clearances "
      "that fewer than three records reach are left out at that level. Friction " +
      run.friction_description + ".";
  const std::vector<LevelCurve> curves = curves_of(results, run);
  const double right_m = 1.08 * (results.thresholds_m.empty() ? 1.0 : results.thresholds_m.back());
  gnuplot::DataBlocks data;
  const std::string file = quoted_file(figure.name);
  std::string bands, medians;
  double top_mps = 0.0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    data.begin(fmt::format("level {}", k), "clearance_m p16_mps median_mps p84_mps shown_at_m");
    // Side by side, so that bars of different levels do not hide each other.
    const double aside_m = 0.006 * right_m * (static_cast<double>(k) - 1.0);
    for (const SpeedPoint& p : curves[k].points) {
      data.row({p.threshold_m, p.p16_mps, p.median_mps, p.p84_mps, p.threshold_m + aside_m});
      top_mps = std::max(top_mps, p.p84_mps);
    }
    const std::string colour = gnuplot::ramp_colour(k, curves.size());
    bands += fmt::format(
        "  {0} index 'level {1}' using 5:2:4 with filledcurves fc rgb '{2}', \\\n"
        "  {0} index 'level {1}' using 5:3:2:4 with yerrorbars pt -1 lw 1.2 lc rgb '{2}', \\\n",
        file, k, colour);
    medians += fmt::format(
        "  {0} index 'level {1}' using 5:3 with linespoints pt {2} ps 0.9 lw 2.5 lc rgb '{3}' "
        "title {4}, \\\n",
        file, k, point_symbol(k), colour,
        gnuplot::quoted("median at " + at_intensity(results, curves[k].level)));
  }
  const double shown_mps = top_mps > 0.0 ? 1.08 * top_mps : 1.0;
  figure.body =
      title_of(figure,
               "given that it gets there; " + counts_of(results) + "; " + friction_of(run)) +
      axis("x", "Clearance: distance in plan from where the array lay (m)") +
      axis("y", "Speed in plan, relative to the roof (m/s)") +
      inches_beside("x", right_m, "Clearance") + energy_beside(shown_mps) +
      fmt::format("set border 15\nset xrange [0:{}]\nset yrange [0:{}]\n", right_m, shown_mps) +
      "plot \\\n" + bands + medians +
      "  keyentry with filledcurves fc rgb '#777777' title "
      "'shaded, and thin bars: 16th to 84th percentile of the histories that get there'\n";
  figure.key_rows = static_cast<int>(curves.size()) + 1;
  figure.data = data.text();
  return figure;
}

}  // namespace glissade
