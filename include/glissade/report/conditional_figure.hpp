// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/motion/conditional_selection.hpp"
#include "glissade/report/figure.hpp"

namespace glissade {

/// The spectra of selected records beside their target: mean, 2.5th and 97.5th percentile.
/// @param target_text what the target is
Figure conditional_figure(const ConditionalTarget& target, const ConditionalSelection& selection,
                          const std::string& target_text);

}  // namespace glissade
