// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "glissade/block/crossing.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/building/roof_table.hpp"

namespace glissade {

/// Search for events in the kernel; both give the same bits.
enum class EventSearch {
  bounds,         ///< by the bounds of the table: only intervals where an event is possible
  every_interval  ///< in each interval, to verify the former
};

/// slide() over tables: a phase begins and ends where V crosses a straight line, so the run time of
/// a history depends on its events, not on its samples. Exact on a rigid roof, to 1e-10 relative to
/// the peak against 50 digits (tests/unit/block); on an oscillator to 1e-6 of slips above 1 mm, and
/// to 1e-9 m below (the quintic V between nodes). Where uplift is possible (outside the model), the
/// roof motion of an oscillator is taken linear over 64ths of an interval.
///
/// theory.md, 1.3: with speed v in the direction of sliding, drives linear in (a, w), and the
/// phase at node r with speed v_r,
///   v(t) = v_r + c_a (V(t) - V_r) + c_w (V_w(t) - V_w,r) + c_0 (t - t_r)
///   s(t) = s_r + v_r (t - t_r) + c_a (U(t) - U_r - V_r (t - t_r)) + ... + c_0 (t - t_r)^2 / 2
///
/// The same bits on every SIMD target. If factors and gravity are multiplied by a number, so is the
/// slip, exactly.
SlipPeak peak_slip(const RoofTable& roof, const Block& block, const MotionFactors& factors = {},
                   EventSearch search = EventSearch::bounds);

/// The same, to the last bit, with the first crossing of each threshold: in a phase that passes a
/// threshold, the interval between nodes is found by bisection, and the root in it to rounding. As
/// exact as slide() on a rigid roof; on an oscillator the slip has an error of 1e-6 of the peak, as
/// the peak has. See slide() for the parameters and the definition of a crossing.
SlipPeak peak_slip(const RoofTable& roof, const Block& block, const MotionFactors& factors,
                   std::span<const double> thresholds_m, std::span<Crossing> crossings,
                   EventSearch search = EventSearch::bounds);

}  // namespace glissade
