// SPDX-License-Identifier: GPL-3.0-or-later
#include "schedule.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace glissade::test {
namespace {

const Network at_once{};

TEST(makespan, of_one_rank_is_the_sum_and_of_many_the_longest_item) {
  const std::vector<double> costs{3.0, 1.0, 2.0};
  EXPECT_DOUBLE_EQ(makespan_s(costs, 1, at_once, Fetch::ahead), 6.0);
  EXPECT_DOUBLE_EQ(makespan_s(costs, 3, at_once, Fetch::ahead), 3.0);
  EXPECT_DOUBLE_EQ(makespan_s(costs, 100, at_once, Fetch::ahead), 3.0);
  EXPECT_DOUBLE_EQ(makespan_s(costs, 2, at_once, Fetch::when_free, 2.0), 6.0);
  EXPECT_DOUBLE_EQ(makespan_s({}, 4, at_once, Fetch::ahead), 0.0);
}

// Rank 1 gets the item of 1 s, then has to wait until rank 0 has finished its item of 4 s.
TEST(makespan, waits_for_rank_0_without_remote_atomics) {
  const std::vector<double> costs{4.0, 1.0, 1.0, 1.0, 1.0};
  const Network deaf{.remote_atomics = false};
  EXPECT_DOUBLE_EQ(makespan_s(costs, 2, at_once, Fetch::when_free), 4.0);
  EXPECT_DOUBLE_EQ(makespan_s(costs, 2, deaf, Fetch::when_free), 6.0);
}

// Items of equal length: rank 0 answers while the others are still at work, but for their first
// requests, which come when it has begun its own first item: 1 s.
TEST(makespan, of_even_items_waits_once_without_remote_atomics_where_items_are_fetched_ahead) {
  const std::vector<double> costs(40, 1.0);
  const Network deaf{.latency_s = 1e-3, .remote_atomics = false};
  EXPECT_NEAR(makespan_s(costs, 4, deaf, Fetch::ahead), 11.0, 0.01);
}

// A round trip is hidden behind an item that is longer.
TEST(makespan, hides_the_latency_where_items_are_fetched_ahead) {
  const std::vector<double> costs(20, 1.0);
  const Network slow{.latency_s = 0.25};
  EXPECT_DOUBLE_EQ(makespan_s(costs, 2, slow, Fetch::ahead), 10.5);
  EXPECT_GT(makespan_s(costs, 2, slow, Fetch::when_free), 12.0);
}

// 100 ranks ask at once, each request takes 1 s of rank 0.
TEST(makespan, is_limited_by_the_requests_that_rank_0_serves) {
  const std::vector<double> costs(100, 1e-3);
  const Network narrow{.service_s = 1.0};
  EXPECT_GE(makespan_s(costs, 100, narrow, Fetch::ahead), 100.0);
}

}  // namespace
}  // namespace glissade::test
