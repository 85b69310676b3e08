// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/reduce.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/study/run/history_assembly.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::fixed;
using test::small_config;
using test::small_plan;

constexpr double infinity = std::numeric_limits<double>::infinity();

class reduce_of_a_small_study : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    plan = new Plan(small_plan(small_config()));
    units = new std::vector<UnitResult>(test::execute_all(*plan));
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
  EXPECT_EQ(test::bits_of(again.histories), test::bits_of(results->histories));
  ASSERT_EQ(again.runs.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    for (std::size_t t = 0; t < 3; ++t) {
      EXPECT_EQ(again.runs[r].fragilities[t].capacities.curve.median,
                results->runs[r].fragilities[t].capacities.curve.median);
      EXPECT_EQ(again.runs[r].fragilities[t].capacities.median_interval.low,
                results->runs[r].fragilities[t].capacities.median_interval.low);
    }
  }
}

TEST_F(reduce_of_a_small_study, needs_no_unit_once_it_is_added) {
  HistoryAssembly histories(*plan);
  WorkCount count;
  for (UnitResult unit : *units) {
    histories.add(unit);
    count += unit.count;
  }
  EXPECT_EQ(histories.count(), count);
  EXPECT_EQ(test::bits_of(histories.take(*plan)), test::bits_of(results->histories));
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
        for (std::size_t s = 0; s < 40; ++s)
          slips.push_back(results->histories.displacement_m(r, run.first_case + s, j));
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
        EXPECT_LE(f.probability_interval[j].low, f.probability[j] + 1e-12);
        EXPECT_GE(f.probability_interval[j].high, f.probability[j] - 1e-12);
      }
    }
  }
}

TEST_F(reduce_of_a_small_study, has_capacities_in_the_bracket_that_the_peaks_show) {
  const HistoryTable& table = results->histories;
  ASSERT_EQ(table.cases, 80u);  // 40 samples, as drawn and at the design friction
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < table.cases; ++c) {
      for (std::size_t t = 0; t < 3; ++t) {
        std::size_t first = 0;
        while (first < 8 && table.displacement_m(r, c, first) < results->thresholds_m[t]) ++first;
        const double capacity = table.capacity(r, c, t);
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
      above +=
          results->histories.displacement_m(r, s, 3) > run.standards[3].prescribed.value_m ? 1 : 0;
  }
  EXPECT_NEAR(run.standards[3].exceedance_probability, static_cast<double>(above) / 120, 1e-14);
}

TEST_F(reduce_of_a_small_study, shows_the_suite_against_its_design_spectrum) {
  ASSERT_EQ(results->suites.size(), 1u);
  const SuiteSpectra& spectra = results->suites[0].spectra;
  EXPECT_EQ(spectra.reference_level, 1.0);
  ASSERT_EQ(spectra.average_g.size(), spectra.target_g.size());
  for (std::size_t p = 0; p < spectra.periods_s.size(); ++p) {
    if (spectra.periods_s[p] > 2.0) continue;
    EXPECT_GE(spectra.average_g[p],
              0.97 * spectra.target_g[p]);  // between the rule's periods
  }
}

// A sheet that prints them has what a reader computes from record and period.
TEST(suite_spectra, are_known_at_the_listed_periods_of_buildings) {
  StudyConfig config = small_config();
  config.sampling.samples = 2;
  const std::vector<double> listed{0.418, 0.835, 1.37};
  config.quantities.at("building", "period_s") = {listed, {}};
  const SuiteSpectra spectra = test::run(small_plan(config)).suites[0].spectra;
  EXPECT_THAT(spectra.periods_s, testing::IsSupersetOf(listed));
  EXPECT_TRUE(std::ranges::is_sorted(spectra.periods_s, std::ranges::less_equal{}));
}

// What the suite must be at that period is not interpolated.
TEST(suite_spectra, are_known_at_the_period_to_which_the_study_scales) {
  StudyConfig config = small_config();
  config.sampling.samples = 2;
  for (const double to_s : {3.1, 6.0}) {
    config.intensity.scaled_to_s = to_s;
    const SuiteSpectra spectra = test::run(small_plan(config)).suites[0].spectra;
    EXPECT_THAT(spectra.periods_s, testing::Contains(to_s));
    EXPECT_TRUE(std::ranges::is_sorted(spectra.periods_s));
    EXPECT_EQ(spectra.periods_s.back(), std::max(to_s, 4.0));
    ASSERT_EQ(spectra.average_g.size(), spectra.periods_s.size());
    for (std::size_t p = 0; p < spectra.periods_s.size(); ++p) {
      if (spectra.periods_s[p] > to_s || spectra.periods_s[p] <= 2.0) continue;
      EXPECT_GE(spectra.average_g[p], 0.9 * spectra.target_g[p] - 1e-3);
    }
  }
}

/// Four samples of three records at 1, 2 and 3 g, with peaks and capacities made up by
/// `fill(record, sample, fields)`; threshold 0.1 m.
template <class Fill>
Results reduce_made_up(Fill fill) {
  StudyConfig config = small_config();
  config.intensity.levels = {1.0, 2.0, 3.0};
  config.sampling.samples = 4;
  config.quantities.at("friction", "mu") = fixed(0.4);
  config.fragility = FragilityConfig{.thresholds_m = {0.1}};
  const Plan plan = small_plan(config);
  std::vector<UnitResult> units;
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    const WorkUnit& work = plan.units[u];
    UnitResult unit;
    unit.unit = u;
    for (std::size_t i = 0; i < work.count; ++i) {
      fill(work.record, plan.order[work.first + i], unit.fields);
      unit.fields.uplift.insert(unit.fields.uplift.end(), 3, 0);
      unit.fields.failed.resize(unit.fields.uplift.size(), 0);
      unit.fields.search_failed.resize(unit.fields.capacity.size(), 0);
    }
    units.push_back(unit);
  }
  return reduce(plan, units);
}

