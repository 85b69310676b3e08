// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/one_run.hpp"
#include "cli/small_study.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

class Run : public OneRun<small_study> {
 protected:
  static std::string h5dump(const std::vector<std::string>& options) {
    std::vector<std::string> command{"h5dump"};
    command.insert(command.end(), options.begin(), options.end());
    command.push_back((out() / "results.h5").string());
    const Finished child = run_child(command);
    EXPECT_EQ(child.status, 0) << child.err;
    return child.out;
  }
  /// The value h5dump prints of a scalar attribute of the root.
  static std::string root_attribute(const std::string& name) {
    const std::string text = h5dump({"-a", "/" + name});
    const std::size_t begin = text.find("(0): ") + 5;
    return text.substr(begin, text.find('\n', begin) - begin);
  }
};

TEST_F(Run, leaves_results_report_tables_figures_and_its_record) {
  for (const char* name :
       {"results.h5", "run.json", "report.html", "tables/fragility.csv", "tables/slip.csv",
        "tables/standards.csv", "tables/stripes.csv", "tables/samples.csv", "tables/records.csv",
        "figures/fragility.svg", "figures/fragility.pdf", "figures/fragility.gp"}) {
    EXPECT_GT(fs::exists(out() / name) ? fs::file_size(out() / name) : 0, 0u) << name;
  }
  for (const std::string& name : folder_->contents())
    EXPECT_EQ(name.find(".partial"), std::string::npos) << name;
}

TEST_F(Run, ends_with_the_fragilities_the_comparison_and_where_the_report_is) {
  EXPECT_EQ(finished_.err, "");
  EXPECT_THAT(finished_.out, states("SEAOC PV1-2012", (out() / "report.html").string()));
}

TEST_F(Run, counts_and_times_are_within_eighty_columns) {
  for (const std::string& line : lines_of(finished_.out)) {
    const bool is_path = line.find(folder_->path("").string()) != std::string::npos;
    EXPECT_TRUE(is_path || line.size() <= 80u) << line;
  }
}

TEST_F(Run, run_json_reports_when_where_and_how_long) {
  const Json json = Json::parse(read_file(out() / "run.json"));
  EXPECT_EQ(json.at("ranks"), 1);
  EXPECT_THAT(std::string(json.at("finished_utc")), testing::MatchesRegex("20..-..-..T..:..:..Z"));
  EXPECT_FALSE(std::string(json.at("host")).empty());
  EXPECT_GT(json.at("histories_integrated"), 0);
  EXPECT_TRUE(json.at("seconds").is_object());
  EXPECT_TRUE(json.at("skipped").is_array());
  EXPECT_EQ("\"" + std::string(json.at("plan_hash")) + "\"", root_attribute("plan_hash"));
}

TEST_F(Run, results_have_their_description_at_the_root) {
  EXPECT_EQ(root_attribute("file_type"), "\"glissade results\"");
  EXPECT_EQ(root_attribute("format_version"), "20");
  EXPECT_EQ(root_attribute("seed"), "7");
  const std::string version = root_attribute("program_version");  // in quotes
  EXPECT_THAT(run_program({"--version"}).out, states(version.substr(1, version.find('"', 1) - 1)));
  const std::string study = h5dump({"-r", "-a", "/study"});
  EXPECT_THAT(study, states("thresholds_m = [0.05, 0.2]"));  // the study file, word for word
}

TEST_F(Run, every_dataset_has_a_unit_and_a_description) {
  const std::string everything = h5dump({"-A"});
  std::size_t datasets = 0;
  for (std::size_t at = everything.find("DATASET \""); at != std::string::npos;) {
    const std::size_t next = everything.find("DATASET \"", at + 1);
    const std::string text = everything.substr(at, next - at);
    EXPECT_THAT(text, states("ATTRIBUTE \"unit\"")) << text.substr(0, 60);
    EXPECT_THAT(text, states("ATTRIBUTE \"description\"")) << text.substr(0, 60);
    ++datasets;
    at = next;
  }
  EXPECT_GT(datasets, 20u);
}

TEST_F(Run, peaks_are_by_record_case_and_level) {
  const std::string header = h5dump({"-H", "-d", "/histories/peak_displacement_m"});
  EXPECT_THAT(header, states("( 7, 16, 3 )"));
  EXPECT_THAT(h5dump({"-H", "-d", "/histories/capacity_g"}), states("( 7, 16, 2 )"));
}

