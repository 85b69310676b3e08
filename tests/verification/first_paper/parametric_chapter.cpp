// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/block/slide.hpp"
#include "glissade/io/study_file.hpp"
#include "run_study.hpp"
#include "verification/chapters.hpp"

namespace glissade::verification {
namespace {

const std::string paper = "Rodriguez-Nikl et al. 2019, ";

/// Every run against slide() on the same record.
double difference_from_slide(const Plan& plan, const Results& results) {
  const Motion& motion = plan.motion(0);
  const Samples& a = motion.horizontal_mps2[0];
  double peak = 0.0, worst = 0.0;
  for (const double x : a) peak = std::max(peak, std::abs(x));
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    const glissade::Case c = plan.cases[i];
    for (std::size_t level = 0; level < results.levels.size(); ++level) {
      const double factor = results.levels[level] * standard_gravity_mps2 / peak;
      const double exact =
          slide({motion.dt_s, a, {}, factor}, {c.friction, c.slope_deg * rad_per_deg})
              .peak_displacement_m;
      const double ours = results.histories.displacement_m(0, i, level);
      worst = worse(worst, std::abs(ours - exact) / (exact + 1e-6));
    }
  }
  return worst;
}

/// Where a point of the chart moves, and where it must: the acceleration has to pass g tan(phi -
/// theta), whichever way its peak points, as the envelope holds both slopes.
Mismatches wrong_onsets(const Results& results) {
  Mismatches wrong{0, 0};
  for (const ChartPoint& p : results.chart->points) {
    if (p.free_sliding) continue;
    const double onset_g =
        yield_acceleration_mps2({p.mu, p.slope_deg * rad_per_deg}) / standard_gravity_mps2;
    if (std::abs(p.level / onset_g - 1.0) < 1e-9) continue;  // at the threshold rounding decides
    ++wrong.of;
    wrong.differing += (p.largest.envelope_m > 0.0) != (p.level > onset_g);
  }
  return wrong;
}

/// Share of the pairs of neighbours along an axis, of those that slide, in which slip does not
/// fall.
template <class Next>
double share_not_falling(const Chart& chart, std::size_t levels, Next next) {
  int pairs = 0, rising = 0;
  for (std::size_t l = 0; l < levels; ++l)
    for (std::size_t s = 0; s < chart.slope_deg.size(); ++s)
      for (std::size_t m = 0; m < chart.mu.size(); ++m) {
        const ChartPoint* to = next(l, s, m);
        if (to == nullptr || to->largest.envelope_m == 0.0) continue;
        ++pairs;
        rising += to->largest.envelope_m >= chart.at(l, s, m).largest.envelope_m;
      }
  return static_cast<double>(rising) / pairs;
}

/// Coefficient of determination of the straight line of slip over slope (Fig. 11: mu 0.5).
double linearity(const Chart& chart, std::size_t level) {
  const auto mu = static_cast<std::size_t>(
      std::ranges::find_if(chart.mu, [](double x) { return std::abs(x - 0.5) < 1e-9; }) -
      chart.mu.begin());
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t s = 0; s < chart.slope_deg.size(); ++s) {
    const double u = chart.slope_deg[s], v = chart.at(level, s, mu).largest.envelope_m;
    n += 1, x += u, y += v, xx += u * u, xy += u * v, yy += v * v;
  }
  const double covariance = n * xy - x * y;
  return covariance * covariance / ((n * xx - x * x) * (n * yy - y * y));
}

struct Column {
  std::string heading;
  const Chart& chart;
  double ChartReading::*statistic;
};

std::string readings_table(const std::vector<Column>& columns) {
  std::string headings = "| reading | the paper |", line = "|---|---|",
              slips = "| peak displacement at mu 0.5 and 4 deg, mm | 1000 |",
              frictions = "| friction needed for 500 mm at 2 deg | 0.55 |";
  for (const auto& [heading, chart, statistic] : columns) {
    headings += fmt::format(" {} |", heading);
    line += "---|";
    slips += fmt::format(" {:.0f} |", 1e3 * (chart.readings[0].*statistic));
    const double friction = chart.readings[1].*statistic;
    frictions +=
        std::isinf(friction) ? std::string(" more than 0.8 |") : fmt::format(" {:.2f} |", friction);
  }
  return fmt::format("{}\n{}\n{}\n{}\n", headings, line, slips, frictions);
}

std::vector<Finding> findings_on(const std::vector<Case>& trends, const Chart& one,
                                 const Chart& all) {
  const bool confirmed = std::ranges::all_of(trends, [](const Case& c) { return c.pass; });
  const ChartReading &slip = all.readings[0], &friction = all.readings[1];
  return {
      {"Figs. 10 to 12: displacement grows with intensity and slope, and as friction falls; nearly "
       "linear over slope at mu 0.5",
       "the same, by the cases of this chapter", yes(confirmed)},
      {"peak displacement at mu 0.5, 4 deg and 1.5 g: 1000 mm",
       fmt::format("{:.0f} mm for one built-in motion; 22 motions: mean {:.0f}, largest {:.0f} mm",
                   1e3 * one.readings[0].envelope, 1e3 * slip.mean, 1e3 * slip.envelope),
       slip.envelope > 1.0 ? "within the 22 motions" : "no"},
      {"friction needed for 500 mm at 2 deg and 1.5 g: 0.55",
       fmt::format("{:.2f} for one built-in motion; 22 motions: mean {:.2f}, largest {:.2f}",
                   one.readings[1].envelope, friction.mean, friction.envelope),
       friction.envelope > 0.55 ? "within the 22 motions" : "no"}};
}

