// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/paged_memory.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "glissade/core/error.hpp"
#include "unit/io/temporary_folder.hpp"

namespace glissade {
namespace {

using Values = std::vector<double, PagedAllocator<double>>;
constexpr std::size_t large = PagedAllocator<double>::least_bytes / sizeof(double);

TEST(paged_memory, holds_what_is_written_and_leaves_no_name_in_the_folder) {
  const TemporaryFolder folder;
  Values values{PagedAllocator<double>(folder.path())};
  for (std::size_t i = 0; i < large; ++i) values.push_back(static_cast<double>(i));  // grows
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  const Values moved = std::move(values);
  const Values copied = moved;  // in ordinary memory
  EXPECT_EQ(copied.get_allocator().folder(), nullptr);
  for (const Values* some : {&moved, &copied})
    EXPECT_EQ(std::accumulate(some->begin(), some->end(), 0.0), 0.5 * large * (large - 1.0));
}

TEST(paged_memory, is_zero_at_first) {
  const TemporaryFolder folder;
  const auto* bytes = static_cast<const char*>(map_pages(folder.path(), 100000));
  EXPECT_EQ(std::count(bytes, bytes + 100000, 0), 100000);
  unmap_pages(const_cast<char*>(bytes), 100000);
}

TEST(paged_memory, without_room_is_refused_before_a_page_is_written) {
  const TemporaryFolder folder;
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1 << 20, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(map_pages(folder.path(), 2 << 20), InputError);
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THROW(map_pages(folder.path() / "missing", 2 << 20), InputError);
}

}  // namespace
}  // namespace glissade
