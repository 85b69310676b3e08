// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace glissade {

/// Prints a page with WeasyPrint: PAGE.pdf beside PAGE.html, tagged (PDF/UA). False where it is not
/// installed or does not succeed.
bool print_page(const std::filesystem::path& html);

}  // namespace glissade
