// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/reduce.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::small_config;
using test::small_suite;

std::vector<UnitResult> executed(const Plan& plan) {
  std::vector<UnitResult> units;
  for (std::size_t u = 0; u < plan.units.size(); ++u) units.push_back(execute(plan, u));
  return units;
}

class reduce_of_a_small_study : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    plan = new Plan(make_plan(small_config(), small_suite()));
    units = new std::vector<UnitResult>(executed(*plan));
    results = new Results(reduce(*plan, *units));
  }
  static void TearDownTestSuite() {
    delete results;
    delete units;
    delete plan;
  }
  static inline Plan* plan = nullptr;
  static inline std::vector<UnitResult>* units = nullptr;
  static inline Results* results = nullptr;
};

TEST_F(reduce_of_a_small_study, does_not_depend_on_the_order_in_which_units_came) {
  std::vector<UnitResult> shuffled(units->rbegin(), units->rend());
  const Results again = reduce(*plan, shuffled);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(again.runs[r].peak_displacement_m.data, results->runs[r].peak_displacement_m.data);
    EXPECT_EQ(again.runs[r].capacity.data, results->runs[r].capacity.data);
    for (std::size_t t = 0; t < 3; ++t) {
      EXPECT_EQ(again.runs[r].fragilities[t].capacities.curve.median,
                results->runs[r].fragilities[t].capacities.curve.median);
      EXPECT_EQ(again.runs[r].fragilities[t].capacities.median_interval.low,
                results->runs[r].fragilities[t].capacities.median_interval.low);
    }
  }
}

TEST_F(reduce_of_a_small_study, refuses_an_incomplete_set_of_units) {
  std::vector<UnitResult> missing(units->begin() + 1, units->end());
  EXPECT_THROW(reduce(*plan, missing), std::logic_error);
}

TEST_F(reduce_of_a_small_study, counts_shares_and_percentiles_as_a_plain_count_does) {
  for (const RunResults& run : results->runs) {
    for (std::size_t j = 0; j < results->levels.size(); ++j) {
      std::vector<double> slips;
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t s = 0; s < 40; ++s) slips.push_back(run.peak_displacement_m(r, s, j));
      }
      std::sort(slips.begin(), slips.end());
      double sum = 0;
      for (const double slip : slips) sum += slip;
      EXPECT_NEAR(run.slip[j].mean_m, sum / 120, 1e-14);
      EXPECT_DOUBLE_EQ(run.slip[j].median_m, 0.5 * (slips[59] + slips[60]));
      for (const ThresholdFragility& f : run.fragilities) {
        const auto above =
            std::count_if(slips.begin(), slips.end(), [&](double s) { return s >= f.threshold_m; });
        EXPECT_NEAR(f.probability[j], static_cast<double>(above) / 120, 1e-14);
        if (above == 0 || above == 120) {
          EXPECT_TRUE(std::isnan(f.probability_interval[j].low));
          continue;
        }
        EXPECT_LE(f.probability_interval[j].low, f.probability[j] + 1e-12);
        EXPECT_GE(f.probability_interval[j].high, f.probability[j] - 1e-12);
      }
    }
  }
}

TEST_F(reduce_of_a_small_study, has_capacities_in_the_bracket_that_the_peaks_show) {
  const RunResults& run = results->runs[0];
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t s = 0; s < 40; ++s) {
      for (std::size_t t = 0; t < 3; ++t) {
        std::size_t first = 0;
        while (first < 8 && run.peak_displacement_m(r, s, first) < results->thresholds_m[t])
          ++first;
        const double capacity = run.capacity(r, s, t);
        if (first == 8) {
          EXPECT_TRUE(std::isinf(capacity));
        } else {
          EXPECT_LE(capacity, results->levels[first]);
          EXPECT_GE(capacity, first > 0 ? results->levels[first - 1] : 0.0);
        }
      }
    }
  }
}

TEST_F(reduce_of_a_small_study, is_more_fragile_at_the_design_friction) {
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_LT(results->runs[1].fragilities[t].capacities.curve.median,
              results->runs[0].fragilities[t].capacities.curve.median);
  }
}

TEST_F(reduce_of_a_small_study, compares_each_level_with_both_standards) {
  const RunResults& run = results->runs[0];
  ASSERT_EQ(run.standards.size(), 16u);
  EXPECT_EQ(run.standards[3].sds_g, 1.0);
  EXPECT_NEAR(run.standards[3].prescribed.value_m, 60 * 0.36 * 0.0254,
              1e-12);  // 60 (S_DS - 0.4)^2 in
  std::size_t above = 0;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t s = 0; s < 40; ++s)
      above += run.peak_displacement_m(r, s, 3) > run.standards[3].prescribed.value_m ? 1 : 0;
  }
  EXPECT_NEAR(run.standards[3].exceedance_probability, static_cast<double>(above) / 120, 1e-14);
}

