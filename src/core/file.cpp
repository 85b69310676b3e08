// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "glissade/core/error.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_io_error(const fs::path& path, const std::string& doing, int error_number) {
  const char* suggestion = error_number == ENOSPC || error_number == EDQUOT || error_number == EFBIG
                               ? "make room on the disk or write elsewhere"
                               : "check that the path is right and that you may write there";
  throw InputError({path.string(), doing + ": " + std::generic_category().message(error_number),
                    suggestion, ""});
}

/// Owns an open file descriptor; `close` reports the error of a delayed write.
class OutputFile {
 public:
  /// @param fd from ::open; @param shown the file the user named, for errors
  OutputFile(int fd, const fs::path& shown) : path_(shown), fd_(fd) {
    if (fd_ < 0) throw_io_error(path_, "cannot be opened for writing", errno);
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    if (fd_ >= 0) ::close(fd_);
  }

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(fd_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) throw_io_error(path_, "cannot be written", errno);
      text.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void sync() {
    if (::fsync(fd_) != 0) throw_io_error(path_, "cannot be flushed to the disk", errno);
  }
  void close() {
    const int fd = fd_;
    fd_ = -1;
    if (::close(fd) != 0) throw_io_error(path_, "cannot be closed", errno);
  }

 private:
  fs::path path_;
  int fd_;
};

/// True of /dev/stdout, /dev/fd/3 and the like: links that the system keeps below /proc to what a
/// process has open.
bool leads_to_an_open_file(fs::path path) {
  std::error_code ignored;
  while (fs::is_symlink(path, ignored)) {
    const fs::path folder = fs::absolute(path, ignored).parent_path();
    if (fs::canonical(folder, ignored).string().starts_with("/proc/")) return true;
    path = folder / fs::read_symlink(path, ignored);
  }
  return false;
}

/// Devices, pipes and sockets, and /dev/stdout even where the shell points it at a regular file.
bool must_be_written_directly(const fs::path& path, const fs::file_status& status) {
  return fs::exists(status) && (!fs::is_regular_file(status) || leads_to_an_open_file(path));
}

void write_directly(const fs::path& path, std::string_view text) {
  OutputFile file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC), path);
  file.write(text);
  file.close();
}

/// A name for `path` while it is written. One that is taken, by a file that was left over or by a
/// link put in the way, is not written to: the next attempt has another.
fs::path partial_name(const fs::path& path, int attempt) {
  fs::path partial = path;
  partial += ".partial." + std::to_string(::getpid());
  if (attempt > 0) partial += "." + std::to_string(attempt);
  return partial;
}

/// Creates a file that was not there and writes to it; its name.
fs::path write_new_beside(const fs::path& path, std::string_view text) {
  constexpr int attempts = 100;
  for (int attempt = 0;; ++attempt) {
    fs::path partial = partial_name(path, attempt);
    const int fd = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd < 0 && errno == EEXIST && attempt + 1 < attempts) continue;
    OutputFile file(fd, path);
    try {
      file.write(text);
      file.sync();
      file.close();
    } catch (...) {
      ::unlink(partial.c_str());
      throw;
    }
    return partial;
  }
}

void write_and_rename(const fs::path& path, std::string_view text) {
  const fs::path partial = write_new_beside(path, text);
  if (::rename(partial.c_str(), path.c_str()) != 0) {
    const int error_number = errno;
    ::unlink(partial.c_str());
    throw_io_error(path, "cannot be put in place", error_number);
  }
}

}  // namespace

std::string read_text_file(const fs::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (file && !fs::is_directory(path)) {
    try {  // the stream buffer throws where the system refuses a read
      text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
      if (!file.bad()) return text;
    } catch (const std::ios_base::failure&) {
    }
  }
  const int error_number = fs::is_directory(path) ? EISDIR : errno != 0 ? errno : EIO;
  throw InputError({path.string(),
                    "cannot be read: " + std::generic_category().message(error_number),
                    "check that the file exists and that you may read it", ""});
}

void create_text_file(const fs::path& path, std::string_view text) {
  OutputFile file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666), path);
  file.write(text);
  file.sync();
  file.close();
}

void write_text_file(const fs::path& path, std::string_view text) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) throw_io_error(path, "cannot be written", EISDIR);
  if (must_be_written_directly(path, status)) return write_directly(path, text);

  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  if (target.has_parent_path()) {
    fs::create_directories(target.parent_path(), error);
    if (error) throw_io_error(target.parent_path(), "cannot be made", error.value());
  }
  write_and_rename(target, text);
}

}  // namespace glissade
