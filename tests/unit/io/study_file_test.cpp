// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/study_file.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// The shape in the design, one section a key so that tests can replace a part.
const std::string study_part = "[study]\nname = \"quickstart\"\nseed = 20260101\n";
const std::string suite_part = "[suite]\nfile = \"suite.toml\"\n";
const std::string intensity_part =
    "[intensity]\nmeasure = \"sds_g\"\nlevels = { from = 0.5, to = 2.0, count = 4 }\n";
const std::string friction_part = "[friction]\nmean = 0.55\nstd = 0.04\n";
const std::string clearance_part = "[clearance]\nthresholds_m = [0.15, 0.3]\n";
const std::string needed =
    study_part + suite_part + intensity_part + friction_part + clearance_part;

/// The same, open for more keys of [friction].
const std::string friction_last =
    study_part + suite_part + intensity_part + clearance_part + friction_part;

class StudyFile : public testing::Test {
 protected:
  StudyFile() { folder_.write("suite.toml", ""); }
  StudyConfig read(const std::string& content) const {
    return read_study(folder_.write("study.toml", content));
  }
  std::string error(const std::string& content) const {
    return message_of([&] { read(content); });
  }
  TemporaryFolder folder_;
};

TEST_F(StudyFile, the_shape_of_the_design_is_read) {
  const std::string text = needed + R"([building]
period_s = { distribution = "uniform", min = 0.2, max = 2.0 }
damping = 0.05
mass_ratio = 0.0
[roof]
slope_deg = { distribution = "discrete", values = [1.19, 2.39, 4.76] }
[sampling]
method = "sobol"
samples = 512
bootstrap_replicates = 200
[orientation]
component = "second"
sign = "negative"
[vertical]
use = "required"
period_s = 0.1
damping = 0.02
[standards]
compare = ["seaoc_pv1_2012", "asce7_16"]
seismic_design_category = "E"
importance = 1.5
)";
  const StudyConfig study = read(text);
  EXPECT_EQ(study.name, "quickstart");
  EXPECT_EQ(study.seed, 20260101u);
  EXPECT_EQ(study.source_text, text);
  EXPECT_EQ(study.suite_file, folder_.path() / "suite.toml");
  EXPECT_EQ(study.intensity.measure, IntensityMeasure::sds_g);
  EXPECT_THAT(study.intensity.levels, ElementsAre(0.5, 1.0, 1.5, 2.0));
  EXPECT_EQ(std::get<Uniform>(study.building.period_s).max, 2.0);
  EXPECT_EQ(std::get<Fixed>(study.building.damping).value, 0.05);
  EXPECT_THAT(std::get<Discrete>(study.roof.slope_deg).weights, ElementsAre(1.0, 1.0, 1.0));
  const auto mu = std::get<TruncatedNormal>(study.friction.mu);
  EXPECT_EQ(mu.mean, 0.55);
  EXPECT_EQ(mu.std, 0.04);
  EXPECT_EQ(mu.min, 0.0);
  EXPECT_TRUE(std::isinf(mu.max));
  EXPECT_EQ(study.orientation.component, ComponentChoice::second);
  EXPECT_EQ(study.orientation.sign, SignChoice::negative);
  EXPECT_EQ(study.vertical.use, VerticalChoice::required);
  EXPECT_EQ(study.vertical.period_s, 0.1);
  EXPECT_EQ(study.sampling.samples, 512u);
  EXPECT_EQ(study.sampling.bootstrap_replicates, 200);
  EXPECT_THAT(study.thresholds_m, ElementsAre(0.15, 0.3));
  EXPECT_THAT(study.standards.compare, ElementsAre(Standard::seaoc_pv1_2012, Standard::asce7_16));
  EXPECT_EQ(study.standards.category, SeismicDesignCategory::e);
  EXPECT_EQ(study.standards.importance, 1.5);
}

TEST_F(StudyFile, the_model_is_read) {
  const StudyConfig study = read(friction_last + R"(across_mean = 0.45
across_std = 0.02
static_ratio = 1.1
fast_ratio = 1.3
rate_spm = 20
[model]
axes = 2
displacement = "vector"
[building]
period_s = 0.5
period_ratio = 1.5
mass_ratio = { distribution = "uniform", min = 0.05, max = 0.1 }
response_modification = 3
hardening_ratio = 0.02
[roof]
azimuth_deg = 30
[orientation]
second_sign = "negative"
)");
  EXPECT_EQ(study.model.axes, SlidingAxes::two);
  EXPECT_EQ(study.model.displacement, DisplacementMeasure::vector);
  EXPECT_EQ(study.building.period_ratio, 1.5);
  EXPECT_EQ(std::get<Uniform>(study.building.mass_ratio).max, 0.1);
  ASSERT_TRUE(study.building.strength);
  EXPECT_EQ(study.building.strength->response_modification, 3.0);
  EXPECT_FALSE(study.building.strength->yield_coefficient);
  EXPECT_EQ(study.building.strength->hardening_ratio, 0.02);
  EXPECT_EQ(std::get<Fixed>(study.roof.azimuth_deg).value, 30.0);
  ASSERT_TRUE(study.friction.across);
  EXPECT_EQ(std::get<TruncatedNormal>(*study.friction.across).mean, 0.45);
  EXPECT_EQ(study.friction.law.static_ratio, 1.1);
  EXPECT_EQ(study.friction.law.fast_ratio, 1.3);
  EXPECT_EQ(study.friction.law.rate_spm, 20.0);
  EXPECT_EQ(study.orientation.second_sign, SignChoice::negative);
}

