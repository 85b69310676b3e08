// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "glissade/design/project.hpp"

namespace glissade {

/// A project file (TOML; keys: project_example()). Throws InputError with everything that is wrong
/// or missing, each with an example line.
Project read_project(const std::filesystem::path& file);

/// The names of the [[site]] of a project of several sites or roofs; empty: it has one [site].
/// Throws InputError where one has no name or that of another.
std::vector<std::string> site_names(const std::filesystem::path& file);
/// The project of one of them: what [site.roof], [site.building] ... state replaces those tables.
Project read_project(const std::filesystem::path& file, std::size_t site);

/// Whether the file has the [project] of a project file, and is not a study. Throws InputError
/// where it is not TOML.
bool is_project(const std::filesystem::path& file);

/// A project file with every key, commented: what `glissade clearance --example` prints.
std::string project_example();

/// The study of the displacement demand: every combination of period, slope, mass ratio, friction
/// (mean - 2 std, lower bound of the tests), with and without vertical motion, at S_DS and 1.5
/// S_DS, in all orientations. A study file, whose paths are relative to `folder`.
std::string demand_study(const Project& project, const std::filesystem::path& folder);

/// The same of the project's own conditions at S_DS, with friction and damping at both of their
/// ends.
std::string uncertainty_study(const Project& project, const std::filesystem::path& folder);

/// The study of the probability that the displacement exceeds each threshold, at each building
/// period: friction, mass ratio and orientation drawn, on the steepest slope.
std::string probability_study(const Project& project, const std::filesystem::path& folder,
                              const std::vector<double>& thresholds_m);

}  // namespace glissade
