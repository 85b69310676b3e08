// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/paged_memory.hpp"

#include <fcntl.h>
#include <stdlib.h>  // mkstemp
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "glissade/core/output_file.hpp"

namespace glissade {
namespace {

/// A new file for reading and writing that no other process finds.
int open_unnamed(const std::filesystem::path& folder) {
  const int fd = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (fd >= 0 || (errno != EOPNOTSUPP && errno != EISDIR)) return fd;
  std::string name = (folder / "pages.XXXXXX").string();  // some file systems cannot
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

}  // namespace

void* map_pages(const std::filesystem::path& folder, std::size_t bytes) {
  OutputFile file(open_unnamed(folder), folder);
  // Else a full disk would end the process when a page is written.
  int full = EINTR;
  while (full == EINTR)  // a signal to stop the run
    full = ::posix_fallocate(file.descriptor(), 0, static_cast<off_t>(bytes));
  if (full != 0) throw_io_error(folder, "cannot take the pages of the histories", full);
  void* pages = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.descriptor(), 0);
  if (pages == MAP_FAILED) throw std::bad_alloc();
  return pages;
}

void unmap_pages(void* pages, std::size_t bytes) { ::munmap(pages, bytes); }

}  // namespace glissade
