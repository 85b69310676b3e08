// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_texts.hpp"

namespace glissade {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST_F(StudyFile, an_unknown_key_is_shown_in_its_line_with_the_nearest_known_one) {
  const std::string text = needed + "[building]\n\tperiod_ms = 200\n";
  const std::string message = error(text);
  EXPECT_THAT(
      message,
      AllOf(
          HasSubstr("study.toml:14: building.period_ms is not a known key; did you mean period_s?"),
          HasSubstr("  \tperiod_ms = 200\n  \t^")));
  EXPECT_THAT(error(needed + "[bulding]\nperiod_s = 1\n"),
              AllOf(HasSubstr("bulding is not a known key; did you mean building?"),
                    Not(HasSubstr("period_s"))));
}

TEST_F(StudyFile, all_problems_are_reported_at_once) {
  const std::string message = error(
      study_part + suite_part +
      "[intensity]\nmeasure = \"sdz_g\"\nlevels = [2, 1]\n[friction]\nmu = { mean = -0.5, std "
      "= 0.1 }\n[roof]\nslope_deg = 95\n");
  for (const char* part :
       {"study.toml:7: intensity.measure = \"sdz_g\"", "study.toml:8: intensity.levels",
        "study.toml:10: friction.mu.mean = -0.5", "study.toml:12: roof.slope_deg", "[fragility]"})
    EXPECT_THAT(message, HasSubstr(part));
}

TEST_F(StudyFile, syntax_errors_and_wrong_types_are_located) {
  EXPECT_THAT(error("[study]\nname = \"a\nseed = 1\n"), HasSubstr("study.toml:2"));
  EXPECT_THAT(error(needed + "[building]\nperiod_s = \"0.5\"\n"),
              AllOf(HasSubstr("study.toml:14: building.period_s"), HasSubstr("s, ms")));
  EXPECT_THAT(error(needed + "[building]\nmass_ratio = \"0.5\"\n"),
              AllOf(HasSubstr("study.toml:14: building.mass_ratio is a text, not a number"),
                    HasSubstr("leave the quotes out")));
  EXPECT_THAT(error(needed + "[sampling]\nsamples = 1.5\n"),
              HasSubstr("sampling.samples is not a whole number"));
  EXPECT_THAT(error(needed + "building = 3\n"), HasSubstr("fragility.building is not a known key"));
  EXPECT_THAT(error("study = 3\n"), HasSubstr("study is a number, not a table"));
  EXPECT_THAT(error(needed + "[roof]\nslope_deg = nan\n"),
              HasSubstr("slope_deg = nan is not finite"));
  EXPECT_THAT(error(std::string("\xff\xfe", 2)), HasSubstr("study.toml"));
}

struct Contradiction {
  std::string text, message;
};

TEST_F(StudyFile, contradictions_and_values_out_of_range_have_one_clear_message_each) {
  const std::string rest = study_part + suite_part + friction_part + fragility_part;
  const std::string pga = rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = [0.5]\n";
  const std::vector<Contradiction> cases = {
      {pga + "[standards]\ncompare = [\"asce7_16\"]\n", "needs intensity.measure = \"sds_g\""},
      {pga + "sa_period_s = 1.0\n", "intensity.sa_period_s needs measure = \"sa_g\""},
      {pga + "avg_sa_periods_s = [1.0]\n", "needs measure = \"avg_sa_g\""},
      {rest + "[intensity]\nmeasure = \"sa_g\"\nlevels = [0.5]\n",
       "intensity.sa_period_s is missing"},
      {pga + "target = { edition = \"asce7_16\", ss_g = 1, s1_g = 0.5 }\n",
       "intensity.target needs"},
      {needed + "[sampling]\nsamples = 1000\n", "take 512 or 1024"},
      {needed + "[sampling]\nsamples = 0\n", "out of range"},
      {needed + "[sampling]\nbootstrap_replicates = 10\n", "100 to 1000000"},
      {needed + "[building]\ndamping = { distribution = \"normal\", mean = 0.05, std = 0.02 }\n",
       "truncated_normal"},
      {needed + "[building]\nperiod_s = { distribution = \"uniform\", min = 2, max = 1 }\n",
       "building.period_s"},
      {needed + "[building]\nperiod_s = { distribution = \"unifrom\", min = 1, max = 2 }\n",
       "did you mean \"uniform\"?"},
      {needed + "[building]\nperiod_s = { distribution = \"uniform\", low = 1, max = 2 }\n",
       "building.period_s.min is missing"},
      {needed + "[building]\nperiod_s = [1, 0.5]\n", "building.period_s is not increasing"},
      {needed + "[building]\nperiod_s = []\n", "building.period_s is empty"},
      {needed + "[building]\nresponse_modification = 0.5\n", "values between 0 and 1"},
      {needed + "[building]\nresponse_modification = [0, 0.5, 2]\n", "values between 0 and 1"},
      {needed + "[building]\nresponse_modification = { mean = 3, std = 1 }\n",
       "values between 0 and 1"},
      {needed + "[building]\nresponse_modification = 2\nyield_coefficient = 0.2\n",
       "response_modification and building.yield_coefficient are both given"},
      {needed + "[building]\nresponse_modification = [0, 2]\nyield_coefficient = [0, 0.2]\n",
       "response_modification and building.yield_coefficient are both given"},
      {needed + "[building]\nhardening_ratio = 0.05\n", "building.hardening_ratio needs"},
      {needed + "[model]\naxes = 1\n[building]\nperiod_ratio = 0.5\n", "needs [model] axes = 2"},
      {needed + "[model]\naxes = 1\n[roof]\nazimuth_deg = 45\n", "needs [model] axes = 2"},
      {needed + "[roof]\nslope_deg = 2\nrise_in_12 = 0.5\n",
       "roof.slope_deg and roof.rise_in_12 are both given"},
      {needed + "[roof]\nrise_in_12 = 101\n", "a rise in 12, -100 to 100"},
      {needed + "[roof]\nrise_in_12 = { mean = 1, std = 0.1 }\n", "roof.rise_in_12"},
      {friction_last + "across_mu = 0.4\n[model]\naxes = 1\n", "needs [model] axes = 2"},
      {needed + "[model]\naxes = 1\n[orientation]\nsecond_sign = \"positive\"\n",
       "needs [model] axes = 2"},
      {needed + "[model]\naxes = 1\n[orientation]\nslope_axis = \"n_s\"\n",
       "needs [model] axes = 2"},
      {needed + "[orientation]\nchoice = \"azimuths\"\nsign = \"positive\"\n",
       "orientation.sign needs choice = \"random\""},
      {needed + "[array]\nsupport = [\"isolated\", \"anchored\"]\n",
       "array.support needs [base_shear]"},
      {needed + "[array]\nsupport = \"anchored\"\n", "leaves out \"isolated\""},
      {needed + "[vertical]\nuse = [\"none\", \"none\"]\n", "vertical.use names one twice"},
      {needed + "[vertical]\nuse = []\n", "vertical.use is empty"},
      {needed + "[model]\naxes = 1\ndisplacement = \"vector\"\n", "needs [model] axes = 2"},
      {needed + "[model]\naxes = 3\n", "model.axes = 3"},
      {friction_last + "across_mu = 0\n[model]\naxes = 2\n", "friction.across_mu is zero"},
      {friction_last + "fast_over_slow = 1.2\n", "friction.fast_over_slow needs"},
      {friction_last + "rate_s_per_m = 3\n", "friction.rate_s_per_m needs"},
      {friction_last + "slip_m = 0.1\n", "friction.slip_m needs friction.file"},
      {friction_last + "fast_over_slow = 1\nrate_s_per_m = 3\n", "friction.rate_s_per_m needs"},
      {needed + "[standards]\ncompare = [\"seaoc_pv1_2012\"]\nimportance = 1.25\n",
       "standards.importance needs"},
      {needed + "[standards]\ncompare = [\"asce7_16\"]\nseismic_design_category = \"D\"\n",
       "standards.seismic_design_category needs"},
      {needed + "[standards]\n", "standards.compare is missing"},
      {needed + "[standards]\ncompare = [\"asce7_16\", \"asce7_16\"]\n", "standards.compare"},
      {needed + "[roof]\nslope_deg = { distribution = \"uniform\", min = 0, max = 90 }\n",
       "can take values outside"},
      {needed + "[vertical]\nuse = \"none\"\nperiod_s = 0.1\n", "vertical.period_s needs"},
      {needed + "[model]\naxes = 1\n[base_shear]\n", "[base_shear] needs [model] axes = 2"},
      {needed + "[tipping]\nbase_width_m = 1\n", "tipping.centre_of_mass_height_m is missing"},
      {needed + "stop_at_largest = true\n[impact]\n", "fragility.stop_at_largest"},
      {needed + "stop_at_largest = true\n[base_shear]\n[model]\naxes = 2\n",
       "fragility.stop_at_largest"},
      {study_part + suite_part + intensity_part + fragility_part + "[friction]\nmu = -0.5\n",
       "friction.mu is outside"},
      {study_part + suite_part + intensity_part + fragility_part + "[friction]\n",
       "friction.mu is missing"},
      {study_part + suite_part + intensity_part + friction_part, "the study has no analysis"},
      {study_part + suite_part + intensity_part + friction_part +
           "[fragility]\nthresholds_m = [0.0, 0.3]\n",
       "is not above 0"},
      {study_part + suite_part + intensity_part + friction_part +
           "[fragility]\nthresholds_m = []\n",
       "is empty"},
      {rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 0.5, count = 4 }\n",
       "is not above from"},
      {rest +
           "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 2, count = 100000000 }\n",
       "out of range"},
      {rest + "[intensity]\nmeasure = \"pga_g\"\nlevels = { from = 1, to = 1.0000000000000004, "
              "count = 9 }\n",
       "more values than there are between"},
      {needed + "[building]\nperiod_s = { from = 0, to = 2, count = 5000 }\n"
                "[roof]\nslope_deg = { from = 0, to = 7, count = 5000 }\n",
       "fifty million"},
      {"[study]\nname = \"a\"\nseed = -1\n" + suite_part + intensity_part + friction_part +
           fragility_part,
       "study.seed = -1"},
      {"[study]\nname = \"\"\n" + suite_part + intensity_part + friction_part + fragility_part,
       "study.name is empty"},
      {study_part + "[suite]\nfile = \"none.toml\"\n" + intensity_part + friction_part +
           fragility_part,
       "there is no suite"},
      {study_part + "[suite]\nfiles = []\n" + intensity_part + friction_part + fragility_part,
       "suite.files is empty"},
      {study_part + "[suite]\nfile = \"suite.toml\"\nfiles = [\"suite.toml\"]\n" + intensity_part +
           friction_part + fragility_part,
       "suite.file and suite.files are both given"},
      {study_part + "[suite]\nfile = \"suite.toml\"\nrecords = []\n" + intensity_part +
           friction_part + fragility_part,
       "suite.records is empty"},
  };
  for (const Contradiction& c : cases) {
    try {
      read(c.text);
      ADD_FAILURE() << "accepted: " << c.message;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(c.message), HasSubstr("study.toml:")));
      // A key misspelt is reported twice: as unknown, and as missing under its right name.
      const std::size_t problems = c.message.find("min is missing") == std::string::npos ? 1 : 2;
      EXPECT_EQ(error.problems().size(), problems) << error.what();
    }
  }
}

}  // namespace
}  // namespace glissade
