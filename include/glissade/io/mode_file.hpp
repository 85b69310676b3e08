// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "glissade/building/modes.hpp"

namespace glissade {

enum class ModeAxis { x, y };

/// What an exported table does not state.
struct ModeFileOptions {
  std::optional<ModeAxis> axis;  ///< of tables with both
  /// By mode: its displacement at the array along the axis, where the file has participation
  /// factors and no shapes.
  std::vector<double> roof_shape;
};

/// Modes of a building along one axis, the longest period first; those without mass along it are
/// left out. Recognised by its heading:
/// - a table with period_s, participation (at the array) and mass_share, in any order;
/// - Modal Participating Mass Ratios of ETABS (Case, Mode, Period, UX, UY ...) and SAP 2000
///   (OutputCase, StepType, StepNum, Period, UX, UY ...), with or without their title and row of
///   units, to which the engineer adds participation, or factor and roof_shape;
/// - the report that OpenSees writes with modalProperties -file.
/// Throws InputError that names the line where a number is out of its range, and where the mass
/// shares are above 1 together.
std::vector<Mode> read_modes(const std::filesystem::path& file,
                             const ModeFileOptions& options = {});

}  // namespace glissade
