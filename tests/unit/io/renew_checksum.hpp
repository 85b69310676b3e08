// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>

#include "results/envelope.hpp"

namespace glissade::test {

/// Of a results file that was edited by HDF5, which cuts off what follows its content.
inline void renew_checksum(const std::filesystem::path& file) {
  OutputFile output(::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC), file);
  append_checksum(file, output);
  output.close();
}

}  // namespace glissade::test
