// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/capacities.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "glissade/core/finite.hpp"

namespace glissade {
namespace {

constexpr double capacity_tolerance =
    1e-4;  // of the capacity: far below the spread between records

/// The search for one capacity.
struct CapacitySearch {
  /// The batch must run a history first.
  struct NotReady {};

  Histories& histories;
  std::span<const double> levels, peaks_m;
  double threshold_m;
  double capacity = 0.0;
  WorkCount count = {};

  /// Searches from the beginning, which the histories already run decide again at once.
  /// @return whether none lacks; else it is prepared
  bool ends() {
    count = {};
    try {
      capacity = first_crossing();
      return true;
    } catch (const NotReady&) {
      return false;
    }
  }

 private:
  /// The lowest level at which the peak displacement reaches the threshold: bracketed on the
  /// study's levels, then solved in the square root of slip, which is nearly linear in intensity
  /// (TOMS 748: Alefeld, Potra & Shi 1995).
  double first_crossing() {
    const auto reached =
        std::ranges::find_if(peaks_m, [&](double peak_m) { return peak_m >= threshold_m; });
    if (reached == peaks_m.end()) return infinity;
    const auto first = static_cast<std::size_t>(reached - peaks_m.begin());
    const double high = levels[first], low = first > 0 ? levels[first - 1] : 0.0;
    const double at_high = excess(*reached),
                 at_low = first > 0 ? excess(peaks_m[first - 1]) : excess_at(0.0);
    if (at_low >= 0.0) return 0.0;  // it is exceeded without shaking
    if (at_high == 0.0) return high;
    std::uintmax_t evaluations = 60;
    const auto bracket = boost::math::tools::toms748_solve(
        [&](double level) { return excess_at(level); }, low, high, at_low, at_high,
        [](double a, double b) { return b - a <= capacity_tolerance * b; }, evaluations);
    return 0.5 * (bracket.first + bracket.second);
  }

  /// Of one that did not converge it is only said that it reaches the threshold: any finite value
  /// above zero says so to the solver, which forms differences and quotients.
  double excess(double peak_m) const {
    const double at_threshold = std::sqrt(threshold_m);
    return std::isinf(peak_m) ? at_threshold : std::sqrt(peak_m) - at_threshold;
  }

  double excess_at(double level) {
    if (histories.does_not_slide(level)) return excess(0.0);
    if (!histories.is_ready(level)) {
      histories.prepare(level);
      throw NotReady();
    }
    return excess(run_history(histories, level, {}, count).peak_displacement_m);
  }
};

}  // namespace

void find_capacities(const StudyConfig& config, std::span<const std::unique_ptr<Histories>> cases,
                     TwoAxisBatch& batch, HistoryFields& fields, WorkCount& count) {
  const std::span<const double> levels = config.intensity.levels;
  const std::span<const double> peaks_m =
      std::span(fields.peak_displacement_m).last(cases.size() * levels.size());
  std::vector<CapacitySearch> searches;
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (const double threshold_m : config.thresholds_m())
      searches.push_back(
          {*cases[i], levels, peaks_m.subspan(i * levels.size(), levels.size()), threshold_m});
  std::vector<CapacitySearch*> open;
  for (CapacitySearch& search : searches) open.push_back(&search);
  while (!open.empty()) {
    std::erase_if(open, [](CapacitySearch* search) { return search->ends(); });
    batch.run();
  }
  for (const CapacitySearch& search : searches) {
    fields.capacity.push_back(search.capacity);
    fields.search_failed.push_back(search.count.failed > 0 ? 1 : 0);
    count.searched += search.count.integrated;
    count.failed += search.count.failed;
    if (search.count.integrated == 0 && search.count.from_curve == 0) ++count.decided;
  }
}

}  // namespace glissade
