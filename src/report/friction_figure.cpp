// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "figure_text.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/friction_report.hpp"
#include "gnuplot.hpp"

namespace glissade {
namespace {

/// Told apart by colour-blind readers (Okabe & Ito 2008).
std::string colour_of(std::size_t direction) {
  static constexpr std::array<const char*, 6> colours = {"0072b2", "d55e00", "009e73",
                                                         "cc79a7", "e69f00", "56b4e9"};
  return colours[direction % colours.size()];
}

double friction_at(const PullTest& test, std::size_t i) {
  return test.force_n[i] / test.normal_n[i];
}
double slip_at(const PullTest& test, std::size_t i) {
  return test.displacement_m[i] - test.displacement_m.front();
}

/// A panel for each direction, side by side on one axis.
struct Panels {
  std::size_t count;
  double width_m = 0.0, top_mu = 0.0;

  double begin_m(std::size_t direction) const {
    return 1.08 * width_m * static_cast<double>(direction);
  }
  double end_m() const { return begin_m(count - 1) + width_m; }
};

Panels panels_for(const std::vector<PullTest>& tests, std::size_t count) {
  Panels panels{count};
  for (const PullTest& test : tests) {
    for (std::size_t i = 0; i < test.force_n.size(); ++i) {
      panels.width_m = std::max(panels.width_m, slip_at(test, i));
      panels.top_mu = std::max(panels.top_mu, friction_at(test, i));
    }
  }
  return panels;
}

/// Ticks that begin at 0 in every panel, about eight in all.
std::string ticks_of(const Panels& panels) {
  const double wanted_m = panels.width_m * static_cast<double>(panels.count) / 8.0;
  const double power = std::pow(10.0, std::floor(std::log10(wanted_m)));
  const double leading = wanted_m / power;
  const double step_m = power * (leading <= 1.0   ? 1.0
                                 : leading <= 2.0 ? 2.0
                                 : leading <= 5.0 ? 5.0
                                                  : 10.0);
  std::string ticks;
  for (std::size_t direction = 0; direction < panels.count; ++direction) {
    for (int i = 0; i * step_m <= panels.width_m; ++i) {
      ticks += fmt::format("{}'{:g}' {}", ticks.empty() ? "" : ", ", i * step_m,
                           panels.begin_m(direction) + i * step_m);
    }
  }
  return "set xtics (" + ticks + ")\n";
}

/// Of the samples [begin, end) those to draw: all, or of a long trace the least and the largest
/// friction in each of some hundred runs of samples, which look the same.
std::vector<std::size_t> drawn_samples(const PullTest& test, std::size_t begin, std::size_t end) {
  constexpr std::size_t most_runs = 500;
  const std::size_t run = (end - begin + most_runs - 1) / most_runs;
  const auto less = [&](std::size_t i, std::size_t j) {
    return friction_at(test, i) < friction_at(test, j);
  };
  std::vector<std::size_t> samples(end - begin), drawn;
  std::iota(samples.begin(), samples.end(), begin);
  for (auto at = samples.begin(); at != samples.end();) {
    const auto stop =
        at + std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(run), samples.end() - at);
    const auto [least, largest] = std::minmax_element(at, stop, less);
    drawn.push_back(std::min(*least, *largest));
    if (*least != *largest) drawn.push_back(std::max(*least, *largest));
    at = stop;
  }
  return drawn;
}

/// The traces of one direction, whole and their sliding parts.
void add_traces(gnuplot::DataBlocks& data, const std::vector<PullTest>& tests,
                const PullTestSummary& summary, std::size_t direction) {
  for (const bool whole : {true, false}) {
    data.begin(fmt::format("{} {}", whole ? "trace" : "sliding", direction),
               "displacement_m force_over_normal");
    for (std::size_t t = 0; t < tests.size(); ++t) {
      const TraceFriction& result = summary.tests[t];
      if (result.direction != summary.directions[direction].direction) continue;
      const std::size_t begin = whole ? 0 : result.sliding_begin;
      const std::size_t end = whole ? tests[t].force_n.size() : result.sliding_end;
      for (const std::size_t i : drawn_samples(tests[t], begin, end))
        data.row({slip_at(tests[t], i), friction_at(tests[t], i)});
      data.break_line();
    }
  }
}

void add_levels(gnuplot::DataBlocks& data, const Panels& panels, const MuStatistics& s,
                std::size_t direction) {
  data.begin(fmt::format("levels {}", direction), "displacement_m mean mean_minus_2_std");
  for (const double x : {0.0, panels.width_m}) data.row({x, s.mean, s.mean_minus_2_std});
}

/// The plot lines of one direction, and how many of them the key has.
int add_direction(const DirectionFriction& d, double begin_m, std::size_t direction,
                  const std::string& file, std::string& plot) {
  const MuStatistics& s = d.sliding;
  const auto line = [&](const char* block, int column, const std::string& style) {
    plot +=
        fmt::format("{}  {} index '{} {}' using ($1+{}):{} with lines {}",
                    plot.empty() ? "" : ", \\\n", file, block, direction, begin_m, column, style);
  };
  const std::string colour = colour_of(direction);
  line("trace", 2, fmt::format("lw 1 lc rgb '#b0{}'", colour));
  line("sliding", 2, fmt::format("lw 1 lc rgb '#60{}'", colour));
  const std::string mean =
      fmt::format("{}: mean of sliding friction {} ({} {})", d.direction, format_number(s.mean),
                  s.tests, s.tests == 1 ? "test" : "tests");
  line("levels", 2, fmt::format("lw 3 lc rgb '#{}' title {}", colour, gnuplot::quoted(mean)));
  if (s.tests == 1) return 1;
  const std::string design =
      fmt::format("{}: mean - 2 std between tests {} (95 % lower bound {})", d.direction,
                  format_number(s.mean_minus_2_std), format_number(s.lower_bound_95));
  line("levels", 3,
       fmt::format("lw 3 dt 2 lc rgb '#{}' title {}", colour, gnuplot::quoted(design)));
  return 2;
}

}  // namespace

