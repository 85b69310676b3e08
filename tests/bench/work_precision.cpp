// SPDX-License-Identifier: GPL-3.0-or-later
#include "work_precision.hpp"

#include <algorithm>
#include <span>

#include "timing.hpp"
#include "truth.hpp"

namespace glissade::bench {
namespace {

using test::StandardScene;
using test::StandardScenes;

/// Below this a peak has no relative error that anyone needs.
constexpr double least_peak_m = 1e-3;

/// [scheme][scene]; NaN where a scheme was not run.
struct Measured {
  std::vector<std::vector<double>> microseconds, peaks_m;
};

/// Calls `peak` on each of the wanted histories, in rounds over them: a history is timed alone,
/// between others with other parameters, as in a study. Repeated at once, its branches would be
/// predicted better than ever in use. Gives (peak, median time in microseconds) to `take`.
template <class Take>
void time_histories(const PeakScheme& peak, const std::vector<History>& histories,
                    const std::vector<std::size_t>& wanted, std::size_t rounds, double overhead_s,
                    Take take) {
  std::vector seconds(wanted.size(), std::vector(rounds, 0.0));
  std::vector<double> peaks(wanted.size());
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const auto start = Clock::now();
      peaks[k] = peak(histories[wanted[k]]);
      seconds[k][round] = seconds_since(start) - overhead_s;
    }
  }
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const double time_s = median(seconds[k]);
    take(wanted[k], peaks[k], 1e6 * std::max(time_s, 0.0));
  }
}

/// All schemes side by side on each roof, so that the machine's moods strike all alike: the exact
/// ones on every scene, the others on the chosen.
Measured measure(const StandardScenes& all, const std::vector<bool>& chosen,
                 const std::vector<Scheme>& schemes) {
  Measured measured;
  measured.microseconds.assign(schemes.size(), std::vector(all.scenes.size(), std::nan("")));
  measured.peaks_m = measured.microseconds;
  const double overhead_s = clock_seconds();
  const auto on_roof = [&](const test::RoofInput& input, std::span<const StandardScene> here) {
    const auto first = static_cast<std::size_t>(here.data() - all.scenes.data());
    const Roof roof{input, roof_motion(input.ground, input.building, input.follow)};
    std::vector<History> histories;
    std::vector<std::size_t> every, some;
    for (std::size_t i = 0; i < here.size(); ++i) {
      histories.push_back({here[i].block, here[i].factor(all.components), here[i].vertical,
                           here[i].excitation(all.components, roof.motion)});
      every.push_back(i);
      if (chosen[first + i]) some.push_back(i);
    }
    for (std::size_t s = 0; s < schemes.size(); ++s) {
      time_histories(schemes[s].on_roof(roof), histories, schemes[s].exact ? every : some,
                     schemes[s].exact ? 5 : 3, overhead_s,
                     [&](std::size_t i, double peak_m, double microseconds) {
                       measured.peaks_m[s][first + i] = peak_m;
                       measured.microseconds[s][first + i] = microseconds;
                     });
    }
  };
  test::for_each_roof(all.components, all.scenes, on_roof);
  return measured;
}

template <class Wanted>
Times times_where(const std::vector<double>& microseconds, Wanted wanted) {
  std::vector<double> chosen;
  for (std::size_t i = 0; i < microseconds.size(); ++i)
    if (wanted(i)) chosen.push_back(microseconds[i]);
  if (chosen.empty()) return {};
  return {chosen.size(), median(chosen), mean(chosen)};
}

void judge(const std::vector<double>& peaks_m, const std::vector<Truth>& truths,
           const StandardScenes& all, const std::vector<bool>& chosen, SchemeResult& result) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const double exact = truths[i].peak_m(result.problem);
    if (!chosen[i] || truths[i].uplift || !(exact > least_peak_m)) continue;
    errors.push_back(std::abs(peaks_m[i] / exact - 1.0));
    if (result.worst_scene.empty() || errors.back() > result.largest_error) {
      result.largest_error = errors.back();
      result.worst_scene = all.scenes[i].describe(all.components);
    }
  }
  result.judged = errors.size();
  result.median_error = median(errors);
}

