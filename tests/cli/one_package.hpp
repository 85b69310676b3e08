// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

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
