// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/suite_file.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "glissade/core/units.hpp"
#include "glissade/io/recipe_writer.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using test::states;
using testing::DoubleEq;
using testing::ElementsAre;

const std::string head = "[suite]\nname = \"s\"\ndescription = \"d\"\n";

class SuiteFile : public testing::Test {
 protected:
  ~SuiteFile() override { ::unsetenv("GLISSADE_RECORDS"); }
  static void look_in(const std::filesystem::path& folder) {
    ::setenv("GLISSADE_RECORDS", folder.c_str(), 1);
  }
  Suite load(const std::string& content) const {
    return load_suite(folder_.write("suites/suite.toml", content));
  }
  void refuses(const std::vector<Refusal>& refusals) const {
    expect_refusals([&](const std::string& content) { load(content); }, refusals);
  }
  TemporaryFolder folder_;
};

TEST_F(SuiteFile, components_are_read_scaled_to_si_and_put_on_a_common_clock) {
  folder_.write("suites/a.txt", "# acceleration_g\n1\n2\n");
  folder_.write("suites/b.txt", "0 100\n0.01 200\n");
  const Suite suite = load(head + R"([target]
edition = "asce7_10"
ss_g = 1.95
s1_g = 0.8
site_classes = ["A", "D"]
[[record]]
id = "one"
event = "e"
station = "st"
magnitude = 6.5
distance_km = 10
vs30_mps = 300
scale = 2.5
first = { file = "a.txt", dt_s = 0.01, start_s = 0.02 }
second = { file = "b.txt", units = "cm/s2" }
)");
  EXPECT_EQ(suite.name, "s");
  ASSERT_TRUE(suite.target);
  EXPECT_THAT(suite.target->site_classes, ElementsAre(SiteClass::a, SiteClass::d));
  ASSERT_EQ(suite.motions.size(), 1u);
  const Motion& motion = suite.motions[0];
  EXPECT_EQ(motion.id, "one");
  EXPECT_EQ(motion.magnitude, 6.5);
  EXPECT_EQ(motion.scale, 2.5);
  EXPECT_EQ(motion.dt_s, 0.01);
  constexpr double g = standard_gravity_mps2;
  EXPECT_THAT(motion.horizontal_mps2[0], ElementsAre(0.0, 0.0, DoubleEq(g), DoubleEq(2 * g)));
  EXPECT_THAT(motion.horizontal_mps2[1], ElementsAre(DoubleEq(1.0), DoubleEq(2.0), 0.0, 0.0));
  EXPECT_TRUE(motion.vertical_mps2.empty());
}

TEST_F(SuiteFile, motions_are_of_the_ground_or_of_a_roof_which_has_no_target) {
  folder_.write("suites/a.txt", "# acceleration_g\n1\n2\n");
  const std::string record =
      "[[record]]\nid = \"one\"\nfirst = { file = \"a.txt\", dt_s = 0.01 }\n";
  EXPECT_FALSE(load(head + record).of_roof);
  EXPECT_FALSE(load(head + "motions = \"ground\"\n" + record).of_roof);
  EXPECT_TRUE(load(head + "motions = \"roof\"\n" + record).of_roof);
  const std::string target =
      "[target]\nedition = \"asce7_16\"\nss_g = 1.5\ns1_g = 0.6\nsite_class = \"D\"\n";
  refuses({{head + "motions = \"roof\"\n" + record + target, "suite.toml:8", {"[target]"}},
           {head + "motions = \"floor\"\n" + record, "suite.toml:4", {"ground", "roof"}}});
}

TEST_F(SuiteFile, components_of_one_file_are_named_behind_it) {
  folder_.write("suites/floor.csv", "time_s,ax_g,ay_g,az_g\n0,.1,.2,.3\n0.01,.4,.5,.6\n");
  const std::string record = "[[record]]\nid = \"a\"\nfirst = \"floor.csv#ax\"\n";
  const Suite suite =
      load(head + record + "second = \"floor.csv#2\"\nvertical = { file = \"floor.csv#az\" }\n");
  constexpr double g = standard_gravity_mps2;
  const Motion& motion = suite.motions.at(0);
  EXPECT_THAT(motion.horizontal_mps2[0], ElementsAre(DoubleEq(.1 * g), DoubleEq(.4 * g)));
  EXPECT_THAT(motion.horizontal_mps2[1], ElementsAre(DoubleEq(.2 * g), DoubleEq(.5 * g)));
  EXPECT_THAT(motion.vertical_mps2, ElementsAre(DoubleEq(.3 * g), DoubleEq(.6 * g)));
  EXPECT_EQ(record_files(folder_.path() / "suites/suite.toml").at(2).path,
            folder_.path() / "suites/floor.csv");
  refuses({{head + "[[record]]\nid = \"a\"\nfirst = \"floor.csv\"\n",
            "suite.toml:6",
            {"#1 (ax)", "#2 (ay)", "#3 (az)"}},
           {head + record + "second = \"floor.csv#u\"\n", "suite.toml:7", {"'u'", "#1 (ax)"}},
           {head + record + "second = \"none.csv#u\"\n", "suite.toml", {"1 record file"}}});
}

