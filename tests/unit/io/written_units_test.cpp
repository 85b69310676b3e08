// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities that are written with their unit.
#include "toml/written_units.hpp"

#include <gmock/gmock.h>

#include "study_texts.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::Optional;

TEST(written_units, are_converted_to_the_unit_of_the_key) {
  struct Written {
    const char *key, *text;
    double value;
  };
  // By definition: inch and foot (0.0254 and 0.3048 m), mile (1609.344 m), g (9.80665 m/s2).
  for (const Written& w : {Written{"fragility.thresholds_m", "18 in", 0.4572},
                           {"x_m", "1.5 ft", 0.4572},
                           {"x_m", "0.46 m", 0.46},
                           {"x_m", "460mm", 0.46},
                           {"x_m", "1/2 in", 0.0127},
                           {"roof.azimuth_deg", "4 deg", 4.0},
                           {"building.period_s", "300 ms", 0.3},
                           {"target.sds_g", "9.80665 m/s2", 1.0},
                           {"pgv_mps", "20 in/s", 0.508},
                           {"friction.rate_s_per_m", "0.381 s/in", 15.0},
                           {"array_weight_kn", "60 kip", 266.893296916},  // 60,000 x 0.45359237 g
                           {"distance_km", "10 mi", 16.09344},
                           {"rise_in_12", "0.25:12", 0.25},
                           {"rise_in_12", "1:48", 0.25},
                           {"rise_in_12", "1/4 in/ft", 0.25},
                           {"rise_in_12", "0 deg", 0.0},
                           {"x_m", "30'", 9.144},
                           {"x_m", "18\"", 0.4572},
                           {"design_life_years", "50 years", 50.0}}) {
    const KeyUnits* units = units_of_key(w.key);
    ASSERT_NE(units, nullptr) << w.key;
    EXPECT_THAT(units->value_of(w.text), Optional(w.value)) << w.text;
  }
  EXPECT_THAT(units_of_key("slope_deg")->value_of("2 %"),
              Optional(testing::DoubleNear(1.14576, 1e-5)));  // atan 0.02
  EXPECT_THAT(units_of_key("rise_in_12")->value_of("4 deg"),
              Optional(testing::DoubleNear(0.839122, 1e-6)));  // 12 tan 4 deg
}

TEST(written_units, of_another_dimension_or_none_are_refused) {
  for (const char* text : {"18", "18 kip", "in", "", "1 1/2 in", "0.25:12", "18 s", "1/0 in", "IN",
                           "nan m", "18 in in", "--1 m"})
    EXPECT_FALSE(units_of_key("x_m")->value_of(text)) << text;
  for (const char* text : {"0.25:0", "0.25:", ":12", "1 m"})
    EXPECT_FALSE(units_of_key("slope_deg")->value_of(text)) << text;
}

TEST(written_units, are_those_of_the_parameters) {
  for (const Parameter& p : parameters()) {
    const KeyUnits* units = units_of_key(p.key);
    ASSERT_EQ(units == nullptr, p.unit == std::string("-")) << p.key;
    if (units != nullptr) {
      EXPECT_EQ(units->units.front().name, std::string(p.unit)) << p.key;
    }
  }
  EXPECT_EQ(units_of_key("building.period_s.log_std"), nullptr);
  EXPECT_NE(units_of_key("building.period_s.median"), nullptr);
}

class WrittenUnits : public StudyFile {};

TEST_F(WrittenUnits, stand_wherever_a_number_does) {
  const StudyConfig study = read(study_part + suite_part + friction_part +
                                 "[intensity]\nmeasure = \"pgv_mps\"\nlevels = [\"20 in/s\", 1]\n"
                                 "[building]\nperiod_s = { distribution = \"uniform\", min = "
                                 "\"200 ms\", max = 2 }\n"
                                 "[roof]\nslope_deg = [\"1/4:12\", 2.0, \"4 deg\"]\n"
                                 "[fragility]\nthresholds_m = { from = \"6 in\", to = '3 ft', "
                                 "count = 2 }\n");
  EXPECT_THAT(study.intensity.levels, ElementsAre(0.508, 1.0));
  EXPECT_EQ(std::get<Uniform>(*study.quantities.at("building", "period_s").drawn).min, 0.2);
  EXPECT_THAT(study.thresholds_m(), ElementsAre(0.1524, 0.9144));
  const StudyConfig rise = read(friction_last + "[roof]\nrise_in_12 = 0.25\n");
  const std::vector<double> slopes = study.quantities.at("roof", "slope_deg").values;
  ASSERT_EQ(slopes.size(), 3u);
  EXPECT_EQ(slopes[0], rise.quantities.at("roof", "slope_deg").values[0]);  // to the last bit
}

TEST_F(WrittenUnits, leave_the_hash_of_a_study_as_with_numbers) {
  const std::string with = without_fragility +
                           "[fragility]  # \xC2\xB5\nthresholds_m = [\"6 in\", '18 in', "
                           "\"\"\"0.5 m\"\"\"]  # \"6 in\"\n";
  const std::string without =
      without_fragility +
      "[fragility]  # \xC2\xB5\nthresholds_m = [0.1524, 0.4572, 0.5]  # \"6 in\"\n";
  EXPECT_EQ(read(with).hashed_text, without);
  EXPECT_EQ(read(with).source_text, with);
  EXPECT_EQ(read(without).hashed_text, without);
  EXPECT_EQ(read(with).thresholds_m(), read(without).thresholds_m());
}

TEST_F(WrittenUnits, the_hash_of_a_study_is_without_the_folders_of_its_files) {
  folder_.write("sub/suite.toml", "");
  std::string moved = needed;
  moved.replace(moved.find("\"suite.toml\""), 12, "\"sub/../sub/suite.toml\"");
  EXPECT_EQ(read(moved).hashed_text, needed);
  EXPECT_EQ(read(moved).source_text, moved);
}

TEST_F(WrittenUnits, that_do_not_fit_are_refused_with_those_that_do) {
  refuses({{without_fragility + "[fragility]\nthresholds_m = [0.1, \"18 kip\"]\n",
            "study.toml:12",
            {"fragility.thresholds_m = '18 kip'", "m, cm, mm, in, ft"}},
           {needed + "[roof]\nslope_deg = \"4 in\"\n", "study.toml:14", {"deg, rad, 0.25:12"}},
           {needed + "[roof]\nslope_deg = \"100 rad\"\n", "study.toml:14", {"roof.slope_deg"}},
           {study_part + suite_part + fragility_part + friction_part +
                "[intensity]\nmeasure = \"mce_fraction\"\nlevels = [\"1 g\"]\n",
            "study.toml:12",
            {"intensity.levels"}}});
}

}  // namespace
}  // namespace glissade
