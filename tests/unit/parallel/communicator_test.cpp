// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/parallel/communicator.hpp"

#include <gtest/gtest.h>

#include <span>
#include <stdexcept>

#include "glissade/core/bytes.hpp"

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

TEST(self_schedule, passes_an_exception_on) {
  EXPECT_THROW(self_schedule(Communicator::serial(), 2,
                             [](std::uint64_t) { throw std::runtime_error("broken"); }),
               std::runtime_error);
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
