// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_texts.hpp"
#include "toml/toml_table.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

TEST_F(StudyFile, an_unknown_key_is_shown_in_its_line_with_the_nearest_known_one) {
  const std::string text = needed + "[building]\n\tperiod_ms = 200\n";
  // The one message of a misspelt key that is compared in full.
  EXPECT_EQ(error(text).substr(folder_.path().string().size()),
            "/study.toml:14: building.period_ms is not a known key; did you mean period_s, in s or "
            "written with its unit (s, ms)?\n  \tperiod_ms = 200\n  \t^");
  EXPECT_THAT(faults(needed + "[bulding]\nperiod_s = 1\n"), ElementsAre("13 bulding"));
}

TEST_F(StudyFile, all_problems_are_reported_at_once) {
  EXPECT_THAT(faults(study_part + suite_part +
                     "[intensity]\nmeasure = \"sdz_g\"\nlevels = [2, 1]\n[friction]\n"
                     "mu = { mean = -0.5, std = 0.1 }\n[roof]\nslope_deg = 95\n"),
              UnorderedElementsAre("7 intensity.measure", "8 intensity.levels",
                                   "10 friction.mu.mean", "12 roof.slope_deg", "1 the"));
}

TEST_F(StudyFile, a_mean_needs_its_deviation_which_is_not_relative) {
  const auto with = [](const char* mu) {
    return study_part + suite_part + intensity_part + "[friction]\nmu = " + mu + "\n" +
           fragility_part;
  };
  refuses(
      {{with("{ mean = 0.55 }"), "study.toml:10", {"friction.mu.std is missing", "mu = 0.55"}}});
  EXPECT_THAT(lines_of([&] { read(with("{ mean = 0.55, cov = 0.08 }")); }), ElementsAre(10));
  EXPECT_THAT(error(with("{ mean = 0.55, cov = 0.08 }")),
              test::states("friction.mu.cov is not a known key", "std = cov x mean"));
  for (const char* mu : {"{ median = 0.5, cov = 0.1 }",
                         "{ distribution = \"lognormal\", median = 0.5, cov = 0.1 }"}) {
    EXPECT_THAT(lines_of([&] { read(with(mu)); }), ElementsAre(10));
    EXPECT_THAT(error(with(mu)), test::states("friction.mu.cov", "log_std = sqrt(ln(1 + cov^2))"));
  }
}

// A number with a unit is named as it is written, or with the unit of its key.
TEST_F(StudyFile, numbers_with_units_are_named_with_units) {
  const std::string head = study_part + suite_part + intensity_part + friction_part;
  EXPECT_THAT(error(head + "[fragility]\nthresholds_m = [\"-2 ft\"]\n"),
              test::states("fragility.thresholds_m = '-2 ft' is not above 0"));
  EXPECT_THAT(error(needed + "[building]\nperiod_s = [\"-300 ms\"]\n"),
              test::states("building.period_s: -0.3 s is outside its range"));
  EXPECT_THAT(error(head + "[fragility]\nthresholds_m = [\"2 ft\", \"1 ft\"]\n"),
              test::states("0.6096 m is followed by 0.3048 m"));
}

TEST_F(StudyFile, several_suites_have_a_key_of_their_own) {
  refuses({{study_part + "[suite]\nfile = [\"suite.toml\"]\n" + intensity_part + friction_part +
                fragility_part,
            "study.toml:5",
            {"suite.file", "suite.files = [...]"}}});
}

TEST_F(StudyFile, plain_numbers_of_a_study_in_us_units_are_named) {
  const std::string us =
      "[study]\nname = \"s\"\nunits = \"us\"\n" + suite_part + intensity_part + friction_part;
  EXPECT_THAT(
      read(us + "[fragility]\nthresholds_m = [\"2 ft\", 1, 3]\n").unmarked_numbers,
      ElementsAre("fragility.thresholds_m = 1 (3.28 ft)", "fragility.thresholds_m = 3 (9.84 ft)"));
  EXPECT_THAT(read(needed).unmarked_numbers, ElementsAre());
}

