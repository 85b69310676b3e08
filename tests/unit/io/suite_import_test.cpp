// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "glissade/core/file.hpp"
#include "record_folder.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST_F(SuiteImporter, components_of_one_station_and_event_become_one_record) {
  write_triple();
  write("RSN8_SOME_OTH337.AT2", at2("Somewhere, 1/2/1999, Other, 337", 4));
  write("sub/RSN8_SOME_OTH067.AT2", at2("Somewhere, 1/2/1999, Other, 67", 5));
  const SuiteImport found = import();
  EXPECT_THAT(found.left_out, IsEmpty()) << reasons(found);
  ASSERT_EQ(found.records.size(), 2u);
  const ImportedRecord& record = found.records[0];
  EXPECT_EQ(record.id, "RSN7_SOME_PLC");
  EXPECT_EQ(record.event, "Somewhere, 1/2/1999");
  EXPECT_EQ(record.station, "Place");
  EXPECT_EQ(files_of(found, record),
            "RSN7_SOME_PLC000.AT2, RSN7_SOME_PLC090.AT2, RSN7_SOME_PLC-UP.AT2");
  EXPECT_EQ(files_of(found, found.records[1]), "RSN8_SOME_OTH067.AT2, RSN8_SOME_OTH337.AT2, -");
  const Suite suite = load(found);
  ASSERT_EQ(suite.motions.size(), 2u);
  EXPECT_EQ(suite.motions[0].vertical_mps2.size(), 200u);
}

TEST_F(SuiteImporter, names_pair_files_without_headers) {
  write("BOL-090", column(1));
  write("BOL-000", column(2));
  write("a/19760506_TLM1_WE.acc", column(3));
  write("a/19760506_TLM1_NS.acc", column(4));
  write("a/19760506_TLM1_UD.acc", column(5));
  write("b/NET.STA.HNZ.20200101.txt", column(6));
  write("b/NET.STA.HNE.20200101.txt", column(7));
  write("b/NET.STA.HNN.20200101.txt", column(8));
  write("d/BK.CMB.00.HNE__20140824T102014Z__20140824T102244Z.txt", column(13));
  write("d/BK.CMB.00.HNN__20140824T102014Z__20140824T102244Z.txt", column(14));
  write("c/REC_H2.txt", column(9));
  write("c/REC_H1.txt", column(10));
  write("c/3_BOLU000.txt", column(11));
  write("c/3_BOLU090.txt", column(12));
  const SuiteImport stated = import();
  EXPECT_THAT(stated.records, IsEmpty());
  EXPECT_EQ(stated.left_out.size(), 14u);
  EXPECT_THAT(reasons(stated), test::states("BOL-090: nothing states which component it is",
                                            "its name suggests 090: --directions-from-names"));
  const SuiteImport found = import(by_names());
  EXPECT_THAT(found.left_out, IsEmpty()) << reasons(found);
  for (const ImportedRecord& record : found.records)
    EXPECT_THAT(record.warnings,
                testing::Contains(HasSubstr("only the names of its files suggest")));
  std::vector<std::string> files;
  for (const ImportedRecord& record : found.records) files.push_back(files_of(found, record));
  EXPECT_THAT(files, ElementsAre("19760506_TLM1_NS.acc, 19760506_TLM1_WE.acc, 19760506_TLM1_UD.acc",
                                 "3_BOLU000.txt, 3_BOLU090.txt, -",
                                 "BK.CMB.00.HNN__20140824T102014Z__20140824T102244Z.txt, "
                                 "BK.CMB.00.HNE__20140824T102014Z__20140824T102244Z.txt, -",
                                 "BOL-000, BOL-090, -",
                                 "NET.STA.HNN.20200101.txt, NET.STA.HNE.20200101.txt, "
                                 "NET.STA.HNZ.20200101.txt",
                                 "REC_H1.txt, REC_H2.txt, -"));
}

