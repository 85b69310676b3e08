// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/study/cases/case_set.hpp"
#include "glissade/study/run/reduce.hpp"
#include "study_texts.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::Not;

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
  EXPECT_THAT(study.suite_files, ElementsAre(folder_.path() / "suite.toml"));
  EXPECT_EQ(study.intensity.measure, IntensityMeasure::sds_g);
  EXPECT_THAT(study.intensity.levels, ElementsAre(0.5, 1.0, 1.5, 2.0));
  const Quantities& q = study.quantities;
  EXPECT_EQ(std::get<Uniform>(*q.at("building", "period_s").drawn).max, 2.0);
  EXPECT_TRUE(q.at("building", "damping").is_always(0.05));
  EXPECT_THAT(std::get<Discrete>(*q.at("roof", "slope_deg").drawn).weights,
              ElementsAre(1.0, 1.0, 1.0));
  const auto mu = std::get<TruncatedNormal>(*q.at("friction", "mu").drawn);
  EXPECT_EQ(mu.mean, 0.55);
  EXPECT_EQ(mu.std, 0.04);
  EXPECT_EQ(mu.min, 0.0);
  EXPECT_TRUE(std::isinf(mu.max));
  EXPECT_EQ(study.orientation.component, ComponentChoice::second);
  EXPECT_EQ(study.orientation.sign, SignChoice::negative);
  EXPECT_THAT(study.vertical, ElementsAre(VerticalChoice::required));
  EXPECT_TRUE(q.at("vertical", "period_s").is_always(0.1));
  EXPECT_TRUE(q.at("vertical", "damping").is_always(0.02));
  EXPECT_EQ(study.sampling.samples, 512u);
  EXPECT_EQ(study.sampling.bootstrap_replicates, 200);
  EXPECT_THAT(study.thresholds_m(), ElementsAre(0.15, 0.3));
  EXPECT_THAT(study.standards.compare, ElementsAre(Standard::seaoc_pv1_2012, Standard::asce7_16));
  EXPECT_EQ(study.standards.category, SeismicDesignCategory::e);
  EXPECT_EQ(study.standards.importance, 1.5);
}

TEST_F(StudyFile, the_model_is_read) {
  const StudyConfig study = read(friction_last + R"(across_mu = { mean = 0.45, std = 0.02 }
static_over_sliding = 1.1
fast_over_slow = 1.3
rate_s_per_m = 20
value = ["sampled", "design"]
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
[array]
support = ["no_array", "isolated"]
[orientation]
second_sign = "negative"
slope_axis = ["n_s", "e_w"]
[base_shear]
[tipping]
centre_of_mass_height_m = 0.3
base_width_m = 1.5
)");
  const Quantities& q = study.quantities;
  EXPECT_TRUE(study.two_axes());
  EXPECT_EQ(study.model.displacement, DisplacementMeasure::vector);
  EXPECT_TRUE(q.at("building", "period_ratio").is_always(1.5));
  EXPECT_EQ(std::get<Uniform>(*q.at("building", "mass_ratio").drawn).max, 0.1);
  EXPECT_TRUE(q.at("building", "response_modification").is_always(3.0));
  EXPECT_TRUE(q.at("building", "yield_coefficient").is_always(0.0));
  EXPECT_TRUE(q.at("building", "hardening_ratio").is_always(0.02));
  EXPECT_TRUE(q.at("roof", "azimuth_deg").is_always(30.0));
  EXPECT_TRUE(study.friction.across_is_given);
  EXPECT_EQ(std::get<TruncatedNormal>(*q.at("friction", "across_mu").drawn).mean, 0.45);
  EXPECT_TRUE(q.at("friction", "static_over_sliding").is_always(1.1));
  EXPECT_TRUE(q.at("friction", "fast_over_slow").is_always(1.3));
  EXPECT_TRUE(q.at("friction", "rate_s_per_m").is_always(20.0));
  EXPECT_THAT(study.friction.values, ElementsAre(FrictionValue::as_drawn, FrictionValue::design));
  EXPECT_EQ(study.orientation.second_sign, SignChoice::negative);
  EXPECT_THAT(study.orientation.slope_axis, ElementsAre(SlopeAxis::n_s, SlopeAxis::e_w));
  // The array that slides is the first.
  EXPECT_THAT(study.support, ElementsAre(ArraySupport::isolated, ArraySupport::no_array));
  EXPECT_TRUE(study.base_shear);
  ASSERT_TRUE(study.tipping);
  EXPECT_EQ(study.tipping->centre_of_mass_height_m, 0.3);
  EXPECT_EQ(study.tipping->width_m, 1.5);
}

