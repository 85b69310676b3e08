// SPDX-License-Identifier: GPL-3.0-or-later
#include "record_folder.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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
              test::states("give it with --report", "1 of its records has no file here: RSN9\n"));
  const Suite suite = load(found);
  EXPECT_EQ(suite.motions[0].scale, 1.7);
  EXPECT_THAT(suite.motions[0].notes, IsEmpty());
}

/// NGA-West2 drops from its table what was searched and is not in the data base.
TEST_F(SuiteImporter, records_that_were_searched_and_have_no_file_are_named_in_one_line) {
  write_triple();
  write("RSN12_SOME_OTH000.AT2", at2("Somewhere, 1/2/1999, Other, 0", 4));
  EXPECT_THAT(reasons(import_with_report(
                  std::string("Record Sequence Number:, 7, 829, 12, 829, 9\n") + peer_report)),
              HasSubstr("2 of its records have no file here: RSN829, RSN9\n"));
}

TEST_F(SuiteImporter, a_name_in_a_report_may_hold_quotes_and_stand_after_a_tab) {
  write_triple();
  for (const char* station : {"\"The \"\"Old\"\", Town\"", "\t\"Place, at Town\""}) {
    std::string report = peer_report;
    const std::string usual = "\"Place, at Town\"";
    report.replace(report.find(usual), usual.size(), station);
    const SuiteImport found = import_with_report(report);
    ASSERT_EQ(found.records.size(), 1u) << station << reasons(found);
    EXPECT_EQ(found.records[0].magnitude, 6.5);
    EXPECT_THAT(found.records[0].station, HasSubstr(", "));
  }
}

TEST_F(SuiteImporter, a_report_that_does_not_state_unscaled_files_is_warned_of) {
  write_triple();
  std::string report = peer_report;
  report.replace(report.find("UNSCALED"), 8, "SCALED");
  EXPECT_THAT(import_with_report(report).warnings, ElementsAre(HasSubstr("factors")));
}

std::string replaced_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// As a spreadsheet writes it again: quotes in names, cells in every line of text; or semicolons
/// and decimal commas.
std::vector<std::string> saved_again(const std::string& report) {
  const std::string footer = "\n These records are UNSCALED, AS RECORDED";
  const std::string quoted =
      replaced_all(replaced_all(report, " \"Friuli_ Italy-01\"", "\" \"\"Friuli_ Italy-01\"\"\""),
                   footer, std::string(15, ',') + footer + std::string(15, ','));
  std::string semicolons =
      replaced_all(replaced_all(report, "\"Place, at Town\"", "Place"), ", ", ";");
  for (const char* number : {"6.5", "15.82", "1.7"})
    semicolons = replaced_all(semicolons, number, replaced_all(number, ".", ","));
  return {quoted, semicolons};
}

TEST_F(SuiteImporter, a_report_that_a_spreadsheet_saved_again_is_read_as_before) {
  write_triple();
  for (const std::string& report : saved_again(peer_report)) {
    const SuiteImport found = import_with_report(report);
    ASSERT_EQ(found.records.size(), 1u) << report << reasons(found);
    EXPECT_EQ(found.records[0].event, "Friuli, Italy-01 1976");
    EXPECT_EQ(found.records[0].magnitude, 6.5);
    EXPECT_EQ(found.records[0].distance_km, 15.82);
    EXPECT_EQ(found.records[0].scale, 1.7);
    EXPECT_THAT(reasons(found), testing::Not(HasSubstr("UNSCALED")));
    EXPECT_THAT(reasons(found), HasSubstr("1 of its records has no file here: RSN9\n"));
  }
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

TEST_F(SuiteImporter, texts_of_a_report_stay_texts) {
  write_triple();
  std::string report = peer_report;
  report.replace(report.find("Place, at"), 5, "Pl\x16\xb1\\");
  const SuiteImport found = import_with_report(report);
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(found.records[0].station, "Pl\\u0016\u00b1\\, at Town");
  EXPECT_EQ(load(found).motions[0].station, found.records[0].station);
}

}  // namespace
}  // namespace glissade
