// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/hazard.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "analysis/hazard/design_life.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/fragility/share.hpp"
#include "glissade/study/cases/case_scene.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

constexpr std::size_t curve_points = 61;
constexpr double least_displacement_m = 1e-3;

double mean_of(const std::vector<double>& values, const std::vector<double>& weights) {
  return std::inner_product(weights.begin(), weights.end(), values.begin(), 0.0) /
         static_cast<double>(values.size());
}

/// The lowest intensity at which a history reaches each of some displacements.
class CapacityCurve {
 public:
  CapacityCurve(const Results& results, std::size_t record, std::size_t c)
      : free_(slides_freely(results.cases.cases[c])) {
    const HistoryTable& table = results.histories;
    for (std::size_t level = 0; level < table.levels; ++level)
      nodes_.push_back({results.levels[level], table.displacement_m(record, c, level)});
    for (std::size_t t = 0; t < table.thresholds; ++t) {
      const double capacity = table.capacity(record, c, t);
      if (capacity > 0.0 && std::isfinite(capacity))
        nodes_.push_back({capacity, results.thresholds_m[t]});
    }
    std::ranges::stable_sort(nodes_, {}, &Node::intensity);
  }

  /// At the lowest node it is exceeded already.
  bool is_below_levels(double displacement_m) const {
    return !free_ && nodes_.front().displacement_m > displacement_m;
  }

  /// Infinite where the levels do not reach it; the lowest node where it is below them. On the safe
  /// side where displacement begins between two nodes: its line in the root begins at the lower
  /// one.
  double capacity(double displacement_m) const {
    if (free_) return 0.0;
    const auto at = std::ranges::find_if(
        nodes_, [&](const Node& node) { return node.displacement_m >= displacement_m; });
    if (at == nodes_.end()) return infinity;
    if (at == nodes_.begin() || at->displacement_m == displacement_m ||
        std::isinf(at->displacement_m))
      return at->intensity;
    const Node& before = *(at - 1);
    const double from = std::sqrt(before.displacement_m), to = std::sqrt(at->displacement_m);
    return std::lerp(before.intensity, at->intensity,
                     (std::sqrt(displacement_m) - from) / (to - from));
  }

 private:
  struct Node {
    double intensity = 0.0, displacement_m = 0.0;
  };
  bool free_;
  std::vector<Node> nodes_;
};

struct Rates {
  const HazardConfig& hazard;
  const Results& results;
  CaseSlice cases;
  double highest = hazard.curve.annual_rate(results.levels.back());

  std::size_t records() const { return results.histories.records; }

  /// Of a capacity: one that is not reached counts from the highest level on.
  double rate(double capacity) const {
    return std::isinf(capacity) ? highest : hazard.curve.annual_rate(capacity);
  }

  /// None where no history decides the rate: the records show nothing of what none of them reached.
  Interval interval(const std::vector<double>& by_record) const {
    const bool unseen =
        std::ranges::all_of(by_record, [&](double r) { return r <= (1.0 + 1e-12) * highest; });
    return unseen ? Interval{} : positive_mean_interval(results.histories.by_unit(by_record));
  }

  Estimate estimate(const std::vector<double>& by_record) const {
    return {mean_of(by_record, std::vector<double>(records(), 1.0)), interval(by_record)};
  }

  /// The median of the deaggregation by intensity: the x above which half of the annual rate
  /// arises. Shaking above x contributes the mean over the histories of rate(max(capacity, x)).
  /// Infinite above the levels where a capacity is not known.
  /// @param rates of the histories' capacities
  double half_intensity(std::vector<double> rates, bool all_are_known) const {
    std::ranges::sort(rates, std::greater());
    double of_rest = std::accumulate(rates.begin(), rates.end(), 0.0);
    if (std::isinf(of_rest)) return nan;
    const double half = 0.5 * of_rest;
    for (std::size_t reached = 1;; ++reached) {
      of_rest -= rates[reached - 1];
      const double above_x = (half - of_rest) / static_cast<double>(reached);
      if (reached < rates.size() && above_x < rates[reached]) continue;
      return all_are_known || above_x >= highest ? hazard.curve.intensity_at(above_x) : infinity;
    }
  }

