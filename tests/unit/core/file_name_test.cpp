// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/file_name.hpp"

#include <gtest/gtest.h>

#include "glissade/core/error.hpp"

namespace glissade {
namespace {

TEST(file_name, takes_what_means_nothing_to_a_shell_a_script_or_a_page) {
  for (const char* good : {"sampled", "design", "fragility_design", "a-1", "9"})
    EXPECT_EQ(FileName(good).text(), good);
  EXPECT_TRUE(FileName::accepts(std::string(64, 'a')));
}

TEST(file_name, refuses_all_else) {
  for (const char* bad : {"", "a b", "A", "a.b", "..", "../a", "a/b", "`a`", "$(a)", "a'b", "a\"b",
                          "a;b", "a\nb", "<script>", "a&b", "\xc3\xa9", "a\\b", "|a"}) {
    EXPECT_FALSE(FileName::accepts(bad)) << bad;
    EXPECT_THROW(FileName{bad}, InputError) << bad;
  }
  EXPECT_FALSE(FileName::accepts(std::string_view("a\0b", 3)));
  EXPECT_FALSE(FileName::accepts(std::string(65, 'a')));
}

}  // namespace
}  // namespace glissade