// The number of an earthquake, of a record, a date: none is an azimuth.
TEST_F(SuiteImporter, digits_of_a_name_are_no_azimuth) {
  int seed = 0;
  for (const char* name : {"eq2019.txt", "eq2109.txt", "GM001.txt", "GM091.txt"})
    write(name, column(++seed));
  write("place1002271.v1",
        changed(read_text_file(fs::path(GLISSADE_SOURCE_DIR) / "tests/fuzz/corpus/record/usc.dat"),
                "COMP N00E", "COMP EZ"));
  const SuiteImport found = import();
  EXPECT_THAT(found.records, IsEmpty());
  EXPECT_THAT(reasons(found),
              test::states("eq2019.txt: nothing states which component it is; write",
                           "GM091.txt: nothing states which component it is; its "
                           "name suggests 091",
                           "'EZ' is no direction"));
  for (const ImportedRecord& record : import(by_names()).records) {
    EXPECT_EQ(record.id, "GM");
    EXPECT_THAT(record.warnings, ElementsAre(HasSubstr("suggest: 001, 091")));
  }
}

// "IMPVALL_H-E12140" is station E12 at 140 degrees.
TEST_F(SuiteImporter, names_of_peer_state_the_direction_of_its_files) {
  for (const char* direction : {"140", "230", "UP"})
    write(fmt::format("RSN175_IMPVALL.H_H-E12{}.AT2", direction),
          at2("Some text", 10 * direction[0] + direction[1]));
  write("H-E13140.AT2", at2("Some text", 3));
  const SuiteImport found = import();
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(found.records[0].id, "RSN175_IMPVALL.H_H-E12");
  EXPECT_EQ(files_of(found, found.records[0]),
            "RSN175_IMPVALL.H_H-E12140.AT2, RSN175_IMPVALL.H_H-E12230.AT2, "
            "RSN175_IMPVALL.H_H-E12UP.AT2");
  EXPECT_THAT(found.records[0].warnings, IsEmpty());
  EXPECT_THAT(reasons(found), HasSubstr("H-E13140.AT2: nothing states"));
}

TEST_F(SuiteImporter, a_vertical_stays_with_its_horizontals_beside_another_of_their_direction) {
  int seed = 0;
  for (const std::string name : {"000", "000b", "090", "UP"})
    write(fmt::format("RSN900_TEST_STA{}.AT2", name),
          at2("TESTQUAKE, 1/2/2003, Some Station, " + name.substr(0, 3), ++seed));
  const SuiteImport found = import();
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(files_of(found, found.records[0]),
            "RSN900_TEST_STA000.AT2, RSN900_TEST_STA090.AT2, RSN900_TEST_STAUP.AT2");
  ASSERT_EQ(found.left_out.size(), 1u);
  EXPECT_THAT(reasons(found), test::states("RSN900_TEST_STA000b.AT2: one horizontal component only",
                                           "--keep-single"));
}

TEST_F(SuiteImporter, columns_of_one_table_are_addressed_by_their_names) {
  std::string table = "Time (s),U1 (m/s2),U2 (m/s2),U3 (m/s2)\n";
  for (int i = 0; i < 50; ++i)
    table += fmt::format("{:.2f},{:.6f},{:.6f},{:.6f}\n", 0.02 * i, std::sin(0.3 * i),
                         std::cos(0.4 * i), std::sin(0.5 * i));
  write("floor.csv", table);
  const SuiteImport found = import();
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(files_of(found, found.records[0]), "floor.csv#U1, floor.csv#U2, floor.csv#U3");
  EXPECT_EQ(load(found).motions[0].vertical_mps2.size(), 50u);
}

