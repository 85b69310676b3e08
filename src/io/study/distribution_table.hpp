// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glissade/sampling/distribution.hpp"
#include "toml_table.hpp"

namespace glissade {

/// The interval of every value of a distribution: [min, max], or [min, max) where `max_open`.
struct Bounds {
  double min, max;
  enum class Top { closed, open } top = Top::closed;
  const char* text;  ///< "0 or more"
};

/// A plain number, or a table { distribution = "uniform", ... } with the fields of the struct as
/// keys (weights of discrete values default to equal ones). Nothing where the key is absent or
/// wrong.
std::optional<Distribution> read_distribution(const TomlTable& table, const char* key,
                                              const Bounds& bounds);

}  // namespace glissade
