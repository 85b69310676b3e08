// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/cases/probable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "glissade/motion/improbable.hpp"

namespace glissade {
namespace {

constexpr std::array ranges{
    ProbableRange{"building", "period_s", 0.05, longest_probable_period_s,
                  "no building has it: is it in s?"},
    ProbableRange{"building", "period_ratio", 0.2, 5.0, "no building is so unlike along its axes"},
    ProbableRange{"building", "alpha", 0.0, 20.0,
                  "no structural system has more (recalled), and it gives less displacement"},
    ProbableRange{"building", "damping", 0.005, 0.2,
                  "buildings without dampers have 0.01 to 0.1 (recalled)"},
    ProbableRange{"building", "mass_ratio", 1e-3, 0.3, "are both weights in one unit?"},
    ProbableRange{"building", "response_modification", 1.0, 8.0, "the largest R of ASCE 7 is 8"},
    ProbableRange{"building", "yield_coefficient", 0.01, 2.0,
                  "ASCE 7 requires a base shear of 0.01 of the weight or more"},
    ProbableRange{"building", "hardening_ratio", 0.0, 0.3, "usual are 0 to 0.1 (recalled)"},
    ProbableRange{"vertical", "period_s", 0.02, 1.0, "roofs have 0.05 to 0.5 s (recalled)"},
    ProbableRange{"vertical", "damping", 0.005, 0.2, "roofs have 0.01 to 0.1 (recalled)"},
    ProbableRange{"friction", "static_over_sliding", 1.0, 2.0,
                  "pull tests have 1 to 1.5 (recalled)"}};

}  // namespace

std::span<const ProbableRange> probable_ranges() { return ranges; }

std::string improbable_value(const Parameter& p, double value) {
  const auto range = std::ranges::find_if(ranges, [&](const ProbableRange& of) {
    return p.table == std::string_view(of.table) && p.key == std::string_view(of.key);
  });
  if (range == ranges.end() || (value >= range->least && value <= range->most) ||
      value == value_of(p, Case()))
    return "";
  const std::string unit = p.unit == std::string_view("-") ? "" : std::string(" ") + p.unit;
  const bool is_above = value > range->most;
  return fmt::format("{} {:.3g}{} is {} {:g}{}: {}", p.words, value, unit,
                     is_above ? "above" : "below", is_above ? range->most : range->least, unit,
                     range->reason);
}

}  // namespace glissade
