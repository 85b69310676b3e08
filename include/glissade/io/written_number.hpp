// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade {

/// A number with its unit, "18 in", as the number in the unit at the end of a key, all digits; a
/// text without a unit, and of a key that has none, as it is. Throws InputError where the unit is
/// not one of the key's. @param key "threshold_m", or "--threshold-m"
std::string number_in_unit_of(std::string key, const std::string& text);

}  // namespace glissade
