// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/folder.hpp"

#include <algorithm>
#include <system_error>

#include "glissade/core/error.hpp"
#include "glissade/core/output_file.hpp"

namespace glissade {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error, ignored;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    files.push_back(entry->path());
  // Without the memory to list it a folder with files is not one without.
  if (error && fs::exists(folder, ignored))
    throw_io_error(folder, "cannot be listed", error.value());
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
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(path, ignored);
  if (!fs::exists(status) || status.type() == type) return;
  throw InputError({path.string(), fs::is_symlink(status) ? "is a link" : fault,
                    "move it away, or give another folder", ""});
}

}  // namespace

void check_own_file(const fs::path& file) {
  check_own(file, fs::file_type::regular, "is no regular file");
}

void check_own_folder(const fs::path& folder) {
  check_own(folder, fs::file_type::directory, "is no folder");
}

}  // namespace glissade
