// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/plan_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <span>

#include "glissade/core/wrap.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/study/plan/one_mass.hpp"
#include "words/model_text.hpp"

namespace glissade {
namespace {

template <class Lacks>
std::size_t count_records(const Plan& plan, Lacks lacks) {
  std::size_t count = 0;
  for (std::size_t record = 0; record < plan.records.size(); ++record)
    count += lacks(plan.motion(record)) ? 1 : 0;
  return count;
}

/// The first few.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 5;
  const std::span shown(names.data(), std::min(most, names.size()));
  const std::size_t more = names.size() - shown.size();
  return fmt::format("{}{}", fmt::join(shown, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

bool has_use(const StudyConfig& config, VerticalChoice use) {
  return std::ranges::find(config.vertical, use) != config.vertical.end();
}

std::vector<std::string> notes_on_records(const Plan& plan) {
  const std::size_t records = plan.records.size();
  std::vector<std::string> notes;
  if (plan.config.normalise_by_pgv)
    notes.emplace_back(
        "records are scaled to the median PGV of their suite first (suite.normalise; FEMA P-695, "
        "A.8, recalled)");
  const std::size_t flat =
      count_records(plan, [](const Motion& m) { return m.vertical_mps2.empty(); });
  if (has_use(plan.config, VerticalChoice::if_available) && flat > 0) {
    notes.push_back(fmt::format("no vertical component in {} of {}: run with the horizontal alone",
                                flat, counted(records, "record")));
  }
  const std::size_t single =
      count_records(plan, [](const Motion& m) { return m.horizontal_mps2[1].empty(); });
  if (single > 0) {
    notes.push_back(fmt::format("one horizontal component in {} of {}: it is used throughout",
                                single, counted(records, "record")));
  }
  std::vector<std::string> assumed;
  for (std::size_t record = 0; record < records; ++record)
    if (plan.motion(record).starts_are_assumed) assumed.push_back(plan.motion(record).id);
  if (!assumed.empty())
    notes.push_back(
        fmt::format("components of different steps or lengths in {} of {}, assumed to start "
                    "together: {}",
                    assumed.size(), counted(records, "record"), listed(assumed)));
  std::map<std::string, std::vector<std::string>> read_so;
  for (std::size_t record = 0; record < records; ++record)
    for (const auto* notes : {&plan.motion(record).notes, &plan.motion(record).processing})
      for (const std::string& note : *notes) read_so[note].push_back(plan.motion(record).id);
  for (const auto& [note, ids] : read_so)
    notes.push_back(
        fmt::format("{} of {}, {}: {}", ids.size(), counted(records, "record"), note, listed(ids)));
  const std::size_t units = unit_count(event_units(events_of(plan)), records);
  if (records == 1) notes.push_back("one record: the scatter between records is not estimated");
  if (units < records)
    notes.push_back(fmt::format("{} of {}: events are the independent unit of intervals{}",
                                counted(records, "record"), counted(units, "event"),
                                units == 1 ? ", of which one event gives none" : ""));
  return notes;
}

std::vector<std::string> notes_on_building(const Plan& plan) {
  if (plan.config.building.is_one_mass()) {
    const double longest_s = plan.config.quantities.at("building", "period_s").largest();
    std::string text = one_mass_text(plan.config);
    if (text.empty() || longest_s > longest_one_mass_period_s) return {};  // else a warning
    return {std::move(text)};
  }
  return {"the building is " + modes_text(plan) + "; modes that are left out move with the ground"};
}

/// Quantities that are stated and have no effect without another one.
std::vector<std::string> notes_on_quantities(const StudyConfig& config) {
  struct Needs {
    const char *table, *key, *other, *what;
  };
  std::vector<std::string> notes;
  for (const Needs& n :
       {Needs{"building", "damping", "period_s", "a rigid building"},
        Needs{"building", "period_ratio", "period_s", "a rigid building"},
        Needs{"building", "mass_ratio", "period_s", "a rigid building"},
        Needs{"vertical", "damping", "period_s", "a roof that moves vertically with the ground"}}) {
    if (config.quantities.at(n.table, n.key).is_stated &&
        config.quantities.at(n.table, n.other).is_always(0.0))
      notes.push_back(fmt::format("{}.{} has no effect on {}: give {}.{} too", n.table, n.key,
                                  n.what, n.table, n.other));
  }
  return notes;
}

/// Directions that are chosen and change nothing.
std::vector<std::string> notes_on_directions(const StudyConfig& config) {
  const OrientationConfig& o = config.orientation;
  const bool is_flat = config.quantities.at("roof", "slope_deg").is_always(0.0),
             is_straight = config.quantities.at("roof", "azimuth_deg").is_always(0.0);
  const bool has_sign = o.sign != SignChoice::random,
             has_second_sign = o.second_sign != SignChoice::random;
  std::vector<std::string> notes;
  if (o.slope_axis != std::vector{SlopeAxis::e_w} && !config.friction.across_is_given)
    notes.push_back(
        "orientation.slope_axis has no effect: friction is the same along and across the slope");
  if (has_sign && is_flat && is_straight)
    notes.push_back("orientation.sign has no effect on a flat roof");
  if (has_second_sign && is_straight)
    notes.push_back(
        "orientation.second_sign has no effect: it mirrors a history where roof.azimuth_deg is 0");
  return notes;
}

/// A seed of no random number.
std::vector<std::string> notes_on_seed(const Plan& plan) {
  const StudyConfig& config = plan.config;
  if (config.seed == 0 || config.draws() || config.clearance || plan.records.size() > 1) return {};
  return {"study.seed has no effect: nothing is drawn, and one record has no intervals"};
}

/// A study that gives probabilities by level gives those at DBE and MCE where they are levels.
std::vector<std::string> notes_on_design_levels(const Plan& plan) {
  const StudyConfig& config = plan.config;
  const double dbe_g = dbe_level(plan);
  if (dbe_g == 0.0 || (!config.fragility && !config.verdict)) return {};
  std::string missing;
  for (const auto& [name, level_g] :
       {std::pair{"DBE", dbe_g}, std::pair{"MCE", mce_over_dbe * dbe_g}}) {
    if (std::ranges::none_of(config.intensity.levels, [&, name = name](double level) {
          return earthquake_name(level, dbe_g) == name;
        }))
      missing += fmt::format("{}{}, {:.6g} g", missing.empty() ? "" : "; ", name, level_g);
  }
  if (missing.empty()) return {};
  return {
      fmt::format("not among intensity.levels are, of the target: {}. No probability is "
                  "computed there: add them to the levels",
                  missing)};
}

/// What takes the place of a warning.
std::vector<std::string> notes_on_hazard_analysis(const StudyConfig& config) {
  const auto& target = config.intensity.target;
  if (!target || target->exceptions.empty()) return {};
  return {"ASCE 7-16, 11.4.8, ground motion hazard analysis: the study states " +
          exceptions_text(*target)};
}

}  // namespace

std::string one_mass_text(const StudyConfig& config) {
  if (!config.building.is_one_mass()) return "";
  return one_mass_sentence(config.building.is_one_storey ? std::optional(1.0) : std::nullopt,
                           config.quantities.at("building", "period_s").largest());
}

std::vector<std::string> notes_on(const Plan& plan) {
  const StudyConfig& config = plan.config;
  std::vector<std::string> notes = notes_on_building(plan);
  std::ranges::move(notes_on_records(plan), std::back_inserter(notes));
  if (!config.friction.note.empty()) notes.push_back(config.friction.note);
  for (std::vector<std::string>& more :
       std::array{notes_on_quantities(config), notes_on_directions(config), notes_on_seed(plan),
                  notes_on_design_levels(plan), notes_on_hazard_analysis(config)})
    notes.insert(notes.end(), more.begin(), more.end());
  for_each_analysis(Analyses(), [&](auto analysis) {
    if constexpr (requires { analysis.plan_notes(plan); })
      std::ranges::move(analysis.plan_notes(plan), std::back_inserter(notes));
  });
  return notes;
}

double mce_level(IntensityMeasure measure, double dbe_level, bool has_target) {
  if (measure == IntensityMeasure::mce_fraction) return has_target ? 1.0 : 0.0;
  return mce_over_dbe * dbe_level;
}

Remarks remarks_on(const StudyOutline& study) {
  Remarks remarks;
  for_each_analysis(Analyses(), [&](auto analysis) {
    if constexpr (requires { analysis.plan_warnings(study); })
      std::ranges::move(analysis.plan_warnings(study), std::back_inserter(remarks.warnings));
    if constexpr (requires { analysis.plan_notes(study); })
      std::ranges::move(analysis.plan_notes(study), std::back_inserter(remarks.notes));
  });
  return remarks;
}

Remarks remarks_on_analyses(const Plan& plan) {
  bool has_target = false;
  for (std::size_t suite = 0; suite < plan.suites.size(); ++suite)
    has_target = has_target || plan.target_of(suite) != nullptr;
  return remarks_on({plan.config, plan.cases.size(), std::cref(plan.cases),
                     mce_level(plan.config.intensity.measure, dbe_level(plan), has_target)});
}

std::vector<Skip> skipped_analyses(const StudyConfig& config) {
  if (!config.standards.compare.empty()) return {};
  return {{"comparison with standards", "the study has no [standards]", 0}};
}

std::vector<Skip> skips_of(const Plan& plan) {
  const StudyConfig& config = plan.config;
  std::vector<Skip> skips = skipped_analyses(config);
  const std::uint64_t pairs = plan.records.size() * plan.cases.size();
  if (config.vertical == std::vector{VerticalChoice::none})
    skips.push_back({plan.suites.front().of_roof ? "vertical motion" : "vertical ground motion",
                     "[vertical] use = \"none\"", pairs});
  if (std::ranges::all_of(plan.cases.all(), [](const Case& c) { return c.period_s == 0.0; }))
    skips.push_back({"roof motions filtered by a building",
                     plan.suites.front().of_roof ? "the motions are those of the roof"
                                                 : "the building is rigid",
                     pairs});
  if (plan.order.size() < plan.cases.size()) {
    skips.push_back({"histories of cases that mirror another, or are the same",
                     "they are those of that case",
                     plan.records.size() * (plan.cases.size() - plan.order.size())});
  }
  return skips;
}

}  // namespace glissade