Agreement agreement(const std::string& schemes, const std::vector<double>& peaks_m,
                    const std::vector<double>& reference_m, const StandardScenes& all) {
  Agreement result{.schemes = schemes};
  for (std::size_t i = 0; i < peaks_m.size(); ++i) {
    const double apart_m = std::abs(peaks_m[i] - reference_m[i]);
    if (reference_m[i] <= least_peak_m) {
      result.largest_still_difference_m = std::max(result.largest_still_difference_m, apart_m);
      continue;
    }
    ++result.histories;
    if (apart_m > result.largest_difference * reference_m[i]) {
      result.largest_difference = apart_m / reference_m[i];
      result.worst_scene = all.scenes[i].describe(all.components);
    }
  }
  return result;
}

void add_groups(const std::string& scheme, const std::vector<double>& microseconds,
                const StandardScenes& all, std::vector<GroupResult>& groups) {
  const auto add = [&](const char* group, auto wanted) {
    groups.push_back({scheme, group, times_where(microseconds, [&](std::size_t i) {
                        return wanted(all.scenes[i]);
                      })});
  };
  const auto paired = [&](const StandardScene& s) {
    return !all.components[s.component].vertical_mps2.empty();
  };
  add("all", [](const StandardScene&) { return true; });
  add("without vertical", [](const StandardScene& s) { return !s.vertical; });
  add("rigid, without vertical",
      [](const StandardScene& s) { return !s.vertical && s.period_s == 0.0; });
  add("buildings, without vertical",
      [](const StandardScene& s) { return !s.vertical && s.period_s > 0.0; });
  add("with vertical", [](const StandardScene& s) { return s.vertical; });
  add("the same without it", [&](const StandardScene& s) { return !s.vertical && paired(s); });
}

}  // namespace

WorkPrecision work_precision(const StandardScenes& all, std::size_t stride, bool quick) {
  const std::vector<Scheme> compared = schemes(quick);
  std::vector<bool> chosen(all.scenes.size(), false);
  for (std::size_t i = 0; i < chosen.size(); i += stride) chosen[i] = true;

  const std::vector<Truth> truths = truths_of(all, chosen);
  WorkPrecision result{.scenes = all.scenes.size()};
  for (std::size_t i = 0; i < truths.size(); ++i) {
    result.compared += chosen[i];
    result.uplift += chosen[i] && truths[i].uplift;
    result.still += chosen[i] && !truths[i].uplift && truths[i].samples_m <= least_peak_m;
  }
  const Measured measured = measure(all, chosen, compared);
  const auto readable = static_cast<std::size_t>(
      std::ranges::find(compared, "slide", &Scheme::family) - compared.begin());
  for (std::size_t s = 0; s < compared.size(); ++s) {
    const std::vector<double>& microseconds = measured.microseconds[s];
    SchemeResult row{.family = compared[s].family,
                     .label = compared[s].label,
                     .problem = compared[s].problem,
                     .exact = compared[s].exact};
    row.all = times_where(microseconds, [&](std::size_t i) { return chosen[i]; });
    row.sliding = times_where(microseconds, [&](std::size_t i) {
      return chosen[i] && truths[i].samples_m > least_peak_m;
    });
    if (compared[s].problem != Problem::none) judge(measured.peaks_m[s], truths, all, chosen, row);
    result.schemes.push_back(row);
    if (!compared[s].exact) continue;
    add_groups(compared[s].family, microseconds, all, result.groups);
    if (compared[s].problem == Problem::samples && s != readable)
      result.agreements.push_back(agreement(compared[s].family + " and slide", measured.peaks_m[s],
                                            measured.peaks_m[readable], all));
  }
  return result;
}

}  // namespace glissade::bench
