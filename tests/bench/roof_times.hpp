// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade::bench {

/// What tabulating sixteen oscillators' responses costs, nanoseconds a node and oscillator on one
/// core.
struct RoofTimes {
  double filter_ns =
      0.0;  ///< their states at the nodes: a, V and U follow by a multiplication each
  double bounds_ns = 0.0;  ///< the bounds the kernel searches
  double whole_ns = 0.0;   ///< tabulate_responses(): both, and the memory
  double ground_ns = 0.0;  ///< the ground's own table with its bounds, once a record: a sample
};
RoofTimes roof_times();

}  // namespace glissade::bench
