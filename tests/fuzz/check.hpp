// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "glissade/core/error.hpp"
#include "glissade/core/output_file.hpp"
#include "unit/io/temporary_folder.hpp"

/// What libFuzzer, or replay.cpp, calls with each input. Returning is passing.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace glissade::fuzz {

/// Ends the program where a target's claim does not hold; libFuzzer then keeps the input.
inline void check(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", claim);
  std::abort();
}

/// A folder for the process's inputs: readers take paths. tests/fuzz/run puts it into memory.
inline const TemporaryFolder& folder() {
  static const TemporaryFolder here;
  return here;
}

/// Of a folder that is there; with fewer calls of the system than TemporaryFolder::write.
inline std::filesystem::path write_input(const char* name, std::string_view text) {
  const std::filesystem::path path = folder().path() / name;
  OutputFile file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666), path);
  file.write(text);
  file.close();
  return path;
}

inline std::filesystem::path input_file(const std::uint8_t* data, std::size_t size,
                                        const char* name = "input") {
  return write_input(name, {reinterpret_cast<const char*>(data), size});
}

/// Reads, and is content with a refusal; whatever else is thrown ends the program.
template <class Read>
void may_refuse(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    check(!error.problems().empty(), "a refusal names at least one problem");
  }
}

}  // namespace glissade::fuzz
