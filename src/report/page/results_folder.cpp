// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/results_folder.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <sstream>
#include <string_view>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/file_name.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/core/input_file.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = "report_files.txt";

/// Of any results folder that a command began: run.json or the journal states it.
constexpr std::array begun_names{"run.json",  "results.h5",  "stop",         "report_files.txt",
                                 "journal/",  "journal/run", "journal/lock", "journal/#-#.units",
                                 "tables/",   "figures/",    "demand/",      "uncertainty/",
                                 "target_#/", "site_#/",     "probability/"};
/// Listed in report_files.txt: first those that a report replaces.
constexpr std::array report_names{"report.html",   "package.html", "product.html",
                                  "sites.html",    "tables/*.csv", "figures/*.svg",
                                  "figures/*.pdf", "figures/*.gp", "figures/*.dat"};
constexpr std::array calculation_names{
    "demand.toml", "uncertainty.toml", "probability.toml", "target_#.toml", "package.json",
    "package.pdf", "package.xlsx",     "product.json",     "product.pdf",   "product.xlsx",
    "sites.json",  "sites.pdf",        "sites.xlsx"};

bool is_number(std::string_view text) {
  return !text.empty() &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool matches(std::string_view pattern, std::string_view name) {
  const std::size_t at = pattern.find_first_of("#*");
  if (at == std::string_view::npos) return name == pattern;
  if (!name.starts_with(pattern.substr(0, at))) return false;
  const std::string_view rest = pattern.substr(at + 1);
  const auto is_part = [&](std::string_view part) {
    return pattern[at] == '#' ? is_number(part) : FileName::accepts(part);
  };
  for (std::size_t end = at + 1; end <= name.size(); ++end)
    if (is_part(name.substr(at, end - at)) && matches(rest, name.substr(end))) return true;
  return false;
}

bool is_one_of(const auto& patterns, const std::string& name) {
  return std::ranges::any_of(patterns, [&](const char* pattern) { return matches(pattern, name); });
}

bool is_of_a_report(const std::string& name) { return is_one_of(report_names, name); }

bool is_listed_kind(const std::string& name) {
  return is_of_a_report(name) || is_one_of(calculation_names, name);
}

using Names = std::set<std::string>;

/// The list may have been written by anybody.
Names listed(const fs::path& folder) {
  for (const char* part : {"tables", "figures"}) check_own_folder(folder / part);
  const fs::path list = folder / list_name;
  check_own_file(list);
  Names names;
  if (!is_there(list)) return names;
  const std::string text = read_text_file(list);
  std::istringstream lines(text);
  for (std::string name; std::getline(lines, name);)
    if (is_listed_kind(name)) names.insert(name);
  if (names.empty() && !text.empty())
    throw InputError({list.string(), "is not as glissade writes it", "move it away", ""});
  return names;
}

void list(const fs::path& folder, const Names& names) {
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  write_text_file(folder / list_name, text);
}

/// And what writers of any of `all` left that were killed.
void remove(const fs::path& folder, const Names& names, const Names& all) {
  for (const char* part : {"", "tables", "figures"}) {
    for (const fs::path& file : files_in(folder / part)) {
      const std::string name = (part / file.filename()).string();
      if ((names.contains(name) || all.contains(whole_name(name))) &&
          fs::is_regular_file(link_status_of(file)))
        remove_file(file);
    }
  }
}

}  // namespace

std::vector<std::string> output_names() {
  std::vector<std::string> names(begun_names.begin(), begun_names.end());
  names.insert(names.end(), report_names.begin(), report_names.end());
  names.insert(names.end(), calculation_names.begin(), calculation_names.end());
  return names;
}

bool is_output_name(const std::string& name) {
  return is_listed_kind(name) || is_one_of(begun_names, name);
}

void check_own(const fs::path& folder) {
  const std::vector<std::string> names = output_names();
  for (const char* part : {"", "journal"}) {
    for (const fs::path& path : files_in(folder / part)) {
      const std::string name = (part / path.filename()).string();
      for (const std::string& pattern : names) {
        if (pattern.find('*') != std::string::npos) continue;
        if (matches(pattern, name)) check_own_file(path);
        if (matches(pattern, name + "/")) check_own_folder(path);
      }
    }
  }
}

void check_files(const fs::path& folder, const std::vector<std::string>& names) {
  GLISSADE_EXPECTS(std::ranges::all_of(names, is_listed_kind));
  const Names earlier = listed(folder);
  for (const std::string& name : names) {
    check_own_file(folder / name);
    if (!earlier.contains(name) && is_there(folder / name))
      throw InputError({(folder / name).string(),
                        "is there already, and report_files.txt does not list it: it is not "
                        "written over",
                        "move it away, or give another folder", ""});
  }
}

void begin_files(const fs::path& folder, const std::vector<std::string>& names) {
  check_files(folder, names);
  Names all = listed(folder);
  all.insert(names.begin(), names.end());
  list(folder, all);
}

void end_report(const fs::path& folder, const std::vector<std::string>& names) {
  const Names all = listed(folder);
  Names kept(names.begin(), names.end()), removed;
  for (const std::string& name : all)
    if (!kept.contains(name)) (is_of_a_report(name) ? removed : kept).insert(name);
  remove(folder, removed, all);
  if (!removed.empty()) list(folder, kept);
}

void remove_listed(const fs::path& folder) {
  const Names all = listed(folder);
  remove(folder, all, all);
  remove_file(folder / list_name);
}

bool is_whole(const fs::path& folder) {
  const Names names = listed(folder);
  return !names.empty() && std::ranges::all_of(names, [&](const std::string& name) {
    const fs::path file = folder / name;
    return fs::is_regular_file(status_of(file)) && fs::file_size(file) > 0;
  });
}

}  // namespace glissade
