// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace glissade::test {

/// How messages between ranks travel.
struct Network {
  double latency_s = 0.0;      ///< one way
  double service_s = 0.0;      ///< of a request for work, at rank 0, one after the other
  bool remote_atomics = true;  ///< else rank 0 answers between its units, and while it waits
  double bytes_per_s = 1e9;    ///< into rank 0, and to each rank of a broadcast
};

/// Whether a rank asks for its next item when it begins one, or when it has finished it.
enum class Fetch { ahead, when_free };

/// Discrete-event simulation of self_schedule() (src/parallel): seconds until the last rank knows
/// that nothing is left. The items go out in their order.
/// @param costs_s of the items on one core
/// @param slowdown of every rank, where ranks share cores
double makespan_s(std::span<const double> costs_s, int ranks, const Network& network, Fetch fetch,
                  double slowdown = 1.0);

}  // namespace glissade::test
