// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/cases/probable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "glissade/core/wrap.hpp"
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

std::vector<std::string> improbable_modes(std::span<const Mode> modes, bool has_own_damping) {
  std::vector<std::string> sentences = improbable_modes(modes);
  const Parameter& damping = parameters()[parameter_index("building", "damping")];
  for (const Mode& mode : modes)
    if (std::string text = improbable_value(damping, mode.damping_ratio);
        has_own_damping && !text.empty())
      sentences.push_back(std::move(text));
  return sentences;
}

std::string improbable_storeys(std::size_t storeys, double period_s) {
  constexpr double least_s = 0.02, most_s = 0.5;  // a storey (recalled: about 0.1)
  const auto count = static_cast<double>(storeys);
  if (period_s >= least_s * count && period_s <= most_s * count) return "";
  return fmt::format(
      "a first period of {:.3g} s of {} is outside {:g} to {:g} s a storey (recalled)", period_s,
      counted(storeys, "storey"), least_s, most_s);
}

void PeriodsByAxis::take(const Case& c) {
  for (const auto& [axis, period_s] :
       {std::pair{0, c.period_s}, {1, c.period_s * c.period_ratio}}) {
    shortest_s[axis] = std::min(shortest_s[axis], period_s);
    longest_s[axis] = std::max(longest_s[axis], period_s);
  }
}

std::vector<std::string> improbable_building(const BuildingModel& model,
                                             const PeriodsByAxis& periods, bool two_axes) {
  using Kind = BuildingModel::Kind;
  const Parameter& of_period = parameters()[parameter_index("building", "period_s")];
  std::vector<std::string> sentences;
  for (std::size_t axis = 0; axis < (two_axes ? 2 : 1); ++axis) {
    const char* along = axis == 0 ? "along the first axis" : "along the second axis";
    const double shortest_s = periods.shortest_s[axis], longest_s = periods.longest_s[axis];
    if (model.kind == Kind::modes)
      for (const std::string& text : improbable_modes(model.modes[axis], model.has_own_damping))
        sentences.push_back(fmt::format("modes {}: {}", along, text));
    const bool is_as_first =
        axis == 0 || (shortest_s == periods.shortest_s[0] && longest_s == periods.longest_s[0]);
    for (const double period_s : {shortest_s, longest_s}) {
      if (std::string text = improbable_value(of_period, period_s); !is_as_first && !text.empty())
        sentences.push_back(fmt::format("{}: {}", along, text));
      if (std::string text = improbable_storeys(model.modes[axis].size(), period_s);
          model.kind == Kind::storeys && !(axis == 1 && is_as_first) && !text.empty())
        sentences.push_back(std::move(text));
      if (shortest_s == longest_s) break;
    }
  }
  return sentences;
}

}  // namespace glissade
