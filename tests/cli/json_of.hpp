// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/child.hpp"

namespace glissade::test {

using Json = nlohmann::json;

inline std::vector<std::string> with(std::vector<std::string> arguments,
                                     const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// What `glissade COMMAND OPTIONS --json` prints: one object, and nothing else.
inline Json json_of(const std::vector<std::string>& command,
                    const std::vector<std::string>& options = {}) {
  const Finished child = run_program(with(with(command, options), {"--json"}));
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_EQ(child.err, "");
  return Json::parse(child.out);  // throws on anything beside one object
}

}  // namespace glissade::test
