// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/report/figure.hpp"

namespace glissade {

/// A panel without its title and the labels of its axes, as it is drawn.
struct PanelSize {
  double width_px, height_px;
};

/// Turns key entries of lines and points into labels beside their last points, and those of level
/// rules into labels on the rules where these hide nothing, else in the margin at the right. The
/// entry stays where the label is too long for it.
void label_lines(Panel& panel, const PanelSize& size);

}  // namespace glissade
