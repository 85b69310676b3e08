// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace glissade {

/// Two storeys of 3 m: a building of this height or more is taken for one of several storeys, and
/// so is one with the period that ASCE 7 gives for it, where its storeys are not stated.
inline constexpr double height_of_two_storeys_m = 6.0;

/// Above it one mass is a warning: no building of one storey is that flexible as a rule (recalled).
inline constexpr double longest_one_mass_period_s = 0.3;

/// That one mass on one spring gives too little slip on a building of several storeys, and how much
/// too little; empty for one storey, and for a rigid building (0).
std::string one_mass_sentence(std::optional<double> storeys, double longest_period_s);

}  // namespace glissade
