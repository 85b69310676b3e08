// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade::test {

/// How many times as long code takes in this build as in the preset dev: a test that repeats
/// something does so less often.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr int slowdown = 8;
#else
constexpr int slowdown = 1;
#endif

}  // namespace glissade::test
