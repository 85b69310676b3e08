// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/record_edit.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/sample_faults.hpp"

namespace glissade {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// 0 -> 4 -> 8 -> 0 over steps of 0.4 s: straight lines, by hand.
TEST(record_edit, resampling_follows_the_straight_lines_to_the_end_of_the_motion) {
  const Record record{"r", 0.4, {0.0, 4.0, 8.0}, ""};
  const Record fine = resampled(record, 0.3);
  EXPECT_EQ(fine.dt_s, 0.3);
  const auto near = [](double value) { return DoubleNear(value, 1e-12); };
  EXPECT_THAT(fine.acceleration_mps2.copy(), ElementsAre(near(0), near(3), near(6), near(6)));
  EXPECT_THAT(fine.notes, ElementsAre(HasSubstr("from 0.4 to 0.3 s")));
  EXPECT_THAT(resampled(record, 0.4).notes, IsEmpty());
  EXPECT_THROW(resampled(record, 0.5), InputError);
  EXPECT_THROW(resampled(record, 1e-9), InputError);
}

TEST(record_edit, a_record_ends_where_it_is_asked_to) {
  const Record record{"r", 0.1, {1.0, 2.0, 3.0, 4.0}, ""};
  const Record ended = ended_at(record, 0.3);
  EXPECT_THAT(ended.acceleration_mps2.copy(), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(ended.notes, ElementsAre(HasSubstr("ended at 0.3 s of 0.4 s")));
  EXPECT_THAT(ended_at(record, 7.0).notes, IsEmpty());
  EXPECT_THROW(ended_at(record, 0.01), InputError);
}

std::vector<double> shaking() {
  std::vector<double> a;
  for (int i = 0; i < 1000; ++i)
    a.push_back(3.0 * std::sin(0.003 * i) * std::sin(0.05 * i + 0.00005 * i * i));
  return a;
}

TEST(sample_faults, finds_dead_flat_clipped_and_spiky_records_and_no_fault_in_others) {
  EXPECT_THAT(sample_faults(shaking()), IsEmpty());
  EXPECT_THAT(sample_faults(std::vector<double>(100, 0.0)), ElementsAre(HasSubstr("dead")));
  std::vector<double> flat = shaking();
  std::fill(flat.begin() + 300, flat.end(), 0.02 * standard_gravity_mps2);
  EXPECT_THAT(sample_faults(flat), ElementsAre(HasSubstr("flat: 700 of 1000 samples, from sample "
                                                         "301 on, are 0.02 g")));
  std::vector<double> clipped = shaking();
  for (double& a : clipped) a = std::max(a, -1.5);
  EXPECT_THAT(sample_faults(clipped), ElementsAre(HasSubstr("clipped?")));
  std::vector<double> spiky = shaking();
  spiky[500] = -20.0;
  EXPECT_THAT(sample_faults(spiky), ElementsAre(HasSubstr("spike? sample 501")));
}

// A motion padded with zeros, and one of few steps of its recorder, are as they should be.
TEST(sample_faults, padding_and_coarse_recorders_are_no_faults) {
  std::vector<double> padded = shaking();
  padded.insert(padded.begin(), 3000, 0.0);
  padded.insert(padded.end(), 3000, 0.0);
  EXPECT_THAT(sample_faults(padded), IsEmpty());
  std::vector<double> coarse = shaking();
  for (double& a : coarse) a = std::round(5.0 * a);
  EXPECT_THAT(sample_faults(coarse), IsEmpty());
}

}  // namespace
}  // namespace glissade
