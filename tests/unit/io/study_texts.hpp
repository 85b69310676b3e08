// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include "glissade/io/study_file.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {

/// The shape in the design, one section a key so that tests can replace a part.
inline const std::string study_part = "[study]\nname = \"quickstart\"\nseed = 20260101\n";
inline const std::string suite_part = "[suite]\nfile = \"suite.toml\"\n";
inline const std::string intensity_part =
    "[intensity]\nmeasure = \"sds_g\"\nlevels = { from = 0.5, to = 2.0, count = 4 }\n";
inline const std::string friction_part = "[friction]\nmu = { mean = 0.55, std = 0.04 }\n";
inline const std::string fragility_part = "[fragility]\nthresholds_m = [0.15, 0.3]\n";
inline const std::string without_fragility =
    study_part + suite_part + intensity_part + friction_part;
inline const std::string needed = without_fragility + fragility_part;

inline const std::string without_friction =
    study_part + suite_part + intensity_part + fragility_part;
/// The needed parts, open for more keys of [friction].
inline const std::string friction_last = without_friction + friction_part;

/// [friction] mu, and this key in its table, which comes last.
inline std::string one_key(const Parameter& p, const std::string& value) {
  const std::string table = "[" + std::string(p.table) + "]\n",
                    line = p.key + (" = " + value + "\n");
  if (p.key == std::string("mu")) return table + line;
  return "[friction]\nmu = 0.5\n" + (table == "[friction]\n" ? "" : table) + line;
}

class StudyFile : public testing::Test {
 protected:
  StudyFile() { folder_.write("suite.toml", ""); }
  StudyConfig read(const std::string& content) const {
    return read_study(folder_.write("study.toml", content));
  }
  std::string error(const std::string& content) const {
    return message_of([&] { read(content); });
  }
  void refuses(const std::vector<Refusal>& refusals) const {
    expect_refusals([&](const std::string& content) { read(content); }, refusals);
  }
  /// "14 building.period_s" of each problem.
  std::vector<std::string> faults(const std::string& content) const {
    return faults_of([&] { read(content); });
  }
  TemporaryFolder folder_;
};

}  // namespace glissade
