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

struct ModeFile {
  std::vector<Mode> modes;   ///< the longest period first
  bool has_damping = false;  ///< of each mode; else theirs is the usual one
};

/// Modes of a building along one axis; those without mass along it are left out. Recognised by its
/// heading:
/// - a table with period_s, participation (at the array), mass_share and, where wanted, damping, in
///   any order;
/// - Modal Participating Mass Ratios of ETABS (Case, Mode, Period, UX, UY ...) and SAP 2000
///   (OutputCase, StepType, StepNum, Period, UX, UY ...), with or without their title and row of
///   units, to which the engineer adds participation, or factor and roof_shape;
/// - the report that OpenSees writes with modalProperties -file, of a model of two dimensions along
///   x alone, as its y is the vertical.
/// Numbers may have decimal commas (between semicolons or tabs), mass shares and damping a percent
/// sign. Throws InputError that names the line where a number is out of its range, for a column
/// that is there twice, and where the mass shares are above 1 together.
ModeFile read_modes(const std::filesystem::path& file, const ModeFileOptions& options = {});

}  // namespace glissade
