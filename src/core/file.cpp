// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <span>
#include <system_error>

#include "glissade/core/error.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/core/output_file.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

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
fs::path write_new_beside(const fs::path& path, const WriteFile& write) {
  constexpr int attempts = 100;
  for (int attempt = 0;; ++attempt) {
    fs::path partial = partial_name(path, attempt);
    const int fd = ::open(partial.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd < 0 && errno == EEXIST && attempt + 1 < attempts) continue;
    OutputFile file(fd, path);
    try {
      write(file, partial);
      file.sync();
      file.close();
    } catch (...) {
      ::unlink(partial.c_str());
      throw;
    }
    return partial;
  }
}

void write_and_rename(const fs::path& path, const WriteFile& write) {
  const fs::path partial = write_new_beside(path, write);
  if (::rename(partial.c_str(), path.c_str()) != 0) {
    const int error_number = errno;
    ::unlink(partial.c_str());
    throw_io_error(path, "cannot be put in place", error_number);
  }
  sync_folder(path.parent_path());
}

}  // namespace

std::string read_text_file(const fs::path& path) {
  constexpr std::size_t most_bytes = std::size_t{1} << 28, block_bytes = std::size_t{1} << 20;
  std::size_t part = 4096;  // most files are small: a large block would be cleared for nothing
  const InputFile file(path);
  std::string text;
  while (text.size() <= most_bytes) {
    const std::size_t size = text.size();
    text.resize(size + part);
    text.resize(size + file.read(std::span(text).subspan(size)));
    if (text.size() == size) return text;
    part = block_bytes;
  }
  throw InputError({path.string(), "has more than 256 MiB of text", "take a smaller file", ""});
}

std::string whole_name(const std::string& partial_name) {
  const std::size_t end = partial_name.rfind(".partial.");
  if (end == std::string::npos) return "";
  const std::string process = partial_name.substr(end + std::string_view(".partial.").size());
  const bool is_number = !process.empty() && std::isdigit(process.front()) != 0 &&
                         process.find_first_not_of("0123456789.") == std::string::npos;
  return is_number ? partial_name.substr(0, end) : "";
}

void sync_folder(const fs::path& folder) {
  const int fd = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0 && errno == EACCES) return;  // it may be written to and not read
  const int failure = fd >= 0 && ::fsync(fd) == 0 ? 0 : errno;
  if (fd >= 0) ::close(fd);
  if (failure != 0 && failure != EINVAL && failure != ENOTSUP)  // some file systems need no flush
    throw_io_error(folder, "cannot be flushed to the disk", failure);
}

void create_text_file(const fs::path& path, std::string_view text) {
  OutputFile file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666), path);
  file.write(text);
  file.sync();
  file.close();
}

void write_file(const fs::path& path, const WriteFile& write) {
  const fs::file_status status = status_of(path);
  if (fs::is_directory(status)) throw_io_error(path, "cannot be written", EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw_io_error(path, "is no regular file", EINVAL);
  const fs::path target = fs::is_symlink(link_status_of(path)) ? fs::weakly_canonical(path) : path;
  if (target.has_parent_path()) {
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    if (error) throw_io_error(target.parent_path(), "cannot be made", error.value());
  }
  write_and_rename(target, write);
}

void write_text_file(const fs::path& path, std::string_view text) {
  const fs::file_status status = status_of(path);
  if (must_be_written_directly(path, status) && !fs::is_directory(status))
    return write_directly(path, text);
  write_file(path, [&](OutputFile& file, const fs::path&) { file.write(text); });
}

}  // namespace glissade
