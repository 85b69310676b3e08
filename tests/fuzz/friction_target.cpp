// SPDX-License-Identifier: GPL-3.0-or-later
// What `glissade friction` and studies read: pull tests, and what is made of them.
#include <cmath>

#include "check.hpp"
#include "glissade/io/pull_test_file.hpp"
#include "glissade/sampling/friction_statistics.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glissade::fuzz;
  const auto file = input_file(data, size);
  may_refuse([&] {
    const auto tests = glissade::read_pull_tests(file);
    check(!tests.empty(), "there is a test");
    for (const glissade::PullTest& t : tests) {
      check(!t.force_n.empty() && t.displacement_m.size() == t.force_n.size() &&
                t.normal_n.size() == t.force_n.size(),
            "a test has samples, each whole");
      for (const double n : t.normal_n) check(std::isfinite(n) && n > 0.0, "normal force above 0");
    }
    const glissade::PullTestSummary summary = glissade::summarise(tests, {});
    for (const glissade::TraceFriction& t : summary.tests) {
      check(t.sliding_begin + 2 <= t.sliding_end, "two samples slide");
      check(t.sliding_mu > 0.0 && t.sliding_mu <= 10.0, "sliding friction can be one");
      check(t.min_mu <= t.max_mu && t.travel_m > 0.0, "the sliding part is one");
    }
    for (const glissade::DirectionFriction& d : summary.directions) {
      for (const glissade::MuStatistics& s : {d.sliding, d.breakaway}) {
        check(s.mean > 0.0 && s.mean <= 10.0, "mean friction can be one");
        check(s.tests == 1 || s.lower_bound_95 <= s.mean_minus_2_std, "the bound is below");
        if (s.normality) {
          check(s.normality->w > 0.0 && s.normality->w <= 1.0, "0 < W <= 1");
          check(s.normality->p_value >= 0.0 && s.normality->p_value <= 1.0, "p is a share");
        }
      }
    }
  });
  return 0;
}
