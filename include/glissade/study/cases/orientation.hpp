// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

// Directions of the ground's two horizontal components relative to the building and its array.
namespace glissade {

/// The array's axis along which the roof falls: its friction may differ along the two.
enum class SlopeAxis { e_w, n_s };

struct Orientation {
  SlopeAxis slope_axis = SlopeAxis::e_w;
  /// From the first component to the building's first axis (of one axis: to the slope's direction),
  /// toward the second component, [0, 360).
  double ground_azimuth_deg = 0.0;
  /// -1: what acts along the second axis is mirrored, which no rotation can do; +1: it is not.
  int across_sign = 1;

  bool operator==(const Orientation&) const = default;
  /// The axes are along the components: nothing is mixed.
  bool is_quarter_turn() const;
};

/// A component of the ground along a building's axis, with its sign.
struct SignedComponent {
  int component = 0;  ///< 0: the first, 1: the second
  int sign = 1;
};
/// Along the first axis (0) or the second (1), of a quarter turn.
SignedComponent along_axis(const Orientation& orientation, int axis);
/// The quarter turn with these along the first axis and this sign along the second.
Orientation quarter_turn(SignedComponent first, int second_sign);

/// Cosine and sine, exact at quarter turns.
struct Direction {
  double cosine, sine;
};
Direction ground_direction(const Orientation& orientation);

/// Which orientations of the ground a study runs.
enum class OrientationChoice {
  random,            ///< one a sample, drawn
  all_permutations,  ///< either component along the first axis, with either sign, the other with
                     ///< either sign: 8
  azimuths,          ///< every 22.5 degrees: 16
  as_recorded,       ///< the first component along the first axis
};

/// The orientations of a choice that is not random, for each axis the slope may have.
std::vector<Orientation> orientations(OrientationChoice choice,
                                      const std::vector<SlopeAxis>& slope_axes);

/// In a sentence: "every 22.5 degrees".
std::string describe(OrientationChoice choice);

/// "slope E-W, along it + first, across + second", "slope N-S, azimuth 22.5 deg"
std::string to_string(const Orientation& orientation, bool two_axes = true);
std::string to_string(SlopeAxis axis);  ///< "E-W"
/// Of a quarter turn: "+first, across +second".
std::string components_text(const Orientation& orientation, bool two_axes);

}  // namespace glissade
