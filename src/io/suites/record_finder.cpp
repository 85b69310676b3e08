// SPDX-License-Identifier: GPL-3.0-or-later
#include "suites/record_finder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <sstream>

#include "glissade/core/error.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/io/record_file.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  const fs::file_status status = status_of(path);
  return fs::exists(status) && !fs::is_directory(status);
}

bool ends_with(const fs::path& path, const fs::path& tail) {
  const std::vector<fs::path> a(path.begin(), path.end()), b(tail.begin(), tail.end());
  return b.size() <= a.size() && std::equal(b.rbegin(), b.rend(), a.rbegin());
}

std::vector<fs::path> folders_of_environment() {
  const char* value = std::getenv("GLISSADE_RECORDS");
  std::vector<fs::path> folders;
  std::istringstream list(value == nullptr ? "" : value);
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
  return folders;
}

}  // namespace

RecordFinder::RecordFinder(fs::path suite_folder)
    : suite_folder_(std::move(suite_folder)), folders_(folders_of_environment()) {}

std::string RecordFinder::searched() const {
  std::string text = "in " + (suite_folder_.empty() ? "." : suite_folder_.string());
  if (folders_.empty()) return text + " (GLISSADE_RECORDS is not set)";
  for (const fs::path& folder : folders_) {
    text += "; in and below " + folder.string() + " (GLISSADE_RECORDS)" +
            (fs::is_directory(status_of(folder)) ? "" : ", which is no folder");
  }
  for (const fs::path& folder : closed_)
    text += "; not in " + folder.string() + ", which you may not read";
  return text;
}

// Links to folders are not followed.
void RecordFinder::index_below(const fs::path& folder) {
  std::vector<fs::path> entries;
  try {
    entries = files_in(folder);
  } catch (const IoError& error) {
    if (error.error_number() != EACCES) throw;
    closed_.push_back(folder);
  }
  for (const fs::path& entry : entries) {
    if (fs::is_directory(link_status_of(entry)))
      index_below(entry);
    else if (is_file(entry))
      by_name_[entry.filename().string()].push_back(entry);
  }
}

const std::vector<fs::path>& RecordFinder::files_named(const std::string& file_name) {
  if (!is_indexed_) {
    for (const fs::path& folder : folders_)
      if (fs::is_directory(status_of(folder))) index_below(folder);
    is_indexed_ = true;
    for (auto& [name, files] :
         by_name_) {  // folders are listed in any order, and may be given twice
      std::sort(files.begin(), files.end());
      files.erase(std::unique(files.begin(), files.end()), files.end());
    }
  }
  return by_name_[file_name];
}

std::optional<fs::path> RecordFinder::find(const fs::path& name) {
  if (const fs::path file = suite_folder_ / name; is_file(file)) return file;
  if (name.is_absolute()) return std::nullopt;
  for (const fs::path& folder : folders_) {
    if (const fs::path file = folder / name; is_file(file)) return file;
  }
  std::vector<fs::path> candidates = files_named(name.filename().string());
  if (candidates.empty()) return std::nullopt;
  if (candidates.size() > 1) {
    std::vector<fs::path> closer;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(closer),
                 [&](const fs::path& file) { return ends_with(file, name); });
    if (!closer.empty()) candidates = closer;
  }
  if (candidates.size() == 1) return candidates.front();
  throw InputError(
      {"", name.string() + " fits " + candidates[0].string() + " and " + candidates[1].string(),
       "give more of the path, or set GLISSADE_RECORDS to the folder that holds the right one",
       ""});
}

std::optional<RecordFinder::Found> RecordFinder::find_component(const std::string& name) {
  if (auto path = find(name)) return Found{std::move(*path), ""};
  for (std::size_t mark = name.find('#', 1); mark != std::string::npos;
       mark = name.find('#', mark + 1))
    if (auto path = find(name.substr(0, mark)))
      return Found{std::move(*path), name.substr(mark + 1)};
  return std::nullopt;
}

}  // namespace glissade
