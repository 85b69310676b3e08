// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded motions as they are downloaded, and the table of what is read of the samples.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "record_folder.hpp"
#include "recorded_motions.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

class RecordedImport : public RecordedMotions {
 protected:
  void TearDown() override { ::setenv("GLISSADE_RECORDS", folder_.c_str(), 1); }
};

std::vector<std::string> ids_of(const SuiteImport& found) {
  std::vector<std::string> ids;
  for (const ImportedRecord& record : found.records) ids.push_back(record.id);
  return ids;
}

// Two to four files each of PEER's, Japan's, Italy's, Turkey's ... data bases in one folder.
TEST_F(RecordedImport, forty_mixed_files_become_a_suite_by_one_call) {
  const TemporaryFolder folder;
  const fs::path in = folder.path() / "in";
  fs::create_directories(in / "copies");
  int files = 0;
  const auto take = [&](const std::string& name) {
    fs::copy_file(folder_ / name, in / fs::path(name).filename());
    ++files;
  };
  for (const char* name :
       {"RSN1111_KOBE_NIS-UP", "RSN1111_KOBE_NIS000", "RSN1111_KOBE_NIS090",
        "RSN725_SUPER.B_B-POE270", "RSN725_SUPER.B_B-POE360", "RSN169_IMPVALL.H_H-DLT262",
        "RSN169_IMPVALL.H_H-DLT352", "RSN169_IMPVALL.H_H-DLTDWN"})
    take(std::string("fema_p695_far_field/") + name + ".AT2");
  for (const char* name : {"peer_at2_nga_west2/RSN763_LOMAP_GIL067.AT2",
                           "peer_at2_nga_west2/RSN763_LOMAP_GIL337.AT2",
                           "knet/AOM0170806140843.EW",
                           "knet/AOM0170806140843.NS",
                           "knet/CHB0021412312349.EW",
                           "knet/CHB0021412312349.NS",
                           "kiknet/NGNH311106302345.EW2",
                           "kiknet/NGNH311106302345.NS1",
                           "kiknet/NGNH311106302345.UD1",
                           "kiknet/NGNH311106302345.UD2",
                           "esm_asc/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC",
                           "esm_asc/HI.ARS1..HNN.D.20190728.160908.C.ACC.ASC",
                           "afad_tadas_asc/20230206011732_3116_mp_Acc_E.asc",
                           "afad_tadas_asc/20230206011732_3116_mp_Acc_N.asc",
                           "afad_nsmn_txt/20170720223109_4819.txt",
                           "bhrc_iran/5522-1.V1",
                           "cosmos_v1_2/Cosmos12TimeSeriesTest.v1",
                           "csmip_dmg_v1_v2_v3/CE89146.V2",
                           "csmip_dmg_v1_v2_v3/CE89146.V3",
                           "cwb_taiwan/2-ECU.dat",
                           "esd_cor_acc/16882_H1.cor.acc",
                           "esd_cor_acc/16882_H2.cor.acc",
                           "esd_cor_acc/16882_V.cor.acc",
                           "geonet_nz/20180212_211557_WPWS_20.V2A",
                           "smc_usgs/0111a.smc",
                           "usc_dat/017m30cc.y0a",
                           "sac/20190706031952.CJ.T001230.HNE.sac",
                           "csv_time_accel_commented/Coyote_Lake_1979_G02-050.csv",
                           "miniseed/gaps.mseed"})
    take(std::string("formats/") + name);
  take("walters2012_table3/bolu_RSN1602/RSN1602_DUZCE_BOL000.VT2");
  fs::copy_file(in / "RSN1111_KOBE_NIS-UP.AT2", in / "copies/again.AT2"), ++files;
  fs::copy_file(folder_ / "README.md", in / "README.md"), ++files;
  ASSERT_EQ(files, 40);

  ImportOptions options;
  options.inputs = {in};
  options.report = folder_ / "fema_p695_far_field/_SearchResults.csv";
  const SuiteImport found = import_suite(options);
  EXPECT_THAT(ids_of(found),
              testing::ElementsAre(
                  "16882.cor", "2-ECU", "20170720223109_4819", "20180212_211557_WPWS_20",
                  "20230206011732_3116_mp_Acc", "5522-1", "AOM0170806140843", "CE89146",
                  "CHB0021412312349", "HI.ARS1.D.20190728.160908.C.ACC", "RSN1111_KOBE_NIS",
                  "RSN169_IMPVALL.H_H-DLT", "RSN725_SUPER.B_B-POE", "RSN763_LOMAP_GIL"));
  EXPECT_THAT(reasons(found),
              test::states(
                  "README.md", "copies/again.AT2: a duplicate: the same bytes as",
                  "RSN1602_DUZCE_BOL000.VT2: units 'cm/s': this is a velocity file", "spectra (V3)",
                  "NGNH311106302345.EW2: one horizontal", "NGNH311106302345.UD2: one horizontal",
                  "NGNH311106302345.NS1: one horizontal", "its name suggests 050",
                  "'building location description' of a structure", "0111a.smc: one horizontal",
                  "SAC files do not state their unit", "the time goes from", "has a gap",
                  "19 of its records have no file here", "RSN68"));
  const auto record = [&](const std::string& id) {
    return *std::ranges::find(found.records, id, &ImportedRecord::id);
  };
  const ImportedRecord kobe = record("RSN1111_KOBE_NIS"), aomori = record("AOM0170806140843"),
                       pazarcik = record("20230206011732_3116_mp_Acc");
  EXPECT_EQ(kobe.event, "Kobe, Japan 1995");
  EXPECT_EQ(kobe.station, "Nishi-Akashi");
  EXPECT_EQ(kobe.magnitude, 6.9);
  EXPECT_EQ(kobe.distance_km, 7.08);
  EXPECT_EQ(kobe.vs30_mps, 609.0);
  EXPECT_EQ(kobe.scale, 1.0);
  EXPECT_EQ(aomori.magnitude_kind, "MJMA");
  // Of 39.028 N, 140.880 E and 40.6363 N, 139.9284 E, by the formula of haversines.
  EXPECT_NEAR(aomori.distance_km, 196.4, 0.1);
  EXPECT_EQ(pazarcik.magnitude, 7.7);
  EXPECT_EQ(pazarcik.distance_km, 105.38);
  EXPECT_EQ(pazarcik.distance_kind, "epicentral");
  EXPECT_EQ(pazarcik.vs30_mps, 870.0);
  EXPECT_THAT(record("RSN169_IMPVALL.H_H-DLT").warnings,
              testing::ElementsAre(testing::HasSubstr("is named down")));

  const fs::path suite =
      folder.write("suite.toml", imported_suite_toml(found, {"forty", {}, {}}, folder.path()));
  const TemporaryFolder elsewhere;
  fs::copy(folder.path(), elsewhere.path(),
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  fs::remove_all(folder.path());
  ::setenv("GLISSADE_RECORDS", "/nowhere", 1);  // no other copy is found
  EXPECT_EQ(load_suite(elsewhere.path() / "suite.toml").motions.size(), 14u);
}

TEST_F(RecordedImport, a_folder_and_report_of_peer_become_the_suite_of_fema_p695) {
  ImportOptions options;
  options.inputs = {folder_ / "fema_p695_far_field"};
  options.report = folder_ / "fema_p695_far_field/_SearchResults.csv";
  const SuiteImport found = import_suite(options);
  EXPECT_EQ(found.records.size(), 21u);
  // Rio Dell, without units and step, and RSN829 of the report
  EXPECT_EQ(found.left_out.size(), 3u) << reasons(found);
  std::size_t verticals = 0;
  for (const ImportedRecord& record : found.records) {
    verticals += record.components[2] ? 1 : 0;
    EXPECT_EQ(record.distance_kind, "rupture") << record.id;
    EXPECT_GT(record.vs30_mps, 0.0) << record.id;
  }
  EXPECT_EQ(verticals, 20u);
}

/// Of a folder of samples: components of one step and unit with their PGA, and how many files are
/// not read.
struct SampleRows {
  std::map<std::string, std::string> peaks;  ///< by what stands behind them in the row
  std::size_t unread = 0;
  std::string reason;  ///< of the first
};

void add_sample_file(const fs::path& file, SampleRows& rows) {
  ImportOptions options;
  options.inputs = {file};
  options.missing.units_if_not_stated = AccelerationUnits::cmps2;
  SuiteImport found = import_suite(options);
  if (found.components.empty()) {  // states no step, or is refused for another reason
    options.missing.dt_s = 0.01;
    found = import_suite(options);
  }
  if (found.components.empty() && ++rows.unread == 1)
    rows.reason = found.left_out.front().reason.substr(0, found.left_out.front().reason.find(';'));
  for (const FoundComponent& c : found.components) {
    const std::string& unit = c.header.unit;
    const auto& processed = c.header.is_processed;
    std::string& peaks =
        rows.peaks[fmt::format("{:g}{},{},{}", c.dt_s, c.stated_dt_s ? " given" : "",
                               unit.empty()                   ? "given"
                               : unit.starts_with("counts x") ? "counts x factor"
                                                              : unit,
                               !processed   ? "-"
                               : *processed ? "yes"
                                            : "no")];
    peaks += fmt::format("{}{}: {:.3g}", peaks.empty() ? "" : ", ",
                         c.header.direction.empty() ? "?" : c.header.direction, c.pga_g);
  }
}

std::string table_of_samples(const fs::path& samples) {
  std::map<std::string, std::vector<fs::path>> folders;
  for (const auto& entry : fs::recursive_directory_iterator(samples))
    if (entry.is_regular_file())
      folders[entry.path().parent_path().filename().string()].push_back(entry.path());
  const auto quoted = [](const std::string& cell) {
    return cell.find(',') == std::string::npos ? cell : fmt::format("\"{}\"", cell);
  };
  std::string table = "folder,component: PGA in g,step in s,unit,processed\n";
  for (auto& [folder, files] : folders) {
    std::ranges::sort(files);
    SampleRows rows;
    for (const fs::path& file : files) add_sample_file(file, rows);
    for (const auto& [rest, peaks] : rows.peaks)
      table += fmt::format("{},{},{}\n", folder, quoted(peaks), rest);
    if (rows.unread > 0)
      table += fmt::format("{},{},,,\n", folder,
                           quoted(fmt::format("{} not read: {}", rows.unread, rows.reason)));
  }
  return table;
}

TEST_F(RecordedImport, the_table_of_samples_is_what_is_read) {
  const fs::path committed = GLISSADE_SOURCE_DIR "/tests/unit/io/recorded_samples.csv";
  const std::string table = table_of_samples(folder_ / "formats");
  std::ifstream in(committed);
  if (std::string{std::istreambuf_iterator<char>(in), {}} == table) return;
  const fs::path made = fs::temp_directory_path() / "recorded_samples.csv";
  std::ofstream(made) << table;
  FAIL() << committed << " has another table: what is read is in " << made;
}

}  // namespace
}  // namespace glissade
