// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "glissade/study/plan/kernel.hpp"

namespace glissade::cli {

/// The options of `glissade slide`.
struct SlideOptions {
  std::string record, vertical, second, units, method = "event", history;
  double mu = 0.0, slope_deg = 0.0, period_s = 0.0, mass_ratio = 0.0;
  std::optional<double> scale, pga_g, dt_s, cm_height_m, base_width_m, clearance_m;
  std::optional<double> given_damping, given_vertical_damping;  ///< absent: 0.05
  std::optional<int> given_substeps;                            ///< absent: 64
  bool one_way = false, json = false, overwrite = false;
  // The model's extensions.
  std::optional<double> mu_across, yield_coefficient;
  double azimuth_deg = 0.0, period_ratio = 1.0, hardening_ratio = 0.0;
  double vertical_period_s = 0.0;
  FrictionLaw law;

  bool two_axes() const { return !second.empty(); }
  double damping() const { return given_damping.value_or(0.05); }
  double vertical_damping() const { return given_vertical_damping.value_or(0.05); }
  int substeps() const { return given_substeps.value_or(64); }
};

void add_options(CLI::App& command, SlideOptions& options);

/// Throws InputError with everything in which the options break a rule or each other.
void check(const SlideOptions& options);

/// The cheapest kernel that is exact for the options.
KernelChoice kernel_for(const SlideOptions& options);

}  // namespace glissade::cli
