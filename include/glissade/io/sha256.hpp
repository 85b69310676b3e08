// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace glissade {

/// SHA-256 (FIPS 180-4) in hexadecimal digits.
std::string sha256_of(std::string_view bytes);
/// Of a file. Throws InputError where it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace glissade