TEST_F(SuiteFile, units_of_a_suite_are_those_of_files_that_state_none) {
  const std::string record = "[[record]]\nid = \"a\"\nfirst = \"a.txt\"\n";
  folder_.write("suites/a.txt", "0 100\n0.01 200\n");
  refuses({{head + record, "suite.toml:6", {"a.txt", "units"}},
           {head + "units = \"g\"\n" + record, "suite.toml:7", {"200 g"}}});
  EXPECT_DOUBLE_EQ(load(head + "units = \"cm/s2\"\n" + record).motions[0].horizontal_mps2[0][0],
                   1.0);
  folder_.write("suites/a.txt", "# units: m/s2\n0 10\n0.01 20\n");
  EXPECT_DOUBLE_EQ(load(head + "units = \"cm/s2\"\n" + record).motions[0].horizontal_mps2[0][0],
                   10.0);
}

TEST_F(SuiteFile, components_whose_headers_contradict_each_other_are_named) {
  const auto at2 = [](const std::string& source) {
    return "PEER NGA STRONG MOTION DATABASE RECORD\n" + source +
           "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2, DT= .0100 SEC,\n0.1 0.2\n";
  };
  folder_.write("suites/a.at2", at2("Kobe, 1/16/1995, Nishi-Akashi, 0"));
  folder_.write("suites/b.at2", at2("Kobe, 1/16/1995, Shin-Osaka, 60"));
  folder_.write("suites/c.at2", at2("Kobe, 1/16/1995, Nishi-Akashi, 270"));
  folder_.write("suites/up.at2", at2("Kobe, 1/16/1995, Nishi-Akashi, UP"));
  const auto found = [&](const std::string& second, const std::string& vertical) {
    return load(head + "[[record]]\nid = \"a\"\nfirst = \"a.at2\"\nsecond = \"" + second +
                "\"\nvertical = \"" + vertical + "\"\n")
        .motions[0]
        .contradictions;
  };
  EXPECT_THAT(found("c.at2", "up.at2"), testing::IsEmpty());
  EXPECT_THAT(found("b.at2", "up.at2"),
              ElementsAre(states("Nishi-Akashi", "Shin-Osaka"), states("0", "60")));
  const auto text = [&](const std::string& first, const std::string& vertical) {
    return head + "[[record]]\nid = \"a\"\nfirst = " + first + "\n" + vertical;
  };
  refuses({{text("\"up.at2\"", ""), "suite.toml:4", {"up.at2", "'UP'", "vertical", "azimuth_deg"}},
           {text("\"a.at2\"", "vertical = \"c.at2\"\n"), "suite.toml:4", {"c.at2", "'270'"}}});
  EXPECT_THAT(load(text("{ file = \"up.at2\", azimuth_deg = 40 }", "")).motions[0].contradictions,
              ElementsAre(states("azimuth_deg = 40", "states that it is vertical")));
}

