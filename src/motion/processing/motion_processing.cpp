// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/motion_processing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/record_edit.hpp"

namespace glissade {
namespace {

[[noreturn]] void refuse(const Motion& motion, std::string what, const char* remedy) {
  throw InputError({motion.id, std::move(what), remedy, ""});
}

/// `change` of every component there is.
template <class Change>
void change_components(Motion& motion, Change change) {
  for (Samples* component :
       {&motion.horizontal_mps2[0], &motion.horizontal_mps2[1], &motion.vertical_mps2})
    if (!component->empty()) *component = change(*component);
}

std::string corners(const ButterworthBand& band) {
  if (!band.high_hz) return fmt::format("high-pass {:g} Hz", *band.low_hz);
  if (!band.low_hz) return fmt::format("low-pass {:g} Hz", *band.high_hz);
  return fmt::format("band-pass {:g} to {:g} Hz", *band.low_hz, *band.high_hz);
}

void filter(Motion& motion, const ButterworthBand& band) {
  const double highest_hz = 0.5 / motion.dt_s;
  for (const std::optional<double>& corner_hz : {band.low_hz, band.high_hz}) {
    if (corner_hz && *corner_hz >= highest_hz)
      refuse(motion,
             fmt::format("a corner of its band_pass, {:g} Hz, is not below {:g} Hz, half of its "
                         "sampling rate",
                         *corner_hz, highest_hz),
             "give a lower corner, or leave it out");
  }
  const double pad_s = 0.75 * band.order / band.low_hz.value_or(band.high_hz.value_or(1.0));
  const double pad = std::ceil(pad_s / motion.dt_s);
  const std::size_t size = motion.horizontal_mps2[0].size();
  if (2.0 * pad + static_cast<double>(size) > static_cast<double>(most_samples))
    refuse(motion,
           fmt::format("the filter needs zeros of {:g} s before and after it, more than {} samples "
                       "in all",
                       pad_s, most_samples),
           "give a higher corner");
  const auto zeros = static_cast<std::size_t>(pad);
  change_components(motion, [&](const Samples& a) {
    std::vector<double> padded(zeros + a.size() + zeros, 0.0);
    std::ranges::copy(a, padded.begin() + static_cast<std::ptrdiff_t>(zeros));
    return band_passed(padded, motion.dt_s, band);
  });
  motion.processing.push_back(fmt::format(
      "{}, Butterworth of order {} forwards and backwards (gain 1/2 at each corner), with {:.3g} s "
      "of zeros before and after",
      corners(band), band.order, pad * motion.dt_s));
}

double in_one_turn(double angle_deg) {
  const double turned = std::fmod(angle_deg, 360.0);
  return turned < 0.0 ? turned + 360.0 : turned;
}

void rotate(Motion& motion, double to_deg, const char* name, const MotionDirections& directions) {
  constexpr double degree = std::numbers::pi / 180.0, most_off_deg = 5.0;
  const auto& [first, second] = motion.horizontal_mps2;
  if (second.empty())
    refuse(motion, "is to be rotated and has one horizontal", "give its second horizontal");
  const auto& [first_deg, second_deg] = directions.horizontal_deg;
  if (!first_deg || !second_deg)
    refuse(motion, "is to be rotated, and the azimuths of its horizontals are not known",
           "state azimuth_deg of first and second: first = { file = ..., azimuth_deg = 67 }");
  const double between_deg = std::abs(std::remainder(*second_deg - *first_deg, 180.0));
  if (between_deg < 90.0 - most_off_deg)
    refuse(motion,
           fmt::format("is to be rotated, and its horizontals, of {:g} and {:g} degrees, are not "
                       "perpendicular",
                       *first_deg, *second_deg),
           "correct azimuth_deg of first and second");
  // first = north cos a + east sin a, second = north cos b + east sin b.
  const double a = *first_deg * degree, b = *second_deg * degree, to = to_deg * degree;
  const double sine = std::sin(b - a);
  const auto along = [&](double azimuth) {
    const double of_first = std::sin(b - azimuth) / sine, of_second = std::sin(azimuth - a) / sine;
    std::vector<double> samples(first.size());
    std::ranges::transform(first, second, samples.begin(),
                           [&](double x, double y) { return of_first * x + of_second * y; });
    return samples;
  };
  motion.horizontal_mps2 = {along(to), along(to + 0.5 * std::numbers::pi)};
  motion.processing.push_back(
      fmt::format("horizontals rotated from {:g} and {:g} degrees to {:g}{} and {:g}", *first_deg,
                  *second_deg, in_one_turn(to_deg), name, in_one_turn(to_deg + 90.0)));
}

void rotate(Motion& motion, const MotionProcessing& processing,
            const MotionDirections& directions) {
  if (processing.rotate_to_deg) return rotate(motion, *processing.rotate_to_deg, "", directions);
  if (!processing.rotate_to) return;
  if (!directions.strike_deg)
    refuse(motion, "is to be rotated to its fault, whose strike is not known",
           "state strike_deg of the record, clockwise from north");
  const bool is_normal = *processing.rotate_to == FaultAxis::normal;
  rotate(motion, *directions.strike_deg + (is_normal ? 90.0 : 0.0),
         is_normal ? " (fault-normal)" : " (fault-parallel)", directions);
}

double largest_g(const Motion& motion) {
  double largest = 0.0;
  for (const Samples* a :
       {&motion.horizontal_mps2[0], &motion.horizontal_mps2[1], &motion.vertical_mps2})
    largest = std::max(largest, peak_ground_acceleration_mps2({a->data(), a->size()}));
  return largest / standard_gravity_mps2;
}

void trim(Motion& motion, const std::array<double, 2>& percent) {
  const auto& [first, second] = motion.horizontal_mps2;
  const auto [from_s, to_s] =
      arias_times_s(motion.dt_s, {first.data(), first.size()}, {second.data(), second.size()},
                    {0.01 * percent[0], 0.01 * percent[1]});
  if (!(to_s > from_s))
    refuse(motion, "is to be trimmed by Arias intensity, and is zero throughout",
           "leave it out of the suite");
  const double before_g = largest_g(motion);
  const std::size_t size = first.size();
  const auto begin = static_cast<std::size_t>(std::floor(from_s / motion.dt_s));
  const auto end = std::min(size, static_cast<std::size_t>(std::ceil(to_s / motion.dt_s)) + 1);
  change_components(motion, [&](const Samples& a) {
    return std::vector<double>(a.begin() + static_cast<std::ptrdiff_t>(begin),
                               a.begin() + static_cast<std::ptrdiff_t>(end));
  });
  motion.processing.push_back(fmt::format(
      "trimmed to {:.4g} to {:.4g} s of {:.4g} s, from {:g} to {:g} % of the Arias intensity of "
      "its horizontals",
      static_cast<double>(begin) * motion.dt_s, static_cast<double>(end - 1) * motion.dt_s,
      static_cast<double>(size) * motion.dt_s, percent[0], percent[1]));
  if (const double after_g = largest_g(motion); after_g < before_g)
    motion.contradictions.push_back(
        fmt::format("trimming by Arias intensity takes its peak of {:.3g} g away: {:.3g} g is "
                    "left",
                    before_g, after_g));
}

void resample(Motion& motion, double step_s, const std::optional<ButterworthBand>& band) {
  if (step_s == motion.dt_s) return;
  constexpr double most_of_rate = 0.25;
  const bool is_safe =
      step_s < motion.dt_s || (band && band->high_hz && *band->high_hz * step_s <= most_of_rate);
  if (!is_safe)
    refuse(motion,
           fmt::format("a step of {:g} s is longer than its own, {:g} s: frequencies above {:g} Hz "
                       "would appear as lower ones",
                       step_s, motion.dt_s, most_of_rate / step_s),
           "give band_pass with a high_hz of that at most, or a shorter step_s");
  const double from_s = motion.dt_s;
  change_components(motion,
                    [&](const Samples& a) { return on_step(motion.id, a, from_s, step_s); });
  motion.dt_s = step_s;
  motion.processing.push_back(
      fmt::format("resampled from {:g} to {:g} s, by straight lines", from_s, step_s));
}

}  // namespace

MotionProcessing MotionProcessing::or_else(const MotionProcessing& others) const {
  MotionProcessing all = *this;
  const auto take = [](auto& own, const auto& other) {
    if (!own) own = other;
  };
  take(all.baseline_degree, others.baseline_degree);
  take(all.band_pass, others.band_pass);
  if (!rotate_to && !rotate_to_deg) {
    all.rotate_to = others.rotate_to;
    all.rotate_to_deg = others.rotate_to_deg;
  }
  take(all.arias_percent, others.arias_percent);
  take(all.step_s, others.step_s);
  return all;
}

Record without_baseline(Record record, int degree) {
  GLISSADE_EXPECTS(degree >= 0);
  std::vector<double> a = record.acceleration_mps2.copy();
  // Polynomials that are orthogonal over the samples: p_(k+1) = x p_k - b_k p_(k-1), x from -1
  // to 1.
  const std::size_t n = a.size();
  std::vector<double> x(n), before(n, 0.0), p(n, 1.0);
  for (std::size_t i = 0; i < n; ++i)
    x[i] = n > 1 ? 2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.0 : 0.0;
  const auto product = [](const std::vector<double>& one, const std::vector<double>& other) {
    return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
  };
  double square_before = 1.0;
  for (int k = 0; k <= degree && static_cast<std::size_t>(k) < n; ++k) {
    const double square = product(p, p), share = product(a, p) / square,
                 b = k == 0 ? 0.0 : square / square_before;
    for (std::size_t i = 0; i < n; ++i) {
      a[i] -= share * p[i];
      const double next = x[i] * p[i] - b * before[i];
      before[i] = p[i];
      p[i] = next;
    }
    square_before = square;
  }
  record.acceleration_mps2 = std::move(a);
  return record;
}

Motion processed(Motion motion, const MotionProcessing& processing,
                 const MotionDirections& directions) {
  if (processing.baseline_degree)
    motion.processing.push_back(
        fmt::format("baseline: the polynomial of degree {} nearest to each component's "
                    "acceleration removed",
                    *processing.baseline_degree));
  if (processing.band_pass) filter(motion, *processing.band_pass);
  rotate(motion, processing, directions);
  if (processing.arias_percent) trim(motion, *processing.arias_percent);
  if (processing.step_s) resample(motion, *processing.step_s, processing.band_pass);
  return motion;
}

}  // namespace glissade
