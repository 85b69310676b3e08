// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "enum_names.hpp"
#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

// C is Chart or const Chart; so with the parts.

template <class Archive, class Points>
void exchange_chart_slip(const Archive& archive, Points& points, const std::string& name,
                         const char* what, double ChartSlip::*slip) {
  const std::string by_period = std::string(what) + ", by (point, period)";
  Columns(archive, points)(name, {"m", what}, member(&ChartPoint::largest, slip));
  std::vector<std::vector<double>> rows(points.size());
  if constexpr (!Archive::reads) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const ChartSlip& s : points[i].by_period) rows[i].push_back(s.*slip);
    }
  }
  matrix(
      archive, name + "_by_period", {"m", by_period.c_str()}, rows,
      [](auto& row) -> auto& { return row; });
  if constexpr (Archive::reads) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].by_period.resize(rows[i].size());
      for (std::size_t p = 0; p < rows[i].size(); ++p) points[i].by_period[p].*slip = rows[i][p];
    }
  }
}

template <class Archive, class Points>
void exchange_chart_points(const Archive& archive, const IntensityScale& scale, Points& points) {
  const Columns column(archive, points, scale.level);
  column(scale.level, {scale.unit, "intensity level"}, &ChartPoint::level);
  column("slope_deg", {"deg", "roof slope"}, &ChartPoint::slope_deg);
  column("friction", {"-", "coefficient of friction"}, &ChartPoint::mu);
  column("free_sliding", {"-", "1 where friction cannot stop the array: slips are inf"},
         &ChartPoint::free_sliding);
  column("clearance_m",
         {"m", "required clearance: the factor x the largest mean over building periods"},
         &ChartPoint::clearance_m);
  column("mean_m", {"m", "95 % interval of the largest mean"}, &ChartPoint::mean_interval);
  column("governing_period_s", {"s", "building period at which the mean is largest"},
         &ChartPoint::governing_period_s);
  exchange_chart_slip(
      archive, points, "mean_m",
      "mean over the records of the peak displacement in plan, largest over periods",
      &ChartSlip::mean_m);
  exchange_chart_slip(archive, points, "p84_m", "84th percentile, largest over periods",
                      &ChartSlip::p84_m);
  exchange_chart_slip(archive, points, "p95_m", "95th percentile, largest over periods",
                      &ChartSlip::p95_m);
  exchange_chart_slip(archive, points, "envelope_m", "largest record, largest over periods",
                      &ChartSlip::envelope_m);
  column("uplift_share", {"-", "share of histories with uplift"}, &ChartPoint::uplift_share);
}

template <class Archive, class Readings>
void exchange_chart_readings(const Archive& archive, const IntensityScale& scale,
                             Readings& readings) {
  const Columns column(archive, readings, scale.level);
  column(scale.level, {scale.unit, "intensity level"},
         member(&ChartReading::question, &ChartQuestion::level));
  column("slope_deg", {"deg", "roof slope"},
         member(&ChartReading::question, &ChartQuestion::slope_deg));
  column("friction", {"-", "coefficient of friction; nan: it is required"},
         member(&ChartReading::question, &ChartQuestion::mu));
  column("displacement_m", {"m", "displacement to keep within; nan: displacements are required"},
         member(&ChartReading::question, &ChartQuestion::displacement_m));
  const auto answer = [&](const std::string& name, double ChartReading::*which) {
    column(name, {"m or -", "displacement, or coefficient of friction needed"}, which);
  };
  answer("mean", &ChartReading::mean);
  answer("clearance", &ChartReading::clearance);
  answer("p84", &ChartReading::p84);
  answer("p95", &ChartReading::p95);
  answer("envelope", &ChartReading::envelope);
}

template <class Archive, class C>
void exchange_chart(const Archive& archive, const IntensityScale& scale, C& chart) {
  list(archive, "slope_deg", {"deg", "axis: roof slope"}, chart.slope_deg);
  list(archive, "friction", {"-", "axis: coefficient of friction"}, chart.mu);
  list(archive, "period_s", {"s", "building periods; 0 is rigid"}, chart.period_s);
  archive.attribute("shown_slope_deg", chart.shown_slope_deg);
  archive.attribute("shown_friction", chart.shown_mu);
  archive.attribute("shown_" + scale.level, chart.shown_level);
  exchange_chart_points(archive.group("points"), scale, chart.points);
  exchange_chart_readings(archive.group("readings"), scale, chart.readings);
  exchange_prescriptions(archive.group("standards"), chart.standards);
}

}  // namespace glissade
