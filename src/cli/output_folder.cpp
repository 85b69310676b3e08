// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_folder.hpp"

#include "glissade/core/error.hpp"

namespace glissade::cli {

void check_output_folder(const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::exists(folder, error)) return;
  if (!std::filesystem::is_directory(folder, error))
    throw InputError({folder.string(), "is not a folder", "give another --out", ""});
  if (!std::filesystem::is_empty(folder, error) || error) {
    throw InputError({folder.string(),
                      "already holds a run or other files, which are never written over",
                      "give a new folder with --out, or remove this one", ""});
  }
}

}  // namespace glissade::cli
