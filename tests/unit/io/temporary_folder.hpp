// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "glissade/core/error.hpp"

namespace glissade {

/// A folder of its own for one test, gone afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "glissade_io_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    const auto file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }

 private:
  std::filesystem::path path_;
};

/// Everything an InputError says; "" if nothing was thrown.
template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The line of a file that each problem of an InputError names, 0 where none; empty if nothing was
/// thrown.
template <class Action>
std::vector<std::size_t> lines_of(const Action& action) {
  std::vector<std::size_t> lines;
  try {
    action();
  } catch (const InputError& error) {
    for (const Problem& p : error.problems()) {
      const std::string number = p.where.substr(p.where.rfind(':') + 1);
      lines.push_back(std::strtoull(number.c_str(), nullptr, 10));
    }
  }
  return lines;
}

/// The line and the key of each problem of an InputError: "14 building.period_s".
template <class Action>
std::vector<std::string> faults_of(const Action& action) {
  const std::vector<std::size_t> lines = lines_of(action);
  std::vector<std::string> faults;
  try {
    action();
  } catch (const InputError& error) {
    for (const Problem& p : error.problems())
      faults.push_back(std::to_string(lines[faults.size()]) + " " +
                       p.what.substr(0, p.what.find(' ')));
  }
  return faults;
}

}  // namespace glissade
