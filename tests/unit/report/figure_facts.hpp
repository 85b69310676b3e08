// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "glissade/report/figure.hpp"

namespace glissade {

inline std::vector<std::string> names(const std::vector<Figure>& figures) {
  std::vector<std::string> list;
  for (const Figure& figure : figures) list.push_back(figure.name);
  return list;
}

inline Figure figure_named(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures) {
    if (figure.name == name) return figure;
  }
  ADD_FAILURE() << "no figure " << name;
  return {};
}

/// The series of that name in any panel; without numbers where there is none.
inline DataSeries series_named(const Figure& figure, const std::string& name) {
  for (const Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series)
      if (series.name == name) return series;
  }
  return {};
}

/// The series that have numbers and an entry in the key.
inline std::vector<DataSeries> curves_of(const Figure& figure) {
  std::vector<DataSeries> curves;
  for (const Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series)
      if (!series.label.empty() && !series.x.empty()) curves.push_back(series);
  }
  return curves;
}

/// The entries of the key, of series and rules.
inline std::vector<std::string> key_of(const Figure& figure) {
  std::vector<std::string> key;
  for (const Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series)
      if (!series.label.empty()) key.push_back(series.label);
    for (const Rule& rule : panel.rules)
      if (!rule.label.empty()) key.push_back(rule.label);
  }
  return key;
}

inline std::size_t numbers_in(const DataSeries& series) {
  std::size_t count = 0;
  for (const double x : series.x) count += std::isfinite(x) ? 1 : 0;
  return count;
}

}  // namespace glissade
