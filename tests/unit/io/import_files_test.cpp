// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>

#include "glissade/core/file.hpp"
#include "glissade/io/sha256.hpp"
#include "record_folder.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

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
      {"nested.tar", tar_of({{"a", "b"}, {"b.tar", tar_of({{"c", "d"}})}})}};
  write("all.tar", tar_of(files));
  ImportOptions options;
  SuiteImport found = import(options);
  if (reasons(found).find("libarchive") != std::string::npos) GTEST_SKIP() << reasons(found);
  EXPECT_THAT(reasons(found), test::states("all.tar#report.csv: is a report of a search; give it "
                                           "with --report",
                                           "all.tar#nested.tar/a: ",
                                           "all.tar#nested.tar/b.tar: is an archive in an archive "
                                           "of archives: unpack it"));
  options.report = folder_.path() / "records/all.tar#report.csv";
  found = import(options);
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_EQ(found.records[0].magnitude, 6.5);
  EXPECT_THAT(found.records[0].warnings, testing::IsEmpty());
  EXPECT_THAT(reasons(found), testing::Not(HasSubstr("report")));
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

TEST_F(SuiteImporter, records_of_an_archive_in_an_archive_are_read_where_they_lie) {
  write("all.tar",
        tar_of({{"quake.tar", tar_of({{"RSN7_SOME_PLC000.AT2", at2("A, 1/2/1999, P, 0", 1)},
                                      {"RSN7_SOME_PLC090.AT2", at2("A, 1/2/1999, P, 90", 2)}})}}));
  const SuiteImport found = import();
  if (reasons(found).find("libarchive") != std::string::npos) GTEST_SKIP() << reasons(found);
  ASSERT_EQ(found.records.size(), 1u) << reasons(found);
  EXPECT_THAT(imported_suite_toml(found, {"s", {}, {}}, folder_.path()),
              HasSubstr("records/all.tar#quake.tar/RSN7_SOME_PLC090.AT2"));
  EXPECT_EQ(load(found).motions.at(0).horizontal_mps2[1].size(), 200u);
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

}  // namespace
}  // namespace glissade
