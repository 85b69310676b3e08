// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "glissade/parallel/communicator.hpp"

namespace glissade::cli {

// Each adds one command to the program: its options, and what it calls. No physics here.
void add_run(CLI::App& program, const Communicator& world);
void add_clearance(CLI::App& program, const Communicator& world);
void add_slide(CLI::App& program);
void add_fit(CLI::App& program);
void add_friction(CLI::App& program);
void add_suite(CLI::App& program);
void add_suite_import(CLI::App& suite);  // called by add_suite
void add_suite_select(CLI::App& suite);  // likewise
void add_standards(CLI::App& program);
void add_building(CLI::App& program);
void add_report(CLI::App& program);
void add_explain(CLI::App& program);
void add_init(CLI::App& program);

/// What `glissade check` prints of a project. Throws InputError where it cannot run.
void check_project(const std::filesystem::path& file, const std::filesystem::path& out);

/// The same of a product file.
void check_product(const std::filesystem::path& file, const std::filesystem::path& out);

/// Throws InputError where a calculation cannot begin in the folder.
void check_calculation_folder(const std::filesystem::path& out, bool overwrite);

}  // namespace glissade::cli
