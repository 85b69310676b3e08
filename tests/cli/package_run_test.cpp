// SPDX-License-Identifier: GPL-3.0-or-later
// The command that makes a calculation package: what it refuses, stops, resumes and checks.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/killed_run.hpp"
#include "cli/one_package.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

using testing::Not;

TEST_F(Package, a_stopped_calculation_goes_on_to_the_same_package) {
  const WithoutWeasyprint path;
  const fs::path other = folder_->path("stopped");
  Child child({GLISSADE_PROGRAM, "clearance", project_file, "--out", other.string()});
  ASSERT_TRUE(reaches(child, [&] { return some_units_are_done(other / "demand"); }));
  folder_->write("stopped/stop", "");
  const Finished stopped = child.wait();
  ASSERT_EQ(stopped.status, 75);
  EXPECT_FALSE(fs::exists(other / "stop"));
  const std::string command = "clearance --resume " + other.string();
  EXPECT_THAT(stopped.err, states(command));
  expect_refused(run_program({"clearance", project_file, "--out", other.string()}), {command});
  succeeding({"clearance", "--resume", other.string()});
  EXPECT_EQ(read_file(other / "package.json"), read_file(out() / "package.json"));
  EXPECT_EQ(run_program({"clearance", "--resume", other.string()}).status, 0);  // is finished
}

TEST_F(Package, is_finished_only_where_its_results_are_whole_and_of_the_project) {
  const fs::path other = folder_->path("finished");
  fs::copy(out(), other, fs::copy_options::recursive);
  const std::vector<std::string> resume = {"clearance", "--resume", other.string()};
  const WithoutWeasyprint path;
  folder_->write("finished/package.html", "");
  EXPECT_EQ(run_program(resume).status, 0);
  EXPECT_EQ(read_file(other / "package.html"), read_file(out() / "package.html"));
  fs::remove(other / "demand/results.h5");
  EXPECT_EQ(run_program(resume).status, 0);
  EXPECT_TRUE(read_file(other / "demand/results.h5") == read_file(out() / "demand/results.h5"));
  fs::remove_all(other);
}

TEST_F(Package, begins_in_a_folder_in_which_another_was_killed_at_its_begin) {
  folder_->write("killed/run.json.partial.7", "{");
  fs::create_directory(folder_->path("killed/journal"));
  folder_->write("killed/journal/lock", "");
  const std::vector<std::string> check = {"check", project_file, "--out",
                                          folder_->path("killed").string()};
  EXPECT_EQ(run_program(check).status, 0);
  folder_->write("killed/notes.txt", "of the user");
  EXPECT_EQ(run_program(check).status, 2);
}

TEST_F(Package, says_where_run_json_could_not_state_the_path_of_its_project) {
  fs::create_directory(folder_->path("caf\xe9"));
  expect_refused(run_program({"clearance", folder_->write("caf\xe9/own.toml", moved_project()),
                              "--out", folder_->path("u").string()}),
                 {"not UTF-8", "rename"});
}

// The studies are finished; the package is missing.
TEST_F(Package, is_made_of_finished_studies_of_its_own_project_only) {
  const fs::path other = folder_->path("unpacked");
  fs::copy(out(), other, fs::copy_options::recursive);
  const std::vector<std::string> resume = {"clearance", "--resume", other.string()};
  fs::remove(other / "package.html");
  succeeding(resume);
  EXPECT_EQ(read_file(other / "package.json"), read_file(out() / "package.json"));
  EXPECT_EQ(read_file(other / "package.html"), read_file(out() / "package.html"));
  fs::remove(other / "package.html");
  for (const char* name : {"results.h5", "run.json"})
    fs::copy_file(out() / "probability" / name, other / "demand" / name,
                  fs::copy_options::overwrite_existing);
  expect_refused(run_program(resume), {"demand/results.h5", "not of the study", "--overwrite"});
  EXPECT_FALSE(fs::exists(other / "package.html"));
  EXPECT_EQ(read_file(other / "demand.toml"), read_file(out() / "demand.toml"));
}

TEST_F(Package, results_without_what_the_project_looks_for_are_an_error_of_the_input) {
  const Project project = read_project(project_file);
  const Suite suite = load_suite(project.suite);
  const Results demand = read_results(out() / "demand/results.h5"),
                probability = read_results(out() / "probability/results.h5");
  EXPECT_THROW(design_clearance(project, probability, suite), InputError);
  Project other = project;
  other.friction.mean += 0.01;
  EXPECT_THROW(design_clearance(other, demand, suite), InputError);
  for (const auto& change : std::vector<std::function<void(Results&)>>{
           [](Results& r) { r.levels.pop_back(); }, [](Results& r) { r.suites.clear(); },
           [](Results& r) { r.suites.front().spectra.target_g.clear(); }}) {
    Results changed = demand;
    change(changed);
    EXPECT_THROW(design_clearance(project, changed, suite), InputError);
  }
  const DesignClearance design = design_clearance(project, demand, suite);
  for (const auto& change : std::vector<std::function<void(Results&)>>{
           [](Results& r) { r.runs.clear(); }, [](Results& r) { r.verdict.reset(); },
           [](Results& r) { r.levels.assign(r.levels.size(), 0.0); },
           [](Results& r) { r.verdict->rows.clear(); },
           [](Results& r) { r.runs.back().fragilities.clear(); }}) {
    Results changed = probability;
    DesignClearance exceeded = design;
    change(changed);
    EXPECT_THROW(add_exceedance(project, changed, exceeded), InputError);
  }
  DesignClearance varied = design;
  EXPECT_THROW(add_model_uncertainty(project, demand, demand, varied), InputError);
  Results uncertainty = read_results(out() / "uncertainty/results.h5");
  uncertainty.clearance->by_period.clear();
  EXPECT_THROW(add_model_uncertainty(project, demand, uncertainty, varied), InputError);
  DesignClearance larger = design;
  larger.governing_m += 1e-3;
  EXPECT_THROW(add_exceedance(project, probability, larger), InputError);
}