TEST_F(SuiteFile, a_file_that_many_entries_name_is_read_once_and_its_samples_are_shared) {
  folder_.write("suites/a.txt", "# acceleration_g\n0 1\n0.01 2\n");
  folder_.write("suites/b.txt", "# acceleration_g\n0 1\n0.01 2\n0.02 1\n");
  const auto record = [](const std::string& id, const std::string& files) {
    return "[[record]]\nid = \"" + id + "\"\nfirst = " + files;
  };
  const Suite suite = load(head + record("1", "\"a.txt\"\n") +
                           record("2", "\"./a.txt\"\nsecond = \"b.txt\"\nvertical = \"b.txt\"\n") +
                           record("3", "{ file = \"a.txt\", dt_s = 0.01 }\nsecond = \"a.txt\"\n"));
  const auto samples = [&](std::size_t motion, std::size_t component) {
    return suite.motions[motion].horizontal_mps2[component].data();
  };
  EXPECT_EQ(samples(2, 1), samples(0, 0));
  EXPECT_NE(samples(2, 0), samples(0, 0));  // read with another option
  EXPECT_NE(samples(1, 0), samples(0, 0));  // longer by a zero
  EXPECT_EQ(suite.motions[1].vertical_mps2.data(), samples(1, 1));
  folder_.write("suites/a.txt", "# acceleration_g\n0 1\n0.01 x\n");
  EXPECT_THAT(
      problems_of([&] {
        load(head + record("1", "\"a.txt\"\nsecond = \"a.txt\"\n") + record("2", "\"a.txt\"\n"));
      }),
      one_problem("suite.toml:6", "a.txt:3"));
}

