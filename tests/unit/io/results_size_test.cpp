// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <hdf5.h>

#include "glissade/io/results_file.hpp"
#include "temporary_folder.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

/// Bytes of all datasets in a group of a results file and below it.
double stored_bytes(const std::filesystem::path& file, const char* group) {
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  double bytes = 0.0;
  const auto add = [](hid_t root, const char* name, const H5O_info_t* info, void* sum) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    const hid_t dataset = H5Dopen2(root, name, H5P_DEFAULT);
    *static_cast<double*>(sum) += static_cast<double>(H5Dget_storage_size(dataset));
    return H5Dclose(dataset);
  };
  H5Ovisit_by_name2(id, group, H5_INDEX_NAME, H5_ITER_NATIVE, add, &bytes, H5O_INFO_BASIC,
                    H5P_DEFAULT);
  H5Fclose(id);
  return bytes;
}

/// Two samples; peak_vector_m and residuals, tips and crossings are kept where the study is so and
/// has them.
StudyConfig study_that_keeps(SlidingAxes axes, bool tips, bool crossings) {
  StudyConfig config = test::small_config();
  config.model.axes = axes;
  config.intensity.levels = {0.5, 2.0};
  config.sampling.samples = 2;
  config.friction.values = {FrictionValue::as_drawn};
  config.standards.compare.clear();
  if (tips) config.tipping = RigidBase{.centre_of_mass_height_m = 0.5, .width_m = 0.6};
  config.impact = crossings;
  return config;
}

TEST(bytes_of_a_study, are_those_of_the_histories_in_the_results_file) {
  const TemporaryFolder folder;
  std::vector<double> predicted;
  for (const auto& config : {study_that_keeps(SlidingAxes::one, false, false),
                             study_that_keeps(SlidingAxes::one, true, false),
                             study_that_keeps(SlidingAxes::two, false, false),
                             study_that_keeps(SlidingAxes::two, false, true)}) {
    const Plan plan = test::small_plan(config);
    const std::filesystem::path file =
        folder.path() / ("results" + std::to_string(predicted.size()) + ".h5");
    write_results(file, test::run(plan));
    const std::size_t records = plan.records.size(), cases = plan.cases.size();
    // By two numbers of records, without what is of a case.
    predicted.push_back(bytes_of(config, 2 * records, cases) - bytes_of(config, records, cases));
    EXPECT_EQ(predicted.back(), stored_bytes(file, "histories")) << predicted.size();
    const double of_cases = bytes_of(config, 0, cases);
    EXPECT_NEAR(of_cases, stored_bytes(file, "cases"), 0.1 * of_cases);
  }
  EXPECT_TRUE(std::ranges::is_sorted(predicted, std::less_equal<>()));  // each keeps more
}

}  // namespace
}  // namespace glissade
