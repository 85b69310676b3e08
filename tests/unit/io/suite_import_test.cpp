// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/suite_import.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/improbable.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// A made-up motion; each seed another.
std::vector<double> motion_g(double seed, std::size_t count = 200) {
  std::vector<double> a;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    a.push_back(0.3 * std::sin(3.0 * t) * std::sin((20.0 + seed) * t + seed));
  }
  return a;
}

std::string lines_of_samples(const std::vector<double>& a) {
  std::string text;
  for (const double value : a) text += fmt::format("{:.9f}\n", value);
  return text;
}

/// A file of NGA-West2.
std::string at2(const std::string& source, double seed, std::size_t count = 200,
                double dt_s = 0.01) {
  return fmt::format(
             "PEER NGA STRONG MOTION DATABASE RECORD\n{}\nACCELERATION TIME SERIES IN UNITS OF G\n"
             "NPTS=   {}, DT=   {:.4f} SEC\n",
             source, count, dt_s) +
         lines_of_samples(motion_g(seed, count));
}

std::string column(double seed, std::size_t count = 200, double dt_s = 0.01) {
  return fmt::format("# units: g\n# DT = {}\n", dt_s) + lines_of_samples(motion_g(seed, count));
}

/// A tar archive (POSIX 1003.1, ustar) of files.
std::string tar_of(const std::vector<std::pair<std::string, std::string>>& files) {
  constexpr std::size_t block = 512, sum_at = 148, sum_length = 8;
  std::string tar;
  for (const auto& [name, content] : files) {
    std::string head(block, '\0');
    head.replace(0, name.size(), name);
    head.replace(124, 11, fmt::format("{:011o}", content.size()));
    head.replace(156, 1, "0");
    head.replace(257, 8, std::string("ustar\0", 6) + "00");
    head.replace(sum_at, sum_length, std::string(sum_length, ' '));
    unsigned int sum = 0;
    for (const char c : head) sum += static_cast<unsigned char>(c);
    head.replace(sum_at, 7, fmt::format("{:06o}", sum) + '\0');
    tar += head + content + std::string((block - content.size() % block) % block, '\0');
  }
  return tar + std::string(2 * block, '\0');
}

class SuiteImporter : public testing::Test {
 protected:
  SuiteImport import(ImportOptions options = {}) const {
    options.inputs = {folder_.path() / "records"};
    return import_suite(options);
  }
  void write(const std::string& name, const std::string& text) const {
    folder_.write("records/" + name, text);
  }
  SuiteImport import_with_report(const std::string& report) const {
    ImportOptions options;
    options.report = folder_.write("report.csv", report);
    return import(options);
  }
  /// The suite that is written beside the folder, read.
  Suite load(const SuiteImport& found) const {
    return load_suite(
        folder_.write("suite.toml", imported_suite_toml(found, {"s", {}, {}}, folder_.path())));
  }
  /// "first, second, vertical" by their files.
  static std::string files_of(const SuiteImport& found, const ImportedRecord& record) {
    std::string list;
    for (const auto& component : record.components)
      list += (list.empty() ? "" : ", ") +
              (component ? found.components[*component].shown() : std::string("-"));
    return list;
  }
  static std::string reasons(const SuiteImport& found) {
    std::string text;
    for (const LeftOut& left : found.left_out) text += left.what + ": " + left.reason + "\n";
    return text;
  }
  void write_triple(const std::string& source = "Somewhere, 1/2/1999, Place") const {
    write("RSN7_SOME_PLC000.AT2", at2(source + ", 0", 1));
    write("RSN7_SOME_PLC090.AT2", at2(source + ", 90", 2));
    write("RSN7_SOME_PLC-UP.AT2", at2(source + ", UP", 3));
  }
  TemporaryFolder folder_;
};

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
  const SuiteImport found = import();
  EXPECT_THAT(found.left_out, IsEmpty()) << reasons(found);
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

