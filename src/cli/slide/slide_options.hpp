// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "glissade/study/plan/kernel.hpp"

namespace glissade::cli {

/// The options of `glissade slide`.
struct SlideOptions {
  std::string record, vertical, second, units, method = "event", history;
  std::vector<std::optional<double>> given;  ///< by parameters(), as options
  Case c;                                    ///< with what is given
  std::optional<double> scale, pga_g, dt_s, counts_per_unit, cm_height_m, base_width_m, clearance_m;
  std::optional<int> given_substeps;  ///< absent: 64
  bool one_way = false, json = false, overwrite = false;
  bool of_roof = false;  ///< the motion is that of the roof: nothing is between it and the array

  std::string modes, modes_across, axis;  ///< files of modes; of an exported one along the first
  std::optional<std::size_t> storeys;
  std::vector<double> storey_masses, storey_stiffnesses;
  BuildingModel building;  ///< as [building] of a study makes it of these

  bool two_axes() const { return !second.empty(); }
  int substeps() const { return given_substeps.value_or(64); }
};

/// A record that is a motion of a suite, "SUITE.toml#ID".
bool names_motion(const SlideOptions& options);

void add_options(CLI::App& command, SlideOptions& options);

/// Makes the case; throws InputError with everything in which the options break a rule or each
/// other.
void check(SlideOptions& options);

/// Throws InputError where a record of this step does not represent a mode of the building.
void check_step(const SlideOptions& options, double step_s);

/// The cheapest kernel that is exact for the options.
KernelChoice kernel_for(const SlideOptions& options);

}  // namespace glissade::cli
