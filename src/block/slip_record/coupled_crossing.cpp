// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/slip_record/coupled_crossing.hpp"

#include <algorithm>

namespace glissade::block_detail {

double CoupledCrossings::ahead_m(const SlipPath& path) const {
  return crossings_.next_m() / cos_slope_ - path.direction * path.begin_m;
}

void CoupledCrossings::note(double time_s, double speed_mps) {
  crossings_.add({time_s, speed_mps * cos_slope_});
}

void CoupledCrossings::follow(const SlipPath& path, const Series& speed, double length_s,
                              double fraction, bool stops) {
  while (reached(path.end_m)) {
    Series left = speed.integral(length_s, 0.0);
    for (int k = 1; k < left.terms; ++k) left.c[k] = -left.c[k];
    left.c[0] = ahead_m(path);
    // Near a stop the root is no better than the square root of rounding.
    const bool at_rest = stops && std::abs(path.end_m) * cos_slope_ == crossings_.next_m();
    const double tau = at_rest ? fraction : std::min(first_fall(left), fraction);
    note(path.time_s + tau * length_s, at_rest ? 0.0 : std::max(speed.at(tau), 0.0));
  }
}

void CoupledCrossings::follow_to_rest(const SlipPath& path, double speed_mps,
                                      double deceleration_mps2) {
  while (reached(path.end_m)) {
    const double energy = speed_mps * speed_mps - 2.0 * deceleration_mps2 * ahead_m(path);
    const double speed = std::min(std::sqrt(std::max(energy, 0.0)), speed_mps);
    note(path.time_s + (speed_mps - speed) / deceleration_mps2, speed);
  }
}

}  // namespace glissade::block_detail