TEST_F(reduce_of_a_small_study, shows_the_suite_against_its_design_spectrum) {
  EXPECT_EQ(results->spectra.reference_level, 1.0);
  ASSERT_EQ(results->spectra.average_srss_g.size(), results->spectra.target_g.size());
  for (std::size_t p = 0; p < results->spectra.periods_s.size(); ++p) {
    if (results->spectra.periods_s[p] > 2.0) continue;
    EXPECT_GE(results->spectra.average_srss_g[p],
              0.97 * results->spectra.target_g[p]);  // between the rule's own periods
  }
}

/// Four samples of three records at 1, 2 and 3 g, with peaks and capacities made up by
/// `fill(record, sample, unit's run)`; threshold 0.1 m.
template <class Fill>
Results reduce_made_up(Fill fill) {
  StudyConfig config = small_config();
  config.intensity.levels = {1.0, 2.0, 3.0};
  config.sampling.samples = 4;
  config.friction.mu = Fixed{0.4};
  config.thresholds_m = {0.1};
  const Plan plan = make_plan(config, small_suite());
  std::vector<UnitResult> units;
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    UnitResult unit;
    unit.unit = u;
    unit.runs.resize(1);
    for (int sample = 0; sample < 4; ++sample) {
      fill(u, sample, unit.runs[0]);
      unit.runs[0].uplift.insert(unit.runs[0].uplift.end(), 3, 0);
    }
    units.push_back(unit);
  }
  return reduce(plan, units);
}

void add(UnitResult::Run& run, const std::vector<double>& peaks_m, double capacity) {
  run.peak_displacement_m.insert(run.peak_displacement_m.end(), peaks_m.begin(), peaks_m.end());
  run.capacity.push_back(capacity);
}

// Recrossing, by hand: a threshold reached at one level and not at the next.
TEST(reduce, counts_histories_that_fall_below_the_threshold_again) {
  const Results results = reduce_made_up([](std::size_t u, int sample, UnitResult::Run& run) {
    const bool recrosses = u == 0 && sample == 0;
    add(run, recrosses ? std::vector<double>{0.0, 0.2, 0.05} : std::vector<double>{0.0, 0.2, 0.3},
        1.5 + 0.01 * sample + 0.1 * static_cast<double>(u));
  });
  EXPECT_DOUBLE_EQ(results.runs[0].fragilities[0].recross_share, 1.0 / 12);
  EXPECT_EQ(results.runs[0].fragilities[0].record_recross, (std::vector<double>{1, 0, 0}));
}

// One sample of four slides freely on every record: it exceeds at 1 g, where no other does.
TEST(reduce, has_histories_that_slide_freely_in_the_observed_shares_the_curves_and_the_band) {
  const Results results = reduce_made_up([](std::size_t u, int sample, UnitResult::Run& run) {
    if (sample == 0) return add(run, {5.0, 5.1, 5.2}, 0.0);
    add(run, {0.0, sample == 1 ? 0.2 : 0.0, 0.3},
        (sample == 1 ? 1.8 : 2.2) + 0.1 * static_cast<double>(u));
  });
  const ThresholdFragility& f = results.runs[0].fragilities[0];
  EXPECT_EQ(f.probability, (std::vector<double>{0.25, 0.5, 1.0}));
  EXPECT_EQ(f.free_sliding_share, 0.25);
  for (const FitSummary& fit : {f.capacities, f.stripes}) {
    EXPECT_TRUE(fit.converged());
    EXPECT_EQ(fit.curve.floor, 0.25);
    EXPECT_NEAR(fit.curve.probability(1.0), 0.25, 0.01);
    EXPECT_LT(fit.curve.intensity_at(0.5), fit.curve.median);
  }
  for (const Interval& interval : f.band) EXPECT_GE(interval.low, 0.25);
}

TEST(reduce, says_that_every_history_slides_freely) {
  const Results results = reduce_made_up([](std::size_t, int, UnitResult::Run& run) {
    add(run, {5.0, 5.1, 5.2}, 0.0);
  });
  const ThresholdFragility& f = results.runs[0].fragilities[0];
  EXPECT_EQ(f.stripes.status, FitStatus::always_exceeds);
  EXPECT_EQ(f.capacities.status, FitStatus::always_exceeds);
  EXPECT_EQ(f.probability, (std::vector<double>{1, 1, 1}));
}

}  // namespace
}  // namespace glissade
