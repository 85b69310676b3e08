// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/building/building_model.hpp"

namespace glissade {

Modes modes_along(const BuildingModel& model, std::size_t axis, const Oscillator& first,
                  double alpha) {
  if (model.is_one_mass() || first.period_s == 0.0) return first;
  std::vector<Mode> modes =
      model.modes[axis].empty() ? cantilever_modes(1.0, alpha, most_modes) : model.modes[axis];
  for (Mode& mode : modes) {
    mode.period_s *= first.period_s;
    if (!model.has_own_damping) mode.damping_ratio = first.damping_ratio;
  }
  // Stated modes are all wanted.
  return Modes(model.kind == BuildingModel::Kind::modes ? modes : governing_modes(modes));
}

}  // namespace glissade
