// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_rule.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

#include "glissade/core/error.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

/// What a report is made of: a page, and folders of files with these extensions.
constexpr const char* page = "report.html";
struct ReportFolder {
  const char* name;
  std::vector<std::string> extensions;
};
const std::vector<ReportFolder>& report_folders() {
  static const std::vector<ReportFolder> folders{{"tables", {".csv"}},
                                                 {"figures", {".svg", ".pdf", ".gp", ".dat"}}};
  return folders;
}

std::vector<fs::path> files_of_report(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  if (fs::exists(folder / page, ignored)) files.push_back(folder / page);
  for (const ReportFolder& part : report_folders()) {
    for (const auto& entry : fs::directory_iterator(folder / part.name, ignored)) {
      if (std::ranges::find(part.extensions, entry.path().extension().string()) !=
          part.extensions.end())
        files.push_back(entry.path());
    }
  }
  return files;
}

[[noreturn]] void refuse(const std::string& option, const fs::path& path, const char* why) {
  throw InputError({option, path.string() + ' ' + why + ": existing files are not overwritten",
                    "give another " + option + ", or --overwrite", ""});
}

void check_folder(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored))
    throw InputError({"--out", folder.string() + " is not a folder", "give another --out", ""});
}

/// As the system answers; on some network file systems the first write decides.
void check_may_write(const fs::path& folder) {
  const fs::path existing = existing_part(folder);
  std::error_code ignored;
  const bool is_folder = fs::is_directory(existing, ignored);
  if (is_folder && ::faccessat(AT_FDCWD, existing.c_str(), W_OK | X_OK, AT_EACCESS) == 0) return;
  const int error_number = is_folder ? errno : ENOTDIR;
  const bool is_there = fs::exists(folder, ignored);
  throw InputError({folder.string(),
                    fmt::format("cannot be {} ({}): {}", is_there ? "written to" : "made",
                                existing.string(), std::generic_category().message(error_number)),
                    "give a folder you may write to with --out", ""});
}

}  // namespace

fs::path existing_part(const fs::path& path) {
  std::error_code ignored;
  fs::path existing = fs::absolute(path);
  while (!fs::exists(existing, ignored) && existing.has_relative_path())
    existing = existing.parent_path();
  return existing;
}

void add_overwrite(CLI::App& command, bool& overwrite) {
  command.add_flag("--overwrite", overwrite, "overwrite existing files");
}

void check_output_file(const fs::path& file, const std::string& option, bool overwrite) {
  std::error_code ignored;
  const bool leads_nowhere = fs::is_symlink(file, ignored) && !fs::exists(file, ignored);
  if (!overwrite && (leads_nowhere || fs::is_regular_file(file, ignored)))
    refuse(option, file, "is there already");
}

void check_output_folder(const fs::path& folder, bool overwrite) {
  check_folder(folder);
  check_may_write(folder);
  std::error_code error;
  if (overwrite || !fs::exists(folder, error)) return;
  if (!fs::is_empty(folder, error) || error) refuse("--out", folder, "holds a run or other files");
}

void check_report_folder(const fs::path& folder, bool overwrite) {
  check_folder(folder);
  if (!overwrite && !files_of_report(folder).empty()) refuse("--out", folder, "holds a report");
}

void remove_report(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::path& file : files_of_report(folder)) fs::remove(file, ignored);
}

void remove_run(const fs::path& folder) {
  remove_report(folder);
  std::error_code ignored;
  for (const char* name : {"results.h5", "run.json"}) fs::remove(folder / name, ignored);
}

}  // namespace glissade::cli