TEST_F(StudyFile, what_is_left_out_takes_the_defaults_of_the_configuration) {
  const StudyConfig study = read(needed), defaults;
  EXPECT_EQ(std::get<Fixed>(study.building.period_s).value, 0.0);
  EXPECT_EQ(study.sampling.samples, defaults.sampling.samples);
  EXPECT_EQ(study.vertical.use, defaults.vertical.use);
  EXPECT_TRUE(study.friction.design_run);
  EXPECT_FALSE(study.intensity.target);
  EXPECT_TRUE(study.standards.compare.empty());
}

TEST_F(StudyFile, every_distribution_is_read) {
  const auto slope = [&](const std::string& value) {
    return read(needed + "[roof]\nslope_deg = " + value + "\n").roof.slope_deg;
  };
  EXPECT_EQ(std::get<Fixed>(slope("2")).value, 2.0);
  EXPECT_EQ(
      std::get<TruncatedNormal>(
          slope("{ distribution = \"truncated_normal\", mean = 2, std = 1, min = 0, max = 5 }"))
          .max,
      5.0);
  EXPECT_EQ(
      std::get<Triangular>(slope("{ distribution = \"triangular\", min = 0, mode = 1, max = 5 }"))
          .mode,
      1.0);
  EXPECT_EQ(std::get<Empirical>(slope("{ distribution = \"empirical\", values = [1, 2, 3] }"))
                .values.size(),
            3u);
  EXPECT_THAT(std::get<Discrete>(
                  slope("{ distribution = \"discrete\", values = [1, 2], weights = [3, 1] }"))
                  .weights,
              ElementsAre(3.0, 1.0));
  const StudyConfig study = read(
      needed +
      "[building]\nperiod_s = { distribution = \"lognormal\", median = 0.5, log_std = 0.4 }\n");
  EXPECT_EQ(std::get<LogNormal>(study.building.period_s).median, 0.5);
}

TEST_F(StudyFile, ranges_give_numbers_as_people_write_them) {
  const auto levels = [&](const std::string& range) {
    return read(study_part + suite_part + friction_part + clearance_part +
                "[intensity]\nmeasure = \"pga_g\"\nlevels = " + range + "\n")
        .intensity.levels;
  };
  EXPECT_THAT(levels("{ from = 0.1, to = 0.4, count = 4 }"), ElementsAre(0.1, 0.2, 0.3, 0.4));
  // Where twelve digits do not tell them apart they are kept as they are.
  const std::vector<double> near = levels("{ from = 1, to = 1.0000000000001, count = 3 }");
  EXPECT_LT(near[0], near[1]);
  EXPECT_LT(near[1], near[2]);
  EXPECT_THAT(levels("{ from = 1, to = 100, count = 3, spacing = \"log\" }"),
              ElementsAre(1, 10, 100));
}

TEST_F(StudyFile, measures_bring_their_periods_and_targets) {
  const std::string rest = study_part + suite_part + friction_part + clearance_part;
  EXPECT_EQ(read(rest + "[intensity]\nmeasure = \"sa_g\"\nsa_period_s = 1.0\nlevels = [0.1, 1]\n")
                .intensity.sa_period_s,
            1.0);
  const auto average = read(rest +
                            "[intensity]\nmeasure = \"avg_sa_g\"\nlevels = [1]\navg_sa_periods_s = "
                            "{ from = 0.1, to = 10, count = 3, spacing = \"log\" }\n");
  EXPECT_THAT(average.intensity.avg_sa_periods_s, ElementsAre(0.1, DoubleEq(1.0), 10.0));
  const auto target = read(needed +
                           "[intensity.target]\nedition = \"asce7_16\"\nss_g = 1.5\ns1_g = "
                           "0.6\nsite_class = \"C\"\n")
                          .intensity.target;
  ASSERT_TRUE(target);
  EXPECT_EQ(target->edition, AsceEdition::asce7_16);
  EXPECT_THAT(target->site_classes, ElementsAre(SiteClass::c));
  EXPECT_EQ(target->tl_s, 8.0);
}