constexpr const char* peer_report =
    "\n PEER Ground Motion Database, Time Series Search Report -- NGA-West2 -- 2019-04-04\n\n"
    " -- Summary of PEER Ground Motion Database Search Criteria --\nMagnitude Min:, -1.0e-06\n"
    "Record Sequence Number:, 7, 9\n\n -- Summary of Metadata of Selected Records --\n"
    "Result ID, Spectral Ordinate, Record Sequence Number, Mean Squared Error, Scale Factor, "
    "Earthquake Name, Year, Station Name, Magnitude, Mechanism, Rjb (km), Rrup (km), Vs30 (m/sec), "
    "Horizontal-1 Acc. Filename, Horizontal-2 Acc. Filename, Vertical Acc. Filename\n"
    "1, SRSS, 7, -, 1.7, \"Friuli_ Italy-01\", 1976, \"Place, at Town\", 6.5, Reverse, 14.97, "
    "15.82, 505.23, RSN7_SOME_PLC090.AT2, RSN7_SOME_PLC000.AT2 , RSN7_SOME_PLC-UP.AT2  \n"
    "2, SRSS, 9, -, 1.0, \"None\", 1976, \"None\", 6.5, Reverse, 1, 2, 505, ../../etc/passwd, "
    "RSN9.AT2 ,  -----   \n\n These records are UNSCALED, AS RECORDED\n\n"
    " -- Scaled Spectra used in Search & Scaling --\nPeriod (sec),RSN-7 SRSS pSa (g)\n0.01,0.4\n";

TEST_F(SuiteImporter, a_report_of_peer_gives_magnitude_distance_site_factor_and_order) {
  write_triple();
  write("_SearchResults.csv", peer_report);
  const SuiteImport found = import_with_report(peer_report);
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  const ImportedRecord& record = found.records[0];
  EXPECT_EQ(record.event, "Friuli, Italy-01 1976");
  EXPECT_EQ(record.station, "Place, at Town");
  EXPECT_EQ(record.magnitude, 6.5);
  EXPECT_EQ(record.distance_km, 15.82);
  EXPECT_EQ(record.distance_kind, "rupture");
  EXPECT_EQ(record.vs30_mps, 505.23);
  EXPECT_EQ(record.scale, 1.7);
  EXPECT_EQ(files_of(found, record),
            "RSN7_SOME_PLC090.AT2, RSN7_SOME_PLC000.AT2, RSN7_SOME_PLC-UP.AT2");
  EXPECT_THAT(found.warnings, IsEmpty());
  // The copy in the folder was not given as the report; RSN9 has no file, and none is opened.
  EXPECT_THAT(reasons(found),
              test::states("give it with --report", "RSN9 of the report", "../../etc/passwd"));
  const Suite suite = load(found);
  EXPECT_EQ(suite.motions[0].scale, 1.7);
  EXPECT_THAT(suite.motions[0].notes, IsEmpty());
}

TEST_F(SuiteImporter, a_report_that_does_not_state_unscaled_files_is_warned_of) {
  write_triple();
  std::string report = peer_report;
  report.replace(report.find("UNSCALED"), 8, "SCALED");
  EXPECT_THAT(import_with_report(report).warnings, ElementsAre(HasSubstr("factors")));
}

