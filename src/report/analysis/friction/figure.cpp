// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "glissade/report/format.hpp"
#include "glissade/report/friction_report.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

double friction_at(const PullTest& test, std::size_t i) {
  return test.force_n[i] / test.normal_n[i];
}
double slip_at(const PullTest& test, std::size_t i) {
  return test.displacement_m[i] - test.displacement_m.front();
}

/// Of the samples [begin, end) those to draw: all, or of a long trace the least and the largest
/// friction in each of some hundred runs of samples, which look the same.
std::vector<std::size_t> drawn_samples(const PullTest& test, std::size_t begin, std::size_t end) {
  constexpr std::size_t most_runs = 500;
  const std::size_t run = (end - begin + most_runs - 1) / most_runs;
  std::vector<std::size_t> samples(end - begin), drawn;
  std::iota(samples.begin(), samples.end(), begin);
  for (auto at = samples.begin(); at != samples.end();) {
    const auto stop =
        at + std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(run), samples.end() - at);
    const auto [least, largest] = std::minmax_element(at, stop, [&](std::size_t i, std::size_t j) {
      return friction_at(test, i) < friction_at(test, j);
    });
    drawn.push_back(std::min(*least, *largest));
    if (*least != *largest) drawn.push_back(std::max(*least, *largest));
    at = stop;
  }
  return drawn;
}

enum class PanelPart { whole, sliding };

/// The traces of one direction, or their sliding parts.
DataSeries traces(const std::vector<PullTest>& tests, const PullTestSummary& summary,
                  const std::string& direction, PanelPart part, Look look) {
  DataSeries series{DataSeries::Kind::line, look,
                    part == PanelPart::whole ? "traces" : "sliding parts"};
  for (std::size_t t = 0; t < tests.size(); ++t) {
    const TraceFriction& result = summary.tests[t];
    if (result.direction != direction) continue;
    const std::size_t begin = part == PanelPart::whole ? 0 : result.sliding_begin;
    const std::size_t end = part == PanelPart::whole ? tests[t].force_n.size() : result.sliding_end;
    for (const std::size_t i : drawn_samples(tests[t], begin, end))
      series.add(slip_at(tests[t], i), friction_at(tests[t], i));
    series.end_line();
  }
  return series;
}

}  // namespace

Figure friction_figure(const std::vector<PullTest>& tests, const PullTestSummary& summary) {
  Figure figure{
      "friction", "Effective friction in pull tests",
      fmt::format("a thin line for each of {}, coloured where it slides: from {:g} m to "
                  "where it stops",
                  counted(tests.size(), "pull"), summary.rule.sliding_from_m),
      "Pull over normal force over displacement, a thin line for each test, coloured over its "
      "sliding part. Thick: the mean of sliding friction over the tests of a direction; dashed: "
      "mean - 2 std between tests."};
  double width_m = 0.0, top_mu = 0.0;
  for (const PullTest& test : tests) {
    for (std::size_t i = 0; i < test.force_n.size(); ++i) {
      width_m = std::max(width_m, slip_at(test, i));
      top_mu = std::max(top_mu, friction_at(test, i));
    }
  }
  for (std::size_t d = 0; d < summary.directions.size(); ++d) {
    const DirectionFriction& direction = summary.directions[d];
    const MuStatistics& s = direction.sliding;
    Look solid = distinct_look(d);
    solid.dash = 1;
    Look thin = solid, dashed = solid;
    thin.width = 1.0;
    dashed.dash = 2;
    Panel panel{direction.direction,
                length_axis("Displacement", width_m),
                {"Pull / normal force", 0.0, 1.1 * top_mu}};
    for (int i = 0; width_m > 0.0 && i * round_step(width_m, 4.0) <= width_m; ++i)
      panel.x.ticks.push_back(
          {i * round_step(width_m, 4.0), fmt::format("{:g}", i * round_step(width_m, 4.0))});
    panel.series = {
        traces(tests, summary, direction.direction, PanelPart::whole, look(Role::record)),
        traces(tests, summary, direction.direction, PanelPart::sliding, thin)};
    panel.rules = {{Rule::Kind::horizontal, s.mean, solid,
                    fmt::format("{}: mean of sliding friction {} ({})", direction.direction,
                                format_number(s.mean), counted(s.tests, "test"))}};
    if (s.tests > 1) {
      panel.rules.push_back(
          {Rule::Kind::horizontal, s.mean_minus_2_std, dashed,
           fmt::format("{}: mean - 2 std {} (95 % lower bound {})", direction.direction,
                       format_number(s.mean_minus_2_std), format_number(s.lower_bound_95))});
    }
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

}  // namespace glissade
