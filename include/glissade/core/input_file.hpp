// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "glissade/core/io_error.hpp"

namespace glissade {

/// A regular file to read, or a pipe that is open already (/dev/stdin, <(command) of a shell).
/// Every failure, of the disk too, is an IoError with the path and the system's reason.
class InputFile {
 public:
  /// Does not wait: a named pipe that nobody writes to would else never be open.
  explicit InputFile(const std::filesystem::path& path);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  std::uint64_t size() const;  ///< of a regular file
  /// What comes next, at most as many bytes; how many. 0: the end.
  std::size_t read(std::span<char> bytes) const;
  void seek(std::uint64_t offset) const;

 private:
  [[noreturn]] void fail(int error_number) const;
  std::filesystem::path path_;
  int fd_;
};

/// What lies at a path, or where the link there leads; of a link itself. "Not found" is said of no
/// other path: IoError where the system does not answer, as with a folder that may not be searched
/// or a disk that fails.
std::filesystem::file_status status_of(const std::filesystem::path& path);
std::filesystem::file_status link_status_of(const std::filesystem::path& path);
/// The path without links. IoError where nothing is there.
std::filesystem::path real_path(const std::filesystem::path& path);

/// True of /dev/stdout, /dev/fd/3 and the like: links that the system keeps below /proc to what a
/// process has open.
bool leads_to_an_open_file(std::filesystem::path path);

}  // namespace glissade
