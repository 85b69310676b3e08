// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "glissade/fragility/fit.hpp"

namespace glissade::test {

/// Of the data sets that have an interval, the share whose interval covers the truth.
struct CoverageShare {
  int covered = 0, count = 0;

  void add(const Interval& interval, double truth) {
    if (std::isnan(interval.low)) return;
    ++count;
    covered += interval.low <= truth && truth <= interval.high;
  }
  double value() const { return covered / static_cast<double>(count); }
};

}  // namespace glissade::test
