// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "glissade/motion/conditional_selection.hpp"
#include "glissade/report/table.hpp"

namespace glissade::cli {

/// The options that state a conditional spectrum: of `suite target` and `suite select`.
struct ConditionalOptions {
  std::optional<double> period_s, sa_g, epsilon, magnitude, distance_km, vs30_mps;
  std::optional<double> from_s, to_s;
  std::string mechanism = "strike_slip";

  void add_to(CLI::App& command);
  bool are_given() const;
  /// Throws InputError with all that is missing or out of range.
  ConditionalTarget target() const;
  /// "Sa(0.5 s) = 0.8 g (RotD50), M 7, ..., epsilon 1.21"
  std::string sentence(const ConditionalTarget& target) const;
  /// What is possible and not probable, or outside the range of the model.
  std::vector<std::string> warnings(const ConditionalTarget& target) const;
};

/// The spectrum by period.
Table target_table(const ConditionalTarget& target);

}  // namespace glissade::cli