TEST_F(StudyFile, syntax_errors_and_wrong_types_are_located) {
  EXPECT_THAT(lines_of([&] { read("[study]\nname = \"a\nseed = 1\n"); }), ElementsAre(2));
  EXPECT_THAT(faults(needed + "[building]\nperiod_s = \"0.5\"\n"),
              ElementsAre("14 building.period_s"));
  EXPECT_THAT(faults(needed + "[building]\nmass_ratio = \"0.5\"\n"),
              ElementsAre("14 building.mass_ratio"));
  EXPECT_THAT(faults(needed + "[sampling]\nsamples = 1.5\n"), ElementsAre("14 sampling.samples"));
  EXPECT_THAT(faults(needed + "building = 3\n"), ElementsAre("13 fragility.building"));
  EXPECT_THAT(faults("study = 3\n"), testing::Contains("1 study"));
  EXPECT_THAT(faults(needed + "[roof]\nslope_deg = nan\n"), ElementsAre("14 roof.slope_deg"));
  EXPECT_EQ(problems_of([&] { read(std::string("\xff\xfe", 2)); }).size(), 1u);
}

/// toml++ takes nested tables down by recursion, which has no room for this many.
TEST_F(StudyFile, a_name_that_nests_without_end_is_refused) {
  std::string name = "a";
  for (int i = 0; i < 100'000; ++i) name += ".a";
  refuses({{needed + name + " = 1\n", "study.toml:13", {"2000"}}});
  EXPECT_LT(error(needed + name + " = 1\n").size(), 1000u);
  EXPECT_THROW(toml_without(name + " = 1\n", {}), InputError);
}

TEST_F(StudyFile, a_problem_far_down_shows_its_line_whatever_the_letters_above) {
  std::string text = "\xEF\xBB\xBF" + needed + "# α\n\n[building]\nperiod_s = \"1 α\"\r\n";
  refuses({{text, "study.toml:16", {"building.period_s"}}});
  const std::vector<Problem> problems = problems_of([&] { read(text); });
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].excerpt, "  period_s = \"1 α\"\n             ^");
}

/// A study that is refused, and what its message begins with: the key at fault.
struct Contradiction {
  std::string text, key;
};

