// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "glissade/core/contract.hpp"

namespace glissade {

/// The rows of a coefficient table (the first for PGA, period 0, then rising periods) on both sides
/// of a period, and the weight of the upper one, linear in ln T. Below the first non-zero period it
/// is the PGA row alone.
template <class Row>
struct PeriodBracket {
  const Row& below;
  const Row& above;
  double weight;
};

template <class Row>
PeriodBracket<Row> bracket_period(std::span<const Row> rows, double period_s) {
  GLISSADE_EXPECTS(period_s >= 0.0 && period_s <= rows.back().period_s);
  if (period_s < rows[1].period_s) return {rows[0], rows[0], 0.0};
  const auto above =
      std::lower_bound(rows.begin() + 2, rows.end() - 1, period_s,
                       [](const Row& row, double period) { return row.period_s < period; });
  const auto below = above - 1;
  return {*below, *above,
          std::log(period_s / below->period_s) / std::log(above->period_s / below->period_s)};
}

}  // namespace glissade