TEST_F(Package, is_not_made_of_studies_of_other_motions) {
  const std::string suite = GLISSADE_SOURCE_DIR "/suites/synthetic_level2.toml",
                    text = read_file(suite), project = replaced(moved_project(), suite, "own.toml"),
                    out = folder_->path("own").string();
  folder_->write("own.toml", text);
  const WithoutWeasyprint path;
  succeeding({"clearance", folder_->write("project.toml", project), "--out", out});
  fs::remove(fs::path(out) / "package.html");
  folder_->write("own.toml", replaced(text, "description = \"", "description = \"Changed. "));
  expect_refused(run_program({"clearance", "--resume", out}),
                 {"demand/results.h5", "other motions", "--overwrite"});
}

TEST_F(Package, check_of_a_project_says_what_would_run_and_writes_nothing) {
  const fs::path other = folder_->path("checked");
  const Finished child = succeeding({"check", project_file, "--out", other.string()});
  EXPECT_THAT(child.out, states("demand", "uncertainty", "probability", "clearance"));
  EXPECT_FALSE(fs::exists(other));
  const Finished taken = run_program({"check", project_file, "--out", out().string()});
  EXPECT_EQ(taken.status, 2);
  EXPECT_THAT(taken.err, states("--overwrite"));
}

// Issue 48: what keeps a verdict open was stated after the run alone.
TEST_F(Package, check_lists_separations_that_are_not_stated_and_each_warning_once) {
  std::string text = replaced(moved_project(), "storeys = 2\n", "");
  text = replaced(text, "similar_array_m = \"1.06 ft\"\n", "");
  const std::string printed = one_line(succeeding({"check", folder_->write("few.toml", text)}).out);
  EXPECT_THAT(printed, states("[clearances]", "similar", "building.storeys"));
  const std::string slip = "too little slip";
  EXPECT_EQ(printed.find(slip), printed.rfind(slip));
  EXPECT_NE(printed.find(slip), std::string::npos);
}

TEST_F(Package, check_warns_that_11_4_8_needs_s_1_and_the_site_class) {
  const std::string text =
      replaced(replaced(moved_project(), "ss_g = 1.313\ns1_g = 0.471\nsite_class = \"default\"",
                        "sds_g = 1.05\nsd1_g = 0.574"),
               "hazard_analysis = \"exception 2 of 11.4.8\"\n", "");
  const Finished child = run_program({"check", folder_->write("sds.toml", text)});
  const std::string unknown = "S_S, S_1 and site class are not stated";
  EXPECT_THAT(one_line(child.out), states("11.4.8", unknown));
  EXPECT_THAT(one_line(run_program({"check", project_file}).out), Not(states(unknown)));
}

TEST_F(Package, asks_for_the_exception_of_11_4_8_where_none_is_stated) {
  const std::string text =
      replaced(moved_project(), "hazard_analysis = \"exception 2 of 11.4.8\"\n", "");
  const Finished child = run_program({"check", folder_->write("open.toml", text)});
  EXPECT_THAT(one_line(child.out), states("11.4.8): not stated"));
  EXPECT_THAT(one_line(run_program({"check", project_file}).out),
              Not(states("11.4.8): not stated")));
}

TEST_F(Package, is_not_written_over_unless_required) {
  const std::string before = read_file(out() / "package.json");
  expect_refused(run_program({"clearance", project_file, "--out", out().string()}),
                 {"--overwrite"});
  EXPECT_EQ(read_file(out() / "package.json"), before);
}

TEST(ClearanceCommand, of_a_project_that_cannot_run_leaves_nothing) {
  const ScratchFolder folder;
  std::string text = read_file(project_file);
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"data/pull_tests.csv",
                                            GLISSADE_SOURCE_DIR "/studies/data/pull_tests.csv"},
        {"../suites/synthetic_level2.toml", "nowhere.toml"}})
    text.replace(text.find(from), from.size(), to);
  const fs::path out = folder.path("out");
  expect_refused(run_program({"clearance", folder.write("p.toml", text), "--out", out.string()}),
                 {"nowhere.toml"});
  EXPECT_FALSE(fs::exists(out));
}

TEST(ClearanceCommand, refuses_a_run_json_of_another_form) {
  const ScratchFolder folder;
  const std::string out = folder.path("").string();
  const auto resumed_with = [&](const std::string& json) {
    folder.write("run.json", json);
    return run_program({"clearance", "--resume", out});
  };
  for (const char* json : {R"({"command": "clearance", "status": 3, "project": 3})",
                           R"({"command": "clearance", "status": ["started"], "project": [1]})",
                           R"({"command": "clearance", "status": "started"})"})
    expect_refused(resumed_with(json), {"run.json", "\"project\"", "--overwrite"});
  expect_refused(
      resumed_with(R"({"command": "clearance", "project": "p.toml", "project_sha256": 3})"),
      {"run.json", "\"project_sha256\"", "--overwrite"});
  for (const char* json : {"[1]", R"({"command": 3})", R"({"status": "finished", "skips": [3]})"})
    expect_refused(resumed_with(json), {"holds no calculation"});
  EXPECT_EQ(folder.contents(), std::vector<std::string>{"run.json"});
}

TEST(ClearanceCommand, prints_an_example_and_needs_a_project) {
  const Finished child = run_program({"clearance", "--example"});
  EXPECT_EQ(child.status, 0);
  EXPECT_THAT(child.out, states("[site]"));
  expect_refused(run_program({"clearance"}), {"--example"});
}

}  // namespace
}  // namespace glissade::test
