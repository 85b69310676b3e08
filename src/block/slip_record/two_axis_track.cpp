// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/slip_record/two_axis_track.hpp"

#include "block/slip_record/first_reach.hpp"

namespace glissade::block_detail {

void TwoAxisTrack::note(double time_s) {
  if (history_ != nullptr) history_->push_back({time_s, {displacement_.s, displacement_.y}});
}

void TwoAxisTrack::slide(const Sliding& from, const Sliding& to, double length_s, double begin_s) {
  if (from.v.s == 0.0 && from.v.y == 0.0) note(begin_s);
  const Path path(length_s, displacement_, scaled(from.v, to_plan_), scaled(from.a, to_plan_),
                  scaled(to.v, to_plan_), scaled(to.a, to_plan_));
  extremes_.along(path);
  for (; waits_for(extremes_.displacement()); ++next_) {
    const double share =
        first_reach([&](double y) { return path.displacement(y); },
                    [&](double y) { return path.velocity(y); }, thresholds_[next_]);
    crossings_[next_] = {begin_s + share * length_s, length(path.velocity(share))};
  }
  displacement_ = path.end;
  path_length_ += path.path_length();
  duration_s_ += length_s;
  note(begin_s + length_s);
}

void TwoAxisTrack::stop(const Stop& stop, double speed, double begin_s) {
  const Vector way = scaled(stop.displacement, to_plan_), from = displacement_;
  const double straight = length(stop.displacement), in_plan = length(way);
  displacement_ = displacement_ + way;
  extremes_.at(displacement_);
  if (straight > 0.0) {  // its curved way is taken in plan as its chord is
    path_length_ += stop.path * in_plan / straight;
    extremes_.at_speed(stop.fastest * in_plan / straight);
  }
  duration_s_ += stop.time_s;
  note(begin_s + stop.time_s);
  for (; waits_for(length(displacement_)); ++next_) {
    const auto at = [&](double share) { return stop.way_share(share, speed); };
    const auto beyond = [&](double share) {
      return length(from + at(share).way * way) - thresholds_[next_];
    };
    const double share = rise_between(beyond, 0.0, 1.0);
    crossings_[next_] = {begin_s + share * stop.time_s, at(share).rate * in_plan / stop.time_s};
  }
}

bool TwoAxisTrack::may_cross(double way) const {
  return waits_for(length(displacement_) + way * std::max(to_plan_.s, to_plan_.y));
}

TwoAxisResult TwoAxisTrack::result() const {
  TwoAxisResult r;
  r.peak_displacement_m = extremes_.displacement();
  tell_peaks(extremes_, r);
  r.residual = {displacement_.s, displacement_.y};
  r.path_length_m = path_length_;
  r.peak_velocity_mps = extremes_.speed();
  r.slip_duration_s = duration_s_;
  return r;
}

}  // namespace glissade::block_detail
