// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <thread>

#include "glissade/core/input_file.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

// What the system does not say is never "not there" (tests/cli injects EIO and the like).
TEST(status_of, is_not_found_only_where_nothing_is_there) {
  const fs::path folder = fs::path(testing::TempDir()) / "glissade_status";
  fs::remove_all(folder);
  fs::create_directories(folder);
  write_text_file(folder / "file", "text");
  fs::create_symlink("loop", folder / "loop");
  fs::create_symlink("file", folder / "link");
  EXPECT_TRUE(fs::is_regular_file(status_of(folder / "link")));
  EXPECT_TRUE(fs::is_symlink(link_status_of(folder / "link")));
  for (const fs::path& nothing :
       {folder / "none", folder / "file/below", folder / "loop", folder / std::string(300, 'n')})
    EXPECT_FALSE(fs::exists(status_of(nothing))) << nothing;
}

TEST(read_text_file, reports_what_the_system_refuses_apart_from_what_is_no_file) {
  const fs::path pipe = fs::path(testing::TempDir()) / "glissade_pipe";
  fs::remove(pipe);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(read_text_file("/nowhere/file"), IoError);
  try {
    read_text_file(pipe);
    FAIL() << "nothing thrown";
  } catch (const IoError&) {
    FAIL() << "a pipe is no failure of the system";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no regular file"));
  }
}

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

TEST(whole_name, is_that_of_the_file_which_a_killed_writer_did_not_end) {
  EXPECT_EQ(whole_name("a.csv.partial.4711"), "a.csv");
  EXPECT_EQ(whole_name("a.partial.1.csv.partial.4711.2"), "a.partial.1.csv");
  for (const char* other : {"a.csv", "a.csv.partial", "a.csv.partial.", "a.csv.partial.mine",
                            "a.csv.partial.1.old", "a.csv.partial..1"})
    EXPECT_EQ(whole_name(other), "") << other;
}

TEST(read_text_file, tells_of_a_file_that_is_not_there) {
  EXPECT_THROW(read_text_file(fs::path(testing::TempDir()) / "glissade_no_such_file"), InputError);
  EXPECT_THROW(read_text_file(fs::path(testing::TempDir()) / std::string(5000, 'x')), InputError);
}

std::string refusal_of(const fs::path& path) {
  try {
    read_text_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(read_text_file, ends_where_a_file_does_not) {
  EXPECT_THROW(read_text_file("/dev/zero"), InputError);
  const fs::path file = fs::path(testing::TempDir()) / "glissade_large_file";
  std::ofstream(file).close();
  fs::resize_file(file, (std::uintmax_t{1} << 28) + 1);  // a hole, which takes no room
  EXPECT_THAT(refusal_of(file), testing::HasSubstr("more than 256 MiB"));
  fs::remove(file);
}

// To open a named pipe waits for a process that writes to it.
TEST(read_text_file, refuses_without_waiting_what_is_no_regular_file) {
  const fs::path pipe = fs::path(testing::TempDir()) / "glissade_pipe";
  fs::remove(pipe);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const fs::path& path : {pipe, fs::path("/dev/null")}) {
    EXPECT_THAT(
        refusal_of(path),
        testing::AllOf(testing::HasSubstr(path.string()), testing::HasSubstr("no regular file"),
                       testing::HasSubstr("give the path of a regular file")));
  }
  fs::remove(pipe);
  EXPECT_THAT(refusal_of(testing::TempDir()), testing::HasSubstr("directory"));
}

TEST(read_text_file, reads_a_pipe_that_is_open_to_its_end) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  const std::string text(50000, 'x');  // in blocks, of which the second is waited for
  std::thread writer([&] {
    for (const std::size_t begin : {std::size_t{0}, text.size() / 2}) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      const std::size_t bytes = text.size() / 2;
      EXPECT_EQ(::write(ends[1], text.data() + begin, bytes), static_cast<ssize_t>(bytes));
    }
    ::close(ends[1]);
  });
  const std::string read = read_text_file("/dev/fd/" + std::to_string(ends[0]));
  writer.join();
  ::close(ends[0]);
  EXPECT_EQ(read, text);
}

}  // namespace
}  // namespace glissade
