// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/record_selection.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "record_screening.hpp"
#include "spectral_scaling.hpp"

namespace glissade {
namespace {

constexpr double factor_weight = 0.01;

/// SRSS spectrum of a candidate relative to the target.
struct Candidate {
  std::size_t record;
  std::vector<double> spectrum_g;
  double mean_log, mean_log_square;  ///< of ln(Sa / target), unscaled

  double closest_factor() const { return std::exp(-mean_log); }
  /// Mean square over the periods of ln(scale x Sa / target).
  double misfit_square(double scale) const {
    const double log_scale = std::log(scale);
    return std::max(0.0, mean_log_square + log_scale * (2.0 * mean_log + log_scale));
  }
};

Candidate candidate_of(const Suite& library, std::size_t record,
                       const std::vector<double>& target_g, const std::vector<double>& periods_s) {
  const Motion& motion = library.motions[record];
  Candidate candidate{record, srss_spectrum_g(motion, periods_s), 0.0, 0.0};
  const auto count = static_cast<double>(target_g.size());
  for (std::size_t i = 0; i < target_g.size(); ++i) {
    const double log_ratio = std::log(candidate.spectrum_g[i] / target_g[i]);
    candidate.mean_log += log_ratio / count;
    candidate.mean_log_square += log_ratio * log_ratio / count;
  }
  return candidate;
}

using Choice = std::vector<std::size_t>;  ///< which candidates

/// Smaller is better: distance of the average below the target, then the misfit.
struct Score {
  double shortfall = 0.0;
  double misfit = 0.0;
  auto operator<=>(const Score&) const = default;
};

/// The search for a set of candidates.
class Selector {
 public:
  Selector(const Suite& library, const std::vector<Candidate>& candidates,
           const std::vector<double>& target_g, const SelectionCriteria& criteria)
      : candidates_(candidates), target_g_(target_g), criteria_(criteria) {
    for (const Candidate& candidate : candidates)
      events_.push_back(&library.motions[candidate.record].event);
  }

  Choice best() const {
    Choice choice = closest();
    Score score = score_of(choice);
    while (const auto better = best_exchange(choice, score)) {
      choice = *better;
      score = score_of(choice);
    }
    return choice;
  }

  /// As scale_suite_to_target, to four decimals: upwards, so that the average stays above.
  std::vector<double> scales_of(const Choice& choice) const {
    std::vector<double> scales = factors_of(choice);
    for (double& scale : scales)
      scale = std::min(std::ceil(scale * 1e4) / 1e4, criteria_.max_scale);
    return scales;
  }

  Spectra spectra_of(const Choice& choice) const {
    Spectra spectra;
    for (const std::size_t k : choice) spectra.emplace_back(candidates_[k].spectrum_g);
    return spectra;
  }

 private:
  std::vector<double> factors_of(const Choice& choice) const {
    std::vector<double> closest_factors;
    for (const std::size_t k : choice) closest_factors.push_back(candidates_[k].closest_factor());
    return lift_to_target(closest_factors, spectra_of(choice), target_g_, criteria_.max_scale)
        .factors;
  }

  Score score_of(const Choice& choice) const {
    const std::vector<double> factors = factors_of(choice);
    Score score;
    for (std::size_t i = 0; i < choice.size(); ++i) {
      const double log_factor = std::log(std::max(factors[i], 1.0));
      score.misfit += candidates_[choice[i]].misfit_square(factors[i]) +
                      factor_weight * log_factor * log_factor;
    }
    // Only if all are at the limit can the average be below; otherwise it is equal at one period.
    if (std::ranges::min(factors) >= criteria_.max_scale) {
      const double lowest = lowest_ratio(factors, spectra_of(choice), target_g_).ratio;
      score.shortfall = std::max(0.0, 1.0 - lowest);
    }
    return score;
  }

  /// The records that are closest to the target individually.
  Choice closest() const {
    std::vector<double> misfits;
    for (const Candidate& c : candidates_)
      misfits.push_back(c.misfit_square(std::min(c.closest_factor(), criteria_.max_scale)));
    Choice order(candidates_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return misfits[k]; });
    Choice choice;
    for (const std::size_t k : order) {
      if (choice.size() < criteria_.count &&
          may_join(choice, choice.size(), k, events_, criteria_.per_event))
        choice.push_back(k);
    }
    std::ranges::sort(choice);
    return choice;
  }

  /// The exchange of one record that gives the best score, if that is below `score`.
  std::optional<Choice> best_exchange(const Choice& choice, Score score) const {
    std::optional<Choice> best;
    for (std::size_t out = 0; out < choice.size(); ++out) {
      for (std::size_t k = 0; k < candidates_.size(); ++k) {
        if (!may_join(choice, out, k, events_, criteria_.per_event)) continue;
        Choice exchanged = choice;
        exchanged[out] = k;
        // One order for one set: its score must not depend on the sequence of exchanges.
        std::ranges::sort(exchanged);
        const Score reached = score_of(exchanged);
        if (!(reached < score)) continue;
        score = reached;
        best = std::move(exchanged);
      }
    }
    return best;
  }

  const std::vector<Candidate>& candidates_;
  std::vector<const std::string*> events_;
  const std::vector<double>& target_g_;
  const SelectionCriteria& criteria_;
};

}  // namespace

RecordSelection select_records(const Suite& library,
                               const std::function<double(double)>& target_sa_g,
                               const std::vector<double>& periods_s,
                               const SelectionCriteria& criteria) {
  GLISSADE_EXPECTS(!periods_s.empty());
  Screening screening = screen(library, criteria);
  const std::vector<double> target_g = target_at(target_sa_g, periods_s);
  std::vector<Candidate> candidates;
  for (const std::size_t record : screening.candidates)
    candidates.push_back(candidate_of(library, record, target_g, periods_s));

  const Selector selector(library, candidates, target_g, criteria);
  const Choice choice = selector.best();
  const std::vector<double> scales = selector.scales_of(choice);

  RecordSelection selection;
  selection.candidates = candidates.size();
  selection.left_out = std::move(screening.left_out);
  for (std::size_t i = 0; i < choice.size(); ++i) {
    const Candidate& candidate = candidates[choice[i]];
    selection.records.push_back(
        {candidate.record, scales[i], std::sqrt(candidate.misfit_square(scales[i]))});
  }
  std::ranges::stable_sort(selection.records, {}, &SelectedRecord::misfit);
  const std::vector<double> ratios = average_ratios(scales, selector.spectra_of(choice), target_g);
  const auto [lowest, highest] = std::ranges::minmax_element(ratios);
  selection.lowest = {*lowest, periods_s[static_cast<std::size_t>(lowest - ratios.begin())]};
  selection.highest = {*highest, periods_s[static_cast<std::size_t>(highest - ratios.begin())]};
  return selection;
}

}  // namespace glissade
