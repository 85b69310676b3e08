// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "glissade/core/error.hpp"

namespace glissade {

void throw_io_error(const std::filesystem::path& path, const std::string& doing, int error_number) {
  const char* suggestion = "check that the path is right and that you may write there";
  if (error_number == ENOSPC || error_number == EDQUOT || error_number == EFBIG)
    suggestion = "make room on the disk or write elsewhere";
  if (error_number == EIO) suggestion = "check the disk, or write elsewhere";
  throw IoError(
      {path.string(), doing + ": " + std::generic_category().message(error_number), suggestion, ""},
      error_number);
}

void throw_read_error(const std::filesystem::path& path, const std::string& doing,
                      int error_number) {
  throw IoError(
      {path.string(), doing + ": " + std::generic_category().message(error_number),
       error_number == EIO ? "check the disk" : "check that it exists and that you may read it",
       ""},
      error_number);
}

namespace {

/// Calls until all bytes are through: `call` takes how many are, and gives how many it adds; 0
/// ends.
template <class Call>
bool all_bytes(std::size_t bytes, Call call) {
  for (std::size_t done = 0; done < bytes;) {
    const ssize_t more = call(done);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) return false;
    if (more == 0) return true;
    done += static_cast<std::size_t>(more);
  }
  return true;
}

}  // namespace

OutputFile::OutputFile(int fd, const std::filesystem::path& shown) : path_(shown), fd_(fd) {
  if (fd_ < 0) fail("cannot be opened for writing");
}

OutputFile::~OutputFile() {
  if (fd_ >= 0) ::close(fd_);
}

void OutputFile::fail(const char* doing) const { throw_io_error(path_, doing, errno); }

void OutputFile::write(std::string_view text) {
  const auto more = [&](std::size_t done) {
    return ::write(fd_, text.data() + done, text.size() - done);
  };
  if (!all_bytes(text.size(), more)) fail("cannot be written");
}

void OutputFile::write_at(std::uint64_t offset, std::string_view bytes) {
  const auto more = [&](std::size_t done) {
    return ::pwrite(fd_, bytes.data() + done, bytes.size() - done,
                    static_cast<off_t>(offset + done));
  };
  if (!all_bytes(bytes.size(), more)) fail("cannot be written");
}

void OutputFile::read_at(std::uint64_t offset, std::span<char> bytes) const {
  const auto more = [&](std::size_t done) {
    return ::pread(fd_, bytes.data() + done, bytes.size() - done,
                   static_cast<off_t>(offset + done));
  };
  if (!all_bytes(bytes.size(), more)) fail("cannot be read while it is written");
}

void OutputFile::resize(std::uint64_t bytes) {
  if (::ftruncate(fd_, static_cast<off_t>(bytes)) != 0) fail("cannot be written");
}

void OutputFile::sync() {
  if (::fsync(fd_) != 0) fail("cannot be flushed to the disk");
}

void OutputFile::forget() const { ::posix_fadvise(fd_, 0, 0, POSIX_FADV_DONTNEED); }

void OutputFile::close() {
  const int fd = fd_;
  fd_ = -1;
  if (::close(fd) != 0) fail("cannot be closed");
}

}  // namespace glissade