Figure friction_figure(const std::vector<PullTest>& tests, const PullTestSummary& summary) {
  Figure figure;
  figure.name = "friction";
  figure.title = "Effective friction in pull tests";
  figure.caption =
      "Pull over normal force over displacement, a thin line for each test, darker over its "
      "sliding part. Thick: the mean of sliding friction over the tests of a direction; dashed: "
      "mean - 2 std between tests.";
  const Panels panels = panels_for(tests, summary.directions.size());
  gnuplot::DataBlocks data;
  std::string plot, labels;
  for (std::size_t direction = 0; direction < panels.count; ++direction) {
    const DirectionFriction& d = summary.directions[direction];
    add_traces(data, tests, summary, direction);
    add_levels(data, panels, d.sliding, direction);
    figure.key_rows +=
        add_direction(d, panels.begin_m(direction), direction, quoted_file(figure.name), plot);
    labels += fmt::format("set label {} at {}, graph 0.96 center tc rgb '#{}'\n",
                          gnuplot::quoted(d.direction),
                          panels.begin_m(direction) + 0.5 * panels.width_m, colour_of(direction));
  }
  const std::string below = fmt::format(
      "a thin line for each of {} pulls, darker where it slides: from {:g} m to where it stops",
      tests.size(), summary.rule.sliding_from_m);
  figure.body =
      title_of(figure, below) + axis("x", "Displacement (m)") + axis("y", "Pull / normal force") +
      ticks_of(panels) + labels +
      fmt::format("set xrange [0:{}]\nset yrange [0:{}]\n", panels.end_m(), 1.1 * panels.top_mu) +
      "plot \\\n" + plot + "\n";
  figure.data = data.text();
  return figure;
}

}  // namespace glissade
