// SPDX-License-Identifier: GPL-3.0-or-later
#include "record_screening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "glissade/core/error.hpp"
#include "glissade/motion/intensity.hpp"

namespace glissade {
namespace {

void check_limits(const Limits& limits, const char* name, ProblemList& problems) {
  for (const std::optional<double>& end : {limits.min, limits.max}) {
    if (end && !(std::isfinite(*end) && *end >= 0.0))
      problems.add({name, fmt::format("the limit {} is not a number of 0 or more", *end), "", ""});
  }
  if (limits.min && limits.max && *limits.min > *limits.max) {
    problems.add({name, fmt::format("from {} to {} admits nothing", *limits.min, *limits.max),
                  "give the smaller limit first", ""});
  }
}

void check(const SelectionCriteria& criteria) {
  ProblemList problems;
  if (criteria.count == 0) problems.add({"count", "no record is required", "give 1 or more", ""});
  check_limits(criteria.magnitude, "magnitude", problems);
  check_limits(criteria.distance_km, "distance_km", problems);
  check_limits(criteria.vs30_mps, "vs30_mps", problems);
  if (!(std::isfinite(criteria.max_scale) && criteria.max_scale > 0.0)) {
    problems.add({"max_scale", fmt::format("{} is not a positive number", criteria.max_scale),
                  "Walters et al. (2012) went up to 3 to 6, with the intensity level", ""});
  }
  if (criteria.per_event == 0)
    problems.add({"per_event", "no record of any event is admitted", "give 1 or more", ""});
  problems.throw_if_any();
}

/// Metadata of a motion are 0 if not given.
void judge(const Limits& limits, double value, MissingMetadata missing, LeftOutFor outside,
           LeftOutFor not_given, std::vector<LeftOutFor>& reasons) {
  if (!limits.are_given()) return;
  if (value == 0.0) {
    if (missing == MissingMetadata::leaves_out) reasons.push_back(not_given);
  } else if (!limits.admit(value)) {
    reasons.push_back(outside);
  }
}

std::vector<LeftOutFor> reasons_against(const Motion& motion, const SelectionCriteria& criteria) {
  std::vector<LeftOutFor> reasons;
  judge(criteria.magnitude, motion.magnitude, criteria.missing, LeftOutFor::magnitude,
        LeftOutFor::magnitude_missing, reasons);
  judge(criteria.distance_km, motion.distance_km, criteria.missing, LeftOutFor::distance,
        LeftOutFor::distance_missing, reasons);
  judge(criteria.vs30_mps, motion.vs30_mps, criteria.missing, LeftOutFor::vs30,
        LeftOutFor::vs30_missing, reasons);
  if (criteria.per_event && motion.event.empty() && criteria.missing == MissingMetadata::leaves_out)
    reasons.push_back(LeftOutFor::event_missing);
  if (motion.horizontal_mps2[1].empty()) reasons.push_back(LeftOutFor::no_second_horizontal);
  if (horizontal_pga_mps2(motion, HorizontalCombination::srss) == 0.0)
    reasons.push_back(LeftOutFor::no_motion);
  return reasons;
}

/// Number of the candidates that `per_event` permits in one suite.
std::size_t selectable(const Suite& library, const std::vector<std::size_t>& candidates,
                       const SelectionCriteria& criteria) {
  if (!criteria.per_event) return candidates.size();
  std::map<std::string, std::size_t> of_event;
  for (const std::size_t record : candidates) ++of_event[library.motions[record].event];
  std::size_t sum = 0;
  for (const auto& [event, records] : of_event) sum += std::min(records, *criteria.per_event);
  return sum;
}

/// "14 with magnitude outside the limits, 2 with no second horizontal".
std::string listed(const std::vector<LeftOutRecord>& left_out) {
  std::map<LeftOutFor, std::size_t> counts;
  for (const LeftOutRecord& record : left_out)
    for (const LeftOutFor reason : record.reasons) ++counts[reason];
  std::string text;
  for (const auto& [reason, count] : counts)
    text += fmt::format("{}{} with {}", text.empty() ? "" : ", ", count, to_string(reason));
  return text;
}

bool any_missing(const std::vector<LeftOutRecord>& left_out) {
  constexpr std::array missing = {LeftOutFor::magnitude_missing, LeftOutFor::distance_missing,
                                  LeftOutFor::vs30_missing, LeftOutFor::event_missing};
  return std::ranges::any_of(left_out, [&](const LeftOutRecord& record) {
    return std::ranges::find_first_of(record.reasons, missing) != record.reasons.end();
  });
}

void check_count(const Suite& library, const Screening& screening,
                 const SelectionCriteria& criteria) {
  const std::size_t most = selectable(library, screening.candidates, criteria);
  if (criteria.count <= most) return;
  std::string what =
      fmt::format("{} records are required, candidates left: {} of {}", criteria.count,
                  screening.candidates.size(), library.motions.size());
  if (most < screening.candidates.size())
    what += fmt::format(", of which {} of an event allows {}", *criteria.per_event, most);
  if (!screening.left_out.empty()) what += "; left out: " + listed(screening.left_out);
  std::string advice = "widen the limits, or select fewer records";
  if (any_missing(screening.left_out))
    advice +=
        "; or add the values that the library does not give, or keep such records "
        "(--keep-incomplete)";
  throw InputError({library.name, what, advice, ""});
}

}  // namespace

// The tables give magnitudes to a tenth: Northridge, 6.69 in NGA-West2, is 6.7 in Table 3 and in a
// suite whose smallest magnitude is 6.7.
SelectionCriteria walters_criteria(int level, SiteGroup sites) {
  constexpr double rounding = 0.05;
  const WaltersLevel& limits = walters_level(level, sites);
  SelectionCriteria criteria;
  criteria.magnitude = {limits.min_magnitude - rounding, limits.max_magnitude + rounding};
  criteria.distance_km = {limits.min_distance_km, limits.max_distance_km};
  criteria.vs30_mps = {limits.min_vs30_mps, limits.max_vs30_mps};
  criteria.max_scale = limits.max_scale;
  return criteria;
}

const char* to_string(LeftOutFor reason) {
  switch (reason) {
    case LeftOutFor::magnitude:
      return "magnitude outside the limits";
    case LeftOutFor::distance:
      return "distance outside the limits";
    case LeftOutFor::vs30:
      return "Vs30 outside the limits";
    case LeftOutFor::magnitude_missing:
      return "no magnitude given";
    case LeftOutFor::distance_missing:
      return "no distance given";
    case LeftOutFor::vs30_missing:
      return "no Vs30 given";
    case LeftOutFor::event_missing:
      return "no event given";
    case LeftOutFor::no_second_horizontal:
      return "no second horizontal";
    case LeftOutFor::no_motion:
      return "horizontals that are zero throughout";
    case LeftOutFor::factor:
      return "a factor outside the limit";
  }
  return "";
}

Screening screen(const Suite& library, const SelectionCriteria& criteria,
                 const std::function<bool(std::size_t record)>& can_be_scaled) {
  check(criteria);
  Screening screening;
  for (std::size_t record = 0; record < library.motions.size(); ++record) {
    auto reasons = reasons_against(library.motions[record], criteria);
    if (reasons.empty() && can_be_scaled && !can_be_scaled(record))
      reasons.push_back(LeftOutFor::factor);
    if (reasons.empty())
      screening.candidates.push_back(record);
    else
      screening.left_out.push_back({record, reasons});
  }
  check_count(library, screening, criteria);
  std::ranges::sort(screening.candidates, {},
                    [&](std::size_t record) { return library.motions[record].id; });
  return screening;
}

bool may_join(const std::vector<std::size_t>& choice, std::size_t out, std::size_t k,
              const std::vector<const std::string*>& events, std::optional<std::size_t> per_event) {
  std::size_t of_event = 0;
  for (std::size_t i = 0; i < choice.size(); ++i) {
    if (choice[i] == k) return false;
    if (i != out && *events[choice[i]] == *events[k]) ++of_event;
  }
  return !per_event || of_event < *per_event;
}

}  // namespace glissade