// 51 times twice a million samples.
TEST_F(SuiteFile, more_samples_than_a_suite_may_have_are_refused_once) {
  std::string text = "# acceleration_g\n# DT = 0.01\n", suite = head;
  for (int i = 0; i < 500'000; ++i) text += ".1\n-.1\n";
  folder_.write("suites/long.txt", text);
  for (int i = 0; i < 60; ++i)
    suite += "[[record]]\nid = \"r" + std::to_string(i) +
             "\"\nfirst = \"long.txt\"\nsecond = \"long.txt\"\n";
  EXPECT_THAT(problems_of([&] { load(suite); }),
              one_problem("suite.toml", "100 million samples", "r50"));
}

// The tools themselves: motion_processing_test.cpp.
TEST_F(SuiteFile, processing_is_of_all_records_key_by_key_unless_one_states_its_own) {
  folder_.write("suites/a.txt", "# acceleration_g\n# DT = 0.01\n3\n4\n8\n");
  folder_.write("suites/b.txt", "# acceleration_g\n# DT = 0.01\n1\n1\n1\n");
  const auto record = [](const char* id, const char* more) {
    return std::string("[[record]]\nid = \"") + id +
           "\"\nfirst = { file = \"a.txt\", azimuth_deg = 0 }\n"
           "second = { file = \"b.txt\", azimuth_deg = 90 }\n" +
           more;
  };
  const Suite suite = load(head + "[processing]\nbaseline_degree = 0\n" + record("mean", "") +
                           record("line", "processing = { baseline_degree = 1 }\n") +
                           record("turned",
                                  "strike_deg = 0\n[record.processing]\nrotate_to = "
                                  "\"fault_normal\"\n"));
  const auto first_g = [&](std::size_t i) {
    std::vector<double> a = suite.motions[i].horizontal_mps2[0].copy();
    for (double& x : a) x /= standard_gravity_mps2;
    return a;
  };
  const auto near = [](double x) { return testing::DoubleNear(x, 1e-13); };
  EXPECT_THAT(first_g(0), ElementsAre(near(-2), near(-1), near(3)));
  EXPECT_THAT(first_g(1), ElementsAre(near(0.5), near(-1), near(0.5)));
  EXPECT_THAT(first_g(2), ElementsAre(near(0), near(0), near(0)));
  EXPECT_THAT(suite.motions[2].processing,
              ElementsAre(testing::HasSubstr("polynomial of degree 0"),
                          testing::HasSubstr("to 90 (fault-normal) and 180")));
}

TEST_F(SuiteFile, mistakes_in_processing_have_one_message_each) {
  folder_.write("suites/a.txt", "# acceleration_g\n# DT = 0.01\n3\n4\n8\n");
  const auto with = [](const std::string& keys) {
    return head + "[processing]\n" + keys +
           "\n[[record]]\nid = \"r\"\nfirst = { file = \"a.txt\", azimuth_deg = 10 }\n"
           "second = { file = \"a.txt\", azimuth_deg = 100 }\n";
  };
  refuses(
      {{with("baseline_degree = 9"), "suite.toml:5", {"baseline_degree", "0 to 5"}},
       {with("band_pass = {}"), "suite.toml:5", {"low_hz, high_hz, or both"}},
       {with("band_pass = { low_hz = 5, high_hz = 0.1 }"), "suite.toml:5", {"not in order"}},
       {with("band_pass = { low_hz = 0.1, order = 40 }"), "suite.toml:5", {"order", "1 to 8"}},
       {with("band_pass = { high_hz = 50 }"), "suite.toml:6", {"half of its sampling rate"}},
       {with("arias_percent = [95, 5]"), "suite.toml:5", {"two percentages", "[5, 95]"}},
       {with("rotate_to_deg = 700"), "suite.toml:5", {"from 0 to 360"}},
       {with("rotate_to = \"fault\""), "suite.toml:5", {"fault_normal", "fault_parallel"}},
       {with("rotate_to = \"fault_normal\""), "suite.toml:6", {"strike_deg"}},
       {with("rotate_to_deg = 0\nrotate_to = \"fault_normal\""), "suite.toml:6", {"both given"}},
       {with("step_s = 0.02"), "suite.toml:6", {"frequencies above 12.5 Hz", "high_hz"}},
       {with("detrend = 1"), "suite.toml:5", {"detrend"}},
       {with("") + "vertical = { file = \"a.txt\", azimuth_deg = 5 }\n",
        "suite.toml:10",
        {"the vertical"}}});
}

TEST_F(SuiteFile, records_are_found_below_the_folders_of_the_environment) {
  const std::string suite = head + "[[record]]\nid = \"a\"\nfirst = \"set/a.txt\"\n";
  folder_.write("r1/readme", "");
  folder_.write("r2/deep/er/a.txt", "# acceleration_g\n0 1\n0.1 2\n");
  look_in(folder_.path().string() + "/none:" + (folder_.path() / "r1").string() + ":" +
          (folder_.path() / "r2").string());
  EXPECT_EQ(load(suite).motions[0].dt_s, 0.1);  // by name, anywhere below
  folder_.write("r2/other/a.txt", "# acceleration_g\n0 1\n0.2 2\n");
  refuses({{suite, "suite.toml:6", {"deep/er/a.txt", "other/a.txt"}}});
  folder_.write("r2/more/set/a.txt", "# acceleration_g\n0 1\n0.3 2\n");
  EXPECT_EQ(load(suite).motions[0].dt_s, 0.3);  // by its own relative path, anywhere below
  folder_.write("r2/set/a.txt", "# acceleration_g\n0 1\n0.4 2\n");
  EXPECT_EQ(load(suite).motions[0].dt_s, 0.4);  // by relative path
  folder_.write("suites/set/a.txt", "# acceleration_g\n0 1\n0.5 2\n");
  EXPECT_EQ(load(suite).motions[0].dt_s, 0.5);  // beside the suite
}

TEST_F(SuiteFile, all_missing_files_are_reported_in_one_error_that_names_the_variable) {
  const std::string text = head +
                           "[[record]]\nid = \"a\"\nfirst = \"a.AT2\"\nsecond = \"b.AT2\"\n"
                           "[[record]]\nid = \"c\"\nfirst = \"c.AT2\"\n";
  refuses({{text, "suite.toml", {"3", "GLISSADE_RECORDS"}}});
  EXPECT_EQ(problems_of([&] { load(text); }).at(0).excerpt, "  a.AT2\n  b.AT2\n  c.AT2");
}

TEST_F(SuiteFile, a_magnitude_that_no_earthquake_has_is_refused) {
  folder_.write("suites/a.txt", "# acceleration_g\n0 1\n0.1 2\n");
  refuses({{head + "[[record]]\nid = \"a\"\nmagnitude = 69\nfirst = \"a.txt\"\n",
            "suite.toml:6",
            {"magnitude = 69", "up to 10"}}});
}

TEST_F(SuiteFile, mistakes_are_located) {
  folder_.write("suites/a.txt", "# acceleration_g\n0 1\n0.1 2\n");
  folder_.write("suites/bad.txt", "# acceleration_g\n0 1\n0.1 x\n");
  const std::string record = head + "[[record]]\nid = \"a\"\n";
  refuses(
      {{record + "first = \"a.txt\"\n[[record]]\nid = \"a\"\nfirst = \"a.txt\"\n",
        "suite.toml:8",
        {"\"a\""}},
       {record + "first = \"bad.txt\"\n", "suite.toml:6", {"bad.txt:3", "'x'"}},
       {record, "suite.toml:4", {"record.first"}},
       {record + "first = { file = \"a.txt\", units = \"ft/s2\" }\n", "suite.toml:6", {"ft/s2"}},
       {record + "first = { file = \"a.txt\", start_s = 0.05 }\nsecond = \"a.txt\"\n",
        "suite.toml:4",
        {"0.05"}},
       {head, "suite.toml:1", {"[[record]]"}}});
  EXPECT_THAT(faults_of([&] { load("[suite]\nname = 3\n"); }),
              ElementsAre("2 suite.name", "1 record"));
  EXPECT_THAT(problems_of([&] { load(record + "frist = \"a.txt\"\n"); }),
              testing::Contains(testing::Field(&Problem::suggestion, states("first"))));
}

const std::string recipe_text = head + R"([target]
edition = "asce7_10"
ss_g = 1.95
s1_g = 0.8
site_classes = ["A", "B", "C", "D"]
tl_s = 8
[simulation]
model = "rezaeian_der_kiureghian_2010"
seed = 7
dt_s = 0.01
max_scale = 4.0
[simulation.gain]
frequency_hz = [0.5, 5.0]
horizontal = [1.1, 0.9]
vertical = [0.7, 0.6]
[[motion]]
id = "m1"
magnitude = 6.7
distance_km = 12
vs30_mps = 400
mechanism = "reverse"
realization = 3
scale = 1.5
)";

