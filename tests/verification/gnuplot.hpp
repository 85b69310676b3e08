// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace glissade::verification {

/// Draws a figure of `size` pixels with gnuplot. Throws std::runtime_error where gnuplot fails.
void gnuplot_svg(const std::filesystem::path& file, const std::string& script,
                 const std::string& size = "760,480");

}  // namespace glissade::verification