TEST_F(SuiteImporter, a_bad_file_is_left_out_with_its_reason_and_stops_no_other) {
  write_triple();
  write("empty.txt", "");
  write("junk.bin", std::string("\0\1\2\xff", 4));
  write("RSN7_SOME_PLC000.VT2",
        "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/2/1999, Place, 0\n"
        "VELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 1, DT= .01 SEC\n1.0\n");
  write("RSN7_cut000.AT2", at2("Somewhere, 1/2/1999, Cut, 0", 1).substr(0, 400));
  write("counts.AT2", "A\nB\nUNITS OF G\nNPTS= 99999999999999999999999, DT= .01\n0.1\n0.2\n");
  write("no_units_000.txt", "0.1\n0.2\n");
  write(".hidden", "x");
  fs::create_symlink("/etc/hostname", folder_.path() / "records" / "link.txt");
  fs::create_symlink("loop", folder_.path() / "records" / "loop");
  const SuiteImport found = import();
  EXPECT_EQ(found.records.size(), 1u);
  EXPECT_EQ(found.left_out.size(), 8u) << reasons(found);
  EXPECT_THAT(reasons(found), test::states("empty.txt", "junk.bin", "velocity", "NPTS is 200",
                                           "counts.AT2: NPTS is no whole number", "units",
                                           "link.txt: a link out of the folder", "loop"));
  EXPECT_THAT(reasons(found), testing::Not(HasSubstr(".hidden")));
  EXPECT_THAT(message_of([&] { import_suite({.inputs = {"/nowhere"}, .report = {}}); }),
              HasSubstr("/nowhere"));
}

TEST_F(SuiteImporter, a_step_that_a_file_contradicts_leaves_it_out_and_a_bad_value_is_its_reason) {
  write("A-000", column(1, 200, 0.005));
  write("B-000", "# units: g\n" + lines_of_samples(motion_g(2)));
  write("B-090", "# units: g\n" + lines_of_samples(motion_g(3)));
  write("C-000", "# units: g\n0.1\n0.2\n0.3x\n");
  ImportOptions options = by_names();
  options.missing.dt_s = 0.01;
  const SuiteImport found = import(options);
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(load(found).motions[0].dt_s, 0.01);
  EXPECT_EQ(found.left_out.size(), 2u);
  EXPECT_THAT(reasons(found), test::states("A-000: the header's DT = 0.005 is not dt_s = 0.01",
                                           "C-000: ", "'0.3x'"));
}

TEST_F(SuiteImporter, duplicates_are_named_and_left_out) {
  write_triple();
  write("copy/RSN7_SOME_PLC000.AT2", at2("Somewhere, 1/2/1999, Place, 0", 1));
  write("old/PLC-090", column(2));
  const SuiteImport found = import();
  EXPECT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_THAT(reasons(found), test::states("the same bytes as",
                                           "old/PLC-090: a duplicate: the "
                                           "same samples as"));
}

TEST_F(SuiteImporter, what_is_not_processed_is_left_out_beside_its_processed_version) {
  const std::string processed =
      changed(read_text_file(fs::path(GLISSADE_SOURCE_DIR) / "tests/fuzz/corpus/record/smc.smc"),
              "*\n*\n*\n", "*\n*\n2000 1 1 Somewhere\n");
  const auto across = [](const std::string& text) {
    return changed(text, "        90        45", "        90       135");
  };
  std::string raw =
      changed(changed(processed, "2 CORRECTED", "1 UNCORRECTED"), "2.0000E+2", "2.1000E+2");
  write("p1.smc", processed), write("p2.smc", across(changed(processed, "2.0000E+2", "1.9000E+2")));
  write("u1.smc", raw), write("u2.smc", across(changed(raw, "2.1000E+2", "1.8000E+2")));
  const SuiteImport found = import();
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(files_of(found, found.records[0]), "p1.smc, p2.smc, -");
  EXPECT_THAT(reasons(found), HasSubstr("not processed"));
}

