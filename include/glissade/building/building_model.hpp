// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "glissade/building/modes.hpp"

namespace glissade {

/// What gives the modes of a building from its first period, along each of its axes.
struct BuildingModel {
  enum class Kind {
    one_mass,
    cantilever,  ///< uniform, of flexure and shear: cantilever_modes()
    storeys,     ///< a shear building
    modes        ///< of the engineer's own model
  };
  Kind kind = Kind::one_mass;
  /// By axis, their periods over the first; of a cantilever only if it has one alpha.
  std::array<std::vector<Mode>, 2> modes;
  bool has_own_damping = false;  ///< the stated modes have theirs
  bool is_one_storey = false;    ///< stated, of one mass

  bool is_one_mass() const { return kind == Kind::one_mass; }
};

/// The modes along an axis that a building is computed with.
/// @param first its first period, 0: rigid; and the damping ratio of all modes, if they have no own
/// @param alpha of a cantilever, 0 to largest_alpha
Modes modes_along(const BuildingModel& model, std::size_t axis, const Oscillator& first,
                  double alpha);

}  // namespace glissade