void add(HistoryFields& fields, const std::vector<double>& peaks_m, double capacity) {
  fields.peak_displacement_m.insert(fields.peak_displacement_m.end(), peaks_m.begin(),
                                    peaks_m.end());
  fields.capacity.push_back(capacity);
}

// Recrossing, by hand: a threshold reached at one level and not at the next.
TEST(reduce, fits_no_fragility_of_an_array_that_cannot_slide) {
  StudyConfig config = small_config();
  config.model.axes = SlidingAxes::two;
  config.base_shear = true;
  config.support = {ArraySupport::isolated, ArraySupport::anchored};
  config.sampling.samples = 2;
  config.intensity.levels = {1.0};
  const Results results = test::run(small_plan(config));
  ASSERT_EQ(results.cases.combinations(), 4u);  // by friction value and support
  ASSERT_EQ(results.runs.size(), 2u);
  for (const RunResults& run : results.runs)
    EXPECT_EQ(results.cases.cases[run.first_case].support, ArraySupport::isolated);
}

TEST(reduce, counts_histories_that_fall_below_the_threshold_again) {
  const Results results =
      reduce_made_up([](std::size_t record, std::size_t sample, HistoryFields& fields) {
        const bool recrosses = record == 0 && sample == 0;
        add(fields,
            recrosses ? std::vector<double>{0.0, 0.2, 0.05} : std::vector<double>{0.0, 0.2, 0.3},
            1.5 + 0.01 * static_cast<double>(sample) + 0.1 * static_cast<double>(record));
      });
  EXPECT_DOUBLE_EQ(results.runs[0].fragilities[0].recross_share, 1.0 / 12);
  EXPECT_EQ(results.runs[0].fragilities[0].record_recross, (std::vector<double>{1, 0, 0}));
}

// One sample of four slides freely on every record: it exceeds at 1 g, where no other does.
TEST(reduce, has_histories_that_slide_freely_in_the_observed_shares_the_curves_and_the_band) {
  const Results results =
      reduce_made_up([](std::size_t record, std::size_t sample, HistoryFields& fields) {
        if (sample == 0) return add(fields, {5.0, 5.1, 5.2}, 0.0);
        add(fields, {0.0, sample == 1 ? 0.2 : 0.0, 0.3},
            (sample == 1 ? 1.8 : 2.2) + 0.1 * static_cast<double>(record));
      });
  const ThresholdFragility& f = results.runs[0].fragilities[0];
  EXPECT_EQ(f.probability, (std::vector<double>{0.25, 0.5, 1.0}));
  EXPECT_EQ(f.free_sliding_share, 0.25);
  for (const FitSummary& fit : {f.capacities, f.stripes}) {
    EXPECT_TRUE(fit.converged());
    EXPECT_EQ(fit.curve.floor, 0.25);
    EXPECT_NEAR(fit.curve.probability(1.0), 0.25, 0.03);  // separated: penalised for 3 records
    EXPECT_LT(fit.curve.intensity_at(0.5), fit.curve.median);
  }
  for (const Interval& interval : f.capacities.band) EXPECT_GE(interval.low, 0.25);
}

TEST(reduce, reports_that_every_history_slides_freely) {
  const Results results = reduce_made_up([](std::size_t, std::size_t, HistoryFields& fields) {
    add(fields, {5.0, 5.1, 5.2}, 0.0);
  });
  const ThresholdFragility& f = results.runs[0].fragilities[0];
  EXPECT_EQ(f.stripes.status, FitStatus::always_exceeds);
  EXPECT_EQ(f.capacities.status, FitStatus::always_exceeds);
  EXPECT_EQ(f.probability, (std::vector<double>{1, 1, 1}));
}

// One history of record 1 does not converge at 2 g: its slip is unknown there, and counts as above
// every clearance. Neither does one of record 2 in search of its capacity.
TEST(reduce,
     counts_a_history_that_does_not_converge_as_above_every_threshold_and_names_its_record) {
  const auto made_up = [](bool fails) {
    return reduce_made_up([=](std::size_t record, std::size_t sample, HistoryFields& fields) {
      const bool failed = fails && record == 1 && sample == 2;
      add(fields, {0.0, failed ? infinity : 0.05, 0.3},
          (failed ? 1.5 : 2.5) + 0.1 * static_cast<double>(record + sample));
      fields.failed.insert(fields.failed.end(), {0, failed ? std::uint8_t{1} : std::uint8_t{0}, 0});
      fields.search_failed.push_back(fails && record == 2 && sample == 0 ? 1 : 0);
    });
  };
  const Results results = made_up(true), without = made_up(false);
  const HistoryTable& table = results.histories;
  EXPECT_EQ(std::ranges::count(table.fields.failed, 1), 1);
  EXPECT_EQ(table.fields.failed[table.at(1, 2, 1)], 1);
  EXPECT_DOUBLE_EQ(results.runs[0].fragilities[0].probability[1], 1.0 / 12);
  EXPECT_EQ(results.runs[0].slip[1].mean_m, infinity);
  EXPECT_EQ(results.runs[0].slip[1].median_m, 0.05);
  ASSERT_EQ(results.notes.size(), without.notes.size() + 1);
  const auto names_it = [](const std::string& note) {
    return note.find("1 of 36 histories, and some in search of 1 of 12 capacities") != note.npos &&
           note.find("motion1, motion2") != note.npos && note.find("motion0") == note.npos;
  };
  EXPECT_EQ(std::ranges::count_if(results.notes, names_it), 1);
  EXPECT_EQ(std::ranges::count_if(without.notes, names_it), 0);
}

}  // namespace
}  // namespace glissade
