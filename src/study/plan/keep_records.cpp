// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/keep_records.hpp"

#include <algorithm>

#include "glissade/core/error.hpp"

namespace glissade {

void keep_records(const RecordChoice& choice, Suite& suite) {
  if (choice.ids.empty()) return;
  std::vector<std::string> known;
  for (const Motion& motion : suite.motions) known.push_back(motion.id);
  const auto holds = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  ProblemList problems;
  for (const std::string& id : choice.ids) {
    if (holds(known, id)) continue;
    const std::string near = nearest_word(id, known);
    problems.add({choice.study_file.string(),
                  "suite.records names " + id + ", which is not in " + choice.suite_file.string(),
                  near.empty() ? "`glissade suite show` lists the suite's records"
                               : "did you mean " + near + "?",
                  ""});
  }
  problems.throw_if_any();
  std::erase_if(suite.motions, [&](const Motion& motion) { return !holds(choice.ids, motion.id); });
}

}  // namespace glissade
