// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace glissade {

/// Work that was not done because the study does not need it. It does not change the results: kept
/// in run.json, never in the results file.
struct Skip {
  std::string what;  ///< "histories whose roof moves too little to start sliding"
  std::string why;
  std::uint64_t count = 0;
};

}  // namespace glissade