TEST_F(StudyFile, a_building_of_modes_is_read_with_its_first_period) {
  const StudyConfig wall = read(needed + "[building]\nperiod_s = [0.5, 1]\nalpha = [2, 10]\n");
  EXPECT_EQ(wall.building.kind, BuildingModel::Kind::cantilever);
  EXPECT_THAT(wall.quantities.at("building", "alpha").values, ElementsAre(2.0, 10.0));

  const StudyConfig storeys =
      read(needed + "[building]\nperiod_s = 0.6\nstoreys = 3\nstorey_masses = [2, 2, 1]\n");
  const Modes three = modes_along(storeys.building, 0, {0.6, 0.04}, 0.0);
  EXPECT_DOUBLE_EQ(three.period_s(), 0.6);
  EXPECT_DOUBLE_EQ(three[1].damping_ratio, 0.04);
  // Masses 2, 2, 1 of equal stiffness: omega^2 = 2 sin^2, a uniform shear beam in six parts.
  EXPECT_NEAR(three[1].period_s / 0.6, std::sin(15 * rad_per_deg) / std::sin(45 * rad_per_deg),
              1e-14);

  const StudyConfig own = read(needed + R"([building]
modes = [
  { period_s = 0.8, participation = 1.3, mass_share = 0.8, damping = 0.04 },
  { period_s = 0.2, participation = -0.4, mass_share = 0.1, damping = 0.02 },
]
modes_across = [{ period_s = 0.4, participation = 1.2, mass_share = 0.9, damping = 0.03 }]
)");
  EXPECT_THAT(own.quantities.at("building", "period_s").values, ElementsAre(0.8));
  EXPECT_THAT(own.quantities.at("building", "period_ratio").values, ElementsAre(0.5));
  const Modes along = modes_along(own.building, 0, {1.6, 0.05}, 0.0);  // twice as slow
  EXPECT_DOUBLE_EQ(along[1].period_s, 0.4);
  EXPECT_DOUBLE_EQ(along[1].damping_ratio, 0.02);
  EXPECT_DOUBLE_EQ(modes_along(own.building, 1, {0.4, 0.05}, 0.0)[0].participation, 1.2);
}

TEST_F(StudyFile, one_storey_is_one_mass_by_intention) {
  const StudyConfig one =
      read(needed + "[building]\nperiod_s = 0.6\nstoreys = 1\nyield_coefficient = 0.2\n");
  EXPECT_TRUE(one.building.is_one_mass());
  EXPECT_TRUE(one.building.is_one_storey);
  EXPECT_FALSE(read(needed).building.is_one_storey);
}

/// The keys of a study that it does not state.
std::vector<std::string> not_stated(const StudyConfig& study) {
  std::vector<std::string> texts;
  for (const auto& key : study.not_stated) texts.push_back(key.text);
  return texts;
}

TEST_F(StudyFile, keys_that_are_left_out_and_have_an_effect_are_named_with_what_holds) {
  const auto has = [](const char* text) { return testing::Contains(testing::StartsWith(text)); };
  const std::vector<std::string> of_rigid = not_stated(read(needed));
  for (const char* text : {"building.period_s: 0", "friction.across_mu: friction.mu"})
    EXPECT_THAT(of_rigid, has(text));
  for (const char* text : {"friction.mu", "building.hardening_ratio", "building.damping",
                           "vertical.damping", "building.alpha", "standards", "study"})
    EXPECT_THAT(of_rigid, testing::Not(has(text)));
  EXPECT_THAT(not_stated(read(needed + "[model]\naxes = 1\n[building]\nperiod_s = 1\n")),
              testing::Not(has("building.period_ratio")));
}