/// What the readings of a study need of it, and no more.
StudyConfig for_its_readings(StudyConfig config) {
  config.intensity.levels = {1.5};
  std::erase_if(config.quantities.at("roof", "slope_deg").values,
                [](double slope) { return std::abs(slope) != 2.0 && std::abs(slope) != 4.0; });
  return config;
}

}  // namespace

Chapter first_paper_parametric_study(const Folders& folders) {
  const Plan plan = plan_of(read_study(folders.studies / "06_rodriguez_nikl_parametric.toml"));
  const Results results = run_study(plan);
  StudyConfig all_motions = plan.config;
  all_motions.records.clear();
  const Results all = run_study(plan_of(for_its_readings(all_motions)));
  const Results buildings = run_study(plan_of(
      for_its_readings(read_study(folders.studies / "08_many_motions_many_buildings.toml"))));
  const Chart& chart = *results.chart;
  const std::size_t levels = results.levels.size();
  const auto falling = [&](const std::string& along, double share) {
    return within(
        {"one motion, neighbours along " + along, "share of pairs in which slip grows",
         paper + "Figs. 10 to 12: PRD grows with intensity and slope, and as friction falls"},
        {"share", share, 0.95, 1.0});
  };
  const std::vector<Case> cases = {
      all_equal({"29 slopes x 15 frictions x 16 intensities", "runs", paper + "6960"},
                {plan.histories() == 6960 ? 0 : 1, 1}),
      all_equal({"envelope of both slopes", "results", paper + "3600"},
                {chart.points.size() == 3600 ? 0 : 1, 1}),
      limit({"6,960 runs of the kernel", "peak displacement", "slide()", ReferenceFrom::this_code},
            {"largest difference, relative to the slip and 1 um",
             difference_from_slide(plan, results), 1e-12}),
      all_equal({"results that do not slide freely", "slides, or does not",
                 "closed form: slip begins where the peak passes g tan(phi - theta); Fig. 10"},
                wrong_onsets(results)),
      falling("intensity", share_not_falling(chart, levels,
                                             [&](std::size_t l, std::size_t s, std::size_t m) {
                                               return l + 1 < levels ? &chart.at(l + 1, s, m)
                                                                     : nullptr;
                                             })),
      falling("slope", share_not_falling(chart, levels,
                                         [&](std::size_t l, std::size_t s, std::size_t m) {
                                           return s + 1 < chart.slope_deg.size()
                                                      ? &chart.at(l, s + 1, m)
                                                      : nullptr;
                                         })),
      falling("falling friction",
              share_not_falling(chart, levels,
                                [&](std::size_t l, std::size_t s, std::size_t m) {
                                  return m > 0 ? &chart.at(l, s, m - 1) : nullptr;
                                })),
      within({"mu 0.5, 1.5 g", "slip over slope", paper + "Fig. 11: nearly linear"},
             {"R2 of a straight line", linearity(chart, levels - 1), 0.95, 1.0})};
  return {
      "1.4 Parametric study",
      "Figs. 10 to 12 of the paper",
      R"(Study 06 has 29 slopes, 15 frictions and 16 peak accelerations of one motion on a rigid roof. The larger
result of a slope and of its mirror image is taken, as in the paper. The displacement may decrease with
intensity, as a larger motion may move the block back by more.

Readings of Fig. 12 of the paper are at a peak roof acceleration of 1.5 g. Study 08 is the same grid with
every orientation, verticals, buildings of 0 to 2 s, and the intensity of the ground. Recorded motions (study
07): [studies](../../studies/README.md#the-first-paper).)",
      cases,
      "![Displacement over friction and slope (study 06)]"
      "(../../studies/figures/06_chart_contours.svg)\n"
      "![Displacement over intensity (study 06)](../../studies/figures/06_chart_intensity.svg)\n"
      "![Displacement over slope (study 06)](../../studies/figures/06_chart_slope_levels.svg)\n",
      readings_table({{"study 06, one built-in motion", chart, &ChartReading::envelope},
                      {"its 22 motions: mean", *all.chart, &ChartReading::mean},
                      {"84th percentile", *all.chart, &ChartReading::p84},
                      {"largest", *all.chart, &ChartReading::envelope},
                      {"study 08, S_DS 1.5 g: mean", *buildings.chart, &ChartReading::mean},
                      {"84th percentile", *buildings.chart, &ChartReading::p84}}),
      findings_on(cases, chart, *all.chart)};
}

}  // namespace glissade::verification
