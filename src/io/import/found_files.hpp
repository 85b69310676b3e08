// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "glissade/io/suite_import.hpp"

namespace glissade {

/// The files of the inputs, each once, sorted; of folders all below them, but for hidden ones and
/// links out of the folder. Throws InputError where an input is not there, and for too many files;
/// IoError where a folder cannot be listed.
std::vector<std::filesystem::path> found_files(const std::vector<std::filesystem::path>& inputs,
                                               std::vector<LeftOut>& left_out);

/// A file, or one in an archive, and its bytes.
struct FileToRead {
  std::filesystem::path file;
  std::string member;  ///< empty: no archive
  const std::string& bytes;

  std::string shown() const { return file.string() + (member.empty() ? "" : "#" + member); }
};

/// All components of a file. Throws InputError where it cannot be read.
std::vector<FoundComponent> read_components(const FileToRead& file,
                                            const RecordFileOptions& missing);

}  // namespace glissade