TEST_F(SuiteImporter, what_is_no_record_is_left_out_and_never_guessed) {
  write("A-000", column(1));  // alone
  write("B-111", column(2));  // not perpendicular
  write("B-112", column(3));
  write("C.txt", column(4));  // no direction
  write("D-UP", column(5));   // no horizontal
  for (const int azimuth : {10, 100, 190})
    write(fmt::format("F{:03}.AT2", azimuth),
          at2(fmt::format("Elsewhere, 1/2/1999, Place, {}", azimuth), azimuth));
  SuiteImport found = import(by_names());
  EXPECT_THAT(found.records, IsEmpty());
  EXPECT_EQ(found.left_out.size(), 8u);  // each file by its own reason
  EXPECT_THAT(reasons(found), test::states("A-000: one horizontal component only", "--keep-single",
                                           "111 and 112 degrees", "C.txt: nothing states which",
                                           "D-UP: no horizontal", "3 horizontal and 0 vertical"));
  ImportOptions options = by_names();
  options.keep_single = true;
  found = import(options);
  EXPECT_EQ(files_of(found, found.records.at(0)), "A-000, -, -");
}

TEST_F(SuiteImporter, other_lengths_and_steps_are_named_and_changed_only_if_asked) {
  write("A-000", column(1, 200));
  write("A-090", column(2, 500));  // 5 s
  write("B-000", column(3, 200, 0.01));
  write("B-090", column(4, 250, 0.008));
  SuiteImport found = import(by_names());
  ASSERT_EQ(found.records.size(), 1u);
  EXPECT_THAT(found.records[0].warnings,
              ElementsAre(test::states("A-000 ends at 2 s", "A-090 at 5 s", "--trim"),
                          HasSubstr("suggest: 000, 090")));
  EXPECT_THAT(reasons(found),
              test::states("B-000: steps of 0.008 and 0.01 s", "B-090: steps", "--resample"));
  EXPECT_EQ(load(found).motions[0].horizontal_mps2[0].size(), 500u);

  ImportOptions options = by_names();
  options.trim = options.resample = true;
  found = import(options);
  const Suite suite = load(found);
  ASSERT_EQ(suite.motions.size(), 2u) << reasons(found);
  EXPECT_EQ(suite.motions[0].horizontal_mps2[1].size(), 200u);
  EXPECT_THAT(suite.motions[0].notes, ElementsAre(HasSubstr("second component: ended at 2 s")));
  EXPECT_THAT(suite.motions[0].contradictions, IsEmpty());
  EXPECT_EQ(suite.motions[1].dt_s, 0.008);
  EXPECT_THAT(suite.motions[1].notes,
              ElementsAre(HasSubstr("first component: resampled from 0.01 to 0.008 s")));
}

TEST_F(SuiteImporter, clipped_flat_and_spiky_components_are_named_here_and_in_the_suite) {
  std::vector<double> clipped = motion_g(1), spiky = motion_g(2), dead(200, 0.25);
  for (double& a : clipped) a = std::clamp(a, -0.15, 0.15);
  spiky[77] = 4.0;
  const auto with = [](const std::vector<double>& a) {
    return "# units: g\n# DT = 0.01\n" + lines_of_samples(a);
  };
  write("A-000", with(clipped));
  write("A-090", with(spiky));
  write("A-UP", with(dead));
  const SuiteImport found = import(by_names());
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  const auto named =
      ElementsAre(HasSubstr("suggest: 000, 090"), test::states("A-000", "clipped?", "0.15 g"),
                  test::states("A-090", "spike?", "sample 78", "4 g"));
  EXPECT_THAT(found.records[0].warnings, named);
  EXPECT_THAT(reasons(found), test::states("A-UP: all 200 samples are 0.25 g"));
  EXPECT_THAT(
      load(found).motions[0].contradictions,
      ElementsAre(HasSubstr("first component: clipped?"), HasSubstr("second component: a spike?")));
}

