// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/model_uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "analysis/shape/threshold_data.hpp"
#include "glissade/core/in_parallel.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

double AtEnds::change() const {
  const auto [least, largest] = std::minmax({low, calculated, high});
  if (std::isnan(low + calculated + high)) return nan;
  return least == largest ? 0.0 : (largest - least) / calculated;
}

std::string PremiseEffect::name() const { return unit.empty() ? premise : premise + ", " + unit; }

void sort_by_change(std::vector<PremiseEffect>& effects) {
  std::ranges::stable_sort(effects, std::greater(), [](const PremiseEffect& effect) {
    const double change = effect.result.change();
    return std::isnan(change) ? -1.0 : change;
  });
}

FrictionValue friction_value_of(const Results& results, const RunResults& run) {
  return run.first_case < results.cases.cases.size()
             ? results.cases.cases[run.first_case].friction_value
             : FrictionValue::as_drawn;
}

std::size_t governing_run(const Results& results) {
  const auto exceeds = [&](std::size_t i) {
    double sum = 0.0;
    if (results.hazard) {
      for (const ThresholdRate& row : results.hazard->runs[i].thresholds)
        sum += std::log(std::max(row.annual_rate.value, std::numeric_limits<double>::min()));
      return sum;
    }
    for (const ThresholdFragility& fragility : results.runs[i].fragilities)
      for (const double share : fragility.probability) sum += share;
    return sum;
  };
  return run_of_largest(results, exceeds);
}

namespace {

struct Found {
  double intensity = nan, probability = nan;
};

/// What the histories of one run give of one threshold.
class RunAtThreshold {
 public:
  RunAtThreshold(const StudyConfig& study, const Results& results, const RunResults& run,
                 std::size_t threshold)
      : study_(study), results_(results), threshold_(threshold), run_(run) {
    for (std::size_t i = results.levels.size(); i-- > 0;)
      if (earthquake_name(results.levels[i], results.model.dbe_level) == "DBE") dbe_ = i;
    all_ = of_run(run_);
  }

  ModelUncertainty uncertainty() const {
    ModelUncertainty found{results_.thresholds_m[threshold_], {}, not_varied()};
    add_listed(found.effects);
    for (std::size_t i = 0; i < parameters().size(); ++i)
      if (study_.quantities[i].is_drawn()) add_drawn(parameters()[i], found.effects);
    add_records(found.effects);
    sort_by_change(found.effects);
    return found;
  }

 private:
  static double at_half(const FitSummary& fit) {
    return fit.converged() ? fit.curve.intensity_at(0.5) : nan;
  }
  Found of_run(const RunResults& run) const {
    const ThresholdFragility& of = run.fragilities[threshold_];
    return {at_half(of.curve_fit()), dbe_ ? of.probability[*dbe_] : nan};
  }
  /// Of some cases alone.
  Found of_cases(const std::vector<std::size_t>& cases) const {
    const HistoryTable& table = results_.histories;
    double histories = 0.0, exceeding = 0.0;
    for (std::size_t record = 0; dbe_ && record < table.records; ++record) {
      if (!table.has(record, *dbe_)) continue;
      for (const std::size_t i : cases) {
        histories += 1.0;
        if (table.displacement_m(record, i, *dbe_) >= results_.thresholds_m[threshold_])
          exceeding += 1.0;
      }
    }
    return {at_half(results_.by_stripes
                        ? fit_stripes(stripes_of(results_, cases, threshold_), Independent::records)
                        : fit_brackets(by_unit(capacities_of(table, cases, threshold_,
                                                             results_.levels.back()),
                                               table),
                                       Independent::records)),
            exceeding / histories};
  }
  PremiseEffect effect(const std::string& premise, const std::string& unit, const char* ends,
                       double low, double high, const Found& at_low, const Found& at_high) const {
    return {premise,
            unit == "-" ? "" : unit,
            ends,
            low,
            high,
            {at_low.intensity, all_.intensity, at_high.intensity},
            {at_low.probability, all_.probability, at_high.probability}};
  }

