// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/figures.hpp"

namespace glissade {

/// A line over x, and what lies around it.
struct PlotLine {
  std::string title;  ///< in the key
  std::string style;  ///< gnuplot: "linespoints lw 2 pt 7 lc rgb '#000000'"
  std::vector<double> y;
  std::vector<double> low, high;  ///< a band in `band_colour`, or bars; empty: none
  enum class Spread { band, bars } spread = Spread::band;
  std::string colour = "#000000";  ///< of band or bars
  double shift = 0.0;              ///< along x, so that bars do not hide one another
};

struct PlotMark {
  double x = 0.0, y = 0.0;
  std::string label, colour = "#d55e00";
};

/// A horizontal line with its label.
struct PlotLevel {
  double y = 0.0;
  std::string label, colour = "#d55e00";
};

struct PlotTick {
  double x = 0.0;
  std::string label;
};

enum class PlotLength { no, metres };  ///< metres: inches on the opposite axis

struct LinePlot {
  std::string x_label, y_label;
  PlotLength length = PlotLength::metres;
  std::vector<double> x;
  std::vector<PlotLine> lines;
  std::vector<PlotMark> marks;
  std::vector<PlotLevel> levels;
  std::vector<PlotTick> ticks;  ///< of the x axis; empty: gnuplot's own
  std::string band_title;       ///< tells in the key what bands and bars are; "": nothing
  int key_columns = 1;
  bool from_zero = true;  ///< else from a little below the lowest
};

/// Draws below the title that figure.title and `below` make.
void draw_lines(Figure& figure, const std::string& below, const LinePlot& plot);

}  // namespace glissade
