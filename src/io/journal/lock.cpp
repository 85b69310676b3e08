// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "glissade/core/error.hpp"
#include "glissade/core/output_file.hpp"
#include "glissade/io/journal.hpp"
#include "journal/names.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// False: another process holds it. A file system without locks refuses nobody.
bool lock_now(int fd) { return ::flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

/// Whether the open file is still the one of that name: a run that ended removes it.
bool is_still(int fd, const fs::path& path) {
  struct stat open = {}, named = {};
  return ::fstat(fd, &open) == 0 && ::stat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

/// Not a link to a folder of somebody else.
bool is_own(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(folder, ignored));
}

void remove_files(const JournalNames& names) {
  std::error_code ignored;
  if (!is_own(names.folder)) return;
  for (const fs::path& file : names.all_units()) fs::remove(file, ignored);
  fs::remove(names.identity, ignored);
}

void remove_folder(const JournalNames& names) {
  std::error_code ignored;
  if (!is_own(names.folder)) return;
  fs::remove(names.lock, ignored);
  fs::remove(names.folder, ignored);  // if empty
}

}  // namespace

RunLock::RunLock(const fs::path& run_folder) : folder_(run_folder) {
  const JournalNames names(run_folder);
  std::error_code error;
  fs::create_directories(names.folder, error);
  if (error) {
    throw InputError({run_folder.string(), "cannot be made: " + error.message(),
                      "give a folder you may write to with --out", ""});
  }
  if (!is_own(names.folder)) {
    throw InputError(
        {names.folder.string(), "is a link", "remove it, or give another folder with --out", ""});
  }
  fd_ = ::open(names.lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (fd_ < 0) throw_io_error(names.lock, "cannot be opened for writing", errno);
  if (lock_now(fd_) && is_still(fd_, names.lock)) return;
  ::close(fd_);
  throw InputError({run_folder.string(), "a run is going on in it",
                    "wait until it ends, or give another --out", ""});
}

RunLock::~RunLock() {
  if (fd_ >= 0) ::close(fd_);
}

void RunLock::remove_journals() {
  const JournalNames names(folder_);
  remove_files(names);
  ::close(fd_);  // before it is removed: a network file system keeps an open file in its folder
  fd_ = -1;
  remove_folder(names);
}

bool is_running(const fs::path& run_folder) {
  const int fd = ::open(JournalNames(run_folder).lock.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0) return false;
  const bool free = lock_now(fd);
  ::close(fd);
  return !free;
}

void remove_journals(const fs::path& run_folder) {
  const JournalNames names(run_folder);
  remove_files(names);
  remove_folder(names);
}

}  // namespace glissade
