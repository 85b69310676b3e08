// SPDX-License-Identifier: GPL-3.0-or-later
// Required clearance, base shear and tipping in the results file.
#include <gmock/gmock.h>

#include "misfits.hpp"
#include "whole_results.hpp"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<double> numbers_of(const SuiteMean& m) {
  std::vector<double> numbers{static_cast<double>(m.suite),
                              static_cast<double>(m.first_case),
                              m.level,
                              m.range.lowest,
                              m.range.median,
                              m.range.highest,
                              m.range.interval.low,
                              m.range.interval.high,
                              m.range.highest_interval.low,
                              m.range.highest_interval.high,
                              m.bounds.lowest,
                              m.bounds.highest,
                              m.largest};
  numbers.insert(numbers.end(), m.by_orientation.begin(), m.by_orientation.end());
  return numbers;
}

void expect_same(const SuiteMean& read, const SuiteMean& written) {
  EXPECT_EQ(numbers_of(read), numbers_of(written));
  EXPECT_EQ(read.condition, written.condition);
  EXPECT_TRUE(read.period_s == written.period_s ||
              (std::isnan(read.period_s) && std::isnan(written.period_s)));
}

struct Both {
  Results written = with_all(), read;
  Both() {
    const TemporaryFolder folder;
    write_results(folder.path() / "a.h5", written);
    read = read_results(folder.path() / "a.h5");
  }
};

TEST(condition_results, a_required_clearance_comes_back) {
  const Both both;
  const ClearanceResults &a = *both.read.clearance, &b = *both.written.clearance;
  EXPECT_EQ(a.factor, 1.2);
  EXPECT_EQ(a.orientation, OrientationRule::median);
  ASSERT_EQ(a.required.size(), 3u);  // levels
  ASSERT_EQ(a.by_period.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    expect_same(a.required[i].largest, b.required[i].largest);
    expect_same(a.by_period[i], b.by_period[i]);
    EXPECT_EQ(a.required[i].clearance_m, b.required[i].clearance_m);
    EXPECT_EQ(a.required[i].median_m, b.required[i].median_m);
    EXPECT_EQ(a.required[i].highest_m, b.required[i].highest_m);
  }
}

TEST(condition_results, the_conditions_are_made_of_the_histories_again) {
  const Both both;
  const ConditionTable &a = *both.read.conditions, &b = *both.written.conditions;
  EXPECT_EQ(a.first_case, b.first_case);
  EXPECT_EQ(a.same_as, b.same_as);
  ASSERT_EQ(a.histories.size(), b.histories.size());
  for (std::size_t i = 0; i < a.histories.size(); ++i) {
    EXPECT_EQ(a.histories[i].displacement_m, b.histories[i].displacement_m);
    EXPECT_EQ(a.histories[i].shear_across, b.histories[i].shear_across);
  }
}

TEST(condition_results, base_shear_comes_back) {
  const Both both;
  ASSERT_EQ(both.read.base_shear->means.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    expect_same(both.read.base_shear->means[i], both.written.base_shear->means[i]);
}

TEST(condition_results, tipping_comes_back) {
  const Both both;
  const TippingResults &a = *both.read.tipping, &b = *both.written.tipping;
  EXPECT_EQ(a.body.centre_of_mass_height_m, 0.5);
  EXPECT_EQ(a.body.width_m, 0.75);
  EXPECT_EQ(a.least_friction, 0.625);
  ASSERT_EQ(a.shares.size(), 6u);  // two frictions, three levels
  for (std::size_t i = 0; i < a.shares.size(); ++i) {
    EXPECT_EQ(a.shares[i].first_case, b.shares[i].first_case);
    EXPECT_EQ(a.shares[i].condition, b.shares[i].condition);
    EXPECT_EQ(a.shares[i].level, b.shares[i].level);
    EXPECT_EQ(a.shares[i].share, b.shares[i].share);
    EXPECT_EQ(a.shares[i].by_record, b.shares[i].by_record);
  }
}

TEST(condition_results, a_group_is_there_only_where_its_analysis_is) {
  const TemporaryFolder folder;
  Results results = whole_results(true);
  add_clearance(results, 1.1);
  const std::string bytes = bytes_of(results, folder, "a.h5");
  EXPECT_THAT(bytes, HasSubstr("clearance_median_m"));
  EXPECT_THAT(bytes, Not(testing::AnyOf(HasSubstr("base_shear"), HasSubstr("tipping"))));
}

TEST(condition_results, parts_that_do_not_fit_are_refused) {
  const auto refusal = [](void (*spoil)(Results&)) {
    Results results = with_all();
    spoil(results);
    return misfit_in(results);
  };
  EXPECT_EQ(refusal([](Results&) {}), "");
  // Required clearance.
  EXPECT_EQ(refusal([](Results& r) { r.clearance->factor = std::nan(""); }), "factor");
  EXPECT_EQ(refusal([](Results& r) { r.clearance->factor = 0.5; }), "factor");
  EXPECT_EQ(refusal([](Results& r) { r.clearance->required.pop_back(); }), "suite");
  EXPECT_EQ(refusal([](Results& r) { r.clearance->by_period.clear(); }), "suite");
  EXPECT_EQ(refusal([](Results& r) { r.clearance->by_period[1].suite = 1; }), "suite");
  EXPECT_EQ(refusal([](Results& r) { r.clearance->required[0].largest.first_case = 8; }),
            "first_case");
  EXPECT_EQ(refusal([](Results& r) { r.clearance->by_period[2].by_orientation.clear(); }),
            "by_orientation");
  // Base shear.
  EXPECT_EQ(refusal([](Results& r) { r.base_shear->means.pop_back(); }), "suite");
  EXPECT_EQ(refusal([](Results& r) { r.base_shear->means[0].suite = 7; }), "suite");
  EXPECT_EQ(refusal([](Results& r) { r.base_shear->means[0].first_case = ~std::uint64_t{0}; }),
            "first_case");
  EXPECT_EQ(refusal([](Results& r) { r.base_shear->means[0].by_orientation.push_back(1.0); }),
            "by_orientation");
  EXPECT_EQ(refusal([](Results& r) {
              r.histories.fields.shear_along.clear();
              r.histories.fields.shear_across.clear();
            }),
            "base_shear");
  // Tipping.
  EXPECT_EQ(refusal([](Results& r) { r.tipping->shares.pop_back(); }), "tipping");
  EXPECT_EQ(refusal([](Results& r) { r.tipping->shares[3].first_case = 8; }), "first_case");
  EXPECT_EQ(refusal([](Results& r) { r.tipping->shares[3].by_record.pop_back(); }),
            "share_by_record");
}

}  // namespace
}  // namespace glissade