TEST_F(SuiteImporter, a_flatfile_of_esm_is_joined_by_event_and_station) {
  const auto esm = [](const char* stream, double seed) {
    return fmt::format(
               "EVENT_NAME: X\nEVENT_ID: EMSC-1\nEVENT_DATE_YYYYMMDD: 20190728\n"
               "EVENT_TIME_HHMMSS: 160908\nMAGNITUDE_W: \nMAGNITUDE_L: 4.6\nNETWORK: HI\n"
               "STATION_CODE: ARS1\nVS30_M/S: 300\nEPICENTRAL_DISTANCE_KM: 88.1\n"
               "SAMPLING_INTERVAL_S: 0.01\nNDATA: 100\nSTREAM: {}\nUNITS: cm/s^2\n"
               "DATA_TYPE: ACCELERATION\nPROCESSING: manual\n",
               stream) +
           lines_of_samples(motion_g(seed, 100));
  };
  write("HI.ARS1..HNE.ASC", esm("HNE", 1));
  write("HI.ARS1..HNN.ASC", esm("HNN", 2));
  const ImportedRecord by_header = import().records.at(0);
  EXPECT_EQ(by_header.magnitude, 4.6);
  EXPECT_EQ(by_header.magnitude_kind, "ML");
  EXPECT_EQ(by_header.distance_km, 88.1);
  EXPECT_EQ(by_header.distance_kind, "epicentral");
  EXPECT_EQ(by_header.vs30_mps, 300.0);
  const std::string flatfile =
      "event_id;event_time;ML;Mw;network_code;station_code;vs30_m_sec;epi_dist;JB_dist;rup_dist\n"
      "EMSC-1;2019;4.6;4.4;HI;OTHR;;1;2;3\nEMSC-1;2019;4.6;4.4;HI;ARS1;412;88.1;80.5;\n";
  const SuiteImport found = import_with_report(flatfile);
  const ImportedRecord& record = found.records.at(0);
  EXPECT_EQ(record.magnitude, 4.4);
  EXPECT_EQ(record.magnitude_kind, "Mw");
  EXPECT_EQ(record.distance_km, 80.5);
  EXPECT_EQ(record.distance_kind, "joyner_boore");
  EXPECT_EQ(record.vs30_mps, 412.0);
  EXPECT_EQ(files_of(found, record), "HI.ARS1..HNN.ASC, HI.ARS1..HNE.ASC, -");
  EXPECT_THAT(load(found).motions[0].notes, ElementsAre(HasSubstr("Joyner")));
  EXPECT_THAT(load(import()).motions[0].notes,
              ElementsAre(HasSubstr("ML"), HasSubstr("epicentral")));
}

