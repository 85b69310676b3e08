// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <spawn.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/core/output_file.hpp"

// gnuplot and WeasyPrint: they read and write files in memory, since not all of their writes to a
// disk are checked.
namespace glissade {

/// A file in memory that a child has open too, by the same number.
class MemoryFile {
 public:
  /// @param shown the file that it is made for, in errors
  explicit MemoryFile(const std::filesystem::path& shown);
  int descriptor() const { return file_.descriptor(); }
  std::string name() const { return "/dev/fd/" + std::to_string(descriptor()); }
  void write(const std::string& text) { file_.write(text); }
  /// All that is in it.
  std::string read() const;

 private:
  OutputFile file_;
};

struct ChildProgram {
  std::vector<std::string> words = {};  ///< the program, of PATH, and its arguments
  std::string variable = {};            ///< "NAME=VALUE", beside those of this process
  std::filesystem::path folder = {};    ///< where it starts; empty: here
  std::vector<const MemoryFile*> files = {};
  std::string input = "/dev/null", output = "/dev/null";

  /// Why it did not succeed; empty: it did. Nothing where it is not installed.
  std::optional<std::string> failure() const;
};

}  // namespace glissade