  /// The first and the last value of each list; which of the frictions is run is no premise.
  void add_listed(std::vector<PremiseEffect>& effects) const {
    const CaseSet& set = results_.cases;
    const std::size_t here = run_.first_case / set.per_combination();
    for (std::size_t axis = 0; axis < set.axes.size(); ++axis) {
      const CaseAxis& listed = set.axes[axis];
      const auto run_at = [&](std::size_t place) {
        std::vector<std::size_t> places = set.places(here);
        places[axis] = place;
        return std::ranges::find(results_.runs, set.combination(places) * set.per_combination(),
                                 &RunResults::first_case);
      };
      const auto low = run_at(0), high = run_at(listed.size() - 1);
      if (listed.key == "friction.value" || low == results_.runs.end() ||
          high == results_.runs.end())
        continue;
      const bool is_number = listed.names.empty();
      effects.push_back(
          effect(listed.words(), listed.unit, "listed", is_number ? listed.values.front() : nan,
                 is_number ? listed.values.back() : nan, of_run(*low), of_run(*high)));
      if (!is_number)
        effects.back().ends = listed.described.front() + "; " + listed.described.back();
    }
  }

  /// The third of the cases with the lowest values and that with the highest, each with what equals
  /// its last; of a few values the lowest and the highest.
  void add_drawn(const Parameter& parameter, std::vector<PremiseEffect>& effects) const {
    const auto value = [&](std::size_t i) { return value_of(parameter, results_.cases.cases[i]); };
    std::vector<std::size_t> cases = all_of(slice_of(run_));
    std::ranges::stable_sort(cases, {}, value);
    const std::size_t third = (cases.size() + 2) / 3;
    double low = value(cases[third - 1]), high = value(cases[cases.size() - third]);
    if (low == high) low = value(cases.front()), high = value(cases.back());
    if (low == high) return;
    const std::vector<std::size_t> lower(cases.begin(),
                                         std::ranges::upper_bound(cases, low, {}, value)),
        upper(std::ranges::lower_bound(cases, high, {}, value), cases.end());
    effects.push_back(effect(parameter.words, parameter.unit, "medians of a third of the samples",
                             value(lower[lower.size() / 2]), value(upper[upper.size() / 2]),
                             of_cases(lower), of_cases(upper)));
  }

  void add_records(std::vector<PremiseEffect>& effects) const {
    const ThresholdFragility& of = run_.fragilities[threshold_];
    const Interval intensity = of.curve_fit().p50_interval,
                   probability = dbe_ ? of.probability_interval[*dbe_] : Interval();
    if (std::isnan(intensity.low) && std::isnan(probability.low)) return;
    effects.push_back(effect("records", "-", "95 % interval", nan, nan,
                             {intensity.low, probability.low}, {intensity.high, probability.high}));
    effects.back().is_of_records = true;
  }

  /// Those of the usual premises that have one value in all cases.
  std::string not_varied() const {
    std::string text;
    for (const auto& [table, key] : {std::pair{"friction", "mu"},
                                     {"roof", "slope_deg"},
                                     {"building", "period_s"},
                                     {"building", "alpha"},
                                     {"building", "damping"},
                                     {"building", "mass_ratio"}}) {
      const Parameter& p = parameters()[parameter_index(table, key)];
      const bool is_of_building = p.moves_roof();
      const Quantity& quantity = study_.quantities.at(table, key);
      const double value = value_of(p, results_.cases.cases.front(), results_.building);
      if (quantity.is_drawn() || quantity.values.size() > 1 || std::isnan(value) ||
          (is_of_building && results_.suites.front().of_roof))
        continue;
      text += fmt::format("{}{} {:.3g}{}", text.empty() ? "" : ", ", p.words, value,
                          p.unit == std::string("-") ? "" : std::string(" ") + p.unit);
      if (key == std::string("period_s") && value == 0.0) break;
    }
    return text;
  }

  const StudyConfig& study_;
  const Results& results_;
  std::size_t threshold_;
  const RunResults& run_;
  std::optional<std::size_t> dbe_;
  Found all_;
};

}  // namespace

std::vector<ModelUncertainty> ModelUncertaintyAnalysis::find(const StudyConfig& study,
                                                             const Results& results) {
  if (results.runs.empty()) return {};
  const RunResults& run = results.runs[governing_run(results)];
  std::vector<ModelUncertainty> found(results.thresholds_m.size());
  in_parallel(found.size(), [&](std::size_t threshold) {
    found[threshold] = RunAtThreshold(study, results, run, threshold).uncertainty();
  });
  return found;
}

}  // namespace glissade