TEST_F(SuiteFile, a_recipe_is_read_as_it_stands) {
  const SyntheticRecipe recipe = read_recipe(folder_.write("recipe.toml", recipe_text));
  EXPECT_EQ(recipe.name, "s");
  EXPECT_EQ(recipe.seed, 7u);
  EXPECT_EQ(recipe.dt_s, 0.01);
  EXPECT_EQ(recipe.max_scale, 4.0);
  EXPECT_EQ(recipe.target.site_classes.size(), 4u);
  EXPECT_THAT(recipe.gain_frequencies_hz, ElementsAre(0.5, 5.0));
  EXPECT_THAT(recipe.horizontal_gain, ElementsAre(1.1, 0.9));
  EXPECT_THAT(recipe.vertical_gain, ElementsAre(0.7, 0.6));
  ASSERT_EQ(recipe.motions.size(), 1u);
  EXPECT_EQ(recipe.motions[0].mechanism, FaultMechanism::reverse);
  EXPECT_EQ(recipe.motions[0].realization, 3u);
  EXPECT_EQ(recipe.motions[0].scale, 1.5);
}

TEST_F(SuiteFile, a_recipe_is_simulated_where_a_suite_is_asked_for) {
  const Suite suite = load(recipe_text);
  ASSERT_EQ(suite.motions.size(), 1u);
  EXPECT_EQ(suite.motions[0].id, "m1");
  EXPECT_EQ(suite.motions[0].dt_s, 0.01);
  EXPECT_FALSE(suite.motions[0].vertical_mps2.empty());
}

std::string with(const std::string& key, const std::string& value) {
  const std::size_t begin = recipe_text.find("\n" + key + " = ") + key.size() + 4;
  std::string text = recipe_text;
  return text.replace(begin, text.find('\n', begin) - begin, value);
}

TEST_F(SuiteFile, numbers_of_a_recipe_that_cannot_be_simulated_are_refused) {
  struct Refused {
    const char *key, *value, *where, *name_and_value, *from, *to;
  };
  for (const auto& [key, value, where, name_and_value, from, to] : {
           Refused{"magnitude", "1e6", "21", "motion.magnitude = 1e+06", "3", "8.5"},
           {"magnitude", "2.9", "21", "motion.magnitude = 2.9", "3", "8.5"},
           {"distance_km", "1e300", "22", "motion.distance_km = 1e+300", "0.1", "400"},
           {"distance_km", "0.09", "22", "motion.distance_km = 0.09", "0.1", "400"},
           {"vs30_mps", "99", "23", "motion.vs30_mps = 99", "100", "2000"},
           {"vs30_mps", "2001", "23", "motion.vs30_mps = 2001", "100", "2000"},
           {"dt_s", "1e-6", "13", "simulation.dt_s = 1e-06", "0.001", "0.05"},
           {"dt_s", "100", "13", "simulation.dt_s = 100", "0.001", "0.05"},
           {"max_scale", "1e300", "14", "simulation.max_scale = 1e+300", "0.001", "1000"},
           {"scale", "1e-300", "26", "motion.scale = 1e-300", "0.001", "1000"},
           {"frequency_hz", "[5e-324, 5.0]", "16", "simulation.gain.frequency_hz = 5e-324", "0.001",
            "1000"},
           {"horizontal", "[1.1, 1e300]", "17", "simulation.gain.horizontal = 1e+300", "0.001",
            "1000"},
           {"vertical", "[0.0, 1.0]", "18", "simulation.gain.vertical = 0", "0.001", "1000"},
       }) {
    const std::vector<std::string> facts = {name_and_value, from, to};
    EXPECT_THAT(problems_of([&] { load(with(key, value)); }),
                testing::Contains(is_problem(std::string("suite.toml:") + where, facts)))
        << key;
  }
}

