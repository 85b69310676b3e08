// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "glissade/io/journal.hpp"

// The rule of all commands on what is there already: it is not written over, unless the user gives
// --overwrite.
namespace glissade::cli {

/// Adds the option --overwrite.
void add_overwrite(CLI::App& command, bool& overwrite);

/// Throws InputError, naming the option that gave the path, where `file` is a regular file. Devices
/// and pipes are written to.
void check_output_file(const std::filesystem::path& file, const std::string& option,
                       bool overwrite);

/// The path up to its last folder (or file) that exists.
std::filesystem::path existing_part(const std::filesystem::path& path);

/// Throws InputError where the folder holds anything (without `overwrite`) or a run.json or
/// results.h5 of the user, is no folder, or could not be written to. It need not exist.
void check_output_folder(const std::filesystem::path& folder, bool overwrite);

/// Throws InputError where the folder, which may hold other files, holds a report.
void check_report_folder(const std::filesystem::path& folder, bool overwrite);

/// Before a command writes into a results folder: no other can take it. What commands left there
/// that were killed while they wrote a file is removed.
std::unique_ptr<RunLock> take_folder(const std::filesystem::path& folder);

}  // namespace glissade::cli
