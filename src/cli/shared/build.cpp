// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/build.hpp"

#include "commit.hpp"  // made by the build

namespace glissade::cli {

std::string build_text() {
#ifdef __clang__
  return "commit " GLISSADE_COMMIT ", " __VERSION__;
#else
  return "commit " GLISSADE_COMMIT ", g++ " __VERSION__;
#endif
}

}  // namespace glissade::cli
