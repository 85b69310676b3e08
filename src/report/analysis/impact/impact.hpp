// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

// The array reaching a clearance: how fast, when, how often. Nothing where the study has no
// [impact].
namespace glissade {

bool has_impact(const Results& results);

/// Kinetic energy of what moves at this speed, by its mass.
inline double energy_jpkg(double speed_mps) { return 0.5 * speed_mps * speed_mps; }

/// The first run at a handful of levels, where the array reaches it at all: for reading.
Table brief_impact_table(const Results& results);
/// How to read any of it, in plain words.
std::string impact_explained();
/// Speeds at a level, one sentence; empty where no history reaches it.
std::string impact_sentence(const Results& results, double level);

}  // namespace glissade
