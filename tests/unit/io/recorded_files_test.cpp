// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "glissade/io/record_file.hpp"
#include "problems.hpp"
#include "recorded_motions.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

class Recorded : public RecordedMotions {
 protected:
  Record read(const std::string& name, const RecordFileOptions& options = {}) const {
    return read_record(folder_ / name, options);
  }
  std::string error(const std::string& name, const RecordFileOptions& options = {}) const {
    return message_of([&] { read(name, options); });
  }
};

struct Expected {
  const char* file;
  std::size_t samples;
  double dt_s;
  double pga_g;
};

// npts, dt and PGA (4 decimals) as in records/INDEX.csv, which was made with other readers.
TEST_F(Recorded, at2_files_of_all_header_variants_give_the_indexed_counts_steps_and_peaks) {
  const std::vector<Expected> files = {
      {"formats/peer_at2_nga_west2/RSN763_LOMAP_GIL067.AT2", 7999, 0.005, 0.3585},
      {"formats/peer_at2_nga_east/RSN10590_ComalTX11-10-20_IU.CCM.BH1.00.AT2", 15306, 0.05, 0.0},
      {"formats/peer_at2_old/A-BPL160.AT2", 7996, 0.005, 0.1607},
      {"formats/peer_at2_old/ARL360.at2", 2000, 0.02, 0.3081},
      {"formats/peer_at2_old/CPPBEAS.AT2", 3238, 0.01, 0.0668},
      {"formats/peer_at2_old/HWA002-N.AT2", 20000, 0.004, 0.0942},
      {"formats/peer_at2_old/ROC-NS.AT2", 8192, 0.00244, 0.0295},
      {"formats/peer_at2_old/TCU122-N.AT2", 18000, 0.005, 0.2606},
      {"formats/peer_at2_old/elCentro.AT2", 1559, 0.02, 0.3188},
      {"formats/peer_at2_reqpy_written/RSN175_IMPVALL.H_H-E12140_ASCE7_Matched.AT2", 7814, 0.005,
       0.6555},
      {"walters2012_table3/bolu_RSN1602/old_header/BOL090.AT2", 5590, 0.01, 0.8224},
      {"walters2012_table3/gukasian_RSN730/RSN730_SPITAK_GUK000.AT2", 2000, 0.01, 0.2003},
      {"walters2012_table3/sylmar_conv_east_RSN1085/RSN1085_NORTHR_SCE011.AT2", 10938, 0.005,
       0.8527},
      {"walters2012_table3/tcu122_RSN1546/reqpy/RSN1546_CHICHI_TCU122-N.AT2", 18000, 0.005, 0.2609},
      {"fema_p695_far_field/RSN1633_MANJIL_ABBAR--T.AT2", 2300, 0.02, 0.4969},
      {"fema_p695_far_field/RSN848_LANDERS_CLW-TR.AT2", 7180, 0.0039, 0.4172},
  };
  for (const Expected& expected : files) {
    const Record record = read(expected.file);
    EXPECT_EQ(record.acceleration_mps2.size(), expected.samples) << expected.file;
    EXPECT_EQ(record.dt_s, expected.dt_s) << expected.file;
    EXPECT_NEAR(peak_g(record.acceleration_mps2), expected.pga_g, 5.1e-5) << expected.file;
  }
}

TEST_F(Recorded, at2_with_npts_and_dt_before_their_names_is_read) {
  const Record record = read("formats/peer_at2_old/Oak_2_50_5_FN.AT2");
  EXPECT_EQ(record.acceleration_mps2.size(), 7997u);
  EXPECT_EQ(record.dt_s, 0.005);
  EXPECT_DOUBLE_EQ(record.acceleration_mps2.back(),
                   0.000898 * standard_gravity_mps2);  // the file's last value
}

TEST_F(Recorded, every_at2_file_is_read_and_every_vt2_file_is_refused_as_velocity) {
  std::size_t read_files = 0, refused = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".AT2" || extension == ".at2") {
      EXPECT_NO_THROW(read_record(entry.path())) << entry.path();
      ++read_files;
    } else if (extension == ".VT2") {
      EXPECT_THAT(message_of([&] { read_record(entry.path()); }), test::states("velocity"));
      ++refused;
    }
  }
  EXPECT_GE(read_files, 80u);  // 62 + 1 of FEMA P-695, 14 of Walters Table 3 and the format samples
  EXPECT_GE(refused, 9u);
}