// Issue 48: "building.period_s: 0, with a warning" beside modes.
TEST_F(StudyFile, keys_of_another_building_are_not_named_as_left_out) {
  const std::vector<std::string> all = {"building.period_s",
                                        "building.alpha: one mass",
                                        "building.damping: 0.05",
                                        "building.period_ratio: 1",
                                        "building.mass_ratio: 0",
                                        "building.yield_coefficient: 0",
                                        "building.response_modification: 0"};
  const std::string mode = "[{ period_s = 1, participation = 1, mass_share = 1",
                    damped = mode + ", damping = 0.02 }]\n";
  struct Building {
    std::string keys;
    std::vector<std::size_t> named;
  };
  for (const auto& [keys, named] : std::vector<Building>{
           {"", {0}},
           {"period_s = 1\n", {1, 2, 3, 4, 5, 6}},
           {"period_s = 1\nstoreys = 1\n", {2, 3, 4, 5, 6}},
           {"period_s = 1\nyield_coefficient = 0.2\n", {1, 2, 3, 4}},
           {"period_s = 1\nalpha = 2\n", {2, 3, 4}},
           {"period_s = 1\nstoreys = 3\ndamping = 0.05\n", {3, 4}},
           {"modes = " + mode + " }]\n", {2, 3, 4}},
           {"modes = " + damped, {3, 4}},
           {"modes = " + damped + "modes_across = " + damped + "period_ratio = 1\n", {4}},
           {"modes = " + damped +
                "modes_across = [{ period_s = 0.5, participation = 1, "
                "mass_share = 1, damping = 0.02 }]\n",
            {4}}}) {
    const std::vector<std::string> texts = not_stated(read(needed + "[building]\n" + keys));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto is_named = testing::Contains(testing::StartsWith(all[i]));
      if (std::ranges::find(named, i) != named.end())
        EXPECT_THAT(texts, is_named) << keys;
      else
        EXPECT_THAT(texts, testing::Not(is_named)) << keys;
    }
  }
  EXPECT_THAT(not_stated(read(needed + "[roof]\nrise_in_12 = 0\n")),
              testing::Not(testing::Contains(testing::StartsWith("roof.slope_deg"))));
}

TEST_F(StudyFile, what_is_left_out_takes_the_defaults_of_the_configuration) {
  const StudyConfig study = read(needed), defaults;
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    if (i != parameter_index("friction", "mu")) {
      EXPECT_EQ(study.quantities[i].values, defaults.quantities[i].values);
    }
  }
  EXPECT_EQ(study.sampling.samples, defaults.sampling.samples);
  EXPECT_EQ(study.model.axes, SlidingAxes::two);
  EXPECT_EQ(study.vertical, defaults.vertical);
  EXPECT_EQ(study.support, defaults.support);
  EXPECT_EQ(study.orientation.choice, OrientationChoice::random);
  EXPECT_THAT(study.friction.values, ElementsAre(FrictionValue::as_drawn, FrictionValue::design));
  EXPECT_FALSE(study.intensity.target || study.chart || study.clearance || study.tipping);
  EXPECT_FALSE(study.impact || study.base_shear);
  EXPECT_TRUE(study.standards.compare.empty());
}

// Issue 34: floor motions were turned at random where nothing was stated.
TEST_F(StudyFile, motions_used_as_given_are_not_turned_unless_the_study_says_so) {
  std::string text = needed;
  const std::size_t at = text.find("measure = \""), end = text.find('\n', at);
  text.replace(at, end - at, "measure = \"factor\"");
  EXPECT_EQ(read(text).orientation.choice, OrientationChoice::as_recorded);
  EXPECT_EQ(read(text + "[orientation]\nchoice = \"random\"\n").orientation.choice,
            OrientationChoice::random);
}

TEST_F(StudyFile, every_parameter_takes_a_number_a_list_a_range_and_distributions) {
  for (std::size_t i = 0; i < parameters().size(); ++i) {
    const Parameter& p = parameters()[i];
    const std::string key = p.key;
    const bool reaches_two = p.range.max >= 2.0;
    // Both ends are in the range of every parameter.
    const std::string from = reaches_two ? "1" : "0.25", to = reaches_two ? "2" : "0.75";
    const auto quantity = [&](const std::string& value) {
      std::string table = one_key(p, value);
      if (key == "fast_over_slow") table += "rate_s_per_m = 10\n";
      if (key == "rate_s_per_m") table += "fast_over_slow = 1.2\n";
      if (key == "hardening_ratio") table += "yield_coefficient = 0.2\n";
      if (key == "alpha") table += "period_s = 1\n";
      if (key.starts_with("neighbour"))
        table += "[standards]\ncompare = [\"asce7_16\"]\n[verdict]\n";
      return read(without_friction + "[model]\naxes = 2\n" + table).quantities[i];
    };
    SCOPED_TRACE(key);
    const double first = std::stod(from), last = std::stod(to);
    EXPECT_THAT(quantity(to).values, ElementsAre(last));
    EXPECT_THAT(quantity("[" + from + ", " + to + "]").values, ElementsAre(first, last));
    EXPECT_THAT(quantity("{ from = " + from + ", to = " + to + ", count = 3 }").values,
                ElementsAre(first, (first + last) / 2, last));
    const std::string ends = "min = " + from + ", max = " + to + " }";
    EXPECT_EQ(std::get<Uniform>(*quantity("{ distribution = \"uniform\", " + ends).drawn).max,
              last);
    EXPECT_EQ(std::get<TruncatedNormal>(*quantity("{ distribution = \"truncated_normal\", mean = " +
                                                  from + ", std = 0.1, " + ends)
                                             .drawn)
                  .min,
              first);
    EXPECT_THAT(
        std::get<Discrete>(
            *quantity("{ distribution = \"discrete\", values = [" + from + ", " + to + "] }").drawn)
            .values,
        ElementsAre(first, last));
    if (key == "response_modification") continue;  // none between 0 and 1
    const auto normal =
        std::get<TruncatedNormal>(*quantity("{ mean = " + to + ", std = 0.01 }").drawn);
    EXPECT_EQ(normal.mean, last);
    EXPECT_EQ(normal.std, 0.01);
    EXPECT_EQ(normal.min, p.range.min);
    EXPECT_THAT(quantity("{ mean = " + to + ", std = 0 }").values, ElementsAre(last));
  }
}

