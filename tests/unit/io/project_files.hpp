// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "glissade/design/design_clearance.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/study_file.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {

inline const std::string whole_project = R"([project]
name = "one"
[site]
edition = "asce7_16"
ss_g = 1.313
s1_g = 0.471
site_class = "default"
risk_category = "III"
[building]
period_s = [1.0, 0.5]
mass_ratio = 0.05
[roof]
rise_in_12 = 0.25
[friction]
mu = { mean = 0.5, std = 0.04 }
source = "report 7"
[suite]
file = "suite.toml"
)";

/// Project files, and what they are read as.
class ProjectFiles : public testing::Test {
 protected:
  inline static const std::string period = "period_s = [1.0, 0.5]",
                                  mass_ratio = "mass_ratio = 0.05",
                                  mapped = "ss_g = 1.313\ns1_g = 0.471\n",
                                  site_class = "site_class = \"default\"\n";

  ProjectFiles() { folder_.write("suite.toml", ""); }
  Project read(const std::string& text) { return read_project(folder_.write("p.toml", text)); }
  std::vector<Problem> problems_of(const std::string& text) {
    return glissade::problems_of([&] { read(text); });
  }
  std::vector<std::string> warnings_of(const std::string& text) {
    return texts_of(warnings_on(read(text)));
  }

  /// The whole project but for a part of its text.
  static std::string changed(const std::string& from, const std::string& to,
                             std::string text = whole_project) {
    return text.replace(text.find(from), from.size(), to);
  }
  /// With more keys in a table.
  static std::string with(const std::string& table, const std::string& keys) {
    return changed(table + "\n", table + "\n" + keys + "\n");
  }
  /// By a sheet of pull tests.
  std::string tested(const std::string& sheet) {
    folder_.write("pulls.csv", sheet);
    return changed("mu = { mean = 0.5, std = 0.04 }\nsource = \"report 7\"",
                   "file = \"pulls.csv\"");
  }
  /// The studies that are made are study files.
  StudyConfig demand_of(const std::string& text) {
    return study_of(demand_study(read(text), folder_.path()));
  }
  StudyConfig uncertainty_of(const std::string& text) {
    return study_of(uncertainty_study(read(text), folder_.path()));
  }
  StudyConfig probability_of(const std::string& text, const std::vector<double>& thresholds_m) {
    return study_of(probability_study(read(text), folder_.path(), thresholds_m));
  }
  TemporaryFolder folder_;

 private:
  StudyConfig study_of(const std::string& text) {
    return read_study(folder_.write("made.toml", text));
  }
};

}  // namespace glissade