// Stations are triggered some seconds apart.
TEST_F(SuiteImporter, headers_with_times_of_records_state_the_minute_and_those_to_come_no_event) {
  const auto corpus = [](const char* name) {
    return read_text_file(fs::path(GLISSADE_SOURCE_DIR "/tests/fuzz/corpus/record") / name);
  };
  write("a.v2", changed(corpus("cosmos.v2"), "Origin: none", "Origin: To be determined"));
  write("b.v2", changed(corpus("csmip.v2"), "\ntext\n",
                        "\nRecord of Mon Feb 13, 2012 13:06:45.0 PST (Avol1 v9.2)\n"));
  const SuiteImport found = import(by_names());
  ASSERT_EQ(found.components.size(), 4u) << reasons(found);  // two channels each
  EXPECT_EQ(found.components[0].header.event, "");
  EXPECT_EQ(found.components[2].header.event, "Record of Mon Feb 13, 2012 13:06");
}

TEST_F(SuiteImporter, ids_are_unique) {
  for (const char* folder : {"a", "b"})
    for (const char* direction : {"000", "090"})
      write(fmt::format("{}/X-{}", folder, direction), column(folder[0] + direction[1]));
  const SuiteImport found = import(by_names());
  ASSERT_EQ(found.records.size(), 2u) << reasons(found);
  EXPECT_EQ(found.records[0].id, "X");
  EXPECT_EQ(found.records[1].id, "X_2");
}

// The made-up samples of the fuzz corpus, one of each format.
TEST(RecordHeaders, state_event_station_direction_magnitude_and_unit) {
  struct Expected {
    const char *file, *event, *station, *direction, *unit;
    double magnitude;
    std::optional<bool> is_processed;
  };
  for (const Expected& e :
       {Expected{"afad.txt", "2000/01/01 00:00:00 (GMT)", "0001", "0", "gal", 0.0, false},
        {"at2_touching.at2", "Made up, 1/1/2000", "Nowhere", "090", "g", 0.0, true},
        {"bhrc.v1", "2000/01/01", "Nowhere Station 0.0", "L1", "G/10", 0.0, false},
        {"cosmos.v2", "none", "Statn No: 01-00001 Code:XX-0001 Nowhere", "340", "cm/sec2", 0.0,
         true},
        {"csmip.v2", "", "Station No. 00001", "360", "cm/sec2", 0.0, true},
        {"cwb.dat", "2000/01/01-00:00:00", "XXX", "UP", "gal. DCoffset(corr)", 0.0, {}},
        {"esd.acc", "2000-01-01 00:00:00", "1 / Nowhere", "0", "m/s/s", 0.0, {}},
        {"esm.asc", "20000101 000000", "XX.XXX", "90", "cm/s^2", 0.0, false},
        {"geonet.v1a", "2000 January 1 00:00:00 UT", "Site XXX", "10", "mm/s/s", 0.0, false},
        {"kiknet_surface.txt", "2000/01/01 00:00:00", "XXX001 surface", "90",
         "counts x 3920(gal)/3920000", 5.0, false},
        {"sac_big.sac", "", "XX.XXX", "90", "", 0.0, {}},
        {"smc.smc", "", "Nowhere", "45", "cm/s2", 0.0, true},
        {"usc.dat", "", "STATION USC# 0001", "0", "G/10", 0.0, false}}) {
    ImportOptions options;
    options.inputs = {fs::path(GLISSADE_SOURCE_DIR "/tests/fuzz/corpus/record") / e.file};
    options.missing.units_if_not_stated = AccelerationUnits::g;
    const SuiteImport found = import_suite(options);
    ASSERT_FALSE(found.components.empty()) << e.file;
    const RecordHeader& header = found.components[0].header;
    EXPECT_EQ(header.event, e.event) << e.file;
    EXPECT_EQ(header.station, e.station) << e.file;
    EXPECT_EQ(header.direction, e.direction) << e.file;
    EXPECT_EQ(header.unit, e.unit) << e.file;
    EXPECT_EQ(header.magnitude, e.magnitude) << e.file;
    EXPECT_EQ(header.is_processed, e.is_processed) << e.file;
  }
}

}  // namespace
}  // namespace glissade
