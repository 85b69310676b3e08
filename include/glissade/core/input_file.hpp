// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace glissade {

/// A regular file to read, or a pipe that is open already (/dev/stdin, <(command) of a shell).
/// Every failure, of the disk too, is an InputError with the path and the system's reason.
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

/// True of /dev/stdout, /dev/fd/3 and the like: links that the system keeps below /proc to what a
/// process has open.
bool leads_to_an_open_file(std::filesystem::path path);

}  // namespace glissade