  ThresholdRate of_threshold(const ThresholdFragility& fragility, std::size_t threshold) const {
    std::vector<double> by_record(records()), by_history;
    double beyond = 0.0;
    for (std::size_t record = 0; record < records(); ++record) {
      for (std::size_t i = cases.first; i < cases.first + cases.count; ++i) {
        const double capacity = results.histories.capacity(record, i, threshold);
        by_history.push_back(rate(capacity));
        by_record[record] += by_history.back() / static_cast<double>(cases.count);
        if (std::isinf(capacity)) beyond += highest;
      }
    }
    ThresholdRate row{.threshold_m = fragility.threshold_m};
    row.annual_rate = estimate(by_record);
    if (std::isfinite(row.annual_rate.value))
      row.effective_records = effective_number(results.histories.by_unit(by_record));
    row.beyond_share =
        fragility.censored_share == 1.0
            ? 1.0
            : beyond / (row.annual_rate.value * static_cast<double>(records() * cases.count));
    if (row.is_mostly_assumed()) row.annual_rate.interval = {};
    const FitSummary& fit =
        fragility.capacities.converged() ? fragility.capacities : fragility.stripes;
    row.fit_rate = fit.converged()                           ? annual_rate(hazard.curve, fit.curve)
                   : fit.status == FitStatus::always_exceeds ? infinity
                                                             : nan;
    row.half_intensity = half_intensity(std::move(by_history), beyond == 0.0);
    const double years = hazard.design_life_years;
    row.life_probability = {probability_in(years, row.annual_rate.value),
                            {probability_in(years, row.annual_rate.interval.low),
                             probability_in(years, row.annual_rate.interval.high)}};
    return row;
  }

  /// From the least to the largest displacement there is.
  std::vector<double> displacements_m() const {
    double largest = 10.0 * least_displacement_m;
    for (std::size_t record = 0; record < records(); ++record) {
      for (std::size_t i = cases.first; i < cases.first + cases.count; ++i) {
        for (std::size_t level = 0; level < results.levels.size(); ++level) {
          const double d = results.histories.displacement_m(record, i, level);
          if (std::isfinite(d)) largest = std::max(largest, d);
        }
      }
    }
    std::vector<double> grid;
    for (std::size_t i = 0; i < curve_points; ++i)
      grid.push_back(
          least_displacement_m *
          std::pow(largest / least_displacement_m, static_cast<double>(i) / (curve_points - 1.0)));
    return grid;
  }

  std::vector<DisplacementRate> of_displacements(const std::vector<double>& displacements_m) const {
    std::vector<std::vector<double>> by_record(displacements_m.size(),
                                               std::vector<double>(records()));
    std::vector<std::size_t> below(displacements_m.size(), 0);
    for (std::size_t record = 0; record < records(); ++record) {
      for (std::size_t i = cases.first; i < cases.first + cases.count; ++i) {
        const CapacityCurve curve(results, record, i);
        for (std::size_t d = 0; d < displacements_m.size(); ++d) {
          by_record[d][record] +=
              rate(curve.capacity(displacements_m[d])) / static_cast<double>(cases.count);
          if (curve.is_below_levels(displacements_m[d])) ++below[d];
        }
      }
    }
    std::vector<DisplacementRate> rows;
    for (std::size_t d = 0; d < displacements_m.size(); ++d) {
      DisplacementRate& row = rows.emplace_back(DisplacementRate{
          displacements_m[d], estimate(by_record[d]),
          static_cast<double>(below[d]) / static_cast<double>(records() * cases.count)});
      if (below[d] > 0) row.annual_rate.interval = {};
    }
    return rows;
  }
};

/// Ends of the intervals of rates, falling with displacement; the rate itself where there is none.
struct RateBand {
  std::vector<double> low, high;

  explicit RateBand(const std::vector<DisplacementRate>& curve) {
    for (const DisplacementRate& row : curve) {
      const auto& [rate, interval] = row.annual_rate;
      const bool none = std::isnan(interval.low);
      low.push_back(none ? rate : interval.low);
      high.push_back(none ? rate : interval.high);
    }
    for (std::size_t i = 1; i < low.size(); ++i) low[i] = std::min(low[i], low[i - 1]);
    for (std::size_t i = high.size() - 1; i > 0; --i) high[i - 1] = std::max(high[i - 1], high[i]);
  }
};

