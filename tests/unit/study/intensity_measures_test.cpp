// SPDX-License-Identifier: GPL-3.0-or-later
// Intensity measures ranked on capacities that are made of one of them.
#include "glissade/study/analysis/intensity_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/core/random.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// Every record reaches the threshold at a PGV of 0.5 m/s times a scatter of 1 %; levels are PGA.
struct SlidesByPgv {
  static constexpr std::size_t records = 20;
  StudyConfig config;
  Results results;

  SlidesByPgv() {
    config.intensity_measures.emplace();
    config.sampling.bootstrap_replicates = 100;
    results.measure = *IntensityMeasure::named("pga_g");
    results.levels = {0.1, 100.0};
    results.thresholds_m = {0.1};
    results.cases.samples = 1;
    results.cases.cases.resize(1);
    results.histories = {records, 1, 2, 1, {}};
    for (std::size_t i = 0; i < records; ++i) {
      RecordSummary r;
      r.pga_g = 0.3 * std::exp(0.5 * normal(i, 0));
      r.pgv_mps = 0.2 * std::exp(0.5 * normal(i, 1));
      r.pgd_m = 0.1 * std::exp(0.5 * normal(i, 2));
      r.arias_mps = std::exp(normal(i, 3));
      r.duration_s = 10.0 * std::exp(0.3 * normal(i, 4));
      r.magnitude = 6.0 + 0.05 * static_cast<double>(i);
      r.factor_at_unit_level = 1.0 / r.pga_g;
      const double factor = 0.5 * std::exp(0.01 * normal(i, 5)) / r.pgv_mps;
      results.histories.fields.capacity.push_back(factor * r.pga_g);
      results.records.push_back(r);
    }
    RunResults run;
    run.label = "sampled";
    run.cases = 1;
    results.runs.push_back(run);
  }
  static double normal(std::size_t record, std::uint32_t what) {
    return keyed_normal(3, RandomPurpose::test, record, what);
  }
  std::vector<RankedMeasure> rank() const {
    return IntensityMeasuresAnalysis::find(config, results);
  }
};

const RankedMeasure& named(const std::vector<RankedMeasure>& rows, const std::string& name) {
  return *std::ranges::find(rows, name, &RankedMeasure::name);
}

TEST(intensity_measures, rank_first_the_one_that_the_capacities_are_made_of) {
  const std::vector<RankedMeasure> rows = SlidesByPgv().rank();
  const RankedMeasure& pgv = named(rows, "PGV");
  EXPECT_NE(rows.front().name.find("PGV"), std::string::npos);
  EXPECT_NEAR(pgv.dispersion.value, 0.01, 0.005);
  EXPECT_GT(named(rows, "PGA").dispersion.value, 0.2);
  EXPECT_LT(pgv.dispersion.interval.low, pgv.dispersion.value);
  EXPECT_GT(pgv.dispersion.interval.high, pgv.dispersion.value);
  EXPECT_NEAR(named(rows, "PGA and PGV").dispersion.value, 0.01, 0.005);
  EXPECT_TRUE(std::isnan(pgv.distance_p));
  EXPECT_GT(pgv.magnitude_p, 0.0);
}

TEST(intensity_measures, of_a_suite_scaled_by_its_own_factors_are_the_same) {
  SlidesByPgv by_pga, by_sds;
  by_sds.results.measure = IntensityMeasure::sds_g;
  for (std::size_t i = 0; i < SlidesByPgv::records; ++i) {
    RecordSummary& r = by_sds.results.records[i];
    by_sds.results.histories.fields.capacity[i] /= 2.0 * r.pga_g;
    r.factor_at_unit_level = 2.0;
  }
  EXPECT_NEAR(named(by_pga.rank(), "PGV").dispersion.value,
              named(by_sds.rank(), "PGV").dispersion.value, 1e-12);
  const std::vector<RankedMeasure> rows = by_sds.rank();
  EXPECT_NE(std::ranges::find(rows, "S_DS", &RankedMeasure::name), rows.end());
}

TEST(intensity_measures, are_not_ranked_where_half_of_the_records_do_not_reach_the_threshold) {
  SlidesByPgv study;
  for (std::size_t i = 0; i < 10; ++i)
    study.results.histories.fields.capacity[i] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(study.rank().empty());
  study.results.histories.fields.capacity[0] = 1.0;
  EXPECT_EQ(study.rank().front().censored_records, 9u);
}

TEST(intensity_measures, find_that_a_measure_depends_on_magnitude) {
  SlidesByPgv study;
  for (std::size_t i = 0; i < SlidesByPgv::records; ++i)
    study.results.histories.fields.capacity[i] *=
        std::exp(0.5 * (study.results.records[i].magnitude - 6.0));
  const RankedMeasure pgv = named(study.rank(), "PGV");
  EXPECT_NEAR(pgv.magnitude_slope, 0.5, 0.05);
  EXPECT_LT(pgv.magnitude_p, 1e-6);
}

}  // namespace
}  // namespace glissade
