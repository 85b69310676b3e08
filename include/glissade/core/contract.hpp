// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

/// A precondition on the caller's code (not on the user's input: that is InputError). Checked in
/// the dev and asan presets, where it throws std::logic_error naming the condition and the place.
#ifdef GLISSADE_CONTRACTS
#define GLISSADE_STRINGIZE_(x) #x
#define GLISSADE_STRINGIZE(x) GLISSADE_STRINGIZE_(x)
#define GLISSADE_EXPECTS(condition)                                                        \
  ((condition) ? void(0)                                                                   \
               : throw std::logic_error("precondition violated: " #condition " (" __FILE__ \
                                        ":" GLISSADE_STRINGIZE(__LINE__) ")"))
#else
#define GLISSADE_EXPECTS(condition) ((void)0)
#endif
