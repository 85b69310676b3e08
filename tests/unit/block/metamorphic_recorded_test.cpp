// SPDX-License-Identifier: GPL-3.0-or-later
// The relations of metamorphic.hpp over every recorded motion there is.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "glissade/core/error.hpp"
#include "glissade/io/record_file.hpp"
#include "unit/block/metamorphic.hpp"

namespace glissade {
namespace metamorphic_recorded_test {

namespace fs = std::filesystem;
using test::Scene;

fs::path records_folder() {
  const char* named = std::getenv("GLISSADE_RECORDS");
  return named != nullptr ? fs::path(named) : fs::path(GLISSADE_SOURCE_DIR "/../shared/records");
}

/// The acceleration in a file, at 0.005 s in g if it states none; none if it has no
/// acceleration.
std::vector<double> read_samples(const fs::path& file, double& dt_s) {
  constexpr auto g = AccelerationUnits::g;
  const std::vector<RecordFileOptions> guesses = {
      {.dt_s = {}, .units = {}, .units_if_not_stated = g},
      {.dt_s = 0.005, .units = {}, .units_if_not_stated = g}};
  for (const RecordFileOptions& options : guesses) {
    try {
      const Record record = read_record(file, options);
      dt_s = record.dt_s;
      return record.acceleration_mps2.copy();
    } catch (const InputError&) {
    }
  }
  return {};
}

/// Every readable file, scaled to a peak of 0.9 g, on four roofs in turn.
std::vector<Scene> recorded_scenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(records_folder()))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  const std::vector<Block> blocks = {
      {0.3, 0.0}, {0.3, 4 * rad_per_deg}, {0.1, 0.0}, {0.5, -7 * rad_per_deg}};
  std::vector<Scene> scenes;
  for (const fs::path& file : files) {
    Scene scene{file.filename().string()};
    scene.a = read_samples(file, scene.dt_s);
    double peak_mps2 = 0.0;
    for (const double x : scene.a) peak_mps2 = std::max(peak_mps2, std::abs(x));
    if (peak_mps2 == 0.0) continue;
    for (double& x : scene.a) x *= 0.9 * standard_gravity_mps2 / peak_mps2;
    scene.a.insert(scene.a.begin(), 0.0);
    scene.block = blocks[scenes.size() % blocks.size()];
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

class RecordedMetamorphic : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(records_folder()))
      GTEST_SKIP() << "no recorded motions: set GLISSADE_RECORDS, or put them in ../shared/records";
  }
  template <class Relation>
  static void expect_of_all(const Relation& relation) {
    const std::vector<Scene> scenes = recorded_scenes();
    const int slipped = over(scenes, relation);
    EXPECT_GE(scenes.size(), 80u);  // as counted in recorded_files_test.cpp
    EXPECT_GT(slipped, static_cast<int>(scenes.size() * 9 / 10));
  }
};

TEST_F(RecordedMetamorphic, slip_scales_with_the_whole_acceleration_field) {
  expect_of_all(test::expect_similitude);
}
TEST_F(RecordedMetamorphic, mirroring_motion_and_slope_mirrors_the_slip) {
  expect_of_all(test::expect_mirror);
}
TEST_F(RecordedMetamorphic, inserted_samples_change_nothing_but_rounding) {
  expect_of_all(test::expect_inserted_samples_change_nothing);
}
TEST_F(RecordedMetamorphic, zeros_before_and_after_change_not_a_bit) {
  expect_of_all(test::expect_padding_and_shift_change_nothing);
}
TEST_F(RecordedMetamorphic, slip_scales_with_the_square_of_the_clock) {
  expect_of_all(test::expect_clock_scaling);
}
TEST_F(RecordedMetamorphic, one_way_slip_is_never_behind_two_way_slip) {
  expect_of_all(test::expect_one_way_beyond_two_way);
}

}  // namespace metamorphic_recorded_test
}  // namespace glissade
