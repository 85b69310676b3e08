// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/report/html_text.hpp"

namespace glissade {

/// Writes a page, of which the foot is still missing, with its symbols set; and prints it with
/// WeasyPrint: PAGE.pdf beside PAGE.html, tagged (PDF/UA). False where that is not installed.
/// Throws InputError where it does not succeed.
bool write_and_print(const Html& page, const std::filesystem::path& html);

}  // namespace glissade
