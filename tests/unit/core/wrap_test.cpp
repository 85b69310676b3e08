// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/wrap.hpp"

#include <gmock/gmock.h>

namespace glissade {
namespace {

using testing::ElementsAre;

TEST(wrapped, breaks_at_blanks_and_line_ends) {
  EXPECT_THAT(wrapped("a bc def", 4), ElementsAre("a bc", "def"));
  EXPECT_THAT(wrapped("a\nb c", 80), ElementsAre("a", "b c"));
  EXPECT_THAT(wrapped("", 4), ElementsAre(""));
  EXPECT_THAT(wrapped("a  b", 4), ElementsAre("a  b"));
}

TEST(wrapped, breaks_long_words_after_their_parts_and_no_others) {
  EXPECT_THAT(wrapped("rsn953_beverly_hills", 14), ElementsAre("rsn953_", "beverly_hills"));
  EXPECT_THAT(wrapped("unbreakable word", 4), ElementsAre("unbreakable", "word"));
}

TEST(wrapped, counts_characters_of_utf8) {
  EXPECT_EQ(display_width("Gülerce"), 7u);
  EXPECT_THAT(wrapped("üü üü", 5), ElementsAre("üü üü"));
}

TEST(wrapped, indents_all_lines_but_the_first) {
  EXPECT_EQ(wrapped("a bc def", 6, 2), "a bc\n  def");
}

}  // namespace
}  // namespace glissade
