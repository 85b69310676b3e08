// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "glissade/core/error.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/core/io_error.hpp"
#include "glissade/core/output_file.hpp"
#include "glissade/io/journal.hpp"
#include "journal/names.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// Of an open file (OFD), not of a process: whoever asks for it does not take it. On a network file
/// system the server answers.
struct flock whole_file() {
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// False: another process holds it. A file system without locks refuses nobody.
bool lock_now(int fd) {
  struct flock lock = whole_file();
  return ::fcntl(fd, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

/// Whether the open file is still the one of that name: a run that ended removes it.
bool is_still(int fd, const fs::path& path) {
  struct stat open = {}, named = {};
  const bool is_named = ::stat(path.c_str(), &named) == 0;
  if (!is_named && (errno == ENOENT || errno == ENOTDIR)) return false;
  if (!is_named || ::fstat(fd, &open) != 0) throw_read_error(path, "cannot be looked up", errno);
  return open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

int open_lock(const JournalNames& names) {
  check_own_folder(names.folder);
  std::error_code error;
  fs::create_directories(names.folder, error);
  if (error) {
    throw InputError({names.folder.parent_path().string(), "cannot be made: " + error.message(),
                      "give a folder you may write to with --out", ""});
  }
  const int fd = ::open(names.lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (fd < 0) throw_io_error(names.lock, "cannot be opened for writing", errno);
  struct stat file = {};
  const int failure = ::fstat(fd, &file) == 0 ? 0 : errno;
  if (failure == 0 && file.st_size == 0) return fd;
  ::close(fd);
  if (failure != 0) throw_read_error(names.lock, "cannot be looked up", failure);
  throw InputError(
      {names.lock.string(), "is not as glissade writes it: it is not empty", "move it away", ""});
}

void remove_files(const JournalNames& names) {
  for (const fs::path& file : names.all_units()) remove_file(file);
  remove_file(names.identity);
}

}  // namespace

RunLock::RunLock(const fs::path& run_folder) : folder_(run_folder) {
  const JournalNames names(run_folder);
  for (;;) {
    fd_ = open_lock(names);
    const bool is_free = lock_now(fd_);
    try {
      if (is_free && is_still(fd_, names.lock)) return;
    } catch (...) {
      ::close(fd_);
      throw;
    }
    ::close(fd_);
    if (is_free) continue;  // whoever held it has removed it
    throw InputError({run_folder.string(), "a run is going on in it",
                      "wait until it ends, or give another --out", ""});
  }
}

RunLock::~RunLock() {
  try {
    give_back();
  } catch (const std::exception&) {  // it stays, and nobody holds it
    if (fd_ >= 0) ::close(fd_);
  }
}

void RunLock::check() const {
  if (fd_ >= 0 && !is_still(fd_, JournalNames(folder_).lock))
    throw InputError({folder_.string(), "was removed or moved while it was written to",
                      "run the command again", ""});
}

void RunLock::give_back() {
  if (fd_ < 0) return;
  check();
  const JournalNames names(folder_);
  // Removed before the lock is given back: nobody else takes it then. On a network file system an
  // open file stays in its folder until it is closed.
  const bool is_alone = files_in(names.folder) == std::vector{names.lock};
  if (is_alone) remove_file(names.lock);
  ::close(fd_);
  fd_ = -1;
  if (is_alone) remove_file(names.folder);
}

void RunLock::empty() { remove_files(JournalNames(folder_)); }

void RunLock::remove_journals() {
  empty();
  give_back();
}

void remove_journals(const fs::path& run_folder) {
  const JournalNames names(run_folder);
  remove_files(names);
  remove_file(names.lock);
  remove_file(names.folder);
}

bool is_running(const fs::path& run_folder) {
  const int fd = ::open(JournalNames(run_folder).lock.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0 && (errno == ENOENT || errno == ENOTDIR || errno == ELOOP)) return false;
  if (fd < 0) throw_read_error(run_folder, "cannot be looked up", errno);
  struct flock lock = whole_file();
  const bool is_held = ::fcntl(fd, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  ::close(fd);
  return is_held;
}

}  // namespace glissade
