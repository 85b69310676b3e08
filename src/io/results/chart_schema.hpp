// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "enum_names.hpp"
#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

// C is Chart or const Chart; so with the parts.

template <class Archive, class Points>
void exchange_chart_slip(const Archive& archive, Points& points, const std::string& name,
                         const char* what, double ChartSlip::*slip) {
  const std::string by_period = std::string(what) + ", by (point, period)";
  column(
      archive, name, {"m", what}, points, [&](auto& p) -> auto& { return p.largest.*slip; });
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
  make_rows(archive, scale.level, points);
  column(
      archive, scale.level, {scale.unit, "intensity level"}, points,
      [](auto& p) -> auto& { return p.level; });
  column(
      archive, "slope_deg", {"deg", "roof slope"}, points,
      [](auto& p) -> auto& { return p.slope_deg; });
  column(
      archive, "friction", {"-", "coefficient of friction"}, points,
      [](auto& p) -> auto& { return p.mu; });
  column(
      archive, "free_sliding", {"-", "1 where friction cannot stop the array: slips are inf"},
      points, [](auto& p) -> auto& { return p.free_sliding; });
  column(
      archive, "clearance_m", {"m", "1.1 x the largest mean over building periods"}, points,
      [](auto& p) -> auto& { return p.clearance_m; });
  interval_column(
      archive, "mean_m", {"m", "95 % interval of the largest mean"}, points,
      [](auto& p) -> auto& { return p.mean_interval; });
  column(
      archive, "governing_period_s", {"s", "building period at which the mean is largest"}, points,
      [](auto& p) -> auto& { return p.governing_period_s; });
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
  column(
      archive, "uplift_share", {"-", "share of histories with uplift"}, points,
      [](auto& p) -> auto& { return p.uplift_share; });
  column(
      archive, "tip_share",
      {"-", "share of histories in which the body begins to tip; nan: not computed"}, points,
      [](auto& p) -> auto& { return p.tip_share; });
}

template <class Archive, class Readings>
void exchange_chart_readings(const Archive& archive, const IntensityScale& scale,
                             Readings& readings) {
  make_rows(archive, scale.level, readings);
  column(
      archive, scale.level, {scale.unit, "intensity level"}, readings,
      [](auto& r) -> auto& { return r.question.level; });
  column(
      archive, "slope_deg", {"deg", "roof slope"}, readings,
      [](auto& r) -> auto& { return r.question.slope_deg; });
  const auto given = [&](const std::string& name, const Label& label,
                         std::optional<double> ChartQuestion::*which) {
    std::vector<double> values;
    if constexpr (!Archive::reads) {
      for (auto& r : readings)
        values.push_back((r.question.*which).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    list(archive, name, label, values);
    if constexpr (Archive::reads) {
      if (values.size() != readings.size()) throw Hdf5Error("fit " + name + " to the readings");
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isnan(values[i])) readings[i].question.*which = values[i];
      }
    }
  };
  given("friction", {"-", "coefficient of friction; nan: it is required"}, &ChartQuestion::mu);
  given("displacement_m", {"m", "displacement to keep within; nan: displacements are required"},
        &ChartQuestion::displacement_m);
  const auto answer = [&](const std::string& name, double ChartReading::*which) {
    column(
        archive, name, {"m or -", "displacement, or coefficient of friction needed"},
        readings, [&](auto& r) -> auto& { return r.*which; });
  };
  answer("mean", &ChartReading::mean);
  answer("clearance", &ChartReading::clearance);
  answer("p84", &ChartReading::p84);
  answer("p95", &ChartReading::p95);
  answer("envelope", &ChartReading::envelope);
}

template <class Archive, class Prescriptions>
void exchange_prescriptions(const Archive& archive, Prescriptions& rows) {
  make_rows(archive, "standard", rows);
  name_column<Standard>(
      archive, "standard", {"-", "standard"}, rows, standard_names(),
      [](auto& c) -> auto& { return c.standard; });
  column(
      archive, "sds_g", {"g", "design spectral acceleration S_DS"}, rows,
      [](auto& c) -> auto& { return c.sds_g; });
  column(
      archive, "prescribed_m", {"m", "prescribed displacement"}, rows,
      [](auto& c) -> auto& { return c.prescribed.value_m; });
  name_column<Provenance>(
      archive, "provenance", {"-", "how well the provision is known"}, rows, provenance_names(),
      [](auto& c) -> auto& { return c.prescribed.provenance; });
  column(
      archive, "basis", {"-", "equation or clause"}, rows,
      [](auto& c) -> auto& { return c.prescribed.basis; });
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
