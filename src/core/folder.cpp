// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/folder.hpp"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string_view>
#include <system_error>

#include "glissade/core/error.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/core/output_file.hpp"

namespace glissade {

namespace fs = std::filesystem;

// By the calls of the system: std::filesystem::directory_iterator ends the program where memory
// ends (libstdc++ 12).
std::vector<fs::path> files_in(const fs::path& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> list(opendir(folder.empty() ? "." : folder.c_str()),
                                                 closedir);
  if (list == nullptr && (errno == ENOENT || errno == ENOTDIR)) return {};
  if (list == nullptr) throw_read_error(folder, "cannot be listed", errno);
  std::vector<fs::path> files;
  errno = 0;
  while (const dirent* entry = readdir(list.get())) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") files.push_back(folder / name);
    errno = 0;
  }
  if (errno != 0) throw_read_error(folder, "cannot be listed", errno);
  std::ranges::sort(files);
  return files;
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw_io_error(file, "cannot be removed", error.value());
}

namespace {

void check_own(const fs::path& path, fs::file_type type, const char* fault) {
  const fs::file_status status = link_status_of(path);
  if (!fs::exists(status) || status.type() == type) return;
  throw InputError({path.string(), fs::is_symlink(status) ? "is a link" : fault,
                    "move it away, or give another folder", ""});
}

}  // namespace

bool is_there(const fs::path& path) { return fs::exists(link_status_of(path)); }

void check_own_file(const fs::path& file) {
  check_own(file, fs::file_type::regular, "is no regular file");
}

void check_own_folder(const fs::path& folder) {
  check_own(folder, fs::file_type::directory, "is no folder");
}

}  // namespace glissade
