// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace glissade {

/// An InputError of a file that cannot be written: the system's reason and what to do.
[[noreturn]] void throw_io_error(const std::filesystem::path& path, const std::string& doing,
                                 int error_number);

/// Owns an open file descriptor; `close` reports the error of a delayed write. Every failure is an
/// InputError.
class OutputFile {
 public:
  /// @param fd from ::open; @param shown the file the user named, for errors
  OutputFile(int fd, const std::filesystem::path& shown);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);
  void sync();  ///< what was written is on the disk on return
  void close();
  /// Takes disk space for the first `bytes` of the file, whose size stays: what is written there
  /// later cannot meet a full disk. Without effect on file systems that cannot.
  void reserve(std::uint64_t bytes);
  void release();  ///< gives back what is reserved behind the file's end
  int descriptor() const { return fd_; }

 private:
  std::filesystem::path path_;
  int fd_;
};

}  // namespace glissade
