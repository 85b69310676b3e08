// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/convergence.hpp"
#include "toml_table.hpp"

namespace glissade {

/// The names in study files and in results files.
inline EnumNames<HorizontalComponent> component_names() {
  static constexpr EnumNames<HorizontalComponent> names = {{"first", HorizontalComponent::first},
                                                           {"second", HorizontalComponent::second}};
  return names;
}

}  // namespace glissade