/// The first row with a rate of at most so much.
std::size_t first_row(double rate, const std::vector<double>& rates) {
  return static_cast<std::size_t>(std::ranges::find_if(rates, [&](double r) { return r <= rate; }) -
                                  rates.begin());
}

/// Where rates, which fall with displacement, come down to one: linear in logarithms; the first
/// displacement where they begin below it, infinite where they end above it.
double displacement_at(double rate, const std::vector<double>& displacements_m,
                       const std::vector<double>& rates) {
  const std::size_t i = first_row(rate, rates);
  if (i == rates.size()) return infinity;
  if (i == 0 || std::isinf(rates[i - 1])) return displacements_m[i];
  const double share = std::log(rates[i - 1] / rate) / std::log(rates[i - 1] / rates[i]);
  return displacements_m[i - 1] * std::pow(displacements_m[i] / displacements_m[i - 1], share);
}

void add_curve(const Rates& rates, HazardRun& run) {
  const std::vector<double> displacements = rates.displacements_m();
  run.curve = rates.of_displacements(displacements);
  const RateBand band(run.curve);
  for (const double target : rates.hazard.target_rates_per_year) {
    TargetDisplacement& row = run.targets.emplace_back(target_displacement(target, run));
    row.intensity = rates.hazard.curve.intensity_at(target);
    auto& [displacement_m, interval] = row.displacement_m;
    if (std::isfinite(displacement_m) && displacement_m > displacements.front() &&
        row.below_share == 0.0 && rates.results.histories.units() > 1)
      interval = {displacement_at(target, displacements, band.low),
                  displacement_at(target, displacements, band.high)};
  }
}

/// @param sds_g of the site
void add_prescribed(const Rates& rates, const StandardsConfig& standards, double sds_g,
                    HazardRun& run) {
  for (const Standard standard : standards.compare) {
    const Prescription prescribed = prescribed_displacement(standard, sds_g, standards);
    const DisplacementRate row = rates.of_displacements({prescribed.value_m}).front();
    run.prescribed.push_back({standard, sds_g, prescribed, row.annual_rate, row.below_share});
  }
}

}  // namespace

TargetDisplacement target_displacement(double annual_rate, const HazardRun& run) {
  std::vector<double> displacements_m, rates;
  for (const DisplacementRate& row : run.curve) {
    displacements_m.push_back(row.displacement_m);
    rates.push_back(row.annual_rate.value);
  }
  TargetDisplacement target{annual_rate,
                            {displacement_at(annual_rate, displacements_m, rates), {}}};
  const std::size_t row = first_row(annual_rate, rates);
  if (row < rates.size()) target.below_share = run.curve[row].below_share;
  if (row == 0 && target.below_share > 0.0) target.displacement_m.value = nan;
  return target;
}

HazardResults HazardAnalysis::find(const StudyConfig& config, const Results& results) {
  const HazardConfig& hazard = *config.hazard;
  const BootstrapOptions options{.seed = config.seed,
                                 .replicates = config.sampling.bootstrap_replicates};
  HazardResults found{.source = hazard.source, .design_life_years = hazard.design_life_years};
  for (const HazardPoint& p : hazard.curve.points()) {
    found.intensity.push_back(p.intensity);
    found.intensity_rate.push_back(p.annual_rate);
  }
  found.beyond_rate = hazard.curve.annual_rate(results.levels.back());
  found.residual_vectors = !results.histories.fields.residual_along_m.empty();
  for (const RunResults& run : results.runs) {
    const Rates rates{hazard, results, slice_of(run)};
    HazardRun& row = found.runs.emplace_back();
    row.label = run.label;
    for (std::size_t t = 0; t < run.fragilities.size(); ++t)
      row.thresholds.push_back(rates.of_threshold(run.fragilities[t], t));
    add_curve(rates, row);
    const double sds_g = hazard.sds_g > 0.0 ? hazard.sds_g : results.model.dbe_level;
    if (sds_g > 0.0) add_prescribed(rates, config.standards, sds_g, row);
    add_design_life(hazard, results, slice_of(run), options, row);
  }
  return found;
}

}  // namespace glissade
