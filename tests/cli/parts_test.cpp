// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/killed_run.hpp"
#include "cli/one_run.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Three parts of a run beside the whole of it.
class Parts : public OneRun<longer_study> {
 protected:
  ~Parts() override {
    for (int part = 1; part <= 3; ++part) fs::remove_all(folder(part));
    fs::remove_all(merged_);
  }
  static std::string folder(int part) { return folder_->path(std::to_string(part)).string(); }
  static std::vector<std::string> part_command(int part, const std::string& study = study_) {
    return {"run", study, "--out", folder(part), "--part", std::to_string(part) + "/3"};
  }
  static void run_part(int part, const std::string& study = study_) {
    const Finished child = succeeding(part_command(part, study));
    EXPECT_THAT(child.out, states("glissade merge"));
    EXPECT_FALSE(fs::exists(folder(part) + "/results.h5"));
  }
  static void run_parts(const std::vector<int>& parts) {
    for (const int part : parts) run_part(part);
  }
  Finished merge(const std::vector<int>& parts, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"merge"};
    for (const int part : parts) arguments.push_back(folder(part));
    arguments.insert(arguments.end(), {"--out", merged_});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  void expect_merged(const Finished& child) const {
    ASSERT_EQ(child.status, 0) << child.err;
    EXPECT_TRUE(read_file(merged_ + "/results.h5") == read_file(out() / "results.h5"));
    EXPECT_FALSE(fs::exists(merged_ + "/journal"));
  }

  std::string merged_ = folder_->path("merged").string();
};

TEST_F(Parts, a_merge_that_was_killed_while_it_copied_is_repeated) {
  run_parts({1, 2, 3});
  fs::create_directories(merged_ + "/journal");
  folder_->write("merged/journal/lock", "");
  folder_->write("merged/journal/0-1.units", "half of a unit");
  expect_merged(merge({1, 2, 3}));
}

TEST_F(Parts, a_part_that_was_killed_goes_on_and_the_merged_run_has_the_bits_of_the_whole) {
  run_parts({1, 3});
  std::vector<std::string> second = part_command(2);
  second.insert(second.begin(), GLISSADE_PROGRAM);
  Child child(second);
  ASSERT_TRUE(reaches(child, [&] { return some_units_are_done(folder(2)); }));
  ::kill(child.pid(), SIGKILL);
  child.wait();
  expect_refused(merge({1, 2, 3}),
                 {folder(2), "is not finished", "glissade run --resume " + folder(2)});
  EXPECT_FALSE(fs::exists(merged_));
  const Finished resumed = succeeding({"run", "--resume", folder(2)});
  EXPECT_THAT(resumed.out, states("2 of 3"));

  expect_merged(merge({3, 1, 2}));
  const Json json = Json::parse(read_file(merged_ + "/run.json"));
  std::uint64_t units = 0;
  for (int part = 1; part <= 3; ++part)
    units +=
        Json::parse(read_file(folder(part) + "/run.json")).at("units_done").get<std::uint64_t>();
  EXPECT_EQ(json.at("units_of_earlier_sessions"), units);  // nothing was computed again
}

TEST_F(Parts, a_unit_that_is_damaged_in_a_part_is_computed_again) {
  run_parts({1, 2, 3});
  std::string bytes = read_file(folder(1) + "/journal/0-1.units");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  folder_->write("1/journal/0-1.units", bytes);
  const Finished child = merge({1, 2, 3});
  EXPECT_THAT(child.out, states("not whole"));
  expect_merged(child);
}

TEST_F(Parts, parts_that_are_not_those_of_one_run_are_refused_with_each_difference) {
  run_part(1);
  folder_->write("2", "a file");
  expect_refused(merge({1, 2, 3}), {folder(2) + ": holds no run", folder(3) + ": holds no run"});
  expect_refused(merge({1}), {"part 2 of 3 is missing", "part 3 of 3 is missing", "--part 3/3"});
  expect_refused(merge({1, 1}), {folder(1), "is part 1 of 3, as " + folder(1) + " is"});
  fs::remove(folder(2));
  const std::string other =
      folder_->write("other.toml", replaced(longer_study(), "seed = 7", "seed = 8"));
  for (const int part : {2, 3}) run_part(part, other);
  expect_refused(merge({1, 2, 3}), {"small.toml:3", folder(2), folder(3), "seed = 7", "seed = 8"});
  EXPECT_FALSE(fs::exists(merged_));
}

TEST_F(Parts, a_folder_that_is_taken_is_refused) {
  run_parts({1, 2, 3});
  expect_refused(run_program(part_command(1)), {"a part of one", "glissade run --resume"});
  fs::create_directory(merged_);
  const std::string note = folder_->write("merged/notes.txt", "mine");
  expect_refused(merge({1, 2, 3}), {"--out", "holds a run or other files"});
  expect_refused(
      run_program({"merge", folder(1), folder(2), folder(3), "--out", folder(3), "--overwrite"}),
      {"--out", "is one of the parts"});
  EXPECT_EQ(read_file(note), "mine");
  expect_merged(merge({1, 2, 3}, {"--overwrite"}));
}

TEST_F(Parts, a_division_that_cannot_be_is_refused) {
  const std::string target = folder_->write("target.toml", target_study());
  expect_refused(run_program(part_command(1, target)), {"--part", "sampling.target_error"});
  for (const char* part : {"0/3", "4/3", "2", "2/", "/3", "a/b", "1/3x", "-1/3"})
    expect_refused(run_program({"run", study_, "--out", folder(1), "--part", part}), {"--part"});
  EXPECT_FALSE(fs::exists(folder(1)));
  const std::string few = folder_->write("few.toml", small_chart());
  expect_refused(run_program({"run", few, "--out", folder(1), "--part", "1000000/1000000"}),
                 {"--part", "units of work"});
  EXPECT_FALSE(fs::exists(folder(1)));
}

}  // namespace
}  // namespace glissade::test
