// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/output_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "glissade/core/error.hpp"

namespace glissade {

void throw_io_error(const std::filesystem::path& path, const std::string& doing, int error_number) {
  const char* suggestion = error_number == ENOSPC || error_number == EDQUOT || error_number == EFBIG
                               ? "make room on the disk or write elsewhere"
                               : "check that the path is right and that you may write there";
  throw InputError({path.string(), doing + ": " + std::generic_category().message(error_number),
                    suggestion, ""});
}

OutputFile::OutputFile(int fd, const std::filesystem::path& shown) : path_(shown), fd_(fd) {
  if (fd_ < 0) throw_io_error(path_, "cannot be opened for writing", errno);
}

OutputFile::~OutputFile() {
  if (fd_ >= 0) ::close(fd_);
}

void OutputFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(fd_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_io_error(path_, "cannot be written", errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::sync() {
  if (::fsync(fd_) != 0) throw_io_error(path_, "cannot be flushed to the disk", errno);
}

void OutputFile::reserve(std::uint64_t bytes) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && bytes > limit.rlim_cur)
    throw_io_error(path_, "cannot be written", EFBIG);
  if (::fallocate(fd_, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) == 0) return;
  if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG)
    throw_io_error(path_, "cannot be written", errno);
}

void OutputFile::release() {
  struct stat status {};
  if (::fstat(fd_, &status) != 0 || ::ftruncate(fd_, status.st_size) != 0)
    throw_io_error(path_, "cannot be written", errno);
}

void OutputFile::close() {
  const int fd = fd_;
  fd_ = -1;
  if (::close(fd) != 0) throw_io_error(path_, "cannot be closed", errno);
}

}  // namespace glissade
