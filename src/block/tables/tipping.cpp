// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/tipping.hpp"

#include <algorithm>
#include <cmath>

#include "block/contact/contact.hpp"
#include "block/tables/event_bounds.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade {
namespace {

using block_detail::Contact;
using block_detail::DriveLine;
using block_detail::EventBounds;
using block_detail::Lines;

/// @param peak_of largest value over the motion, or 0, of a line without a constant
template <class PeakOf>
double onset_factor(const Block& block, const MotionFactors& factors, PeakOf peak_of) {
  block_detail::require_block(block);
  const Contact contact(block);
  const auto onset = [&](const DriveLine& drive) {
    if (drive.constant > 0.0) return 0.0;
    const double demand = peak_of({drive.a * block_detail::mirror(block) * factors.horizontal[0],
                                   drive.w * factors.vertical, 0.0});
    return demand > 0.0 ? std::abs(drive.constant) / demand : infinity;
  };
  const double down = onset(contact.down());
  if (block.directions == SlipDirections::downslope_only) return down;
  return std::min(down, onset(contact.up()));
}

/// The search of peak_slip for the onset of sliding, with the largest value so far as threshold.
double peak_over_table(const RoofTable& roof, const DriveLine& line) {
  const MotionTable &a = *roof.horizontal, *w = roof.vertical.get();
  const MotionNodes a_nodes = a.at_nodes(), w_nodes = w != nullptr ? w->at_nodes() : MotionNodes();
  const std::size_t last = std::max(a.end, w != nullptr ? w->end : 0);
  const auto line_after = [&](std::size_t i) {
    const Quartic along = a_nodes.acceleration_after(i),
                  up = w != nullptr ? w_nodes.acceleration_after(i) : Quartic{};
    Quartic values;
    for (int k = 0; k < 5; ++k) values.b[k] = line.at({along.b[k], up.b[k]});
    return values;
  };
  double peak = 0.0;
  for (std::size_t i = 0; i < last; ++i) {
    const DriveLine above_peak{line.a, line.w, -peak}, nothing{0.0, 0.0, -1.0};
    i = EventBounds(a, w, Lines{{above_peak, nothing}, nothing, 1}, last).next_exit(i);
    if (i < last) raise_to_largest(line_after(i), peak);
  }
  return peak;
}

double peak_over_samples(const RoofAcceleration& roof, const DriveLine& line) {
  double peak = 0.0;
  for (std::size_t i = 0; i < roof.horizontal_mps2.size(); ++i) {
    const double w = roof.vertical_mps2.empty() ? 0.0 : roof.vertical_mps2[i];
    peak = std::max(peak, line.at({roof.horizontal_mps2[i], w}));
  }
  return peak;
}

bool tips_before_it_slides(const Block& block, const RigidBase& base) {
  return block.friction.along > rocking_block(block, base).friction.along;
}

}  // namespace

double slip_onset_factor(const RoofTable& roof, const Block& block, const MotionFactors& per_unit) {
  return onset_factor(block, per_unit,
                      [&](const DriveLine& line) { return peak_over_table(roof, line); });
}

double slip_onset_factor(const RoofAcceleration& roof, const Block& block) {
  return onset_factor(block, {roof.horizontal_factor, roof.vertical_factor},
                      [&](const DriveLine& line) { return peak_over_samples(roof, line); });
}

Block rocking_block(const Block& block, const RigidBase& base) {
  GLISSADE_EXPECTS(base.centre_of_mass_height_m > 0.0 && base.width_m > 0.0);
  return {.friction = base.width_m / (2.0 * base.centre_of_mass_height_m),
          .slope_rad = block.slope_rad,
          .gravity_mps2 = block.gravity_mps2};
}

double tipping_onset_factor(const RoofTable& roof, const Block& block, const RigidBase& base,
                            const MotionFactors& per_unit) {
  if (!tips_before_it_slides(block, base)) return infinity;
  return slip_onset_factor(roof, rocking_block(block, base), per_unit);
}

double tipping_onset_factor(const RoofAcceleration& roof, const Block& block,
                            const RigidBase& base) {
  if (!tips_before_it_slides(block, base)) return infinity;
  return slip_onset_factor(roof, rocking_block(block, base));
}

}  // namespace glissade
