// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/record_selection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "facts.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/random.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/suite_scaling.hpp"

namespace glissade {
namespace {

using test::states;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// To 2 s by 0.05.
std::vector<double> some_periods_s() {
  std::vector<double> periods_s;
  for (int i = 0; i <= 40; ++i) periods_s.push_back(i / 20.0);
  return periods_s;
}

/// Noise under an envelope, smoothed over some samples, so that records differ in shape.
Motion noise(const std::string& id, std::uint64_t number, double strength_mps2 = 2.0) {
  Motion motion;
  motion.id = id;
  motion.event = "event of " + id;
  motion.magnitude = 7.0;
  motion.distance_km = 20.0;
  motion.vs30_mps = 400.0;
  motion.dt_s = 0.02;
  const double memory = 0.5 + 0.09 * static_cast<double>(number % 6);
  for (std::uint32_t axis = 0; axis < 2; ++axis) {
    double value = 0.0;
    std::vector<double> samples;
    for (std::size_t n = 0; n < 300; ++n) {
      value = memory * value + keyed_normal(number, RandomPurpose::test, n, axis);
      samples.push_back(strength_mps2 * value *
                        std::sin(std::numbers::pi * static_cast<double>(n) / 300.0));
    }
    motion.horizontal_mps2[axis] = samples;
  }
  return motion;
}

/// `motion` with all samples times a factor.
Motion times(double factor, Motion motion, const std::string& id) {
  motion.id = id;
  for (Samples& component : motion.horizontal_mps2) {
    std::vector<double> scaled = component.copy();
    for (double& a : scaled) a *= factor;
    component = scaled;
  }
  return motion;
}

Suite noise_library(std::size_t records, std::uint64_t first = 1) {
  Suite library;
  library.name = "library";
  for (std::size_t i = 0; i < records; ++i)
    library.motions.push_back(noise("noise " + std::to_string(i), first + i));
  return library;
}

double target_sa_g(double period_s) {
  return DesignSpectrum{.sds_g = 1.0, .sd1_g = 0.6, .tl_s = 8.0}.sa_g(period_s);
}

/// The motion's own SRSS spectrum at some_periods_s().
std::function<double(double)> spectrum_of(const Motion& motion) {
  const std::vector<double> periods_s = some_periods_s();
  const auto sa = horizontal_spectrum_mps2(motion, periods_s, HorizontalCombination::srss);
  std::map<double, double> at;
  for (std::size_t i = 0; i < sa.size(); ++i) at[periods_s[i]] = sa[i] / standard_gravity_mps2;
  return [at](double period_s) { return at.at(period_s); };
}

SelectionCriteria any(std::size_t count, double max_scale = 100.0) {
  SelectionCriteria criteria;
  criteria.count = count;
  criteria.max_scale = max_scale;
  return criteria;
}

std::vector<std::string> ids(const Suite& library, const RecordSelection& selection) {
  std::vector<std::string> names;
  for (const SelectedRecord& r : selection.records) names.push_back(library.motions[r.record].id);
  return names;
}

Suite selected_suite(const Suite& library, const RecordSelection& selection) {
  Suite suite;
  for (const SelectedRecord& r : selection.records) {
    suite.motions.push_back(library.motions[r.record]);
    suite.motions.back().scale = r.scale;
  }
  return suite;
}

std::string refusal(const Suite& library, const SelectionCriteria& criteria) {
  try {
    select_records(library, target_sa_g, some_periods_s(), criteria);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(select_records, takes_the_weaker_copies_of_the_target_with_the_factors_that_undo_them) {
  const Motion model = noise("model", 99);
  Suite library = noise_library(5);
  library.motions.push_back(times(0.5, model, "half"));
  library.motions.push_back(times(0.4, model, "two fifths"));
  library.motions.push_back(times(0.8, model, "four fifths"));
  const RecordSelection s =
      select_records(library, spectrum_of(model), some_periods_s(), any(3, 4.0));
  EXPECT_THAT(ids(library, s), UnorderedElementsAre("half", "two fifths", "four fifths"));
  for (const SelectedRecord& r : s.records) {
    const std::string& id = library.motions[r.record].id;
    const double undone = id == "half" ? 2.0 : id == "two fifths" ? 2.5 : 1.25;
    EXPECT_NEAR(r.scale, undone, 1.1e-4);  // to four decimals, upwards
    EXPECT_LT(r.misfit, 1e-4);
  }
  EXPECT_EQ(s.candidates, 8u);
  EXPECT_TRUE(s.left_out.empty());
}

TEST(select_records, of_two_of_one_shape_takes_the_one_with_the_smaller_factor) {
  const Motion model = noise("model", 99);
  Suite library = noise_library(3);
  library.motions.push_back(times(0.3, model, "a"));
  library.motions.push_back(times(0.5, model, "b"));
  const RecordSelection s = select_records(library, spectrum_of(model), some_periods_s(), any(1));
  EXPECT_THAT(ids(library, s), ElementsAre("b"));
}

TEST(select_records, passes_over_a_copy_that_would_need_more_than_the_largest_factor) {
  const Motion model = noise("model", 99);
  Suite library = noise_library(3);
  library.motions.push_back(times(0.1, model, "weak copy"));
  const auto target = spectrum_of(model);
  EXPECT_THAT(ids(library, select_records(library, target, some_periods_s(), any(1, 10.1))),
              ElementsAre("weak copy"));
  const RecordSelection s = select_records(library, target, some_periods_s(), any(1, 6.0));
  EXPECT_THAT(ids(library, s), testing::Not(ElementsAre("weak copy")));
  EXPECT_LE(s.records[0].scale, 6.0);
}

TEST(select_records, leaves_the_average_nowhere_below_the_target_and_tells_its_range) {
  const Suite library = noise_library(9);
  const std::vector<double> periods_s = some_periods_s();
  const RecordSelection s = select_records(library, target_sa_g, periods_s, any(4));
  std::vector<double> ratios(periods_s.size(), 0.0);
  for (const SelectedRecord& r : s.records) {
    const auto sa =
        horizontal_spectrum_mps2(library.motions[r.record], periods_s, HorizontalCombination::srss);
    for (std::size_t i = 0; i < sa.size(); ++i)
      ratios[i] += r.scale * sa[i] / standard_gravity_mps2 / 4.0 / target_sa_g(periods_s[i]);
  }
  const auto [lowest, highest] = std::ranges::minmax_element(ratios);
  EXPECT_GE(*lowest, 1.0 - 1e-12);
  EXPECT_LT(*lowest, 1.001);  // no higher than four decimals make it
  EXPECT_NEAR(s.lowest.ratio, *lowest, 1e-12);
  EXPECT_EQ(s.lowest.period_s, periods_s[lowest - ratios.begin()]);
  EXPECT_NEAR(s.highest.ratio, *highest, 1e-12);
  EXPECT_EQ(s.highest.period_s, periods_s[highest - ratios.begin()]);
  EXPECT_TRUE(s.reaches_target());
}

TEST(select_records, gives_the_factors_that_scaling_the_selected_suite_gives) {
  const Suite library = noise_library(9);
  const double max_scale = 1.2;  // reached by some
  const RecordSelection s =
      select_records(library, target_sa_g, some_periods_s(), any(4, max_scale));
  const SuiteScaling scaling =
      scale_suite_to_target(selected_suite(library, s), target_sa_g, some_periods_s(), max_scale);
  for (std::size_t i = 0; i < s.records.size(); ++i) {
    EXPECT_GE(s.records[i].scale, scaling.factors[i] - 1e-12);
    EXPECT_LE(s.records[i].scale, std::min(scaling.factors[i] + 1.0001e-4, max_scale));
  }
}

/// What select_records makes least, computed from the suite's factors.
double score(const Suite& suite, const std::vector<double>& periods_s) {
  const SuiteScaling scaling = scale_suite_to_target(suite, target_sa_g, periods_s, 100.0);
  double sum = 0.0;
  for (std::size_t j = 0; j < suite.motions.size(); ++j) {
    const auto sa =
        horizontal_spectrum_mps2(suite.motions[j], periods_s, HorizontalCombination::srss);
    for (std::size_t i = 0; i < sa.size(); ++i) {
      const double log_ratio =
          std::log(scaling.factors[j] * sa[i] / standard_gravity_mps2 / target_sa_g(periods_s[i]));
      sum += log_ratio * log_ratio / static_cast<double>(sa.size());
    }
    const double log_factor = std::log(std::max(scaling.factors[j], 1.0));
    sum += 0.01 * log_factor * log_factor;
  }
  return sum;
}

TEST(select_records, finds_a_set_that_no_exchange_of_one_record_betters) {
  const std::vector<double> periods_s = some_periods_s();
  for (const std::uint64_t first : {1u, 101u, 201u}) {
    const Suite library = noise_library(8, first);
    const RecordSelection s = select_records(library, target_sa_g, periods_s, any(3));
    const double best = score(selected_suite(library, s), periods_s);
    std::set<std::size_t> chosen;
    for (const SelectedRecord& r : s.records) chosen.insert(r.record);
    ASSERT_EQ(chosen.size(), 3u);
    for (std::size_t out = 0; out < 3; ++out) {
      for (std::size_t k = 0; k < library.motions.size(); ++k) {
        if (chosen.contains(k)) continue;
        Suite exchanged = selected_suite(library, s);
        exchanged.motions[out] = library.motions[k];
        EXPECT_GE(score(exchanged, periods_s), best * (1.0 - 1e-12));
      }
    }
  }
}

TEST(select_records, does_not_depend_on_the_order_of_the_library) {
  Suite library = noise_library(9);
  library.motions.push_back(library.motions[3]);  // of equals the first by id
  library.motions.back().id = "twin";
  const RecordSelection s = select_records(library, target_sa_g, some_periods_s(), any(4));
  Suite turned = library;
  std::ranges::reverse(turned.motions);
  std::swap(turned.motions[2], turned.motions[7]);
  const RecordSelection t = select_records(turned, target_sa_g, some_periods_s(), any(4));
  EXPECT_EQ(ids(library, s), ids(turned, t));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(s.records[i].scale, t.records[i].scale);
    EXPECT_EQ(s.records[i].misfit, t.records[i].misfit);
  }
  EXPECT_EQ(s.lowest.ratio, t.lowest.ratio);
}

TEST(select_records, does_not_look_at_the_scale_a_record_has) {
  Suite library = noise_library(6);
  const RecordSelection before = select_records(library, target_sa_g, some_periods_s(), any(3));
  library.motions[before.records[0].record].scale = 9.0;
  const RecordSelection after = select_records(library, target_sa_g, some_periods_s(), any(3));
  EXPECT_EQ(ids(library, before), ids(library, after));
  EXPECT_EQ(before.records[0].scale, after.records[0].scale);
}

TEST(select_records, keeps_limits_with_both_ends_included_and_tells_who_is_left_out_and_why) {
  Suite library = noise_library(6);
  library.motions[0].magnitude = 6.5;
  library.motions[1].magnitude = 7.5;
  library.motions[2].magnitude = 6.49;
  library.motions[3].vs30_mps = 180.0;
  library.motions[3].distance_km = 80.0;
  library.motions[4].distance_km = 5.0;
  SelectionCriteria criteria = any(3);
  criteria.magnitude = {6.5, 7.5};
  criteria.vs30_mps.min = 200.0;
  criteria.distance_km = {10.0, 75.0};
  const RecordSelection s = select_records(library, target_sa_g, some_periods_s(), criteria);
  EXPECT_THAT(ids(library, s), UnorderedElementsAre("noise 0", "noise 1", "noise 5"));
  ASSERT_EQ(s.left_out.size(), 3u);
  EXPECT_EQ(s.left_out[0].record, 2u);
  EXPECT_THAT(s.left_out[0].reasons, ElementsAre(LeftOutFor::magnitude));
  EXPECT_THAT(s.left_out[1].reasons, ElementsAre(LeftOutFor::distance, LeftOutFor::vs30));
  EXPECT_THAT(s.left_out[2].reasons, ElementsAre(LeftOutFor::distance));
}

TEST(select_records, leaves_out_what_does_not_tell_what_a_limit_is_on_unless_asked_to_keep_it) {
  Suite library = noise_library(4);
  library.motions[0].magnitude = 0.0;
  library.motions[1].vs30_mps = 0.0;  // no limit on it
  SelectionCriteria criteria = any(3);
  criteria.magnitude.max = 8.0;
  const RecordSelection s = select_records(library, target_sa_g, some_periods_s(), criteria);
  ASSERT_EQ(s.left_out.size(), 1u);
  EXPECT_EQ(s.left_out[0].record, 0u);
  EXPECT_THAT(s.left_out[0].reasons, ElementsAre(LeftOutFor::magnitude_missing));
  criteria.missing = MissingMetadata::keeps;
  EXPECT_EQ(select_records(library, target_sa_g, some_periods_s(), criteria).candidates, 4u);
}

TEST(select_records, leaves_out_records_without_second_horizontal_or_without_motion) {
  Suite library = noise_library(4);
  library.motions[1].horizontal_mps2[1] = {};
  for (Samples& component : library.motions[2].horizontal_mps2)
    component = std::vector<double>(component.size(), 0.0);
  const RecordSelection s = select_records(library, target_sa_g, some_periods_s(), any(2));
  ASSERT_EQ(s.left_out.size(), 2u);
  EXPECT_THAT(s.left_out[0].reasons, ElementsAre(LeftOutFor::no_second_horizontal));
  EXPECT_THAT(s.left_out[1].reasons, ElementsAre(LeftOutFor::no_motion));
}

TEST(select_records, takes_at_most_so_many_of_one_event) {
  const Motion model = noise("model", 99);
  Suite library = noise_library(4);
  for (const char* id : {"copy 1", "copy 2", "copy 3"})
    library.motions.push_back(times(0.5, model, id));  // of one event
  SelectionCriteria criteria = any(3);
  const auto target = spectrum_of(model);
  EXPECT_THAT(ids(library, select_records(library, target, some_periods_s(), criteria)),
              UnorderedElementsAre("copy 1", "copy 2", "copy 3"));
  criteria.per_event = 2;
  const auto two = ids(library, select_records(library, target, some_periods_s(), criteria));
  EXPECT_EQ(std::ranges::count_if(two, [](const auto& id) { return id.starts_with("copy"); }), 2);
}

TEST(select_records, tells_a_shortfall_where_the_largest_factor_does_not_suffice) {
  const Motion model = noise("model", 99);
  Suite library;
  library.motions = {times(0.1, model, "a"), times(0.1, model, "b"), times(0.05, model, "c")};
  const RecordSelection s =
      select_records(library, spectrum_of(model), some_periods_s(), any(2, 4.0));
  EXPECT_THAT(ids(library, s), UnorderedElementsAre("a", "b"));  // the nearer to the target
  EXPECT_EQ(s.records[0].scale, 4.0);
  EXPECT_EQ(s.records[1].scale, 4.0);
  EXPECT_FALSE(s.reaches_target());
  EXPECT_NEAR(s.lowest.ratio, 0.4, 1e-12);  // 4 x 0.1 at all periods
  EXPECT_NEAR(s.highest.ratio, 0.4, 1e-12);
  EXPECT_NEAR(s.records[0].misfit, -std::log(0.4), 1e-12);
}

TEST(select_records, refuses_more_records_than_are_left_and_tells_which_limits_left_them_out) {
  Suite library = noise_library(5);
  library.motions[0].magnitude = 5.0;
  library.motions[1].magnitude = 5.5;
  library.motions[2].vs30_mps = 0.0;
  SelectionCriteria criteria = any(3);
  criteria.magnitude.min = 6.0;
  criteria.vs30_mps.min = 100.0;
  EXPECT_THAT(refusal(library, criteria), states("2 of 5", "2 with magnitude", "1 with no Vs30"));
  criteria.magnitude.min = 9.0;
  EXPECT_THAT(refusal(library, criteria), states("0 of 5"));
  EXPECT_THAT(refusal({}, any(1)), states("0 of 0"));
  for (Motion& motion : library.motions) motion.event = "the one";
  criteria = any(2);
  criteria.per_event = 1;
  EXPECT_THAT(refusal(library, criteria), states("event", "1"));
}

TEST(select_records, refuses_limits_that_contradict_themselves_all_at_once) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SelectionCriteria criteria = any(0, -1.0);
  criteria.magnitude = {7.0, 6.0};
  criteria.distance_km.min = -1.0;
  criteria.vs30_mps.max = nan;
  criteria.per_event = 0;
  const std::string text = refusal(noise_library(3), criteria);
  EXPECT_THAT(text,
              states("count", "max_scale", "from 7 to 6", "distance_km", "vs30_mps", "per_event"));
}

TEST(walters_criteria, are_those_of_table_2_and_admit_magnitudes_that_round_to_its_tenths) {
  const SelectionCriteria level2 = walters_criteria(2);
  EXPECT_EQ(level2.count, 7u);
  EXPECT_EQ(level2.max_scale, 4.0);
  EXPECT_EQ(level2.distance_km.min, 5.0);
  EXPECT_EQ(level2.vs30_mps.max, 800.0);
  EXPECT_TRUE(level2.magnitude.admit(6.69));  // Northridge, 6.7 in Table 3
  EXPECT_TRUE(level2.magnitude.admit(7.62));  // Chi-Chi, 7.6 in Table 3
  EXPECT_FALSE(level2.magnitude.admit(6.6));
  EXPECT_FALSE(level2.magnitude.admit(7.7));
  EXPECT_EQ(walters_criteria(2, SiteGroup::e).vs30_mps.max, 285.0);
  EXPECT_THROW(walters_criteria(7), InputError);
}

}  // namespace
}  // namespace glissade
