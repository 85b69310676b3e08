// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/small_study.hpp"

namespace glissade::test {

namespace fs = std::filesystem;

inline const std::string project_file = GLISSADE_SOURCE_DIR "/studies/permit_project.toml";

/// The example in another folder, with fewer samples.
inline std::string moved_project() {
  return replaced(replaced(read_file(project_file), "data/pull_tests.csv",
                           GLISSADE_SOURCE_DIR "/studies/data/pull_tests.csv"),
                  "[suite]\nfile = \"../suites/",
                  "[sampling]\nsamples = 16\n[suite]\nfile = \"" GLISSADE_SOURCE_DIR "/suites/");
}

/// While it lives, commands find gnuplot alone: no package is printed, which takes seconds.
class WithoutWeasyprint {
 public:
  WithoutWeasyprint() {
    fs::create_directory(folder_.path("bin"));
    fs::create_symlink("/usr/bin/gnuplot", folder_.path("bin/gnuplot"));
    ::setenv("PATH", folder_.path("bin").c_str(), 1);
  }
  ~WithoutWeasyprint() { ::setenv("PATH", path_.c_str(), 1); }
  WithoutWeasyprint(const WithoutWeasyprint&) = delete;
  WithoutWeasyprint& operator=(const WithoutWeasyprint&) = delete;

 private:
  ScratchFolder folder_;
  std::string path_ = std::getenv("PATH");
};

/// The example project, run once.
class Package : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    finished_ = run_program({"clearance", project_file, "--out", out().string()});
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path out() { return folder_->path("out"); }
  static nlohmann::json numbers() {
    return nlohmann::json::parse(read_file(out() / "package.json"));
  }

  static inline ScratchFolder* folder_ = nullptr;
  static inline Finished finished_;
};

}  // namespace glissade::test
