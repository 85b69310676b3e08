// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/chart/report.hpp"
#include "analysis/chart/view.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr auto gravity_note =
    "inf: friction cannot stop the array (tan(slope) >= mu), no clearance is enough.";

const ColumnOf mu_column{
    Column{"mu", "", "Friction", ColumnKind::number, "coefficient of friction"}, &ChartPoint::mu};

/// The mean with its interval.
void put_statistic(auto& t, const ChartStatistic& statistic) {
  const bool is_mean = statistic.stem == "mean_slip";
  t.length(statistic.stem, statistic.heading, "largest over the building periods",
           [=, slip_m = statistic.slip_m](const ChartPoint& point) -> Cell {
             return Estimate{slip_m(point), is_mean ? point.mean_interval : Interval{}};
           })
      .with_interval = is_mean;
}

std::vector<std::string> reading_notes(const Results& results) {
  std::vector<std::string> notes = {
      how_counted(results),
      "Between rows: interpolate linearly in slope and mu at one level. On the safe side: take the "
      "next larger slope and the next smaller mu.",
      gravity_note};
  if (!is_one_record(results)) {
    notes.push_back(design_title(results) + ": " + clearance_rule(results) +
                    "; p84, p95 and envelope (the largest " +
                    std::string(results.cases.samples > 1 ? "history" : "record") +
                    ") are each the largest over the building periods.");
  }
  return notes;
}

std::string title_of_levels(const std::string& what, const Results& results) {
  return what + " Levels are " + results.intensity_label +
         ". Displacements are in plan (horizontal).";
}

}  // namespace

Table chart_table(const Results& results) {
  const Chart& chart = *results.chart;
  using P = ChartPoint;
  TableOf<P> t("chart", title_of_levels("Design chart: slip over slope and friction.", results));
  t.put_all(level_column(results), slope_column, mu_column);
  t.notes = reading_notes(results);
  for (const ChartStatistic& s : chart_statistics(results)) put_statistic(t, s);
  t.number("governing_period", "Governing period", "building period at which the mean is largest",
           &P::governing_period_s, "s");
  t.count("free_sliding", "Slides freely",
          "1 where friction cannot stop the array: displacements are inf",
          [](const P& p) { return p.free_sliding ? 1 : 0; });
  t.share("uplift_share", "Uplift", "share of histories with uplift", &P::uplift_share);
  for (const Standard standard : standards_of(chart)) {
    const std::string name = standard_name(standard);
    t.length(key_of(standard), name,
             "displacement that " + name + " prescribes; nan: does not apply",
             [&chart, standard](const P& p) {
               return applies_at(standard, p.slope_deg, p.mu)
                          ? prescribed_m(chart, standard, p.level).value_or(nan)
                          : nan;
             });
    t.notes.push_back(name + " is for " + limits_of(standard) + ": empty elsewhere.");
  }
  t.add_each(chart.points);
  return t;
}

Table chart_by_period_table(const Results& results) {
  const Chart& chart = *results.chart;
  using P = ChartPoint;
  TableOf<P, std::size_t> t("chart_by_period",
                            title_of_levels("Design chart by building period.", results));
  t.put_all(level_column(results), slope_column, mu_column);
  t.number(
      "period", "Period", "building period; 0 is rigid",
      [&](std::size_t period) { return chart.period_s.at(period); }, "s");
  std::vector<ChartStatistic> statistics = chart_statistics(results);
  std::vector<double ChartSlip::*> slips{&ChartSlip::envelope_m};
  if (!is_one_record(results)) {
    statistics.erase(statistics.begin());  // of no period by itself
    slips = {&ChartSlip::mean_m, &ChartSlip::p84_m, &ChartSlip::p95_m, &ChartSlip::envelope_m};
  }
  for (std::size_t i = 0; i < slips.size(); ++i)
    t.length(statistics.at(i).stem, statistics[i].heading, "over the records, at this period",
             [slip_m = slips[i]](const P& p, std::size_t period) {
               return p.by_period[period].*slip_m;
             });
  for (const P& p : chart.points)
    for (std::size_t period = 0; period < p.by_period.size(); ++period) t.add(p, period);
  t.notes = {how_counted(results), gravity_note};
  return t;
}

Table chart_readings_table(const Results& results) {
  Table table{
      "chart_readings",
      title_of_levels("Read off the chart, linear in slope and friction.", results),
      {level_column(results),
       slope_column,
       text_column("read_off", "Read off", "what is read off"),
       text_column("statistic", "Of", "statistic that is read off"),
       mu_column,
       {"displacement", "m", "Displacement, m (in)", ColumnKind::length, "displacement in plan"}},
      {},
      {how_counted(results),
       "displacement is read off at a given mu, friction (the least mu needed) at a given "
       "displacement. mu inf: more than the chart's largest. displacement inf: "
       "friction cannot stop the array. mu at the chart's least: that or less."}};
  for (const ChartReading& reading : results.chart->readings) {
    const ChartQuestion& q = reading.question;
    for (const ChartStatistic& s : chart_statistics(results)) {
      const double answer = reading.*s.reading;
      if (q.mu) {
        table.add({q.level, q.slope_deg, std::string("displacement"), s.stem, *q.mu, answer});
      } else {
        table.add({q.level, q.slope_deg, std::string("friction"), s.stem, answer,
                   q.displacement_m.value_or(nan)});
      }
    }
  }
  return table;
}