TEST_F(Run, the_stripes_table_counts_what_the_results_hold) {
  const std::vector<std::string> lines = lines_of(read_file(out() / "tables" / "stripes.csv"));
  std::size_t rows = 0;
  double last_threshold = 0.0, last_exceedances = 0.0;
  for (const std::string& line : lines) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells[0] != "sampled") continue;
    ++rows;
    EXPECT_EQ(std::stod(cells[3]), 56.0) << line;  // 7 records x 8 samples
    if (std::stod(cells[1]) == last_threshold) {
      EXPECT_GE(std::stod(cells[4]), last_exceedances) << line;
    }
    last_threshold = std::stod(cells[1]);
    last_exceedances = std::stod(cells[4]);
  }
  EXPECT_EQ(rows, 6u);  // two thresholds, three levels
}

TEST_F(Run, a_second_run_gives_the_same_bytes) {
  const fs::path again = folder_->path("again");
  ASSERT_EQ(run_program({"run", study_, "--out", again.string()}).status, 0);
  EXPECT_TRUE(read_file(again / "results.h5") == read_file(out() / "results.h5"));
  EXPECT_EQ(read_file(again / "tables/fragility.csv"), read_file(out() / "tables/fragility.csv"));
}

TEST_F(Run, without_skipping_gives_the_same_bytes) {
  const std::string study =
      folder_->write("weak.toml", replaced(small_study(), "[0.5, 1.0, 2.0]", "[0.1, 1.0]"));
  const fs::path usual = folder_->path("skips"), all = folder_->path("no_skip");
  ASSERT_EQ(run_program({"run", study, "--out", usual.string()}).status, 0);
  ASSERT_EQ(run_program({"run", study, "--no-skip", "--out", all.string()}).status, 0);
  EXPECT_TRUE(read_file(all / "results.h5") == read_file(usual / "results.h5"));
  const auto count = [](const fs::path& folder, const char* key) {
    return nlohmann::json::parse(read_file(folder / "run.json")).at(key).get<int>();
  };
  EXPECT_GT(count(all, "histories_at_levels"), count(usual, "histories_at_levels"));
}

TEST_F(Run, stops_at_the_largest_threshold_where_nothing_beyond_is_both) {
  const std::string both = replaced(small_study(), "thresholds_m = [0.05, 0.2]",
                                    "thresholds_m = [0.001, 0.01]\nstop_at_largest = true");
  const Finished refused = run_program(
      {"run", folder_->write("asks_both.toml", both), "--out", folder_->path("refused").string()});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, states("stop_at_largest"));
  const std::string study = folder_->write(
      "stops.toml", replaced(both, "[standards]\ncompare = [\"seaoc_pv1_2012\"]\n", ""));
  const fs::path stopped = folder_->path("stopped");
  const Finished child = succeeding({"run", study, "--out", stopped.string()});
  EXPECT_THAT(child.out, states("largest threshold"));
  EXPECT_TRUE(fs::exists(stopped / "figures" / "slip_vs_sds.svg"));
}

TEST_F(Run, another_seed_gives_other_results) {
  const std::string study =
      folder_->write("other.toml", replaced(small_study(), "seed = 7", "seed = 8"));
  ASSERT_EQ(run_program({"run", study, "--out", folder_->path("other").string()}).status, 0);
  EXPECT_NE(read_file(folder_->path("other") / "tables/samples.csv"),
            read_file(out() / "tables/samples.csv"));
}

TEST_F(Run, report_makes_the_same_tables_again_elsewhere) {
  const std::string results_before = read_file(out() / "results.h5");
  std::vector<std::string> tables;
  for (const auto& table : fs::directory_iterator(out() / "tables"))
    tables.push_back("tables/" + table.path().filename().string());
  EXPECT_GE(tables.size(), 5u);
  expect_report_gives_again(tables);
  for (const char* name : {"report.html", "figures/fragility.svg"})
    EXPECT_TRUE(fs::exists(folder_->path("report_again") / name)) << name;
  EXPECT_TRUE(read_file(out() / "results.h5") == results_before);
}

TEST_F(Run, check_is_a_dry_run_and_reports_cost_and_folder) {
  const ScratchFolder folder;
  const std::string study = folder.write("small.toml", small_study());
  const Finished check = succeeding({"check", study, "--out", folder.path("out").string()});
  EXPECT_EQ(run_program({"run", study, "--out", folder.path("out").string(), "--dry-run"}).out,
            check.out);
  EXPECT_THAT(check.out, states("\nwork", "\ntime", "\nresults"));
  EXPECT_EQ(folder.contents(), std::vector<std::string>{"small.toml"});
  const Finished taken = run_program({"check", study, "--out", out().string()});
  EXPECT_EQ(taken.status, 2);  // the plan, and that the folder is taken
  EXPECT_THAT(taken.out, states("\nwork"));
  EXPECT_THAT(taken.err, states(out().string()));
}

