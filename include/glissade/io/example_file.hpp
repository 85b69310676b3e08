// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace glissade {

/// A commented study or project file to begin with, of which single keys are changed.
class ExampleFile {
 public:
  /// studies/01_quickstart.toml, its keys explained as by `glissade explain`.
  static ExampleFile study();
  /// project_example().
  static ExampleFile project();

  static std::string string_value(const std::string& text);  ///< as TOML

  /// `value` as TOML. A key that is commented out, or not there, is one of the file then.
  void set(const std::string& table, const std::string& key, const std::string& value);
  /// The same, of a value that is still of the example.
  void set_example(const std::string& table, const std::string& key, const std::string& value);
  void set_text(const std::string& table, const std::string& key, const std::string& text);
  void set_numbers(const std::string& table, const std::string& key,
                   const std::vector<double>& values);  ///< one: a number; else a list
  /// As a path from `folder`.
  void set_path(const std::string& table, const std::string& key, const std::filesystem::path& path,
                const std::filesystem::path& folder);
  void comment_out(const std::string& table, const std::string& key);
  void leave_out(const std::string& table);
  /// A key of the example that was commented out is one of the file.
  void take_example(const std::string& table, const std::string& key);
  /// A line for each table, "building    damping, mass_ratio": the keys of the file whose values
  /// are still those of the example. Empty texts count as left open, not as values.
  std::string of_example() const;
  /// With each key's meaning above or beside it.
  std::string text() const;

 private:
  enum class Comments { of_the_grammar, as_they_are };
  ExampleFile(const std::string& text, Comments comments);
  /// The line of the key, commented out or not, else the one below the last of the table.
  std::size_t line_of(const std::string& table, const std::string& key);

  std::vector<std::string> lines_;
  std::set<std::string> given_;  ///< "building.period_s"
  Comments comments_;
};

}  // namespace glissade