TEST_F(Recorded, text_files_of_one_and_two_columns_are_read) {
  const std::vector<Expected> with_time = {
      {"formats/csv_time_accel_commented/Coyote_Lake_1979_G02-050.csv", 5070, 0.005, 0.2109},
      {"formats/csv_time_accel_commented/Duzce_1999_375-090.csv", 3077, 0.01, 0.5137},
      {"formats/csv_time_accel_commented/Northridge_1994_PAC-175.csv", 1000, 0.02, 0.4153},
  };
  for (const Expected& expected : with_time) {
    const Record record = read(expected.file, {.dt_s = {}, .units = AccelerationUnits::g});
    EXPECT_EQ(record.acceleration_mps2.size(), expected.samples) << expected.file;
    EXPECT_EQ(record.dt_s, expected.dt_s) << expected.file;
    EXPECT_NEAR(peak_g(record.acceleration_mps2), expected.pga_g, 5.1e-5) << expected.file;
  }
  const RecordFileOptions mps2{.dt_s = {}, .units = AccelerationUnits::mps2},
      gal{.dt_s = {}, .units = AccelerationUnits::cmps2};
  EXPECT_EQ(read("formats/plain_two_column/Kocaeli.dat", mps2).dt_s, 0.02);
  EXPECT_EQ(read("formats/plain_two_column/Spitak.dat", mps2).acceleration_mps2.size(), 906u);
  EXPECT_EQ(read("formats/plain_two_column/Christchurch2011HVPS_UP.dat", mps2).dt_s, 0.005);
  EXPECT_NEAR(peak_g(read("formats/plain_two_column/CHV1-20140203E.txt", gal).acceleration_mps2),
              7.4111 / standard_gravity_mps2, 1e-4);
  EXPECT_THAT(error("formats/plain_two_column/CHV1-20140203E.txt"), test::states("units"));
  const RecordFileOptions slammer{.dt_s = 0.005, .units = AccelerationUnits::g};
  EXPECT_NEAR(peak_g(read("walters2012_table3/saratoga_aloha_RSN802/slammer/STG-000", slammer)
                         .acceleration_mps2),
              0.5125, 5.1e-5);
  EXPECT_EQ(read("formats/opensees_tcl_and_plain/eq_120111.tcl", slammer).acceleration_mps2.size(),
            2999u);
  EXPECT_EQ(read("formats/peer_at2_reqpy_written/RSN175_IMPVALL.H_H-E12140_ASCE7_Matched_1col.txt",
                 slammer)
                .acceleration_mps2.size(),
            7814u);
}

TEST_F(Recorded, walters_table_3_loads_with_its_factors_and_a_common_clock) {
  const Suite suite = load("walters_table3.toml");
  ASSERT_EQ(suite.motions.size(), 7u);
  const std::vector<double> scale = {4.0, 2.5, 3.8, 1.4, 4.0, 3.5, 1.4},
                            distance_km = {36.2, 8.5, 23.6, 5.2, 10.9, 9.4, 12.0};
  for (std::size_t i = 0; i < 7; ++i) {  // Walters et al. (2012), Table 3
    EXPECT_EQ(suite.motions[i].scale, scale[i]);
    EXPECT_EQ(suite.motions[i].distance_km, distance_km[i]);
    EXPECT_EQ(suite.motions[i].horizontal_mps2[0].size(),
              suite.motions[i].horizontal_mps2[1].size());
  }
  const auto with_vertical =
      std::count_if(suite.motions.begin(), suite.motions.end(),
                    [](const Motion& m) { return !m.vertical_mps2.empty(); });
  EXPECT_EQ(with_vertical, 4);
  ASSERT_TRUE(suite.target);
  EXPECT_EQ(suite.target->ss_g, 1.95);
  EXPECT_EQ(suite.target->site_classes.size(), 4u);

  // Saratoga: kallioras' H2 is minus STG-000 on one clock for all components, so the start given
  // must line them up.
  const Record h2 =
      read("walters2012_table3/saratoga_aloha_RSN802/ccby_kallioras/19891018_0004_58065_H2.acc",
           {.dt_s = 0.005, .units = AccelerationUnits::mps2});
  const auto& first = suite.motions[1].horizontal_mps2[0];
  ASSERT_EQ(first.size(), h2.acceleration_mps2.size());
  for (std::size_t i = 85; i < 85 + 7671; ++i)
    EXPECT_NEAR(first[i], -h2.acceleration_mps2[i], 2e-5) << i;
}

TEST_F(Recorded, fema_p695_far_field_loads_with_twenty_verticals) {
  const Suite suite = load("fema_p695_far_field.toml");
  ASSERT_EQ(suite.motions.size(), 22u);
  std::size_t verticals = 0;
  for (const Motion& motion : suite.motions) {
    EXPECT_EQ(motion.scale, 1.0) << motion.id;
    EXPECT_GT(motion.vs30_mps, 150.0) << motion.id;
    EXPECT_GT(peak_g(motion.horizontal_mps2[0]), 0.1) << motion.id;
    EXPECT_FALSE(motion.horizontal_mps2[1].empty()) << motion.id;
    verticals += motion.vertical_mps2.empty() ? 0 : 1;
    EXPECT_EQ(motion.dt_s == 1.0 / 256, motion.station == "Coolwater") << motion.id;
  }
  EXPECT_EQ(verticals, 20u);
}

}  // namespace
}  // namespace glissade
