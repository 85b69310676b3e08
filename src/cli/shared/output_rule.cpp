// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/output_rule.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/report/results_folder.hpp"
#include "run/run_record.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& option, const fs::path& path, const char* why) {
  throw InputError({option, path.string() + ' ' + why + ": existing files are not overwritten",
                    "give another " + option + ", or --overwrite", ""});
}

void check_folder(const fs::path& folder) {
  const fs::file_status status = status_of(folder);
  if (fs::exists(status) && !fs::is_directory(status))
    throw InputError({"--out", folder.string() + " is not a folder", "give another --out", ""});
  check_own(folder);
}

/// As the system answers; on some network file systems the first write decides.
void check_may_write(const fs::path& folder, const std::string& option) {
  const fs::path existing = existing_part(folder);
  const bool is_folder = fs::is_directory(status_of(existing));
  if (is_folder && ::faccessat(AT_FDCWD, existing.c_str(), W_OK | X_OK, AT_EACCESS) == 0) return;
  const int error_number = is_folder ? errno : ENOTDIR;
  throw InputError({folder.string(),
                    fmt::format("cannot be {} ({}): {}",
                                existing == fs::absolute(folder) ? "written to" : "made",
                                existing.string(), std::generic_category().message(error_number)),
                    "give a folder you may write to with " + option, ""});
}

/// `run.json` of `run.json.partial.123`, which a killed command left.
bool is_partial_of_own(const fs::path& folder, const fs::path& file) {
  const std::string whole = whole_name((file.lexically_relative(folder)).string());
  return !whole.empty() && is_output_name(whole);
}

/// A command of glissade: else a run.json or results.h5 is the user's.
bool has_begun(const fs::path& folder) {
  const fs::path run_json = folder / "run.json";
  try {
    if (has_identity(folder)) {
      static_cast<void>(read_identity(folder));
      return true;
    }
  } catch (const IoError&) {
    throw;
  } catch (const InputError&) {  // a file of the user
  }
  return is_there(folder / "report_files.txt") ||
         (is_there(run_json) && read_run_json(run_json).contains("status"));
}

/// Nothing, or what a command that was killed at its begin left: it computed nothing.
bool is_free(const fs::path& folder) {
  const auto is_left = [&](const fs::path& file) {
    return (file == folder / "journal/lock" && fs::is_empty(file)) ||
           is_partial_of_own(folder, file);
  };
  return std::ranges::all_of(files_in(folder), [&](const fs::path& file) {
    return file == folder / "journal" ? std::ranges::all_of(files_in(file), is_left)
                                      : is_left(file);
  });
}

}  // namespace

fs::path existing_part(const fs::path& path) {
  fs::path existing = fs::absolute(path);
  while (!fs::exists(status_of(existing)) && existing.has_relative_path())
    existing = existing.parent_path();
  return existing;
}

void add_overwrite(CLI::App& command, bool& overwrite) {
  command.add_flag("--overwrite", overwrite, "overwrite existing files");
}

void check_output_file(const fs::path& file, const std::string& option, bool overwrite) {
  const fs::file_status status = status_of(file);
  const bool leads_nowhere = fs::is_symlink(link_status_of(file)) && !fs::exists(status);
  if (!overwrite && (leads_nowhere || fs::is_regular_file(status)))
    refuse(option, file, "is there already");
  if (fs::is_directory(status))
    throw InputError({option, file.string() + " is a folder", "give a file", ""});
  if (!fs::exists(status))
    check_may_write(file.has_parent_path() ? file.parent_path() : ".", option);
}

void check_output_folder(const fs::path& folder, bool overwrite) {
  check_folder(folder);
  check_may_write(folder, "--out");
  if (!overwrite && !is_free(folder)) refuse("--out", folder, "holds a run or other files");
  if (has_begun(folder)) return;
  for (const char* name : {"run.json", "results.h5", "stop", "journal/run"})
    if (is_there(folder / name))
      throw InputError({(folder / name).string(),
                        "is there already, and no command of glissade began in this folder",
                        "move it away, or give another --out", ""});
}

void check_report_folder(const fs::path& folder, bool overwrite) {
  check_folder(folder);
  for (const char* name : {"report.html", "tables", "figures"})
    if (!overwrite && is_there(folder / name)) refuse("--out", folder, "holds a report");
}

std::unique_ptr<RunLock> take_folder(const fs::path& folder) {
  auto lock = std::make_unique<RunLock>(folder);
  for (const fs::path& in : {folder, folder / "journal"})
    for (const fs::path& file : files_in(in))
      if (is_partial_of_own(folder, file) && fs::is_regular_file(link_status_of(file)))
        remove_file(file);
  return lock;
}

}  // namespace glissade::cli
