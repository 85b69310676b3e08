// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "facts.hpp"
#include "glissade/core/error.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/response_spectrum.hpp"

namespace glissade {
namespace {

using test::states;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::Pointwise;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TimedRecord timed(double dt_s, std::vector<double> samples, double start_s = 0.0) {
  return {Record{"made-up", dt_s, std::move(samples)}, start_s};
}

Motion assemble(const TimedRecord& first) {
  return assemble_motion({}, first, std::nullopt, std::nullopt);
}

std::string what_is_wrong_with(const TimedRecord& first) {
  try {
    assemble(first);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(assemble_motion, of_one_component_is_that_component_and_keeps_the_metadata) {
  Motion metadata;
  metadata.id = "m1";
  metadata.scale = 1.4;
  const Motion motion =
      assemble_motion(metadata, timed(0.005, {1.0, 2.0}), std::nullopt, std::nullopt);
  EXPECT_EQ(motion.id, "m1");
  EXPECT_EQ(motion.scale, 1.4);
  EXPECT_EQ(motion.dt_s, 0.005);
  EXPECT_THAT(motion.horizontal_mps2[0], ElementsAre(1.0, 2.0));
  EXPECT_TRUE(motion.horizontal_mps2[1].empty());
  EXPECT_TRUE(motion.vertical_mps2.empty());
}

TEST(assemble_motion, names_components_that_end_more_than_a_second_apart) {
  const std::vector<double> long_one(500, 1.0), shorter(401, 1.0), cut(350, 1.0);
  const auto assembled = [&](const std::vector<double>& second, double start_s = 0.0) {
    return assemble_motion({}, timed(0.01, long_one), timed(0.01, second, start_s), std::nullopt);
  };
  EXPECT_THAT(assembled(cut).contradictions,
              ElementsAre(states("second component ends at 3.5 s", "first at 5 s", "cut short",
                                 "start together")));
  EXPECT_THAT(assembled(cut, 1.5).contradictions, ElementsAre());  // as it is stated
  EXPECT_THAT(assembled(shorter).contradictions, ElementsAre());
  EXPECT_TRUE(assembled(shorter).starts_are_assumed);
  EXPECT_FALSE(assembled(long_one).starts_are_assumed);
  EXPECT_FALSE(assembled(cut, 1.5).starts_are_assumed);
  const Motion steps = assemble_motion({}, timed(0.01, long_one),
                                       timed(0.02, std::vector<double>(250, 1.0)), std::nullopt);
  EXPECT_TRUE(steps.starts_are_assumed);
}

TEST(assemble_motion, pads_shorter_components_with_zeros) {
  const Motion motion = assemble_motion({}, timed(0.01, {1.0}), timed(0.01, {1.0, 2.0, 3.0}),
                                        timed(0.01, {4.0, 5.0}));
  EXPECT_THAT(motion.horizontal_mps2[0], ElementsAre(1.0, 0.0, 0.0));
  EXPECT_THAT(motion.horizontal_mps2[1], ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(motion.vertical_mps2, ElementsAre(4.0, 5.0, 0.0));
}

TEST(assemble_motion, shifts_each_component_to_its_start) {
  const Motion motion =
      assemble_motion({}, timed(0.01, {1.0, 2.0}, 0.03), timed(0.01, {3.0}), std::nullopt);
  EXPECT_THAT(motion.horizontal_mps2[0], ElementsAre(0.0, 0.0, 0.0, 1.0, 2.0));
  EXPECT_THAT(motion.horizontal_mps2[1], ElementsAre(3.0, 0.0, 0.0, 0.0, 0.0));
}

TEST(assemble_motion, interpolates_the_coarser_component_and_its_last_interval_to_zero) {
  const Motion motion =
      assemble_motion({}, timed(0.04, {1.0, 3.0}), timed(0.01, {7.0}), std::nullopt);
  EXPECT_EQ(motion.dt_s, 0.01);
  EXPECT_THAT(motion.horizontal_mps2[0],
              Pointwise(DoubleEq(), {1.0, 1.5, 2.0, 2.5, 3.0, 2.25, 1.5, 0.75}));
}

TEST(assemble_motion, changes_nothing_about_a_coarser_component) {
  const std::vector<double> coarse = {0.0, 3.0, -1.0, -2.0, 1.0};
  const std::vector<double> periods_s = {0.0, 0.03, 0.2, 1.0};
  const Motion motion = assemble_motion({}, timed(0.02, coarse), timed(0.005, {1.0}), std::nullopt);
  EXPECT_NEAR(peak_ground_velocity_mps(motion.dt_s, motion.horizontal_mps2[0]),
              peak_ground_velocity_mps(0.02, coarse), 1e-15);
  const std::vector<double> before = pseudo_acceleration_spectrum(0.02, coarse, periods_s);
  const std::vector<double> after =
      pseudo_acceleration_spectrum(motion.dt_s, motion.horizontal_mps2[0], periods_s);
  for (std::size_t i = 0; i < periods_s.size(); ++i)
    EXPECT_NEAR(after[i] / before[i], 1.0, 1e-12) << periods_s[i];
}

// A start read from decimal text is never an exact multiple: 0.29 / 0.01 = 28.999999999999996.
TEST(assemble_motion, takes_starts_within_a_millionth_of_a_sample) {
  EXPECT_EQ(assemble(timed(0.01, {1.0}, 0.29)).horizontal_mps2[0].size(), 30u);
  EXPECT_EQ(assemble(timed(0.01, {1.0}, 0.01 * (3 + 0.9e-6))).horizontal_mps2[0].size(), 4u);
  EXPECT_THROW(assemble(timed(0.01, {1.0}, 0.01 * (3 + 1.1e-6))), InputError);
}

TEST(assemble_motion, says_which_start_would_be_the_nearest) {
  EXPECT_THAT(what_is_wrong_with(timed(0.005, {1.0}, 0.0123)), states("nearest is 0.01"));
  EXPECT_THAT(what_is_wrong_with(timed(0.005, {1.0}, -0.01)), states("nearest is 0"));
}

TEST(assemble_motion, refuses_starts_that_are_no_place_on_the_clock) {
  for (const double start_s : {-0.01, 1e12, inf, nan}) {
    EXPECT_THROW(assemble(timed(0.01, {1.0}, start_s)), InputError) << start_s;
  }
}

TEST(assemble_motion, refuses_steps_that_are_not_whole_multiples) {
  EXPECT_THROW(assemble_motion({}, timed(0.01, {1.0}), timed(0.004, {1.0}), std::nullopt),
               InputError);
}

TEST(assemble_motion, names_the_sample_that_is_not_finite) {
  EXPECT_THAT(what_is_wrong_with(timed(0.01, {1.0, 2.0, nan})),
              states("made-up", "sample 3", "nan"));
  EXPECT_THAT(what_is_wrong_with(timed(0.01, {inf, 2.0})), states("sample 1", "inf"));
}

TEST(assemble_motion, refuses_empty_records_and_steps_that_are_not_positive) {
  EXPECT_THROW(assemble(timed(0.01, {})), InputError);
  for (const double dt_s : {0.0, -0.01, inf, nan})
    EXPECT_THROW(assemble(timed(dt_s, {1.0})), InputError) << dt_s;
}

TEST(assemble_motion, tells_the_problems_of_all_components_at_once) {
  try {
    assemble_motion({}, timed(0.0, {nan}), timed(0.01, {}), timed(-1.0, {1.0}));
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 4u) << error.what();
  }
}

}  // namespace
}  // namespace glissade
