// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "glissade/core/io_error.hpp"

namespace glissade {

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
  void write_at(std::uint64_t offset, std::string_view bytes);
  /// Of a file that is open for reading too; what is behind its end stays as it is.
  void read_at(std::uint64_t offset, std::span<char> bytes) const;
  void resize(std::uint64_t bytes);
  void sync();  ///< what was written is on the disk on return
  /// What was flushed is read from the disk next time, not from memory, where the system can.
  void forget() const;
  void close();
  int descriptor() const { return fd_; }

 private:
  [[noreturn]] void fail(const char* doing) const;  ///< with errno
  std::filesystem::path path_;
  int fd_;
};

}  // namespace glissade