TEST_F(StudyFile, contradictions_and_values_out_of_range_have_one_clear_message_each) {
  const std::string rest = study_part + suite_part + friction_part + fragility_part;
  const std::string building = needed + "[building]\n";
  const std::string pga = rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = [0.5]\n";
  const std::string by_sds = "[intensity]\nmeasure = \"sds_g\"\nlevels = [0.5]\n";
  const std::vector<Contradiction> cases = {
      {pga + "[standards]\ncompare = [\"asce7_16\"]\n", "[standards] needs intensity.measure"},
      {pga + "sa_period_s = 1.0\n", "intensity.sa_period_s"},
      {pga + "avg_sa_periods_s = [1.0]\n", "intensity.avg_sa_periods_s"},
      {rest + "[intensity]\nmeasure = \"sa_g\"\nlevels = [0.5]\n", "intensity.sa_period_s"},
      {pga + "target = { edition = \"asce7_16\", ss_g = 1, s1_g = 0.5 }\n", "intensity.target"},
      {pga + "scaling_rule = \"asce7_16\"\n", "intensity.scaling_rule"},
      {rest + by_sds + "scaling_rule = \"asce7_10\"\nto_1_5_t = true\n", "intensity.to_1_5_t"},
      {rest + by_sds + "scaling_rule = \"asce7_16\"\nscaled_to_s = 3\n", "intensity.scaled_to_s"},
      {needed + "[sampling]\nsamples = 1000\n", "sampling.samples"},
      {needed + "[sampling]\nsamples = 0\n", "sampling.samples"},
      {needed + "[sampling]\nbootstrap_replicates = 10\n", "sampling.bootstrap_replicates"},
      {building + "damping = { distribution = \"normal\", mean = 0.05, std = 0.02 }\n",
       "building.damping"},
      {building + "period_s = { distribution = \"uniform\", min = 2, max = 1 }\n",
       "building.period_s"},
      {building + "period_s = { distribution = \"unifrom\", min = 1, max = 2 }\n",
       "building.period_s.distribution"},
      {building + "period_s = { distribution = \"uniform\", low = 1, max = 2 }\n",
       "building.period_s.min"},
      {building + "period_s = [1, 0.5]\n", "building.period_s"},
      {building + "period_s = []\n", "building.period_s"},
      {building + "response_modification = 0.5\n", "building.response_modification"},
      {building + "response_modification = [0, 0.5, 2]\n", "building.response_modification"},
      {building + "response_modification = { mean = 3, std = 1 }\n",
       "building.response_modification"},
      {building + "response_modification = 2\nyield_coefficient = 0.2\n",
       "building.response_modification"},
      {building + "response_modification = [0, 2]\nyield_coefficient = [0, 0.2]\n",
       "building.response_modification"},
      {building + "hardening_ratio = 0.05\n", "building.hardening_ratio"},
      {building + "period_s = 1\nalpha = -1\n", "building.alpha"},
      {building + "alpha = 5\n", "building.alpha"},
      {building + "period_s = 1\nalpha = 5\nstoreys = 3\n", "building.storeys"},
      {building + "period_s = 1\nalpha = 5\nresponse_modification = 2\n",
       "building.response_modification"},
      {building + "period_s = 1\nstoreys = 0\n", "building.storeys"},
      {building + "period_s = 1\nstoreys = 2\nstorey_masses = [1, 1, 1]\n",
       "building.storey_masses"},
      {building + "period_s = 1\nstorey_stiffnesses = [1, 0]\n", "building.storey_stiffnesses"},
      {building + "modes = [{ period_s = 1, participation = 1.3 }]\n", "building.modes.mass_share"},
      {building + "modes = [{ period_s = 1, participation = 1.3, mass_share = 0.8 }, { "
                  "period_s = 1.2, participation = -0.3, mass_share = 0.1 }]\n",
       "building.modes"},
      {building + "modes = [{ period_s = 1, participation = 1.3, mass_share = 0.8 }, { "
                  "period_s = 0.3, participation = -0.3, mass_share = 0.3 }]\n",
       "building.modes"},
      {building + "modes = []\n", "building.modes"},
      {building + "modes = 5\n", "building.modes"},
      {building +
           "modes = [{ period_s = 1, participation = 1.3, mass_share = 0.8, damping = 5 }]\n",
       "building.modes.damping"},
      {building + "modes = [{ period_s = 1, participation = 1e308, mass_share = 0.8 }]\n",
       "building.modes.participation"},
      {building + "modes_across = [{ period_s = 1, participation = 1.3, mass_share = 0.8 }]\n",
       "building.modes_across"},
      {building + "modes = [{ period_s = 1, participation = 1.3, mass_share = 0.8 }]\n"
                  "modes_across = [{ period_s = 1, participation = 1.3, mass_share = 0.8 }]\n"
                  "[model]\naxes = 1\n",
       "building.modes_across"},
      {study_part + "[suite]\nfile = \"suite.toml\"\nrecords = [5]\n" + intensity_part +
           friction_part + fragility_part,
       "suite.records"},
      {building +
           "modes = [{ period_s = 7, participation = 1, mass_share = 0.1 }, { "
           "period_s = 6, participation = 1, mass_share = 0.1 }, { period_s = 5, participation "
           "= 1, mass_share = 0.1 }, { period_s = 4, participation = 1, mass_share = 0.1 }, { "
           "period_s = 3, participation = 1, mass_share = 0.1 }, { period_s = 2, participation "
           "= 1, mass_share = 0.1 }, { period_s = 1, participation = 1, mass_share = 0.1 }]\n",
       "building.modes"},
      {needed + "[model]\naxes = 1\n[building]\nperiod_ratio = 0.5\n", "building.period_ratio"},
      {needed + "[model]\naxes = 1\n[roof]\nazimuth_deg = 45\n", "roof.azimuth_deg"},
      {needed + "[roof]\nslope_deg = 2\nrise_in_12 = 0.5\n", "roof.slope_deg"},
      {needed + "[roof]\nrise_in_12 = 101\n", "roof.rise_in_12"},
      {needed + "[roof]\nrise_in_12 = { distribution = \"uniform\", min = 0, max = 200 }\n",
       "roof.rise_in_12"},
      {friction_last + "across_mu = 0.4\n[model]\naxes = 1\n", "friction.across_mu"},
      {needed + "[model]\naxes = 1\n[orientation]\nsecond_sign = \"positive\"\n",
       "orientation.second_sign"},
      {needed + "[model]\naxes = 1\n[orientation]\nslope_axis = \"n_s\"\n",
       "orientation.slope_axis"},
      {needed + "[orientation]\nchoice = \"azimuths\"\nsign = \"positive\"\n", "orientation.sign"},
      {needed + "[array]\nsupport = [\"isolated\", \"anchored\"]\n", "array.support"},
      {needed + "[array]\nsupport = \"anchored\"\n", "array.support"},
      {needed + "[vertical]\nuse = [\"none\", \"none\"]\n", "vertical.use"},
      {needed + "[vertical]\nuse = []\n", "vertical.use"},
      {needed + "[model]\naxes = 1\ndisplacement = \"vector\"\n", "model.displacement"},
      {needed + "[model]\naxes = 3\n", "model.axes"},
      {without_fragility + "[base_shear]\n[model]\ndisplacement = \"vector\"\n",
       "model.displacement"},
      {without_fragility + "[clearance]\n[sampling]\nscrambles = 2\n", "sampling.scrambles"},
      {friction_last + "across_mu = 0\n[model]\naxes = 2\n", "friction.across_mu"},
      {friction_last + "fast_over_slow = 1.2\n", "friction.fast_over_slow"},
      {friction_last + "rate_s_per_m = 3\n", "friction.rate_s_per_m"},
      {friction_last + "slip_m = 0.1\n", "friction.slip_m"},
      {friction_last + "fast_over_slow = 1\nrate_s_per_m = 3\n", "friction.rate_s_per_m"},
      {needed + "[standards]\ncompare = [\"seaoc_pv1_2012\"]\nimportance = 1.25\n",
       "standards.importance"},
      {needed + "[standards]\ncompare = [\"asce7_16\"]\nseismic_design_category = \"D\"\n",
       "standards.seismic_design_category"},
      {needed + "[standards]\n", "standards.compare"},
      {needed + "[standards]\ncompare = [\"asce7_16\", \"asce7_16\"]\n", "standards.compare"},
      {needed + "[roof]\nslope_deg = { distribution = \"uniform\", min = 0, max = 90 }\n",
       "roof.slope_deg"},
      {needed + "[vertical]\nuse = \"none\"\nperiod_s = 0.1\n", "vertical.period_s"},
      {needed + "[model]\naxes = 1\n[base_shear]\n", "[base_shear]"},
      {needed + "[tipping]\nbase_width_m = 1\n", "tipping.centre_of_mass_height_m"},
      {needed + "stop_at_largest = true\n[impact]\n", "fragility.stop_at_largest"},
      {needed + "stop_at_largest = true\n[base_shear]\n[model]\naxes = 2\n",
       "fragility.stop_at_largest"},
      {without_friction + "[friction]\nmu = -0.5\n", "friction.mu"},
      {without_friction + "[friction]\n", "friction.mu"},
      {without_fragility, "the study"},
      {without_fragility + "[fragility]\nthresholds_m = [0.0, 0.3]\n", "fragility.thresholds_m"},
      {without_fragility + "[fragility]\nthresholds_m = []\n", "fragility.thresholds_m"},
      {rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 0.5, count = 4 }\n",
       "intensity.levels"},
      {rest +
           "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 2, count = 100000000 }\n",
       "intensity.levels"},
      {rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 1.0000000000000004, "
              "count = 9 }\n",
       "intensity.levels"},
      {building + "period_s = { from = 0, to = 2, count = 5000 }\n"
                  "[roof]\nslope_deg = { from = 0, to = 7, count = 5000 }\n",
       "the study"},
      {"[study]\nname = \"a\"\nseed = -1\n" + suite_part + intensity_part + friction_part +
           fragility_part,
       "study.seed"},
      {"[study]\nname = \"\"\n" + suite_part + intensity_part + friction_part + fragility_part,
       "study.name"},
      {study_part + "[suite]\nfile = \"none.toml\"\n" + intensity_part + friction_part +
           fragility_part,
       "there is no suite"},
      {study_part + "[suite]\nfiles = []\n" + intensity_part + friction_part + fragility_part,
       "suite.files"},
      {study_part + "[suite]\nfile = \"suite.toml\"\nfiles = [\"suite.toml\"]\n" + intensity_part +
           friction_part + fragility_part,
       "suite.file"},
      {study_part + "[suite]\nfile = \"suite.toml\"\nrecords = []\n" + intensity_part +
           friction_part + fragility_part,
       "suite.records"},
  };
  for (const Contradiction& c : cases) {
    try {
      read(c.text);
      ADD_FAILURE() << "accepted: " << c.key;
    } catch (const InputError& error) {
      // A key misspelt is reported twice: as unknown, and as missing under its right name.
      const std::size_t problems = c.key.ends_with(".min") ? 2 : 1;
      EXPECT_EQ(error.problems().size(), problems) << error.what();
      EXPECT_THAT(error.problems(), testing::Contains(testing::Truly([&](const Problem& p) {
                    return p.what.starts_with(c.key) && p.where.find("study.toml") != p.where.npos;
                  })))
          << c.key << "\n"
          << error.what();
    }
  }
}

}  // namespace
}  // namespace glissade
