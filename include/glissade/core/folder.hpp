// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace glissade {

/// What lies in a folder, sorted; nothing where there is no folder. Throws InputError where it
/// cannot be listed.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

/// Whether there is anything of this name, a link too. Throws InputError where the system cannot
/// tell.
bool is_there(const std::filesystem::path& path);

/// Throws InputError where the file is there and cannot be removed. Of a link the link is.
void remove_file(const std::filesystem::path& file);

/// What lies in a results folder is the program's own. Throws InputError where something else is
/// there: for a file a folder, a pipe or a device, for a folder a file, for both a link.
void check_own_file(const std::filesystem::path& file);
void check_own_folder(const std::filesystem::path& folder);

}  // namespace glissade
