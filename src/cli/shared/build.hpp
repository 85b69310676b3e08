// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade::cli {

/// "commit 6ab75ac1b2, g++ 12.2.0".
std::string build_text();

}  // namespace glissade::cli
