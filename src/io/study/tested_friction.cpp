// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "glissade/io/pull_test_file.hpp"
#include "glissade/sampling/friction_statistics.hpp"
#include "keys/quantity_table.hpp"
#include "study/case_tables.hpp"

namespace glissade {
namespace {

std::string list_of(const std::vector<DirectionFriction>& directions) {
  std::string list;
  for (const DirectionFriction& d : directions)
    list += (list.empty() ? "" : ", ") + ("\"" + d.direction + "\"");
  return list;
}

/// The direction that `key` gives, or the only one; null where there is none, which is reported.
const DirectionFriction* direction_of(const TomlTable& table, const char* key,
                                      const PullTestSummary& summary) {
  const auto name = table.text(key);
  const auto& directions = summary.directions;
  if (!name && table.has(key)) return nullptr;
  if (!name) {
    if (directions.size() == 1) return &directions.front();
    table.report("file", fmt::format("friction.file has tests in {} directions", directions.size()),
                 "give one with direction = ...: " + list_of(directions));
    return nullptr;
  }
  if (const DirectionFriction* found = find_direction(summary, *name)) return found;
  table.report(key, fmt::format("friction.{} = \"{}\" is not in the pull tests", key, *name),
               "they have " + list_of(directions));
  return nullptr;
}

std::string note_on(const DirectionFriction& d, const std::string& file) {
  const MuStatistics& s = d.sliding;
  std::string note = fmt::format(
      "friction from {} pull tests, direction {}, in {}: sliding mean {:.4g}, std {:.4g}; with "
      "95 % confidence 97.7 % of pulls have more than {:.4g}",
      s.tests, d.direction, file, s.mean, s.std, s.lower_bound_95);
  if (s.normality) note += fmt::format("; Shapiro-Wilk p = {:.2g}", s.normality->p_value);
  if (!d.note.empty()) note += "; " + d.note;
  return note;
}

/// How friction in a direction is distributed; nothing where the tests are too few, which is
/// reported.
std::optional<Distribution> distribution_in(const TomlTable& table, const DirectionFriction& d) {
  const MuStatistics& s = d.sliding;
  if (s.tests < 2) {
    table.report("file",
                 fmt::format("friction.file has one test in direction \"{}\", which gives no "
                             "standard deviation",
                             d.direction),
                 "test more, or give mu = { mean, std }");
    return std::nullopt;
  }
  if (s.std == 0.0) return Fixed{s.mean};
  return TruncatedNormal{s.mean, s.std, 0.0, std::numeric_limits<double>::infinity()};
}

/// The directions of the file that the study does not use.
std::string note_on_unused(const PullTestSummary& summary, const std::vector<std::string>& used) {
  std::string unused;
  for (const DirectionFriction& d : summary.directions) {
    if (std::ranges::find(used, d.direction) != used.end()) continue;
    unused += fmt::format("{}\"{}\" (sliding mean {:.4g}, std {:.4g})", unused.empty() ? "" : ", ",
                          d.direction, d.sliding.mean, d.sliding.std);
  }
  return unused.empty() ? "" : "; NOT used: the tests in direction " + unused;
}

void take(const TomlTable& table, const PullTestSummary& summary, const std::string& file,
          StudyConfig& study) {
  std::vector<std::string> used;
  if (const DirectionFriction* d = direction_of(table, "direction", summary)) {
    used.push_back(d->direction);
    if (const auto mu = distribution_in(table, *d))
      study.quantities.at("friction", "mu") = quantity_of(*mu);
    study.friction.note = note_on(*d, file);
  }
  if (table.has("across_direction")) {
    if (const DirectionFriction* d = direction_of(table, "across_direction", summary)) {
      used.push_back(d->direction);
      if (const auto mu = distribution_in(table, *d))
        study.quantities.at("friction", "across_mu") = quantity_of(*mu);
      study.friction.across_is_given = true;
      study.friction.note += "; across the slope: " + note_on(*d, file);
    }
  }
  study.friction.note += note_on_unused(summary, used);
}

}  // namespace

void read_tested_friction(const TomlTable& table, StudyConfig& study) {
  const std::size_t problems_before = table.problem_count();
  for (const char* key : {"mu", "across_mu"})
    table.refuse_both(key, "file", "give the file of pull tests, or the friction itself");
  const std::string file = table.required_text("file");
  SlidingRule rule;
  rule.slip_m = table.number("slip_m", above_zero).value_or(rule.slip_m);
  rule.sliding_from_m = table.number("sliding_from_m", above_zero).value_or(rule.sliding_from_m);
  const auto give_up = [&] { table.ignore_unknown(); };
  if (table.problem_count() > problems_before) return give_up();
  try {
    take(table, read_pull_test_results(table.text_file(file), rule).summary, file, study);
  } catch (const InputError& error) {
    table.report("file", error);
    give_up();
  }
}

}  // namespace glissade
