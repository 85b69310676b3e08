// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/report/figure.hpp"

// What names the lines and points of a figure: as it is drawn, and under the pointer in a browser.
namespace glissade {

/// A panel without its title and the labels of its axes, as it is drawn.
struct PanelSize {
  double width_px, height_px;
};

/// Turns key entries of lines and points into labels beside their last points, and those of level
/// rules into labels on the rules where these hide nothing, else in the margin at the right. The
/// entry stays where the label is too long for it.
void label_lines(Panel& panel, const PanelSize& size);

/// As a reader of the axis says it: "0.131 m (5.16 in)", "12 %", a name.
std::string value_on(const Axis& axis, double value);

/// What is to be seen, for who does not see it: axes, and of each line its ends and its largest
/// value.
std::string description_of(const Figure& figure);

/// gnuplot's drawing of a figure with its title and description, with a title at each point that
/// says what it is, "84th percentile: Period (s) 1.23, Displacement 2.6 in (0.066 m)", and at each
/// line its name, which browsers show, in place of the titles that only number the plots.
std::string with_tooltips(const std::string& svg, const Figure& figure);

}  // namespace glissade