TEST_F(SuiteFile, a_recipe_without_the_largest_scale_survives_being_written) {
  std::string text = recipe_text;
  text.erase(text.find("max_scale"), std::string("max_scale = 4.0\n").size());
  const SyntheticRecipe recipe = read_recipe(folder_.write("recipe.toml", text));
  const std::string written = recipe_toml(recipe, {"a test"});
  EXPECT_EQ(recipe_toml(read_recipe(folder_.write("copy.toml", written)), {"a test"}), written);
}

TEST_F(SuiteFile, a_recipe_needs_a_gain) {
  std::string text = recipe_text;
  const std::size_t begin = text.find("[simulation.gain]");
  text.erase(begin, text.find("[[motion]]") - begin);
  std::string empty = text;
  refuses({{text, "suite.toml:10", {"[simulation.gain]"}},
           {empty.insert(begin, "[simulation.gain]\n"),
            "suite.toml:15",
            {"simulation.gain.frequency_hz"}}});
}

TEST_F(SuiteFile, a_recipe_at_the_ends_of_its_ranges_is_simulated_to_finite_motions) {
  std::string text = with("dt_s", "0.05");
  text.erase(text.find("[[motion]]"));
  int count = 0;
  for (const char* magnitude : {"3", "8.5"})
    for (const char* distance_km : {"0.1", "400"})
      for (const char* vs30_mps : {"100", "2000"})
        for (int realization = 0; realization < 8; ++realization, ++count)
          text += "[[motion]]\nid = \"" + std::to_string(count) + "\"\nmagnitude = " + magnitude +
                  "\ndistance_km = " + distance_km + "\nvs30_mps = " + vs30_mps +
                  "\nmechanism = \"" + (realization % 2 ? "reverse" : "strike_slip") +
                  "\"\nrealization = " + std::to_string(realization) + "\n";
  const Suite suite = load(text);
  EXPECT_EQ(suite.motions.size(), 64u);
  for (const Motion& motion : suite.motions) {
    for (const auto& component :
         {motion.horizontal_mps2[0], motion.horizontal_mps2[1], motion.vertical_mps2}) {
      EXPECT_TRUE(std::ranges::all_of(component, [](double a) { return std::isfinite(a); }))
          << motion.id;
    }
  }
}

TEST_F(SuiteFile, components_whose_common_clock_would_be_endless_are_refused) {
  folder_.write("suites/fine.txt", "# acceleration_g\n.1\n.2\n");
  folder_.write("suites/coarse.txt", "# acceleration_g\n.1\n.2\n.1\n.2\n");
  // 4 samples of 1e7 each: the finest step, of 1e-7 s, is a slip.
  refuses({{head + "[[record]]\nid = \"a\"\nfirst = { file = \"fine.txt\", dt_s = 1e-7 }\n"
                   "second = { file = \"coarse.txt\", dt_s = 1 }\n",
            "suite.toml:4",
            {"coarse.txt", "40000000", "dt_s"}},
           {head + "[[record]]\nid = \"a\"\n"
                   "first = { file = \"fine.txt\", dt_s = 1e-7, start_s = 3 }\n",
            "suite.toml:4",
            {"30000002"}}});
}

TEST_F(SuiteFile, mistakes_in_a_recipe_are_located) {
  const auto without = [](const std::string& line) {
    std::string text = recipe_text;
    text.erase(text.find(line), line.size());
    return text;
  };
  refuses({{without("seed = 7\n"), "suite.toml:10", {"simulation.seed"}},
           {without("model = \"rezaeian_der_kiureghian_2010\"\n"),
            "suite.toml:10",
            {"simulation.model"}},
           {without("realization = 3\n"), "suite.toml:19", {"motion.realization"}},
           {without("vertical = [0.7, 0.6]\n"),
            "suite.toml:16",
            {"frequency_hz", "horizontal", "vertical"}},
           {recipe_text + "colour = 3\n", "suite.toml:27", {"motion.colour"}}});
}

}  // namespace
}  // namespace glissade