TEST_F(StudyFile, an_unknown_key_is_shown_in_its_line_with_the_nearest_known_one) {
  const std::string text = needed + "[building]\n\tperiod_ms = 200\n";
  const std::string message = error(text);
  EXPECT_THAT(
      message,
      AllOf(
          HasSubstr("study.toml:15: building.period_ms is not a known key; did you mean period_s?"),
          HasSubstr("  \tperiod_ms = 200\n  \t^")));
  EXPECT_THAT(error(needed + "[bulding]\nperiod_s = 1\n"),
              AllOf(HasSubstr("bulding is not a known key; did you mean building?"),
                    Not(HasSubstr("period_s"))));
}

TEST_F(StudyFile, all_problems_are_told_at_once) {
  const std::string message =
      error(study_part + suite_part +
            "[intensity]\nmeasure = \"sdz_g\"\nlevels = [2, 1]\n[friction]\nmean = -0.5\nstd = "
            "0.1\n[roof]\nslope_deg = 95\n");
  EXPECT_THAT(
      message,
      AllOf(
          HasSubstr(
              "study.toml:7: intensity.measure = \"sdz_g\" is not known; did you mean \"sds_g\"?"),
          HasSubstr("study.toml:8: intensity.levels is not increasing"),
          HasSubstr("study.toml:10: friction.mean = -0.5 is not from 0 to 10"),
          HasSubstr("study.toml:13: roof.slope_deg is outside"),
          HasSubstr("[clearance] is missing")));
}

TEST_F(StudyFile, syntax_errors_and_wrong_types_are_located) {
  EXPECT_THAT(error("[study]\nname = \"a\nseed = 1\n"), HasSubstr("study.toml:2"));
  EXPECT_THAT(error(needed + "[building]\nperiod_s = \"0.5\"\n"),
              AllOf(HasSubstr("study.toml:15: building.period_s is a text, not a number"),
                    HasSubstr("leave the quotes out")));
  EXPECT_THAT(error(needed + "[sampling]\nsamples = 1.5\n"),
              HasSubstr("sampling.samples is not a whole number"));
  EXPECT_THAT(error(needed + "building = 3\n"), HasSubstr("clearance.building is not a known key"));
  EXPECT_THAT(error("study = 3\n"), HasSubstr("study is a number, not a table"));
  EXPECT_THAT(error(needed + "[roof]\nslope_deg = nan\n"),
              HasSubstr("slope_deg = nan is not finite"));
  EXPECT_THAT(error(std::string("\xff\xfe", 2)), HasSubstr("study.toml"));
}

TEST_F(StudyFile, measures_have_the_names_that_they_are_printed_with) {
  const std::string rest = study_part + suite_part + friction_part + clearance_part;
  for (const auto measure :
       {IntensityMeasure::sds_g, IntensityMeasure::pga_g, IntensityMeasure::ppa_g}) {
    EXPECT_EQ(read(rest + "[intensity]\nlevels = [1]\nmeasure = \"" + to_string(measure) + "\"\n")
                  .intensity.measure,
              measure);
  }
}

struct Contradiction {
  std::string text, message;
};

