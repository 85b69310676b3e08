// SPDX-License-Identifier: GPL-3.0-or-later
#include "suite_choice.hpp"

namespace glissade {

SuiteChoice read_suite_choice(const TomlTable& suite, const std::filesystem::path& study_file) {
  SuiteChoice choice;
  const std::string name = suite.required_text("file");
  choice.file = study_file.parent_path() / name;
  std::error_code ignored;
  if (!name.empty() && !std::filesystem::exists(choice.file, ignored)) {
    suite.report("file", "there is no suite " + choice.file.string(),
                 "give its path relative to the study file");
  }
  choice.records = suite.texts("records").value_or(choice.records);
  if (suite.is_array("records") && choice.records.empty())
    suite.report("records", "suite.records is empty", "name at least one record, or leave it out");
  return choice;
}

}  // namespace glissade
