// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/cases/orientation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"

namespace glissade {

bool Orientation::is_quarter_turn() const { return std::fmod(ground_azimuth_deg, 90.0) == 0.0; }

SignedComponent along_axis(const Orientation& o, int axis) {
  GLISSADE_EXPECTS(o.is_quarter_turn());
  const bool second_along = o.ground_azimuth_deg == 90.0 || o.ground_azimuth_deg == 270.0;
  const int along = o.ground_azimuth_deg < 180.0 ? 1 : -1;
  if (axis == 0) return {second_along ? 1 : 0, along};
  // With the second component along the first axis, the first one acts against the second axis.
  return {second_along ? 0 : 1, o.across_sign * (second_along ? -along : along)};
}

Orientation quarter_turn(SignedComponent first, int second_sign) {
  Orientation o;
  o.ground_azimuth_deg = (first.component == 1 ? 90.0 : 0.0) + (first.sign < 0 ? 180.0 : 0.0);
  o.across_sign = along_axis(o, 1).sign == second_sign ? 1 : -1;
  return o;
}

Direction ground_direction(const Orientation& o) {
  if (o.ground_azimuth_deg == 0.0) return {1.0, 0.0};
  if (o.ground_azimuth_deg == 90.0) return {0.0, 1.0};
  if (o.ground_azimuth_deg == 180.0) return {-1.0, 0.0};
  if (o.ground_azimuth_deg == 270.0) return {0.0, -1.0};
  const double azimuth_rad = o.ground_azimuth_deg * rad_per_deg;
  return {std::cos(azimuth_rad), std::sin(azimuth_rad)};
}

std::vector<Orientation> orientations(OrientationChoice choice,
                                      const std::vector<SlopeAxis>& slope_axes) {
  GLISSADE_EXPECTS(choice != OrientationChoice::random);
  constexpr int azimuths = 16;
  std::vector<Orientation> all;
  for (const SlopeAxis axis : slope_axes) {
    if (choice == OrientationChoice::all_permutations) {
      for (const double azimuth : {0.0, 180.0, 90.0, 270.0}) {
        for (const int across : {1, -1}) all.push_back({axis, azimuth, across});
      }
    } else if (choice == OrientationChoice::azimuths) {
      for (int i = 0; i < azimuths; ++i) all.push_back({axis, 360.0 / azimuths * i, 1});
    } else {
      all.push_back({axis, 0.0, 1});
    }
  }
  return all;
}

std::string describe(OrientationChoice choice) {
  switch (choice) {
    case OrientationChoice::random:
      return "drawn for each sample: either component along the first axis, with either sign";
    case OrientationChoice::all_permutations:
      return "either component along the first axis with either sign, the other with either sign";
    case OrientationChoice::azimuths:
      return "every 22.5 degrees";
    case OrientationChoice::as_recorded:
      break;
  }
  return "as recorded: the first component along the first axis";
}

std::string to_string(SlopeAxis axis) { return axis == SlopeAxis::e_w ? "E-W" : "N-S"; }

std::string to_string(const Orientation& o, bool two_axes) {
  const std::string slope = "slope " + to_string(o.slope_axis);
  if (!o.is_quarter_turn()) {
    return fmt::format("{}, azimuth {:g} deg{}", slope, o.ground_azimuth_deg,
                       two_axes && o.across_sign < 0 ? ", across mirrored" : "");
  }
  return slope + ", along it " + components_text(o, two_axes);
}

std::string components_text(const Orientation& o, bool two_axes) {
  const auto signed_name = [&](int axis) {
    const SignedComponent c = along_axis(o, axis);
    return std::string(c.sign > 0 ? "+" : "-") + (c.component == 0 ? "first" : "second");
  };
  return two_axes ? signed_name(0) + ", across " + signed_name(1) : signed_name(0);
}

}  // namespace glissade
