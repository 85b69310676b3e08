// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "glissade/core/error.hpp"

namespace glissade {

namespace fs = std::filesystem;

namespace {

/// The status that `read` gives; none where the path is that of no file.
fs::file_status known_status(const fs::path& path,
                             fs::file_status (*read)(const fs::path&, std::error_code&)) {
  std::error_code error;
  const fs::file_status status = read(path, error);
  if (status.type() != fs::file_type::none) return status;
  if (error.value() == ELOOP || error.value() == ENAMETOOLONG)
    return fs::file_status(fs::file_type::not_found);
  throw_read_error(path, "cannot be looked up", error.value());
}

}  // namespace

fs::file_status status_of(const fs::path& path) { return known_status(path, fs::status); }

fs::file_status link_status_of(const fs::path& path) {
  return known_status(path, fs::symlink_status);
}

fs::path real_path(const fs::path& path) {
  std::error_code error;
  fs::path real = fs::canonical(path, error);
  if (error) throw_read_error(path, "cannot be looked up", error.value());
  return real;
}

bool leads_to_an_open_file(fs::path path) {
  while (fs::is_symlink(link_status_of(path))) {
    const fs::path folder = fs::absolute(path).parent_path();
    if (real_path(folder).string().starts_with("/proc/")) return true;
    path = folder / fs::read_symlink(path);
  }
  return false;
}

InputFile::InputFile(const fs::path& path)
    : path_(path), fd_{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)} {
  if (fd_ < 0) fail(errno);
  try {
    struct stat status {};
    if (::fstat(fd_, &status) != 0) fail(errno);
    if (S_ISDIR(status.st_mode)) fail(EISDIR);
    if (S_ISREG(status.st_mode)) return;
    if (!S_ISFIFO(status.st_mode) || !leads_to_an_open_file(path)) {
      throw InputError({path.string(), "is no regular file but a pipe, a device or a socket",
                        "give the path of a regular file", ""});
    }
    if (::fcntl(fd_, F_SETFL, 0) != 0) fail(errno);  // its reads wait for what is written
  } catch (...) {
    ::close(fd_);
    throw;
  }
}

InputFile::~InputFile() { ::close(fd_); }

std::uint64_t InputFile::size() const {
  struct stat status {};
  if (::fstat(fd_, &status) != 0) fail(errno);
  return static_cast<std::uint64_t>(status.st_size);
}

std::size_t InputFile::read(std::span<char> bytes) const {
  for (;;) {
    const ssize_t count = ::read(fd_, bytes.data(), bytes.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) fail(errno);
  }
}

void InputFile::seek(std::uint64_t offset) const {
  if (::lseek(fd_, static_cast<off_t>(offset), SEEK_SET) < 0) fail(errno);
}

void InputFile::fail(int error_number) const {
  throw_read_error(path_, "cannot be read", error_number);
}

}  // namespace glissade