TEST_F(SuiteImporter, a_report_that_is_none_is_refused) {
  write_triple();
  EXPECT_THAT(message_of([&] { import_with_report("a,b\n1,2\n"); }),
              test::states("report.csv", "Record Sequence Number", "event_id"));
  EXPECT_THAT(message_of([&] {
                import_with_report("Record Sequence Number,Horizontal-1 Acc. Filename\n");
              }),
              HasSubstr("no rows"));
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

/// A channel of the miniSEED file of the corpus, 1000 counts for one unit.
std::string station_xml(const std::string& unit, const std::string& azimuth) {
  return "<?xml version=\"1.0\"?><FDSNStationXML><Network code=\"XX\"><Station code=\"XXX\">"
         "<Channel code=\"HNE\" locationCode=\"\" startDate=\"1999-01-01T00:00:00\" "
         "endDate=\"2001-01-01T00:00:00\"><Azimuth>" +
         azimuth +
         "</Azimuth><Dip>0</Dip><Response><InstrumentSensitivity><Value>1000</Value><Frequency>1"
         "</Frequency><InputUnits><Name>" +
         unit +
         "</Name></InputUnits><OutputUnits><Name>COUNTS</Name></OutputUnits>"
         "</InstrumentSensitivity></Response></Channel></Station></Network></FDSNStationXML>";
}

class MiniseedImporter : public SuiteImporter {
 protected:
  SuiteImport import_with(const std::string& xml) const {
    write("a.mseed", read_text_file(fs::path(GLISSADE_SOURCE_DIR) /
                                    "tests/fuzz/corpus/record/miniseed.mseed"));
    write("metadata/station.xml", xml);
    ImportOptions options;
    options.keep_single = true;
    return import(options);
  }
};

TEST_F(MiniseedImporter, takes_gain_and_azimuth_of_the_stations_metadata) {
  const SuiteImport found = import_with(station_xml("M/S**2", "30"));
  if (reasons(found).find("libmseed") != std::string::npos) GTEST_SKIP() << reasons(found);
  EXPECT_EQ(reasons(found), "");
  ASSERT_EQ(found.records.size(), 1u);
  EXPECT_EQ(found.components[*found.records[0].components[0]].header.direction, "30");
  fs::remove_all(folder_.path() / "records/metadata");  // the suite has the gain
  const Suite suite = load(found);
  const auto& first = suite.motions.at(0).horizontal_mps2[0];
  EXPECT_THAT(std::vector<double>(first.begin(), first.end()),
              ElementsAre(0.0, 0.5, -1.0, 0.25, 2.0, -0.5, -0.75, -0.5));
}

TEST_F(MiniseedImporter, refuses_channels_of_velocity_and_metadata_that_are_none) {
  for (const auto& [xml, words] :
       {std::pair{station_xml("M/S", "30"), "channel XX_XXX__HNE has 1000 'counts' for 1 'M/S'"},
        std::pair{station_xml("M/S**2", "30").substr(0, 200), "no whole XML"},
        std::pair{std::string("<FDSNStationXML/>"), "does not state how many"}}) {
    const std::string reason = reasons(import_with(xml));
    if (reason.find("libmseed") != std::string::npos) GTEST_SKIP() << reason;
    EXPECT_THAT(reason, HasSubstr(words));
  }
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
  SuiteImport found = import();
  EXPECT_THAT(found.records, IsEmpty());
  EXPECT_THAT(reasons(found), test::states("A-000: one horizontal component only", "--keep-single",
                                           "111 and 112 degrees", "which component C.txt is",
                                           "D-UP: no horizontal", "3 horizontal and 0 vertical"));
  ImportOptions options;
  options.keep_single = true;
  found = import(options);
  EXPECT_EQ(files_of(found, found.records.at(0)), "A-000, -, -");
}

TEST_F(SuiteImporter, other_lengths_and_steps_are_named_and_changed_only_if_asked) {
  write("A-000", column(1, 200));
  write("A-090", column(2, 500));  // 5 s
  write("B-000", column(3, 200, 0.01));
  write("B-090", column(4, 250, 0.008));
  SuiteImport found = import();
  ASSERT_EQ(found.records.size(), 1u);
  EXPECT_THAT(found.records[0].warnings,
              ElementsAre(test::states("A-000 ends at 2 s", "A-090 at 5 s", "--trim")));
  EXPECT_THAT(reasons(found), test::states("B-000, B-090", "0.008 and 0.01 s", "--resample"));
  EXPECT_EQ(load(found).motions[0].horizontal_mps2[0].size(), 500u);

  ImportOptions options;
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
  const SuiteImport found = import();
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  const auto named = ElementsAre(test::states("A-000", "clipped?", "0.15 g"),
                                 test::states("A-090", "spike?", "sample 78", "4 g"));
  EXPECT_THAT(found.records[0].warnings, named);
  EXPECT_THAT(reasons(found), test::states("A-UP: all 200 samples are 0.25 g"));
  EXPECT_THAT(
      load(found).motions[0].contradictions,
      ElementsAre(HasSubstr("first component: clipped?"), HasSubstr("second component: a spike?")));
}

TEST_F(SuiteImporter, a_suite_is_read_where_it_was_moved_to_and_knows_its_files) {
  write_triple();
  const SuiteImport found = import();
  folder_.write("home/suite.toml",
                imported_suite_toml(found, {"s", {"made\nby"}, {}}, folder_.path() / "home"));
  TemporaryFolder other;
  fs::copy(folder_.path(), other.path() / "moved", fs::copy_options::recursive);
  fs::rename(folder_.path() / "records", folder_.path() / "gone");
  const fs::path suite = other.path() / "moved/home/suite.toml";
  EXPECT_EQ(load_suite(suite).motions.size(), 1u);

  const fs::path changed = other.path() / "moved/records/RSN7_SOME_PLC090.AT2";
  std::ofstream(changed) << at2("Somewhere, 1/2/1999, Place, 90", 2.5);
  const std::vector<Problem> problems = problems_of([&] { load_suite(suite); });
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_THAT(problems[0].what,
              test::states("RSN7_SOME_PLC090.AT2", "is not the file", sha256_of_file(changed)));
  EXPECT_THAT(problems[0].suggestion, HasSubstr("sha256"));
}

TEST_F(SuiteImporter, records_in_an_archive_are_imported_and_read_without_being_unpacked) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"RSN7_SOME_PLC000.AT2", at2("Somewhere, 1/2/1999, Place, 0", 1)},
      {"up/RSN7_SOME_PLC-UP.AT2", at2("Somewhere, 1/2/1999, Place, UP", 3)},
      {"RSN7_SOME_PLC090.AT2", at2("Somewhere, 1/2/1999, Place, 90", 2)},
      {"report.csv",
       "Record Sequence Number,Earthquake Name,Year,Station Name,Magnitude,Rrup (km),Horizontal-1 "
       "Acc. Filename,Horizontal-2 Acc. Filename,Vertical Acc. Filename\n"
       "7,Somewhere,1999,Place,6.5,12,RSN7_SOME_PLC000.AT2,RSN7_SOME_PLC090.AT2,"
       "RSN7_SOME_PLC-UP.AT2\n"},
      {"nested.tar", tar_of({{"a", "b"}})}};
  write("all.tar", tar_of(files));
  ImportOptions options;
  SuiteImport found = import(options);
  if (reasons(found).find("libarchive") != std::string::npos) GTEST_SKIP() << reasons(found);
  EXPECT_THAT(reasons(found), test::states("all.tar#report.csv: is a report of a search; give it "
                                           "with --report",
                                           "all.tar#nested.tar: is an archive in an archive"));
  options.report = folder_.path() / "records/all.tar#report.csv";
  found = import(options);
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(found.records[0].magnitude, 6.5);
  EXPECT_EQ(files_of(found, found.records[0]),
            "RSN7_SOME_PLC000.AT2, RSN7_SOME_PLC090.AT2, RSN7_SOME_PLC-UP.AT2");
  const std::string suite = imported_suite_toml(found, {"s", {}, {}}, folder_.path());
  EXPECT_THAT(suite, HasSubstr("records/all.tar#up/RSN7_SOME_PLC-UP.AT2"));
  const Suite loaded = load(found);
  EXPECT_EQ(loaded.motions[0].vertical_mps2.size(), 200u);
  const auto entries = fs::directory_iterator(folder_.path() / "records");
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
  const auto listed = record_files(folder_.path() / "suite.toml");
  EXPECT_EQ(sha256_of(listed).at(1), sha256_of(std::string_view(files[2].second)));

  auto changed = files;
  changed[2].second = at2("Somewhere, 1/2/1999, Place, 90", 2.5);
  write("all.tar", tar_of(changed));
  EXPECT_THAT(message_of([&] { load(found); }),
              test::states("RSN7_SOME_PLC090.AT2", "is not the file"));
}

