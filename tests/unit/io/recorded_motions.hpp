// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

#include "glissade/core/units.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/intensity.hpp"

namespace glissade {

inline std::filesystem::path folder_of_records() {
  const char* named = std::getenv("GLISSADE_RECORDS");
  return named != nullptr ? named : GLISSADE_SOURCE_DIR "/../shared/records";
}

inline double peak_g(std::span<const double> acceleration_mps2) {
  return peak_ground_acceleration_mps2(acceleration_mps2) / standard_gravity_mps2;
}

/// Tests with recorded motions, where there are any.
class RecordedMotions : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(folder_ / "formats"))
      GTEST_SKIP() << "no recorded motions: set GLISSADE_RECORDS, or put them in ../shared/records";
  }
  /// A suite of the project.
  Suite load(const std::string& name) const {
    ::setenv("GLISSADE_RECORDS", folder_.c_str(), 1);
    return load_suite(std::filesystem::path(GLISSADE_SOURCE_DIR) / "suites" / name);
  }
  const std::filesystem::path folder_ = folder_of_records();
};

}  // namespace glissade
