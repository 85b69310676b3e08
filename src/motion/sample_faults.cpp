// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/sample_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "glissade/core/units.hpp"

namespace glissade {
namespace {

/// Neighbours of one value, [begin, end).
struct FlatRun {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};

template <class Take>
void for_each_run(std::span<const double> a, Take take) {
  for (FlatRun run; run.begin < a.size(); run.begin = run.end) {
    run.end = run.begin + 1;
    while (run.end < a.size() && a[run.end] == a[run.begin]) ++run.end;
    take(run);
  }
}

/// The smallest step between neighbours: that of the recorder, or of the digits printed.
double resolution(std::span<const double> a) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < a.size(); ++i)
    if (a[i] != a[i - 1]) smallest = std::min(smallest, std::abs(a[i] - a[i - 1]));
  return smallest;
}

/// A recorder at the end of its range gives its largest value again and again: in two places or
/// more, or for long. A peak of few steps of the recorder does so too, and is not judged.
std::size_t clipped_samples(std::span<const double> a) {
  constexpr std::size_t repeated = 4, long_run = 8;
  constexpr double least_steps = 100.0;
  const auto [low, high] = std::ranges::minmax_element(a);
  if (*high - *low < least_steps * resolution(a)) return 0;
  std::size_t samples = 0;
  for (const double extreme : {*low, *high}) {
    std::size_t runs = 0, count = 0, longest = 0;
    for_each_run(a, [&](const FlatRun& run) {
      if (a[run.begin] != extreme || run.size() < repeated) return;
      ++runs;
      count += run.size();
      longest = std::max(longest, run.size());
    });
    if (runs >= 2 || longest >= long_run) samples += count;
  }
  return samples;
}

/// The largest sample stands alone: its neighbours and all others are far below it.
bool is_spike(std::span<const double> a, std::size_t at) {
  constexpr double neighbour = 0.3, others = 0.5;
  constexpr std::size_t beside = 2;
  const double peak = std::abs(a[at]);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t apart = i > at ? i - at : at - i;
    if (apart == 0) continue;
    const double most = apart == 1 ? neighbour : apart <= beside ? 1.0 : others;
    // A neighbour of the other sign is part of the spike.
    const double value = apart == 1 ? a[i] * std::copysign(1.0, a[at]) : std::abs(a[i]);
    if (value > most * peak) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> sample_faults(std::span<const double> a) {
  constexpr std::size_t least = 50;
  constexpr double most_flat = 0.5;
  if (a.size() < least) return {};
  std::size_t longest = 0, begin = 0;
  for_each_run(a, [&](const FlatRun& run) {
    // Zeros before and behind a motion are padding.
    const bool is_padding = a[run.begin] == 0.0 && (run.begin == 0 || run.end == a.size());
    if (run.size() > longest && (!is_padding || run.size() == a.size()))
      longest = run.size(), begin = run.begin;
  });
  if (longest == a.size())
    return {fmt::format("all {} samples are {:.3g} g: a dead channel?", a.size(),
                        a.front() / standard_gravity_mps2)};
  std::vector<std::string> faults;
  if (static_cast<double>(longest) > most_flat * static_cast<double>(a.size()))
    faults.push_back(fmt::format("flat: {} of {} samples, from sample {} on, are {:.3g} g", longest,
                                 a.size(), begin + 1, a[begin] / standard_gravity_mps2));
  const auto at = static_cast<std::size_t>(
      std::ranges::max_element(a, {}, [](double x) { return std::abs(x); }) - a.begin());
  const double peak_g = std::abs(a[at]) / standard_gravity_mps2;
  if (const std::size_t clipped = clipped_samples(a); clipped > 0)
    faults.push_back(
        fmt::format("clipped? {} samples in runs are its largest or smallest value, {:.3g} g",
                    clipped, peak_g));
  if (is_spike(a, at))
    faults.push_back(
        fmt::format("a spike? sample {}, {:.3g} g, is alone far above all others", at + 1, peak_g));
  return faults;
}

}  // namespace glissade
