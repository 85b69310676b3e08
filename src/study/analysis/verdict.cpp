// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "analysis/pooled_level.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/standards/conditions.hpp"
#include "glissade/study/analysis/exceeded_displacement.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

/// What is compared with prescribed values.
using Field = HistoryValues<double> HistoryFields::*;
constexpr Field displacement = &HistoryFields::peak_displacement_m;

/// A field of one combination at every level.
struct AtPeriod {
  double period_s = 0.0;
  std::vector<PooledLevel> levels;
};

/// All buildings on which arrays of one kind stand.
class Buildings {
 public:
  Buildings(const Results& results, std::size_t combination, Field field) {
    const CaseSet& set = results.cases;
    const std::size_t axis = set.axis(period_key);
    std::vector<std::size_t> places = set.places(combination);
    const std::size_t periods = axis < set.axes.size() ? set.axes[axis].size() : 1;
    for (std::size_t p = 0; p < periods; ++p) {
      if (axis < places.size()) places[axis] = p;
      const std::size_t first = set.index(set.combination(places), 0, 0);
      AtPeriod at{set.cases[first].period_s, {}};
      for (std::size_t level = 0; level < results.levels.size(); ++level)
        at.levels.push_back(
            pooled_at(results.histories, {first, set.per_combination()}, level, field));
      buildings_.push_back(std::move(at));
    }
  }

  static constexpr const char* period_key = "building.period_s";

  /// The largest probability that the field exceeds a value.
  VerdictProbability exceedance(std::size_t level, double value_m) const {
    const AtPeriod& worst =
        largest(level, [&](const PooledLevel& l) { return l.share_above(value_m); });
    const PooledLevel& pooled = worst.levels[level];
    return {pooled.share_above(value_m), pooled.wide_share_interval(value_m), worst.period_s};
  }

  /// The largest displacement that is exceeded with a probability.
  void displacement(std::size_t level, double probability, VerdictRow& row) const {
    const double quantile = 1.0 - probability;
    const AtPeriod& worst =
        largest(level, [&](const PooledLevel& l) { return l.quantile_m(quantile); });
    const PooledLevel& pooled = worst.levels[level];
    row.displacement_m.push_back(pooled.quantile_m(quantile));
    row.displacement_interval.push_back(pooled.exceeded_interval(probability));
  }

 private:
  template <class Value>
  const AtPeriod& largest(std::size_t level, Value value) const {
    return *std::ranges::max_element(buildings_, {},
                                     [&](const AtPeriod& at) { return value(at.levels[level]); });
  }

  std::vector<AtPeriod> buildings_;
};

/// Of a combination that is the first of its building periods; with what does not depend on the
/// standard and the level.
VerdictRow kind_of_array(const StudyConfig& config, const CaseSet& set, std::size_t combination) {
  VerdictRow row{.first_case = set.index(combination, 0, 0),
                 .condition = set.describe(combination, {Buildings::period_key})};
  const std::span cases(set.cases.data() + row.first_case, set.per_combination());
  const auto mean_beyond = [&](double first, auto value) {  // exactly the first if all are equal
    double beyond = 0.0;
    for (const Case& c : cases) beyond += value(c) - first;
    return first + beyond / static_cast<double>(cases.size());
  };
  const auto friction = [&](const Case& c) { return stated_friction(config, c); };
  row.mu = mean_beyond(friction(cases.front()), friction);
  row.slope_deg = cases.front().slope_deg;
  return row;
}

/// R gives a building the strength for the S_DS of the design target: it is the building of that
/// design earthquake alone.
bool is_designed_for(const Results& results, const VerdictRow& kind, double sds_g) {
  return results.cases.cases[kind.first_case].response_modification == 0.0 ||
         level_at({results.model.dbe_level}, sds_g) == 0;
}

/// What does not depend on the standard, at each S_DS of which the MCE is a level too.
std::vector<VerdictRow> computed_rows(const StudyConfig& config, const Results& results,
                                      const Buildings& buildings, std::size_t combination,
                                      const VerdictResults& verdict) {
  std::vector<VerdictRow> rows;
  const VerdictRow kind = kind_of_array(config, results.cases, combination);
  for (std::size_t level = 0; level < results.levels.size(); ++level) {
    const double sds_g = results.levels[level];
    if (level_at(results.levels, mce_over_dbe * sds_g) == results.levels.size() ||
        !is_designed_for(results, kind, sds_g))
      continue;
    rows.push_back(kind);
    rows.back().sds_g = sds_g;
    for (const double probability : verdict.exceedance)
      buildings.displacement(level, probability, rows.back());
  }
  return rows;
}

