// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/slip_record/path_piece.hpp"

#include <algorithm>

#include "block/contact/line.hpp"
#include "glissade/core/hull_maximum.hpp"

namespace glissade::block_detail {
namespace {

using Points = std::array<Vector, 5>;

/// The polar form of a curve: symmetric in its arguments, and the curve where they are equal.
Vector polar(Points curve, const std::array<double, 4>& at) {
  for (std::size_t k = at.size(); k > 0; --k)
    for (std::size_t i = 0; i < k; ++i)
      curve[i] = (1.0 - at[k - 1]) * curve[i] + at[k - 1] * curve[i + 1];
  return curve[0];
}

/// A path through rising times.
class PathWalk {
 public:
  explicit PathWalk(std::span<const PathPiece> path) : path_(path) {}

  /// Where the piece, or the rest, that follows `time_s` ends.
  double go_on(double time_s) {
    while (next_ < path_.size() && path_[next_].end_s <= time_s)
      at_rest_.fill(path_[next_++].points.back());
    if (next_ == path_.size()) return never;
    slides_ = path_[next_].begin_s <= time_s;
    return slides_ ? path_[next_].end_s : path_[next_].begin_s;
  }
  /// The curve whose hull the path does not leave until then.
  const Points& hull() const { return slides() ? path_[next_].points : at_rest_; }
  Points between(double from_s, double to_s) const {
    if (!slides()) return at_rest_;
    const PathPiece& piece = path_[next_];
    const double length_s = piece.end_s - piece.begin_s;
    const double u = std::max(0.0, (from_s - piece.begin_s) / length_s),
                 v = to_s == piece.end_s ? 1.0 : (to_s - piece.begin_s) / length_s;
    const Points& p = piece.points;
    return {polar(p, {u, u, u, u}), polar(p, {u, u, u, v}), polar(p, {u, u, v, v}),
            polar(p, {u, v, v, v}), polar(p, {v, v, v, v})};
  }

 private:
  bool slides() const { return next_ < path_.size() && slides_; }

  std::span<const PathPiece> path_;
  std::size_t next_ = 0;
  bool slides_ = false;
  Points at_rest_{};
};

}  // namespace

Vector largest_lead(std::span<const PathPiece> first, std::span<const PathPiece> second) {
  constexpr double rounding = 1e-12;  // of the displacements
  PathWalk one(first), other(second);
  Vector lead;
  for (double from_s = 0.0, to_s;
       (to_s = std::min(one.go_on(from_s), other.go_on(from_s))) != never; from_s = to_s) {
    const auto by = [&](double Vector::*axis) {
      return [axis](Vector a, Vector b) { return a.*axis < b.*axis; };
    };
    for (double Vector::*axis : {&Vector::s, &Vector::y}) {
      const double farthest = std::ranges::max(one.hull(), by(axis)).*axis,
                   least = std::ranges::min(other.hull(), by(axis)).*axis;
      if (farthest - least <= lead.*axis) continue;
      const Points a = one.between(from_s, to_s), b = other.between(from_s, to_s);
      Points ahead;
      for (std::size_t k = 0; k < ahead.size(); ++k) ahead[k] = a[k] - b[k];
      raise_to_largest(
          ahead, lead.*axis, [axis](Vector d) { return d.*axis; },
          rounding * std::max(std::abs(farthest), std::abs(least)));
    }
  }
  return lead;
}

}  // namespace glissade::block_detail