TEST_F(Run, dry_run_prints_the_plan_and_writes_nothing) {
  const ScratchFolder folder;
  const std::string study = folder.write("small.toml", small_study());
  const Finished child =
      run_shell("cd '" + folder.path("").string() + "' && \"$0\" run small.toml --dry-run");
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_THAT(child.out, states("small", "7 motions", "2 combinations", "8 samples",
                                "336 histories"));  // 7 x 8 x 3, twice
  EXPECT_EQ(folder.contents(), std::vector<std::string>{"small.toml"});
}

TEST_F(Run, without_out_the_folder_is_named_after_the_study_file) {
  const ScratchFolder folder;
  folder.write("my_roof.toml", small_study());
  EXPECT_EQ(run_shell("cd '" + folder.path("").string() + "' && \"$0\" run my_roof.toml").status,
            0);
  EXPECT_TRUE(fs::exists(folder.path("results/my_roof/results.h5")));
}

TEST_F(Run, runs_one_history_of_one_record_without_standards_or_samples) {
  const ScratchFolder folder;
  std::string record;
  for (int i = 0; i < 200; ++i) record += std::to_string(0.5 * std::sin(0.2 * i)) + "\n";
  folder.write("record.txt", record);
  folder.write("suite.toml", suite_of_one_record());
  const std::string study =
      folder.write("one.toml",
                   "[study]\nname = \"one\"\n[suite]\nfile = \"suite.toml\"\n[intensity]\nmeasure "
                   "= \"pga_g\"\nlevels = [1.0]\n[model]\naxes = 1\n"
                   "[friction]\nmu = 0.3\n[orientation]\ncomponent = "
                   "\"first\"\n[sampling]\nsamples = 1\n[fragility]\nthresholds_m = [0.1]\n");
  succeeding({"run", study, "--out", folder.path("out").string()});
  EXPECT_TRUE(fs::exists(folder.path("out/report.html")));
}

// Friction that falls to a thousandth within some um/s: many of its histories do not converge, also
// in search of capacities. A capacity of -nan ended the run after all of them.
TEST(RunThatDoesNotConverge, ends_with_finite_capacities_counts_and_names) {
  const ScratchFolder folder;
  std::string text = small_study();
  for (const auto& [from, to] :
       {std::pair{"[sampling]", "fast_over_slow = 0.001\nrate_s_per_m = 1e5\n[sampling]"},
        {"samples = 8", "samples = 1"},
        {"[0.05, 0.2]", "[0.2]"},
        {"[\"sampled\", \"design\"]", "\"sampled\""}})
    text = replaced(text, from, to);
  const std::string study = folder.write("study.toml", text);
  const auto out = folder.path("out").string(), again = folder.path("again").string();
  const Finished child = succeeding({"run", study, "--out", out});
  EXPECT_THAT(child.out, states("NOT CONVERGED"));
  EXPECT_THAT(read_file(out + "/report.html"), states("NOT CONVERGED", "in search of", "level0_1"));
  const Json json = Json::parse(read_file(out + "/run.json"));
  EXPECT_GT(json.at("histories_not_converged"), 0);
  for (const char* name : {"capacity_g", "peak_displacement_m"}) {
    const Finished dump =
        run_child({"h5dump", "-d", std::string("/histories/") + name, out + "/results.h5"});
    EXPECT_EQ(dump.status, 0) << dump.err;
    EXPECT_EQ(dump.out.find("nan"), std::string::npos);
  }
  // Nothing of such a history is known, and no number of it is zero.
  const auto values = [&](const char* name) {
    std::vector<std::string> found;
    const Finished dump = run_child(
        {"h5dump", "-y", "-w", "1", "-d", std::string("/histories/") + name, out + "/results.h5"});
    std::istringstream lines(dump.out.substr(dump.out.find("DATA {")));
    for (std::string word; lines >> word;)
      if (word.find_first_of("0123456789in") == 0) found.push_back(word.substr(0, word.find(',')));
    return found;
  };
  const auto failed = values("failed"), residual = values("residual_along_m");
  ASSERT_EQ(failed.size(), residual.size());
  for (std::size_t i = 0; i < failed.size(); ++i) {
    if (failed[i] == "1") {
      EXPECT_EQ(residual[i], "inf") << i;
    }
  }
  ASSERT_EQ(run_program({"run", study, "--walltime-s", "0.01", "--out", again}).status, 75);
  EXPECT_EQ(run_program({"run", "--resume", again}).status, 0);
  EXPECT_TRUE(read_file(again + "/results.h5") == read_file(out + "/results.h5"));
}

}  // namespace
}  // namespace glissade::test
