// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/suite_writer.hpp"

#include <gmock/gmock.h>

#include "glissade/io/suite_file.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* library_toml = R"([suite]
name = "library"
units = "cm/s2"
[target]
edition = "asce7_10"
ss_g = 9.0
s1_g = 9.0
[[record]]
id = "first"
first = "a.acc"
[[record]]
id = "a \"quoted\" one"
event = "Somewhere \\ 1999"
station = "S\tT"
magnitude = 6.93
distance_km = 8.5
vs30_mps = 123.456789
scale = 7.0
first = { file = "records/a.acc", dt_s = 0.005, units = "m/s2" }
second = { file = "records/b.acc", dt_s = 0.005, start_s = 0.015, units = "gal" }
vertical = { file = "records/c.acc", dt_s = 0.005 }
)";

class SuiteWriter : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("library/records/a.acc", "-0.25\n0.5\n1.0\n");
    folder_.write("library/records/b.acc", "100\n-200\n");
    folder_.write("library/records/c.acc", "0.1\n");
    library_ = folder_.write("library/library.toml", library_toml);
  }
  std::string text_for(const std::string& out_folder, const std::vector<ScaledRecord>& records) {
    SuiteHead head{"selected",
                   "some records",
                   StatedTarget{{.ss_g = 1.95, .s1_g = 0.8}, {}},
                   {"Made by a test"}};
    head.nearest_to_target = true;
    head.target->target.site_classes = {SiteClass::a, SiteClass::e};
    return suite_of_records_toml(library_, head, records, folder_.path() / out_folder);
  }
  TemporaryFolder folder_;
  std::filesystem::path library_;
};

TEST_F(SuiteWriter, writes_a_suite_that_loads_from_another_folder_with_the_same_records) {
  const std::string text = text_for("elsewhere/deep", {{"a \"quoted\" one", 1.2345}});
  EXPECT_THAT(text, testing::StartsWith("# Made by a test\n"));
  const Suite suite = load_suite(folder_.write("elsewhere/deep/selected.toml", text));
  EXPECT_EQ(suite.name, "selected");
  EXPECT_TRUE(suite.nearest_to_target);
  EXPECT_EQ(suite.target->ss_g, 1.95);
  EXPECT_THAT(suite.target->site_classes, ElementsAre(SiteClass::a, SiteClass::e));
  ASSERT_EQ(suite.motions.size(), 1u);
  const Motion& motion = suite.motions[0];
  EXPECT_EQ(motion.id, "a \"quoted\" one");
  EXPECT_EQ(motion.event, "Somewhere \\ 1999");
  EXPECT_EQ(motion.station, "S\tT");
  EXPECT_EQ(motion.magnitude, 6.93);
  EXPECT_EQ(motion.distance_km, 8.5);
  EXPECT_EQ(motion.vs30_mps, 123.456789);
  EXPECT_EQ(motion.scale, 1.2345);
  EXPECT_EQ(motion.dt_s, 0.005);
  // One column in m/s2, as the library says; the second in gal, three samples later.
  EXPECT_THAT(motion.horizontal_mps2[0], ElementsAre(-0.25, 0.5, 1.0, 0.0, 0.0));
  EXPECT_THAT(motion.horizontal_mps2[1], ElementsAre(0.0, 0.0, 0.0, 1.0, -2.0));
  EXPECT_EQ(motion.vertical_mps2.size(), 5u);
}

TEST_F(SuiteWriter, processing_and_directions_go_with_their_records) {
  const std::string of_all =
      "[processing]\nband_pass = { low_hz = 0.1, high_hz = 20, order = 3 }\narias_percent = [1, "
      "99]\n"
      "step_s = 0.004\n";
  library_ = folder_.write("library/library.toml",
                           of_all + library_toml +
                               "[[record]]\nid = \"turned\"\nstrike_deg = 12.5\n"
                               "first = { file = \"records/a.acc\", azimuth_deg = 67.5 }\n"
                               "processing = { rotate_to = \"fault_parallel\", arias_percent = "
                               "[5, 95], baseline_degree = 2 }\n");
  const std::string text = text_for("library", {{"first", 1.0}, {"turned", 1.0}});
  EXPECT_THAT(
      text,
      testing::AllOf(
          HasSubstr("processing = { band_pass = { low_hz = 0.1, high_hz = 20, order = 3 }, "
                    "arias_percent = [1, 99], step_s = 0.004 }\nfirst = \"a.acc\""),
          HasSubstr("strike_deg = 12.5\nprocessing = { baseline_degree = 2, band_pass = { low_hz = "
                    "0.1, high_hz = 20, order = 3 }, rotate_to = \"fault_parallel\", "
                    "arias_percent = [5, 95], step_s = 0.004 }"),
          HasSubstr("azimuth_deg = 67.5")));
}

TEST_F(SuiteWriter, keeps_names_that_are_not_beside_the_library) {
  // They are found by GLISSADE_RECORDS, wherever the suite file is.
  EXPECT_THAT(text_for("elsewhere", {{"first", 1.0}}), HasSubstr("first = \"a.acc\"\n"));
  EXPECT_THAT(text_for("library", {{"a \"quoted\" one", 1.0}}),
              HasSubstr("{ file = \"records/a.acc\""));
}

TEST_F(SuiteWriter, keeps_the_units_of_the_library) {
  EXPECT_THAT(text_for("elsewhere", {{"first", 1.0}}), HasSubstr("units = \"cm/s2\"\n"));
}

TEST_F(SuiteWriter, refuses_a_record_the_library_does_not_have) {
  EXPECT_THAT(message_of([&] {
                text_for("library", {{"nobody", 1.0}});
              }),
              test::states("library.toml", "nobody"));
}

TEST_F(SuiteWriter, components_and_gains_go_with_their_files) {
  folder_.write("library/floor.csv", "time_s,ax_g,ay_g\n0,.1,.2\n0.01,.4,.5\n");
  library_ = folder_.write("library/library.toml",
                           "[suite]\nname = \"l\"\n[[record]]\nid = \"f\"\nfirst = "
                           "\"floor.csv#ax\"\nsecond = { file = \"floor.csv#ay\", units = "
                           "\"g\", counts_per_unit = 2.5 }\n");
  const std::string text = text_for("elsewhere", {{"f", 1.0}});
  EXPECT_THAT(text, HasSubstr("first = \"../library/floor.csv#ax\""));
  EXPECT_THAT(text, HasSubstr("floor.csv#ay\", units = \"g\", counts_per_unit = 2.5"));
}

}  // namespace
}  // namespace glissade
