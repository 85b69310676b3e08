// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/check.hpp"

namespace glissade::fragility {

void check(const std::vector<Stripe>& rows) {
  ProblemList problems;
  for (const Stripe& s : rows) {
    if (!(s.intensity >= 0 && std::isfinite(s.intensity)))
      problems.add(
          {"stripes",
           "intensity = " + std::to_string(s.intensity) + " is not a finite number above 0", "",
           ""});
    const bool all = s.intensity != 0 || s.exceedances == s.trials;  // these exceed without shaking
    if (!(all && std::isfinite(s.trials) && s.exceedances >= 0 && s.exceedances <= s.trials))
      problems.add({"stripes",
                    std::to_string(s.exceedances) + " exceedances of " + std::to_string(s.trials) +
                        " trials at intensity " + std::to_string(s.intensity),
                    "give exceedances between 0 and trials", ""});
  }
  problems.throw_if_any();
  check_weights(rows);
}

void check(const std::vector<Bracket>& rows) {
  ProblemList problems;
  for (const Bracket& row : rows) {
    if (row.low >= 0 && row.low <= row.high && std::isfinite(row.low)) continue;
    problems.add({"brackets",
                  std::to_string(row.low) + " to " + std::to_string(row.high) +
                      " is no range of intensities",
                  "give 0 <= low <= high", ""});
  }
  problems.throw_if_any();
  check_weights(rows);
}

}  // namespace glissade::fragility