TEST_F(SuiteImporter, texts_of_headers_and_names_stay_texts) {
  const std::string hostile = "Quake \"\x1b[2J\"\\\nid = \"x, 1/2/1999, Pl\xff\xe2\x80\xae\"ace";
  std::string source = hostile;
  std::replace(source.begin(), source.end(), '\n', '\r');
  write("RSN7_'$(x)'_\"q\"_000.AT2", at2(source + ", 0", 1));
  write("RSN7_'$(x)'_\"q\"_090.AT2", at2(source + ", 90", 2));
  write("bad\x1b[31m000.txt", column(3));
  const SuiteImport found = import();
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(found.records[0].id, "RSN7____x____q");
  for (const std::string& text : {found.records[0].event, found.records[0].station}) {
    EXPECT_TRUE(std::ranges::all_of(text, [](unsigned char c) { return c >= ' '; })) << text;
    EXPECT_THAT(text, testing::Not(HasSubstr("\u0080")));  // a control character of Latin-1
  }
  EXPECT_THAT(reasons(found), HasSubstr("control characters"));
  const Suite suite = load(found);
  EXPECT_EQ(suite.motions.size(), 1u);
  EXPECT_EQ(suite.motions[0].id, found.records[0].id);
}

TEST_F(SuiteImporter, texts_of_a_report_stay_texts) {
  write_triple();
  std::string report = peer_report;
  report.replace(report.find("Place, at"), 5, "Pl\x16\xb1\\");
  const SuiteImport found = import_with_report(report);
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(found.records[0].station, "Pl\\u0016\\xb1\\, at Town");
  EXPECT_EQ(load(found).motions[0].station, found.records[0].station);
}

TEST_F(SuiteImporter, ids_are_unique) {
  for (const char* folder : {"a", "b"})
    for (const char* direction : {"000", "090"})
      write(fmt::format("{}/X-{}", folder, direction), column(folder[0] + direction[1]));
  const SuiteImport found = import();
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
