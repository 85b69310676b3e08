// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "glissade/core/error.hpp"
#include "glissade/motion/record_selection.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "recorded_motions.hpp"

namespace glissade {
namespace {

class RecordedSelection : public RecordedMotions {};

/// A tenth of Walters's periods: enough to choose by, and quick.
std::vector<double> some_periods_s() {
  std::vector<double> periods_s;
  const std::vector<double> all = walters_periods_s();
  for (std::size_t i = 0; i < all.size(); i += 10) periods_s.push_back(all[i]);
  return periods_s;
}

RecordSelection select_for_level(const Suite& library, int level,
                                 const SelectionCriteria& criteria) {
  const TargetSpectrum target(walters_target(level));
  return select_records(
      library, [&](double period_s) { return target.mce_sa_g(period_s); }, some_periods_s(),
      criteria);
}

void expect_sane(const Suite& library, const RecordSelection& s,
                 const SelectionCriteria& criteria) {
  ASSERT_EQ(s.records.size(), criteria.count);
  EXPECT_EQ(s.candidates + s.left_out.size(), library.motions.size());
  std::set<std::size_t> different;
  for (const SelectedRecord& r : s.records) {
    different.insert(r.record);
    EXPECT_GT(r.scale, 0.2);
    EXPECT_LE(r.scale, criteria.max_scale);
    EXPECT_LT(r.misfit, 0.7);  // within a factor of two in the root mean square
  }
  EXPECT_EQ(different.size(), s.records.size());
  EXPECT_NEAR(s.lowest.ratio, 1.0, 1e-3);
  EXPECT_TRUE(s.reaches_target());
  EXPECT_LT(s.highest.ratio, 2.5);
}

TEST_F(RecordedSelection, of_the_far_field_set_for_level_2_keeps_table_2) {
  const Suite library = load("fema_p695_far_field.toml");
  const SelectionCriteria criteria = walters_criteria(2);
  const RecordSelection s = select_for_level(library, 2, criteria);
  expect_sane(library, s, criteria);
  // M 6.7-7.6 to a tenth, 5-50 km, 260-800 m/s: counted in the suite file by hand.
  EXPECT_EQ(s.candidates, 14u);
  for (const SelectedRecord& r : s.records) {
    const Motion& m = library.motions[r.record];
    EXPECT_GE(m.magnitude, 6.65);
    EXPECT_LE(m.magnitude, 7.65);
    EXPECT_GE(m.vs30_mps, 260.0);
    EXPECT_LE(m.vs30_mps, 800.0);
  }
}

TEST_F(RecordedSelection, of_the_far_field_set_for_level_3_is_refused_for_want_of_near_records) {
  const Suite library = load("fema_p695_far_field.toml");
  try {
    select_for_level(library, 3, walters_criteria(3));
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("with distance outside the limits"));
  }
}

TEST_F(RecordedSelection, of_walters_own_seven_gives_the_factors_of_his_table_3) {
  const Suite library = load("walters_table3.toml");  // whose `scale` is Table 3's factor
  SelectionCriteria criteria = walters_criteria(2);
  criteria.missing = MissingMetadata::keeps;  // Table 3 gives no V_S30
  const TargetSpectrum target(walters_target(2));
  const RecordSelection s = select_records(
      library, [&](double period_s) { return target.mce_sa_g(period_s); }, walters_periods_s(),
      criteria);
  expect_sane(library, s, criteria);
  // His are given to a tenth, and some records are of another processing than his.
  for (const SelectedRecord& r : s.records)
    EXPECT_NEAR(r.scale, library.motions[r.record].scale, 0.11) << library.motions[r.record].id;
}

TEST_F(RecordedSelection, kallioras_loads_with_the_indexed_peaks_on_one_clock) {
  const Suite library = load("kallioras_2025.toml");
  ASSERT_EQ(library.motions.size(), 83u);
  for (const Motion& m : library.motions) {
    EXPECT_EQ(m.dt_s, 0.005);
    EXPECT_EQ(m.horizontal_mps2[0].size(), m.vertical_mps2.size());
  }
  // PGA (g) of records/INDEX.csv, which was made with another reader: TLM1 WE and NS.
  EXPECT_EQ(library.motions[0].id, "19760506_2000_tlm1");
  EXPECT_NEAR(peak_g(library.motions[0].horizontal_mps2[0]), 0.3151, 5e-5);
  EXPECT_NEAR(peak_g(library.motions[0].horizontal_mps2[1]), 0.3457, 5e-5);
}

TEST_F(RecordedSelection, of_kallioras_for_the_spectrum_of_level_2_reaches_it) {
  const Suite library = load("kallioras_2025.toml");
  SelectionCriteria criteria;
  criteria.per_event = 1;
  const RecordSelection s = select_for_level(library, 2, criteria);
  EXPECT_EQ(s.candidates, 83u);
  expect_sane(library, s, criteria);
  std::set<std::string> events;
  for (const SelectedRecord& r : s.records) events.insert(library.motions[r.record].event);
  EXPECT_EQ(events.size(), 7u);
}

TEST_F(RecordedSelection, of_kallioras_by_magnitude_leaves_out_those_without_it) {
  const Suite library = load("kallioras_2025.toml");
  SelectionCriteria criteria;
  criteria.count = 3;
  criteria.magnitude.min = 6.0;
  const RecordSelection s = select_for_level(library, 2, criteria);
  EXPECT_EQ(s.candidates, 7u);  // the earthquakes the far-field set has too
  EXPECT_EQ(s.left_out.size(), 76u);
  for (const LeftOutRecord& record : s.left_out)
    EXPECT_THAT(record.reasons, testing::ElementsAre(LeftOutFor::magnitude_missing));
}

}  // namespace
}  // namespace glissade
