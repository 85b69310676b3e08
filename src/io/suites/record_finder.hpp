// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace glissade {

/// Finds the record files a suite names: relative to the suite file; else below the folders of
/// GLISSADE_RECORDS (colon-separated), first by the same relative path below each, then by file
/// name anywhere below. IoError where one cannot be listed; those that the user may not read are
/// named among the places searched.
class RecordFinder {
 public:
  explicit RecordFinder(std::filesystem::path suite_folder);
  /// Nothing if it is not there. Throws InputError, naming two, where the name fits several files
  /// and the relative path none or several of them.
  std::optional<std::filesystem::path> find(const std::filesystem::path& name);
  /// The same of a name with a component behind it, floor.csv#U1 or all.zip#floor.csv#U1, unless
  /// that is a file itself.
  struct Found {
    std::filesystem::path path;
    std::string component;
  };
  std::optional<Found> find_component(const std::string& name);
  /// Where it looks, for a message.
  std::string searched() const;

 private:
  void index_below(const std::filesystem::path& folder);
  const std::vector<std::filesystem::path>& files_named(const std::string& file_name);
  std::filesystem::path suite_folder_;
  std::vector<std::filesystem::path> folders_, closed_;
  bool is_indexed_ = false;
  std::map<std::string, std::vector<std::filesystem::path>> by_name_;
};

}  // namespace glissade