TEST_F(StudyFile, a_value_out_of_a_parameters_range_is_refused_with_the_range) {
  for (const Parameter& p : parameters()) {
    const auto refuses_value = [&](const std::string& value) {
      const std::string text = without_friction + "[model]\naxes = 2\n" + one_key(p, value);
      EXPECT_THAT(problems_of([&] { read(text); }),
                  testing::Contains(testing::ResultOf(
                      [](const Problem& problem) { return to_string(problem); },
                      test::states(std::string(p.table) + "." + p.key, p.range.text))))
          << value;
    };
    for (const double end : {p.range.min, p.range.max}) {
      if (std::isinf(end)) continue;
      EXPECT_THAT(p.range.text, test::states(shortest_decimal(end))) << p.key;
      const double step = std::abs(end) / 1000 + 1e-6;
      const std::string beyond = shortest_decimal(end == p.range.min ? end - step : end + step);
      const std::string inside = shortest_decimal(end);
      refuses_value(beyond);
      refuses_value("{ mean = " + beyond + ", std = 0.1 }");
      refuses_value("{ distribution = \"discrete\", values = [" + beyond + "] }");
      refuses_value(end == p.range.min ? "[" + beyond + ", " + inside + "]"
                                       : "[" + inside + ", " + beyond + "]");
    }
  }
}

TEST_F(StudyFile, a_slope_may_be_given_as_a_rise_in_12) {
  const auto slope = [&](const std::string& value) {
    return read(needed + "[roof]\nrise_in_12 = " + value + "\n").quantities.at("roof", "slope_deg");
  };
  EXPECT_THAT(slope("0.25").values, ElementsAre(DoubleEq(1.193489423982035)));  // atan(1/48)
  EXPECT_THAT(slope("[0, 12]").values, ElementsAre(0.0, DoubleEq(45.0)));
  EXPECT_THAT(
      std::get<Discrete>(*slope("{ distribution = \"discrete\", values = [-12, 12] }").drawn)
          .values,
      ElementsAre(DoubleEq(-45.0), DoubleEq(45.0)));
  const std::string uniform = "{ distribution = \"uniform\", min = 0, max = 12 }";
  EXPECT_TRUE(slope(uniform).drawn_as_rise_in_12);
  // The rise is uniform, not the angle: its median is 6 in 12.
  const PlannedCases cases(
      read(needed + "[roof]\nrise_in_12 = " + uniform + "\n[sampling]\nsamples = 1024\n"));
  const auto below = std::ranges::count_if(
      cases.all(), [](const Case& c) { return std::tan(c.slope_deg * rad_per_deg) < 0.5; });
  EXPECT_EQ(static_cast<std::size_t>(below) * 2, cases.size());
}

TEST_F(StudyFile, several_suites_and_some_records_can_be_named) {
  folder_.write("other.toml", "");
  const StudyConfig study = read(study_part +
                                 "[suite]\nfiles = [\"suite.toml\", \"other.toml\"]\nrecords = "
                                 "[\"b\"]\nnormalise = \"pgv\"\n" +
                                 intensity_part + friction_part + fragility_part);
  EXPECT_THAT(study.suite_files,
              ElementsAre(folder_.path() / "suite.toml", folder_.path() / "other.toml"));
  EXPECT_THAT(study.records, ElementsAre("b"));
  EXPECT_TRUE(study.normalise_by_pgv);
  EXPECT_FALSE(read(needed).normalise_by_pgv);
}

