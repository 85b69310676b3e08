// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/report_files.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/file_name.hpp"
#include "glissade/core/folder.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = "report_files.txt";

/// The list may have been written by anybody.
bool is_of_a_report(const std::string& name) {
  constexpr std::array<const char*, 4> pages{"report.html", "package.html", "product.html",
                                             "sites.html"};
  constexpr std::array<const char*, 5> endings{"tables/.csv", "figures/.svg", "figures/.pdf",
                                               "figures/.gp", "figures/.dat"};
  const fs::path path(name);
  const std::string folder = path.parent_path().string() + "/", stem = path.stem().string(),
                    extension = path.extension().string();
  return std::ranges::count(pages, name) > 0 ||
         (std::ranges::count(endings, folder + extension) > 0 && FileName::accepts(stem) &&
          name == folder + stem + extension);
}

std::set<std::string> listed(const fs::path& folder) {
  for (const char* part : {"tables", "figures"}) check_own_folder(folder / part);
  const fs::path list = folder / list_name;
  check_own_file(list);
  std::set<std::string> names;
  std::error_code ignored;
  if (!fs::exists(list, ignored)) return names;
  std::istringstream lines(read_text_file(list));
  for (std::string name; std::getline(lines, name);)
    if (is_of_a_report(name)) names.insert(name);
  return names;
}

}  // namespace

void remove_report(const fs::path& folder) {
  const std::set<std::string> own = listed(folder);
  std::error_code ignored;
  for (const char* part : {"", "tables", "figures"}) {
    for (const fs::path& file : files_in(folder / part)) {
      const std::string name = (part / file.filename()).string();
      if ((own.contains(name) || own.contains(whole_name(name))) &&
          fs::is_regular_file(fs::symlink_status(file, ignored)))
        remove_file(file);
    }
  }
  remove_file(folder / list_name);
}

void begin_report(const fs::path& folder, const std::vector<std::string>& names, bool overwrite) {
  GLISSADE_EXPECTS(std::ranges::all_of(names, is_of_a_report));
  const std::set<std::string> earlier = listed(folder);
  std::string list;
  std::error_code ignored;
  for (const std::string& name : names) {
    check_own_file(folder / name);
    if (!overwrite && !earlier.contains(name) && fs::exists(folder / name, ignored))
      throw InputError({(folder / name).string(), "is there already, and is of no earlier report",
                        "move it away, or make the report with --overwrite", ""});
    list += name + "\n";
  }
  remove_report(folder);
  for (const std::string& name : names) remove_file(folder / name);
  write_text_file(folder / list_name, list);
}

}  // namespace glissade
