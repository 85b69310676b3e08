// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// { distribution = NAME, KEYS } of a study file.
struct DistributionForm {
  const char* name;
  const char* keys;
  Distribution (*read)(const TomlTable& table);
};
std::span<const DistributionForm> distribution_forms();

/// One value, or what is drawn.
Quantity quantity_of(const Distribution& distribution);

/// A quantity of a study: a number, a list, { from, to, count }, a distribution, or { mean, std }
/// of a normal one that is cut at the ends of the range. Nothing where the key is absent or wrong.
std::optional<Quantity> read_quantity(const TomlTable& table, const char* key,
                                      const ParameterRange& range);

/// The same of a slope that is given as the rise in 12, not in degrees.
std::optional<Quantity> read_rise_in_12(const TomlTable& table);

/// Notes a coefficient of variation, in whose place std or log_std is given; whether there is one.
bool refuse_cov(const TomlTable& moments, bool of_median);

}  // namespace glissade
