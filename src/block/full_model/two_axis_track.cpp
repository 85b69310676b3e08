// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/full_model/two_axis_track.hpp"

namespace glissade::block_detail {

void TwoAxisTrack::slide(const Sliding& from, const Sliding& to, double length_s, double begin_s) {
  const Path path(length_s, displacement_, scaled(from.v, to_plan_), scaled(from.a, to_plan_),
                  scaled(to.v, to_plan_), scaled(to.a, to_plan_));
  extremes_.along(path);
  crossings_.pass(
      [&](double tau) {
        return PathPoint{path.displacement(tau), path.velocity(tau)};
      },
      begin_s, length_s, extremes_.displacement());
  if (pieces_ != nullptr)
    pieces_->push_back({begin_s, begin_s + length_s, path.displacement_points()});
  displacement_ = path.end;
  path_length_ += path.path_length();
  duration_s_ += length_s;
}

void TwoAxisTrack::stop(const Stop& stop, double speed, double begin_s) {
  const Vector displacement = scaled(stop.displacement, to_plan_), from = displacement_;
  const double straight = length(stop.displacement), in_plan = length(displacement);
  displacement_ = displacement_ + displacement;
  extremes_.at(displacement_);
  if (straight > 0.0) {  // its curved path is taken in plan as its chord is
    path_length_ += stop.path * in_plan / straight;
    extremes_.at_speed(stop.fastest * in_plan / straight);
  }
  duration_s_ += stop.time_s;
  if (pieces_ != nullptr) {
    PathPiece& piece = pieces_->emplace_back(PathPiece{begin_s, begin_s + stop.time_s, {}});
    const std::array<double, 5> fractions = stop.path_points(speed);
    for (std::size_t k = 0; k < fractions.size(); ++k)
      piece.points[k] = from + fractions[k] * displacement;
  }
  while (crossings_.may_reach(length(displacement_))) {
    const auto at = [&](double fraction) { return stop.path_fraction(fraction, speed); };
    const auto beyond = [&](double fraction) {
      return length(from + at(fraction).path * displacement) - crossings_.next_m();
    };
    const double fraction = rise_between(beyond, 0.0, 1.0);
    crossings_.add({begin_s + fraction * stop.time_s, at(fraction).rate * in_plan / stop.time_s});
  }
}

bool TwoAxisTrack::is_wanted(double path_length) const {
  return pieces_ != nullptr || crossings_.may_reach(length(displacement_) +
                                                    path_length * std::max(to_plan_.s, to_plan_.y));
}

SlipResult TwoAxisTrack::result() const {
  SlipResult r;
  set_peaks(extremes_, r);
  r.residual = {displacement_.s, displacement_.y};
  r.path_length_m = path_length_;
  r.peak_velocity_mps = extremes_.speed();
  r.slip_duration_s = duration_s_;
  return r;
}

}  // namespace glissade::block_detail
