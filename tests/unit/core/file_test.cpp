// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

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

// /dev/shm is a folder of regular files among the devices.
TEST(write_text_file, replaces_a_regular_file_below_dev) {
  const std::string file = "/dev/shm/glissade_text_file_" + std::to_string(::getpid());
  if (!std::ofstream(file)) GTEST_SKIP() << "no /dev/shm to write to";
  write_text_file(file, "old");
  write_text_file(file, "new");
  EXPECT_EQ(read_text_file(file), "new");
  fs::remove(file);
}

TEST(write_text_file, adds_to_a_regular_file_that_the_shell_has_opened_as_a_descriptor) {
  const fs::path file = fs::path(testing::TempDir()) / "glissade_opened_file.txt";
  std::ofstream(file) << "before, ";
  const int opened = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  ASSERT_GE(opened, 0);
  const fs::path link = fs::path(testing::TempDir()) / "glissade_link_to_opened_file";
  fs::remove(link);
  fs::create_symlink("/dev/fd/" + std::to_string(opened), link);
  write_text_file("/dev/fd/" + std::to_string(opened), "then ");
  write_text_file(link, "text");
  EXPECT_EQ(::close(opened), 0);
  EXPECT_EQ(read_text_file(file), "before, then text");
}

TEST(write_text_file, follows_links_and_replaces_what_they_lead_to) {
  const fs::path file = fs::path(testing::TempDir()) / "glissade_linked_file.txt";
  const fs::path link = fs::path(testing::TempDir()) / "glissade_link";
  write_text_file(file, "old");
  fs::remove(link);
  fs::create_symlink(file.filename(), link);
  write_text_file(link, "new");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_text_file(file), "new");
}

// Who may write to the folder could put a link in the way, to have another file written over.
TEST(write_text_file, does_not_follow_a_link_in_the_place_of_its_partial_file) {
  const fs::path folder = fs::path(testing::TempDir()) / "glissade_partial";
  fs::remove_all(folder);
  const fs::path file = folder / "out.txt", other = folder / "other.txt";
  write_text_file(other, "not to be touched");
  const fs::path link = file.string() + ".partial." + std::to_string(::getpid());
  fs::create_symlink(other, link);
  write_text_file(file, "text");
  EXPECT_EQ(read_text_file(other), "not to be touched");
  EXPECT_EQ(read_text_file(file), "text");
  EXPECT_FALSE(fs::is_symlink(file));
  EXPECT_TRUE(fs::is_symlink(link));
}

// A process that was killed, with the same id in another container, leaves its partial file.
TEST(write_text_file, leaves_a_partial_file_of_another_process_alone) {
  const fs::path folder = fs::path(testing::TempDir()) / "glissade_partial_left";
  fs::remove_all(folder);
  const fs::path file = folder / "out.txt";
  const fs::path left = file.string() + ".partial." + std::to_string(::getpid());
  write_text_file(left, "of another");
  write_text_file(file, "text");
  EXPECT_EQ(read_text_file(left), "of another");
  EXPECT_EQ(read_text_file(file), "text");
}

TEST(read_text_file, tells_of_a_file_that_is_not_there) {
  EXPECT_THROW(read_text_file(fs::path(testing::TempDir()) / "glissade_no_such_file"), InputError);
  EXPECT_THROW(read_text_file(fs::path(testing::TempDir()) / std::string(5000, 'x')), InputError);
}

TEST(read_text_file, ends_where_a_file_does_not) {
  EXPECT_THROW(read_text_file("/dev/zero"), InputError);
}

}  // namespace
}  // namespace glissade
