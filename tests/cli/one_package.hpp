// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/small_study.hpp"

namespace glissade::test {

namespace fs = std::filesystem;

inline const std::string project_file = GLISSADE_SOURCE_DIR "/studies/permit_project.toml";

/// The example in another folder, with fewer samples.
inline std::string moved_project() {
  return replaced(replaced(read_file(project_file), "data/pull_tests.csv",
                           GLISSADE_SOURCE_DIR "/studies/data/pull_tests.csv"),
                  "[suite]\nfile = \"../suites/",
                  "[sampling]\nsamples = 16\n[suite]\nfile = \"" GLISSADE_SOURCE_DIR "/suites/");
}

/// Two roofs: the second is steeper, at a stronger site, and has less room.
inline std::string two_roofs() {
  return R"([project]
name = "campus"

[[site]]
name = "Roof A"
edition = "asce7_16"
sds_g = 0.8
sd1_g = 0.4
risk_category = "II"

[[site]]
name = "Roof B"
address = "2 Side Street"
edition = "asce7_10"
ss_g = 1.5
s1_g = 0.5
site_class = "C"
risk_category = "II"

[site.roof]
rise_in_12 = 0.5

[site.clearances]
open_edge_m = "3 ft"

[building]
period_s = 0.3
mass_ratio = 0.05
storeys = 1

[roof]
rise_in_12 = 0.25

[friction]
mu = { mean = 0.5, std = 0 }
tests = 5
source = "made up"

[suite]
file = ")" GLISSADE_SOURCE_DIR R"(/suites/synthetic_level0.toml"

[sampling]
samples = 2

[clearances]
open_edge_m = "30 ft"
)";
}

/// Two sites that differ in S_D1 alone.
inline std::string small_product() {
  return R"([product]
name = "racking"
unit = "ft"
round_up_m = "0.1 ft"

[[target]]
sds_g = 1.2
sd1_g = 0.5

[[target]]
sds_g = 1.2
sd1_g = 1.1

[suite]
file = ")" GLISSADE_SOURCE_DIR R"(/suites/synthetic_level2.toml"

[model]
axes = 1

[building]
period_s = [0.3, 0.35]

[roof]
slope_deg = [0, 2, 9]

[friction]
mu = [0.15, 0.3, 0.5]

[hazard]
k = 2.5
design_life_years = 25
)";
}

/// While it lives, commands find gnuplot alone: no package is printed, which takes seconds.
class WithoutWeasyprint {
 public:
  WithoutWeasyprint() {
    fs::create_directory(folder_.path("bin"));
    fs::create_symlink("/usr/bin/gnuplot", folder_.path("bin/gnuplot"));
    ::setenv("PATH", folder_.path("bin").c_str(), 1);
  }
  /// Another program of this name: a script of sh.
  void put(const std::string& script) const {
    const std::string file = folder_.write("bin/weasyprint", "#!/bin/sh\n" + script + "\n");
    fs::permissions(file, fs::perms::owner_all);
  }
  ~WithoutWeasyprint() { ::setenv("PATH", path_.c_str(), 1); }
  WithoutWeasyprint(const WithoutWeasyprint&) = delete;
  WithoutWeasyprint& operator=(const WithoutWeasyprint&) = delete;

 private:
  ScratchFolder folder_;
  std::string path_ = std::getenv("PATH");
};

/// The example project, run once.
class Package : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    finished_ = run_program({"clearance", project_file, "--out", out().string()});
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path out() { return folder_->path("out"); }
  static nlohmann::json numbers() {
    return nlohmann::json::parse(read_file(out() / "package.json"));
  }

  static inline ScratchFolder* folder_ = nullptr;
  static inline Finished finished_;
};

}  // namespace glissade::test
