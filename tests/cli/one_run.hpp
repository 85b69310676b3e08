// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/child.hpp"

namespace glissade::test {

/// One run of a study, shared by the tests that look at what it left.
template <std::string (*study_text)()>
class OneRun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    study_ = folder_->write("small.toml", study_text());
    finished_ = run_program({"run", study_, "--out", out().string()});
  }
  /// Here, since tests of a suite that is not set up are skipped.
  void SetUp() override { ASSERT_EQ(finished_.status, 0) << finished_.err; }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static std::filesystem::path out() { return folder_->path("out"); }
  /// `report`, in a folder of its own, gives these files again.
  static void expect_report_gives_again(const std::vector<std::string>& names) {
    const std::filesystem::path again = folder_->path("report_again");
    succeeding({"report", (out() / "results.h5").string(), "--out", again.string()});
    for (const std::string& name : names)
      EXPECT_TRUE(read_file(again / name) == read_file(out() / name)) << name;
  }

  static inline ScratchFolder* folder_ = nullptr;
  static inline std::string study_;
  static inline Finished finished_;
};

}  // namespace glissade::test
