// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/parallel/communicator.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <functional>
#include <new>
#include <span>
#include <stdexcept>
#include <system_error>

#include "glissade/core/bytes.hpp"
#include "glissade/core/error.hpp"
#include "glissade/parallel/together.hpp"

namespace glissade {
namespace {

// Several ranks are tested through the program (tests/mpi).

TEST(communicator, alone_is_root_and_keeps_its_messages) {
  const Communicator alone = Communicator::serial();
  EXPECT_TRUE(alone.is_root());
  EXPECT_EQ(alone.size(), 1);
  std::vector<char> message{'a', 'b'};
  alone.broadcast(message);
  EXPECT_EQ(message, (std::vector<char>{'a', 'b'}));
  EXPECT_EQ(alone.gather(message), (std::vector<std::vector<char>>{message}));
}

TEST(communicator, alone_keeps_its_numbers) {
  const Communicator alone = Communicator::serial();
  const std::span<const double> first = alone.on_each_machine(std::vector{1.0, 2.0});
  const std::span<const double> second = alone.on_each_machine(std::vector<double>());
  EXPECT_EQ(std::vector(first.begin(), first.end()), (std::vector{1.0, 2.0}));
  EXPECT_TRUE(second.empty());
}

TEST(self_schedule, hands_out_every_item_once_in_order) {
  std::vector<std::uint64_t> seen;
  self_schedule(Communicator::serial(), 5, [&](std::uint64_t item) { seen.push_back(item); });
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{0, 1, 2, 3, 4}));
  self_schedule(Communicator::serial(), 0, [](std::uint64_t) { FAIL() << "no work to do"; });
}

TEST(self_schedule, takes_no_item_once_it_is_stopped) {
  std::vector<std::uint64_t> seen;
  self_schedule(
      Communicator::serial(), 5, [&](std::uint64_t item) { seen.push_back(item); },
      [&] { return seen.size() == 2; });
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{0, 1}));
}

/// "2 there is not enough memory ...".
std::string ending_of(const std::function<void()>& step) {
  try {
    on_root(Communicator::serial(), step);
    return "none";
  } catch (const ExitStatus& ending) {
    return std::to_string(ending.status) + " " + ending.message;
  }
}

TEST(together, states_how_the_program_ends_by_every_kind_of_error) {
  EXPECT_EQ(ending_of([] {}), "none");
  EXPECT_EQ(ending_of([] { throw ExitStatus{75, "stopped"}; }), "75 stopped");
  EXPECT_EQ(ending_of([] {
              throw InputError({"a.toml:3", "is wrong", "", ""});
            }),
            "2 a.toml:3: is wrong");
  EXPECT_EQ(ending_of([] { throw std::runtime_error("broken"); }), "1 internal error: broken");
  EXPECT_THAT(ending_of([] { throw std::bad_alloc(); }), testing::StartsWith("2 there is not"));
  EXPECT_THAT(ending_of([] { std::filesystem::create_directory("/proc/none/folder"); }),
              testing::AllOf(testing::StartsWith("2 "), testing::HasSubstr("/proc/none/folder"),
                             testing::HasSubstr("No such file")));
  EXPECT_THAT(
      ending_of([] {
        throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
      }),
      testing::AllOf(testing::StartsWith("2 "), testing::HasSubstr("unavailable")));
}

TEST(self_schedule, ends_as_a_step_does_where_its_work_throws) {
  EXPECT_THROW(self_schedule(Communicator::serial(), 2,
                             [](std::uint64_t) { throw std::runtime_error("broken"); }),
               ExitStatus);
}

TEST(share_parts, alone_computes_every_part) {
  const auto part = [](std::size_t i) { return std::vector<double>(i, 0.5); };
  EXPECT_EQ(share_parts(Communicator::serial(), 3, part),
            (std::vector<std::vector<double>>{{}, {0.5}, {0.5, 0.5}}));
}

TEST(numbered_parts, come_in_any_order_from_any_rank) {
  const std::vector<double> one{1.0, 2.0}, two{3.0};
  const auto message = [](std::uint64_t i, const std::vector<double>& part) {
    return ByteWriter().put(i).put(part).take();
  };
  EXPECT_EQ(numbered_parts(2, {message(1, two), message(0, one)}),
            (std::vector<std::vector<double>>{one, two}));
}

}  // namespace
}  // namespace glissade
