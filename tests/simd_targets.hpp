// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <string>

namespace glissade::test {

inline void use_targets(std::int64_t targets) {
  hwy::SetSupportedTargetsForTest(targets);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

/// Calls what() with each SIMD target that this machine has; their names.
template <class What>
std::string on_each_target(const What& what) {
  std::string ran;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    use_targets(target);
    SCOPED_TRACE(hwy::TargetName(target));
    EXPECT_EQ(hwy::SupportedTargets(), target);  // it is the one that runs
    what();
    ran += std::string(hwy::TargetName(target)) + " ";
  }
  use_targets(0);
  EXPECT_FALSE(ran.empty());
  return ran;
}

}  // namespace glissade::test