TEST_F(StudyFile, every_distribution_is_read) {
  const auto slope = [&](const std::string& value) {
    const Quantity quantity =
        read(needed + "[roof]\nslope_deg = " + value + "\n").quantities.at("roof", "slope_deg");
    EXPECT_TRUE(quantity.is_drawn());
    return *quantity.drawn;
  };
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
  EXPECT_EQ(std::get<LogNormal>(*study.quantities.at("building", "period_s").drawn).median, 0.5);
}

TEST_F(StudyFile, ranges_give_numbers_as_people_write_them) {
  const auto levels = [&](const std::string& range) {
    return read(study_part + suite_part + friction_part + fragility_part +
                "[intensity]\nmeasure = \"pga_g\"\nlevels = " + range + "\n")
        .intensity.levels;
  };
  EXPECT_THAT(levels("{ from = 0.1, to = 0.4, count = 4 }"), ElementsAre(0.1, 0.2, 0.3, 0.4));
  // Where twelve digits do not distinguish them they are kept as they are.
  const std::vector<double> near = levels("{ from = 1, to = 1.0000000000001, count = 3 }");
  EXPECT_LT(near[0], near[1]);
  EXPECT_LT(near[1], near[2]);
  EXPECT_THAT(levels("{ from = 1, to = 100, count = 3, spacing = \"log\" }"),
              ElementsAre(1, 10, 100));
}

TEST_F(StudyFile, measures_bring_their_periods_and_targets) {
  const std::string rest = study_part + suite_part + friction_part + fragility_part;
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

TEST_F(StudyFile, measures_have_the_names_that_they_are_printed_with) {
  const std::string rest = study_part + suite_part + friction_part + fragility_part;
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i) {
    const IntensityMeasure measure = IntensityMeasure::number(i);
    const std::string own = measure.own_key() != nullptr ? measure.own_key() : "";
    std::string text =
        "[intensity]\nlevels = [1]\nmeasure = \"" + std::string(measure.key()) + "\"\n";
    if (own == "sa_period_s") text += "sa_period_s = 1\n";
    if (own == "avg_sa_periods_s") text += "avg_sa_periods_s = [1, 2]\n";
    EXPECT_EQ(read(rest + text).intensity.measure, measure);
  }
}

TEST_F(StudyFile, a_tail_of_one_in_a_million_may_lie_outside_the_range) {
  const StudyConfig lognormal = read(
      needed +
      "[building]\ndamping = { distribution = \"lognormal\", median = 0.05, log_std = 0.4 }\n");
  EXPECT_TRUE(
      std::holds_alternative<LogNormal>(*lognormal.quantities.at("building", "damping").drawn));
  const StudyConfig normal = read(
      needed + "[building]\ndamping = { distribution = \"normal\", mean = 0.05, std = 0.01 }\n");
  EXPECT_TRUE(std::holds_alternative<Normal>(*normal.quantities.at("building", "damping").drawn));
}

TEST_F(StudyFile, of_finished_results_names_files_as_they_were_but_for_a_hazard_curve) {
  folder_.write("tests.csv", "mu\n0.50\n0.54\n0.58\n");
  folder_.write("curve.csv", "sds_g,annual_rate\n0.1,0.05\n1.5,0.0004\n");
  const std::string study = without_friction +
                            "[friction]\nfile = \"tests.csv\"\n[hazard]\ncurve = "
                            "\"curve.csv\"\ndesign_life_years = 25\n";
  Results run;
  put_study(read(study), run);
  EXPECT_EQ(run.study_data_files.size(), 2u);
  const auto file = folder_.path() / "study.toml";
  EXPECT_EQ(message_of([&] { read_study_again(file, run); }), "");
  folder_.write("curve.csv", "sds_g,annual_rate\n0.1,0.06\n1.5,0.0005\n");
  EXPECT_EQ(message_of([&] { read_study_again(file, run); }), "");
  folder_.write("tests.csv", "mu\n0.50\n0.54\n0.60\n");
  EXPECT_THAT(message_of([&] { read_study_again(file, run); }),
              test::states("tests.csv", "not as it was"));
}

}  // namespace
}  // namespace glissade
