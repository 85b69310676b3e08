// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "chart/view.hpp"
#include "glissade/report/figures.hpp"

namespace glissade {

struct Curve {
  std::string title;  ///< in the key
  std::string style;  ///< gnuplot: "lines lw 2 lc rgb '#000000'"
  std::vector<double> y_m;
};

/// Part of the x axis.
struct Stretch {
  double from = 0.0, to = 0.0;
};

/// A prescribed value as a horizontal line.
struct Horizontal {
  PrescribedLine prescribed;
  Stretch where;  ///< it applies
};

/// Slip over something: one data block "curves" with a column for each.
struct CurvePlot {
  std::string x_label, x_column;  ///< as people read it, as the data block names it
  std::string y_label;            ///< "Recommended clearance"
  std::vector<double> x;
  std::vector<Curve> curves;
  std::vector<Horizontal> horizontals;
  int key_columns = 1;
  double share_within = 1.0;  ///< of the slips the figure must hold; 1: all
};

/// Draws below the title that figure.title and `below` make. Slips that are not finite are gaps;
/// steep curves may leave at the top.
void draw_curves(Figure& figure, const std::string& below, const CurvePlot& plot);

/// An ordered family of curves: colour and point of the curve `index` of `count`.
std::string family_style(std::size_t index, std::size_t count);

}  // namespace glissade
