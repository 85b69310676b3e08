// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

// The names enumerations have in study files and in results files.

inline EnumNames<UnitSystem> unit_names() {
  static constexpr EnumNames<UnitSystem> names = {{"si", UnitSystem::si},
                                                  {"us", UnitSystem::us_customary}};
  return names;
}
/// Those that scale a suite as a whole.
inline EnumNames<ScalingRule> scaling_rule_names() {
  static constexpr EnumNames<ScalingRule> names = {{"walters_2012", ScalingRule::walters_2012},
                                                   {"asce7_10", ScalingRule::asce7_10},
                                                   {"asce7_16", ScalingRule::asce7_16},
                                                   {"asce7_22", ScalingRule::asce7_22}};
  return names;
}
inline EnumNames<ArraySupport> support_names() {
  static constexpr EnumNames<ArraySupport> names = {{"isolated", ArraySupport::isolated},
                                                    {"anchored", ArraySupport::anchored},
                                                    {"no_array", ArraySupport::no_array}};
  return names;
}

inline EnumNames<SlopeAxis> slope_axis_names() {
  static constexpr EnumNames<SlopeAxis> names = {{"e_w", SlopeAxis::e_w}, {"n_s", SlopeAxis::n_s}};
  return names;
}

inline EnumNames<NeighbourSlope> neighbour_slope_names() {
  static constexpr EnumNames<NeighbourSlope> names = {{"same", NeighbourSlope::same},
                                                      {"facing", NeighbourSlope::facing}};
  return names;
}

inline EnumNames<VerticalChoice> vertical_names() {
  static constexpr EnumNames<VerticalChoice> names = {
      {"none", VerticalChoice::none},
      {"if_available", VerticalChoice::if_available},
      {"required", VerticalChoice::required}};
  return names;
}

inline EnumNames<OrientationChoice> orientation_names() {
  static constexpr EnumNames<OrientationChoice> names = {
      {"random", OrientationChoice::random},
      {"all_permutations", OrientationChoice::all_permutations},
      {"azimuths", OrientationChoice::azimuths},
      {"as_recorded", OrientationChoice::as_recorded}};
  return names;
}

inline EnumNames<OrientationRule> orientation_rule_names() {
  static constexpr EnumNames<OrientationRule> names = {{"largest", OrientationRule::largest},
                                                       {"median", OrientationRule::median}};
  return names;
}

inline EnumNames<DisplacementMeasure> displacement_names() {
  static constexpr EnumNames<DisplacementMeasure> names = {{"srss", DisplacementMeasure::srss},
                                                           {"vector", DisplacementMeasure::vector}};
  return names;
}

inline EnumNames<SlidingAxes> axes_names() {
  static constexpr EnumNames<SlidingAxes> names = {{"one", SlidingAxes::one},
                                                   {"two", SlidingAxes::two}};
  return names;
}

inline EnumNames<FrictionValue> friction_value_names() {
  static constexpr EnumNames<FrictionValue> names = {{"sampled", FrictionValue::as_drawn},
                                                     {"design", FrictionValue::design}};
  return names;
}

inline EnumNames<Standard> standard_names() {
  static constexpr EnumNames<Standard> names = {{"seaoc_pv1_2012", Standard::seaoc_pv1_2012},
                                                {"asce7_16", Standard::asce7_16}};
  return names;
}

}  // namespace glissade
