// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/core/file_name.hpp"
#include "glissade/fragility/fit.hpp"

// A figure as a value: what is drawn, in the numbers of its axes. render_figure() makes the only
// script of it.
namespace glissade {

struct Colour {
  std::uint32_t rgb = 0;  ///< 0xrrggbb
  bool operator==(const Colour&) const = default;
};

/// How a series looks. Figures take it by role, so that a median is the same in each of them.
struct Look {
  Colour colour;
  double width = 2.0;
  int dash = 1;    ///< of the line; 1: solid
  int symbol = 0;  ///< of points; 0: none
  double symbol_size = 0.7;
  bool operator==(const Look&) const = default;
};

enum class Role {
  clearance,  ///< the number to design with
  median,
  mean,
  p16,
  p84,
  p95,
  largest,
  record,      ///< one of many, in the background
  bound,       ///< of what is possible
  target,      ///< a design spectrum
  prescribed,  ///< by a standard
  reference,   ///< to read others against
  published,   ///< by others
};
Look look(Role role);
/// One of an ordered family: colours that stay ordered in grey and for colour-blind readers
/// (viridis, Smith & van der Walt 2015, without its light end), and symbols of different outline.
Look family_look(std::size_t index, std::size_t count);
/// One of a few that have no order (Okabe & Ito 2008).
Look distinct_look(std::size_t index);

struct DataSeries {
  enum class Kind {
    line,
    points,
    line_and_points,
    band,  ///< shaded from low to high
    bars,  ///< from low to high, thin
    area,  ///< shaded within the closed line
  };
  Kind kind = Kind::line;
  Look look;
  std::string name;          ///< of its numbers in NAME.dat, and in the titles of its points
  std::string label;         ///< in the key; empty: it has none
  std::vector<double> x, y;  ///< a gap where one is not finite; without numbers: in the key alone
  std::vector<double> low, high;  ///< of bands and bars, in place of y; drawn to the edge where
                                  ///< infinite
  double aside = 0.0;             ///< added to x where it is drawn, not in NAME.dat
  std::string source = {};        ///< "tables/chart.csv: mu, clearance_m", where it is of a table

  void add(double x_value, double y_value);
  /// Of bands and bars; nothing where an end is NaN.
  void add(double x_value, const Interval& range);
  /// The next point begins another line.
  void end_line();
};

/// A straight line across the plot, or part of it.
struct Rule {
  enum class Kind { horizontal, vertical };
  Kind kind = Kind::horizontal;
  double at = 0.0;
  Look look;
  std::string label;            ///< in the key
  double from = 0.0, to = 0.0;  ///< equal: all across
};

/// Text at a place of the plot.
struct Note {
  enum class Align { left, center, right };
  double x = 0.0, y = 0.0;
  std::string text;
  Colour colour;
  Align align = Align::center;
};

struct Tick {
  double at = 0.0;
  std::string label;
};

struct Axis {
  std::string label;  ///< with its unit: "Period (s)"
  double low = 0.0, high = 1.0;
  std::vector<Tick> ticks;  ///< empty: at round numbers
  enum class Values {
    numbers,
    logarithms,  ///< drawn at them; what is below the axis is drawn at its low end
    shares,      ///< in percent
    names,       ///< of the nearest tick
  };
  Values values = Values::numbers;
  std::string length;  ///< of a length: the label without its unit
};
/// A displacement from 0 m on, in the unit that stands first.
Axis length_axis(const std::string& label, double high_m);
/// From 0 to 100 %.
Axis share_axis(const std::string& label);
/// Values at their logarithms. Ticks are at these digits times powers of ten, each with its text.
Axis log_axis(const std::string& label, double low, double high, std::string (*text)(double),
              const std::vector<double>& digits = {1.0});
/// 1, 2 or 5 times a power of ten: about `count` ticks over the range.
double round_step(double range, double count);

struct Panel {
  std::string title;  ///< of one of several
  Axis x, y;
  std::vector<DataSeries> series;  ///< the first lies lowest
  std::vector<Rule> rules;
  std::vector<Note> notes;
};

/// Labels of lines in a margin that the panel gets beside them, each near its height and none over
/// another. Both sizes are shares of the panel.
enum class Side { left, right };
struct LabelMargin {
  Side side;
  double width, line;  ///< line: from one label to the next
};
void add_side_labels(Panel& panel, std::vector<Note> labels, const LabelMargin& margin);

struct Figure {
  FileName name = "figure";        ///< of its files: "fragility"
  std::string title;               ///< one line: what is shown
  std::string below;               ///< a smaller line: of what
  std::string caption;             ///< what to read from it and how it was made
  std::vector<Panel> panels = {};  ///< two in a row, with one key for all of them
  int key_columns = 1;
  bool labels_at_lines = false;  ///< in place of a key
  int plot_height_px = 480;      ///< of a single panel with its axes, of 840 in width: two a page
  std::optional<std::size_t> suite = {};  ///< where it is of one of the study's suites alone
};

/// Writes NAME.gp and NAME.dat and runs gnuplot on them: NAME.svg and NAME.pdf in `folder`. The
/// same figure gives the same bytes (with the same gnuplot, cairo and fonts): the PDF's creation
/// date is set to 1970. `cd folder && gnuplot NAME.gp` draws it again. Throws InputError where
/// gnuplot is not installed or does not succeed, with its message.
void render_figure(const Figure& figure, const std::filesystem::path& folder);

}  // namespace glissade