Table chart_answers_table(const Results& results) {
  using R = ChartReading;
  TableOf<R> t("chart_answers", title_of_levels("Read off the chart.", results));
  t.text("question", "Question", "",
         [&](const R& reading) { return question_text(results, reading.question); });
  for (const ChartStatistic& s : chart_statistics(results))
    t.text(s.stem, s.heading, "", [&results, answer = s.reading](const R& reading) {
      return answer_text(*results.chart, reading.question, reading.*answer);
    });
  t.add_each(results.chart->readings);
  return t;
}

Table chart_standards_table(const Results& results) {
  const Chart& chart = *results.chart;
  const ChartStatistic design = design_statistic(results);
  Table table{
      "chart_standards",
      title_of_levels(fmt::format("Displacements prescribed by standards beside the chart at {}.",
                                  at_slope_and_friction(chart.shown_slope_deg, chart.shown_mu)),
                      results),
      {standard_column,
       sds_column,
       prescribed_column,
       {design.stem, "m", design.heading + ", m (in)", ColumnKind::length,
        "largest over the building periods", design.stem == "mean_slip"},
       {"above_share", "", "Points where more is needed", ColumnKind::share,
        "share of the points to which the standard applies that need more"},
       text_column("provenance", "Provision", "how well the provision is known"),
       text_column("basis", "Basis", "equation or clause")},
      {},
      {"above_share: of the chart's points at this level to which the standard applies, "
       "those that need more than it prescribes."}};
  for (const ChartPrescription& p : chart.standards) {
    double points = 0.0, above = 0.0;
    for (const ChartPoint& point : chart.points) {
      if (point.level != p.sds_g || !applies_at(p.standard, point.slope_deg, point.mu)) continue;
      ++points;
      if (design.slip_m(point) > p.prescribed.value_m) ++above;
    }
    const ChartPoint& shown =
        chart.at(nearest(results.levels, p.sds_g), nearest(chart.slope_deg, chart.shown_slope_deg),
                 nearest(chart.mu, chart.shown_mu));
    table.add({standard_name(p.standard), p.sds_g, p.prescribed.value_m, design.slip_m(shown),
               points > 0.0 ? above / points : nan, provenance_label(p.prescribed.provenance),
               p.prescribed.basis});
  }
  return table;
}

Table chart_matrix_table(const Results& results, std::size_t most) {
  const Chart& chart = *results.chart;
  const ChartStatistic design = design_statistic(results);
  const bool si = LengthUnits::first() == UnitSystem::si;
  const int decimals = si ? 3 : 1;
  const double unit = std::pow(10.0, -decimals);
  Table table{
      "chart_matrix",
      fmt::format("{}, {}, at {}: slope (down) and coefficient of friction (across)",
                  design.heading, si ? "m" : "in", at_intensity(results, chart.shown_level)),
      {{"slope", "deg", "Slope, degrees", ColumnKind::text, "slope of the roof"}},
      {},
      {}};
  const std::vector<std::size_t> frictions = spread(chart.mu.size(), most);
  for (const std::size_t m : frictions)
    table.columns.push_back({"mu_" + brief(chart.mu[m]), "m", brief(chart.mu[m])});
  const std::size_t level = nearest(results.levels, chart.shown_level);
  for (const std::size_t s : spread(chart.slope_deg.size(), most)) {
    std::vector<Cell> row = {brief(chart.slope_deg[s])};
    for (const std::size_t m : frictions) {
      const ChartPoint& p = chart.at(level, s, m);
      const double slip = in_first_unit(design.slip_m(p));
      row.emplace_back(p.free_sliding                    ? std::string("slides")
                       : slip > 0.0 && slip < 0.5 * unit ? fmt::format("< {:g}", unit)
                       : std::isfinite(slip)             ? fmt::format("{:.{}f}", slip, decimals)
                                                         : std::string("-"));
    }
    table.add(std::move(row));
  }
  return table;
}

std::vector<Table> chart_csv_tables(const Results& results) {
  const Chart& chart = *results.chart;
  std::vector<Table> tables = {chart_table(results)};
  if (chart.period_s.size() > 1) tables.push_back(chart_by_period_table(results));
  if (!chart.readings.empty()) tables.push_back(chart_readings_table(results));
  if (!chart.standards.empty()) tables.push_back(chart_standards_table(results));
  return tables;
}

}  // namespace glissade
