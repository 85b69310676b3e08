// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace glissade {

/// Names what exp, log, sin and the other functions of the C library give here. Its versions, and
/// one version on processors with and without fused multiply-add, differ in last digits.
std::string mathematics();

}  // namespace glissade