TEST_F(StudyFile, contradictions_and_values_out_of_range_have_one_clear_message_each) {
  const std::string rest = study_part + suite_part + friction_part + clearance_part;
  const std::string pga = rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = [0.5]\n";
  const std::vector<Contradiction> cases = {
      {pga + "[standards]\ncompare = [\"asce7_16\"]\n", "needs intensity.measure = \"sds_g\""},
      {pga + "sa_period_s = 1.0\n", "intensity.sa_period_s goes with measure = \"sa_g\" only"},
      {pga + "avg_sa_periods_s = [1.0]\n", "goes with measure = \"avg_sa_g\" only"},
      {rest + "[intensity]\nmeasure = \"sa_g\"\nlevels = [0.5]\n",
       "intensity.sa_period_s is missing"},
      {needed + "[sampling]\nsamples = 1000\n", "take 512 or 1024"},
      {needed + "[sampling]\nsamples = 0\n", "out of range"},
      {needed + "[sampling]\nbootstrap_replicates = 10\n", "100 to 1000000"},
      {needed + "[building]\ndamping = 1.0\n", "building.damping is outside"},
      {needed + "[building]\ndamping = { distribution = \"normal\", mean = 0.05, std = 0.02 }\n",
       "truncated_normal"},
      {needed + "[building]\nperiod_s = { distribution = \"uniform\", min = 2, max = 1 }\n",
       "building.period_s"},
      {needed + "[building]\nperiod_s = { distribution = \"unifrom\", min = 1, max = 2 }\n",
       "did you mean \"uniform\"?"},
      {needed + "[building]\nperiod_s = { distribution = \"uniform\", low = 1, max = 2 }\n",
       "building.period_s.min is missing"},
      {needed + "[building]\nmass_ratio = -0.1\n", "building.mass_ratio is outside"},
      {needed + "[building]\nmass_ratio = 1.5\n", "the array's mass over the building's, 0 to 1"},
      {needed + "[building]\nresponse_modification = 0.5\n", "R divides the elastic demand"},
      {needed + "[building]\nresponse_modification = 2\nyield_coefficient = 0.2\n",
       "each tells how strong the building is"},
      {needed + "[building]\nhardening_ratio = 0.05\n", "has no effect on a building that stays"},
      {needed + "[building]\nperiod_ratio = 0.5\n", "goes with [model] axes = 2 only"},
      {needed + "[roof]\nazimuth_deg = 45\n", "goes with [model] axes = 2 only"},
      {friction_last + "across_mu = 0.4\n", "goes with [model] axes = 2 only"},
      {needed + "[orientation]\nsecond_sign = \"positive\"\n", "goes with [model] axes = 2 only"},
      {needed + "[model]\ndisplacement = \"vector\"\n", "goes with [model] axes = 2 only"},
      {needed + "[model]\naxes = 3\n", "model.axes = 3"},
      {friction_last + "across_mu = 0\n[model]\naxes = 2\n", "friction across the slope is zero"},
      {friction_last + "static_ratio = 0.9\n", "static friction is not below sliding friction"},
      {friction_last + "fast_ratio = 1.2\n", "one half of how friction depends on speed"},
      {friction_last + "fast_ratio = 0\nrate_spm = 3\n", "friction.fast_ratio"},
      {needed + "[roof]\nslope_deg = { distribution = \"uniform\", min = 0, max = 90 }\n",
       "can take values outside"},
      {needed + "[vertical]\nuse = \"none\"\nperiod_s = 0.1\n", "no effect"},
      {study_part + suite_part + intensity_part + clearance_part +
           "[friction]\nmu = 0.5\nmean = 0.5\n",
       "both given"},
      {study_part + suite_part + intensity_part + clearance_part + "[friction]\nmu = -0.5\n",
       "friction.mu is outside"},
      {study_part + suite_part + intensity_part + clearance_part + "[friction]\n",
       "give mean and std, or mu"},
      {study_part + suite_part + intensity_part + friction_part +
           "[clearance]\nthresholds_m = [0.0, 0.3]\n",
       "is not above 0"},
      {study_part + suite_part + intensity_part + friction_part +
           "[clearance]\nthresholds_m = []\n",
       "is empty"},
      {rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 0.5, count = 4 }\n",
       "is not above from"},
      {rest +
           "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 2, count = 100000000 }\n",
       "out of range"},
      {rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 1.0000000000000004, "
              "count = 9 }\n",
       "more values than there are between"},
      {"[study]\nname = \"a\"\nseed = -1\n" + suite_part + intensity_part + friction_part +
           clearance_part,
       "study.seed = -1"},
      {"[study]\nname = \"\"\n" + suite_part + intensity_part + friction_part + clearance_part,
       "study.name is empty"},
      {study_part + "[suite]\nfile = \"none.toml\"\n" + intensity_part + friction_part +
           clearance_part,
       "there is no suite"},
  };
  for (const Contradiction& c : cases) {
    try {
      read(c.text);
      ADD_FAILURE() << "accepted: " << c.message;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(c.message), HasSubstr("study.toml:")));
      // A key misspelt is told twice: as unknown, and as missing under its right name.
      const std::size_t problems = c.message.find("min is missing") == std::string::npos ? 1 : 2;
      EXPECT_EQ(error.problems().size(), problems) << error.what();
    }
  }
}

TEST_F(StudyFile, a_convergence_study_gets_one_error_that_names_the_program_for_it) {
  try {
    read(study_part + suite_part + "[convergence]\nmu = [0, 0.1]\nsubsteps = [1, 2]\n");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 1u) << error.what();
    EXPECT_THAT(error.problems()[0].where, HasSubstr("study.toml:6"));
    EXPECT_THAT(error.problems()[0].suggestion, HasSubstr("tests/convergence/convergence"));
  }
}

TEST_F(StudyFile, a_tail_of_one_in_a_million_may_lie_outside_the_range) {
  const StudyConfig lognormal = read(
      needed +
      "[building]\ndamping = { distribution = \"lognormal\", median = 0.05, log_std = 0.4 }\n");
  EXPECT_TRUE(std::holds_alternative<LogNormal>(lognormal.building.damping));
  const StudyConfig normal = read(
      needed + "[building]\ndamping = { distribution = \"normal\", mean = 0.05, std = 0.01 }\n");
  EXPECT_TRUE(std::holds_alternative<Normal>(normal.building.damping));
}

}  // namespace
}  // namespace glissade
