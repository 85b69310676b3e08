// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace glissade {

/// A file and its text.
struct TextFile {
  /// Reads it. Throws InputError where it cannot (read_text_file).
  template <class Path>
  requires std::is_convertible_v<Path, std::filesystem::path> TextFile(
      const Path& file)  // NOLINT(google-explicit-constructor): functions take names of files
      : TextFile(read(file)) {}
  TextFile(std::filesystem::path file, std::string content)
      : path(std::move(file)), text(std::move(content)) {}
  std::filesystem::path path;
  std::string text;

 private:
  static TextFile read(const std::filesystem::path& file);
};

/// The text files that a study consists of, each read once, by their names in the study. Rank 0
/// reads them, and the other ranks, which may not see them, have them from it; a report has them
/// from the results file.
class TextFiles {
 public:
  TextFiles() = default;
  /// @param packed of a rank that has read all of them
  explicit TextFiles(std::span<const char> packed);
  std::vector<char> packed() const;
  /// Of finished results: every other file that the study names was there.
  explicit TextFiles(std::map<std::string, std::string> texts)
      : are_given_(true), all_are_there_(true), texts_(std::move(texts)) {}
  const std::map<std::string, std::string>& texts() const { return texts_; }

  /// @param name relative to `folder`, or absolute
  /// Throws InputError where it cannot be read (read_text_file).
  TextFile text_file(const std::filesystem::path& folder, const std::string& name);
  /// A text in place of a file's own.
  void put(const std::string& name, std::string text) { texts_[name] = std::move(text); }
  /// Whether a file is there, to be read by rank 0.
  bool is_there(const std::filesystem::path& file);

 private:
  bool are_given_ = false, all_are_there_ = false;
  std::map<std::string, std::string> texts_;
  std::set<std::string> there_;
};

}  // namespace glissade
