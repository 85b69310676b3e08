// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/hash.hpp"

#include <gtest/gtest.h>

namespace glissade {
namespace {

// FNV-1a 64-bit test values from the reference (Fowler, Noll & Vo): "" and "a" and "foobar".
TEST(hasher, gives_the_published_fnv1a_values) {
  const auto hash = [](std::string_view text) {
    return Hasher().bytes(std::as_bytes(std::span(text.data(), text.size()))).value();
  };
  EXPECT_EQ(to_hex(hash("")), "cbf29ce484222325");
  EXPECT_EQ(to_hex(hash("a")), "af63dc4c8601ec8c");
  EXPECT_EQ(to_hex(hash("foobar")), "85944171f73967e8");
}

TEST(hasher, tells_apart_lists_that_concatenate_to_the_same) {
  EXPECT_NE(Hasher().text("ab").text("c").value(), Hasher().text("a").text("bc").value());
}

}  // namespace
}  // namespace glissade
