// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glissade/core/error.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

TEST(write_text_file, replaces_a_file_whole_and_tells_of_a_full_disk) {
  const fs::path file = fs::path(testing::TempDir()) / "glissade_text_file.txt";
  write_text_file(file, "old");
  write_text_file(file, "new");
  EXPECT_EQ(read_text_file(file), "new");
  try {
    write_text_file("/dev/full", "text");
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("No space left"));
  }
}

TEST(read_text_file, tells_of_a_file_that_is_not_there) {
  EXPECT_THROW(read_text_file(fs::path(testing::TempDir()) / "glissade_no_such_file"), InputError);
}

}  // namespace
}  // namespace glissade
