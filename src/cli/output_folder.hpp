// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace glissade::cli {

/// A folder that holds anything is never written into: throws InputError where `folder` does, or is
/// no folder. It need not exist.
void check_output_folder(const std::filesystem::path& folder);

}  // namespace glissade::cli
