// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/motion/record.hpp"

// Changes of motions that a suite asks for.
namespace glissade {

/// High-pass and low-pass Butterworth filters, each run forwards and backwards: no phase shift, and
/// a gain of 1/2 at its corner.
struct ButterworthBand {
  std::optional<double> low_hz, high_hz;  ///< corners, above 0, the lower first; one at least
  int order = 4;                          ///< of one pass, >= 1
};

enum class FaultAxis { normal, parallel };

/// What is done with a motion, in this order; off where it is not stated.
struct MotionProcessing {
  std::optional<int> baseline_degree;  ///< of the polynomial that is removed from each component
  std::optional<ButterworthBand> band_pass;
  std::optional<double> rotate_to_deg;  ///< azimuth of the first horizontal; or:
  std::optional<FaultAxis> rotate_to;
  std::optional<std::array<double, 2>> arias_percent;  ///< what is kept, 0 to 100, increasing
  std::optional<double> step_s;

  /// These, and for what they leave off those of `others`.
  MotionProcessing or_else(const MotionProcessing& others) const;
};

/// Clockwise from north; nothing where not known.
struct MotionDirections {
  std::array<std::optional<double>, 2> horizontal_deg;
  std::optional<double> strike_deg;  ///< of the fault
};

/// Less the polynomial of the degree (>= 0) that is nearest by least squares.
Record without_baseline(Record record, int degree);

/// Filtered in both directions, from rest at both ends. Expects corners below half of the sampling
/// rate.
std::vector<double> band_passed(std::span<const double> samples, double dt_s,
                                const ButterworthBand& band);

/// The motion after all but the baseline, which is of components before they are put together; each
/// change, that one too, is stated in Motion::processing.
/// - band_pass: with zeros of 0.75 order / corner before and after (Converse & Brady 1992), which
///   stay: the response to the filtered motion needs them (Boore 2005).
/// - rotation: the first horizontal along the azimuth, the second 90 degrees clockwise of it.
///   Normal to the fault: strike + 90; parallel: strike.
/// - arias_percent: from the sample before the time at which the first share of the Arias
///   intensity of both horizontals is reached to the sample after that of the second.
/// - step_s: along the straight lines between samples; a longer step only where high_hz is at most
///   half of what the new step can show.
/// Throws InputError where the motion does not have what a change needs.
Motion processed(Motion motion, const MotionProcessing& processing,
                 const MotionDirections& directions);

}  // namespace glissade
