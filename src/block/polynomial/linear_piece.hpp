// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "block/contact/line.hpp"

namespace glissade::block_detail {

/// A drive that is a straight line over one interval between nodes, or over the rest of it. tau in
/// [0, 1] is the elapsed fraction of the piece.
struct LinearPiece {
  struct Interval {
    Roof begin, end;
  };
  double begin = 0.0, end = 0.0, length_s = 0.0;

  LinearPiece() = default;
  LinearPiece(double from, double to, double length) : begin(from), end(to), length_s(length) {}
  LinearPiece(const DriveLine& drive, const Interval& roof, double length)
      : LinearPiece(drive.at(roof.begin), drive.at(roof.end), length) {}

  void set(const DriveLine& drive, const Interval& roof, double length) {
    *this = {drive, roof, length};
  }
  /// Keeps the part after tau.
  void keep_after(double tau) {
    begin += (end - begin) * tau;
    length_s *= 1.0 - tau;
  }

  /// Time at which the drive first becomes positive, or never.
  double rise() const {
    if (begin > 0.0) return 0.0;
    if (!(end > 0.0)) return never;
    const double tau = begin / (begin - end);
    return tau < 1.0 ? tau : never;  // within rounding of the end: the next interval starts it
  }

  /// Time at which a speed v0 >= 0 under this drive first returns to zero, or never.
  double stop(double v0) const {
    const double t = time_to_stop(v0, {begin, (end - begin) / length_s, end}, length_s);
    return t == never ? never : std::min(t / length_s, 1.0);
  }

  /// Speed and displacement from rest.
  double gain(double tau) const { return length_s * tau * (begin + 0.5 * (end - begin) * tau); }
  double travel(double tau) const {
    const double t = length_s * tau;
    return t * t * (0.5 * begin + (end - begin) * tau / 6.0);
  }
  bool may_be_positive() const { return begin > 0.0 || end > 0.0; }
  void begin_at_zero() { begin = 0.0; }
  void begin_at_most_zero() { begin = std::min(begin, 0.0); }
};

}  // namespace glissade::block_detail