/// The separations of the last row.
class Separations {
 public:
  Separations(const Results& results, std::size_t combination) : levels_(results.levels) {
    const auto add = [&](const char* where, Field field) {
      gaps_.emplace_back(where, Buildings(results, combination, field));
    };
    const CaseSet& set = results.cases;
    const Case& c = set.cases[set.index(combination, 0, 0)];
    if (c.neighbour_friction == 0.0 || results.histories.fields.closing_along_m.empty()) return;
    const bool faces = c.neighbour_slope == NeighbourSlope::facing && c.slope_deg != 0.0;
    add(faces ? " on facing slopes, along the slope" : ", along the slope",
        &HistoryFields::closing_along_m);
    add(faces ? " on facing slopes, across the slope" : ", across the slope",
        &HistoryFields::closing_across_m);
  }

  void add_to(VerdictResults& verdict, const Buildings& displacements) const {
    const VerdictRow& row = verdict.rows.back();
    const std::vector<Separation> all = separations_of(row.standard, row.prescribed.value_m);
    const auto add = [&](const Separation& separation, const std::string& where,
                         const Buildings& buildings) {
      const auto exceedance = [&](double sds_g) {
        return buildings.exceedance(level_at(levels_, sds_g), separation.value_m);
      };
      verdict.separations.push_back({verdict.rows.size() - 1, separation.what + where,
                                     separation.factor, separation.value_m, exceedance(row.sds_g),
                                     exceedance(mce_over_dbe * row.sds_g)});
    };
    for (const auto& [where, buildings] : gaps_) add(all.front(), where, buildings);
    for (std::size_t i = 1; i < all.size(); ++i) add(all[i], "", displacements);
  }

 private:
  const std::vector<double>& levels_;
  std::vector<std::pair<const char*, Buildings>> gaps_;
};

bool is_first_of_its_periods(const CaseSet& set, std::size_t combination) {
  const std::size_t axis = set.axis(Buildings::period_key);
  return axis == set.axes.size() || set.places(combination)[axis] == 0;
}

}  // namespace

std::size_t level_at(const std::vector<double>& levels, double level) {
  const auto found = std::ranges::find_if(
      levels, [&](double l) { return std::abs(l - level) <= 1e-9 * std::abs(level); });
  return static_cast<std::size_t>(found - levels.begin());
}

ExceededDisplacement exceeded_displacement(const Results& results, CaseSlice cases,
                                           std::size_t level, double probability) {
  const PooledLevel pooled = pooled_at(results.histories, cases, level);
  return {pooled.quantile_m(1.0 - probability), pooled.exceeded_interval(probability)};
}

Judgement judgement(const VerdictResults& verdict, const VerdictRow& row) {
  if (row.dbe.probability > verdict.exceedance.front()) return Judgement::exceeded;
  return row.prescribed.value_m > 2.0 * row.displacement_m.back() ? Judgement::conservative
                                                                  : Judgement::sufficient;
}

bool is_certain(const VerdictResults& verdict, const VerdictRow& row) {
  const double accepted = verdict.exceedance.front();
  return row.dbe.interval.low > accepted || row.dbe.interval.high <= accepted;
}

VerdictResults VerdictAnalysis::find(const StudyConfig& config, const Results& results) {
  GLISSADE_EXPECTS(config.verdict.has_value());
  const CaseSet& set = results.cases;
  VerdictResults verdict{config.verdict->exceedance, {}, {}};
  for (std::size_t c = 0; c < set.combinations(); ++c) {
    if (!is_first_of_its_periods(set, c) ||
        set.cases[set.index(c, 0, 0)].support != ArraySupport::isolated)
      continue;
    const Buildings buildings(results, c, displacement);
    const Separations separations(results, c);
    const std::vector<VerdictRow> computed = computed_rows(config, results, buildings, c, verdict);
    for (const Standard standard : config.standards.compare) {
      for (VerdictRow row : computed) {
        row.standard = standard;
        row.prescribed = prescribed_displacement(standard, row.sds_g, config.standards);
        row.within_conditions =
            is_within(standard, {.slope_deg = row.slope_deg, .friction = row.mu});
        row.dbe = buildings.exceedance(level_at(results.levels, row.sds_g), row.prescribed.value_m);
        row.mce = buildings.exceedance(level_at(results.levels, mce_over_dbe * row.sds_g),
                                       row.prescribed.value_m);
        verdict.rows.push_back(std::move(row));
        separations.add_to(verdict, buildings);
      }
    }
  }
  return verdict;
}

std::vector<std::string> VerdictAnalysis::notes(const Results& results, const StudyConfig& study) {
  if (!study.verdict || std::ranges::none_of(results.cases.cases, [](const Case& c) {
        return c.response_modification > 0.0;
      }))
    return {};
  return {results.model.dbe_level > 0.0
              ? fmt::format("Verdict: R gives a building the strength for the design target, "
                            "{:.3g} g; buildings with R are judged at that S_DS alone",
                            results.model.dbe_level)
              : "Verdict: buildings with R are not judged, since there is no single design target "
                "whose S_DS gives their strength"};
}

}  // namespace glissade
