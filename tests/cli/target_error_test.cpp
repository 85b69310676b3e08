// SPDX-License-Identifier: GPL-3.0-or-later
// sampling.target_error: a run that ends when its samples are precise enough.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/killed_run.hpp"
#include "cli/one_run.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class TargetError : public OneRun<target_study> {
 protected:
  static Json run_json(const fs::path& folder) {
    return Json::parse(read_file(folder / "run.json"));
  }
};

TEST_F(TargetError, ends_the_run_before_all_samples_are_run) {
  const Json target = run_json(out()).at("sampling_target");
  const int scrambles = target.at("scrambles");
  EXPECT_GT(scrambles, 8);
  EXPECT_LT(scrambles, target.at("most_scrambles"));
  EXPECT_EQ(target.at("samples"), 8 * scrambles);
  EXPECT_TRUE(target.at("is_reached"));
  EXPECT_LE(target.at("error"), target.at("target_error"));
  EXPECT_THAT(finished_.out, states("Of at most 64", std::to_string(scrambles)));
  EXPECT_THAT(read_file(out() / "report.html"), states("Of at most 64"));
}

TEST_F(TargetError, a_killed_run_goes_on_and_ends_at_the_same_scramble) {
  const fs::path again = folder_->path("again");
  Child child({GLISSADE_PROGRAM, "run", study_, "--out", again.string()});
  ASSERT_TRUE(reaches(child, [&] { return journal_bytes(again) > 40000; }));
  ::kill(child.pid(), SIGKILL);
  child.wait();
  succeeding({"run", "--resume", again.string()});
  EXPECT_GT(run_json(again).at("units_of_earlier_sessions"), 0);
  EXPECT_EQ(run_json(again).at("sampling_target"), run_json(out()).at("sampling_target"));
  EXPECT_TRUE(read_file(again / "results.h5") == read_file(out() / "results.h5"));
}

TEST_F(TargetError, other_analyses_are_of_the_samples_that_were_run) {
  const std::string other = folder_->write("other.toml", target_study() + "[shape]\n");
  const std::string to = folder_->path("shape").string();
  succeeding({"report", (out() / "results.h5").string(), "--study", other, "--out", to});
  EXPECT_EQ(read_file(to + "/tables/sampling_error.csv"),
            read_file(out() / "tables/sampling_error.csv"));
  EXPECT_TRUE(fs::exists(to + "/tables/shape.csv"));
}

}  // namespace
}  // namespace glissade::test
