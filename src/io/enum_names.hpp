// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

// The names enumerations have in study files and in results files.

inline constexpr EnumNames<UnitSystem> unit_names = {{"si", UnitSystem::si},
                                                     {"us", UnitSystem::us_customary}};
inline constexpr EnumNames<AsceEdition> edition_names = {{"asce7_10", AsceEdition::asce7_10},
                                                         {"asce7_16", AsceEdition::asce7_16},
                                                         {"asce7_22", AsceEdition::asce7_22}};
/// Those that scale a suite as a whole.
inline constexpr EnumNames<ScalingRule> scaling_rule_names = {
    {"walters_2012", ScalingRule::walters_2012},
    {"asce7_10", ScalingRule::asce7_10},
    {"asce7_16", ScalingRule::asce7_16},
    {"asce7_22", ScalingRule::asce7_22}};
/// Of ASCE 7-16, 11.4.8.
inline constexpr EnumNames<int> exception_names = {
    {"exception 1 of 11.4.8", 1}, {"exception 2 of 11.4.8", 2}, {"exception 3 of 11.4.8", 3}};
inline constexpr EnumNames<ArraySupport> support_names = {{"isolated", ArraySupport::isolated},
                                                          {"anchored", ArraySupport::anchored},
                                                          {"no_array", ArraySupport::no_array}};

inline constexpr EnumNames<SlopeAxis> slope_axis_names = {{"e_w", SlopeAxis::e_w},
                                                          {"n_s", SlopeAxis::n_s}};

inline constexpr EnumNames<NeighbourSlope> neighbour_slope_names = {
    {"same", NeighbourSlope::same}, {"facing", NeighbourSlope::facing}};

inline constexpr EnumNames<VerticalChoice> vertical_names = {
    {"none", VerticalChoice::none},
    {"if_available", VerticalChoice::if_available},
    {"required", VerticalChoice::required}};

inline constexpr EnumNames<OrientationChoice> orientation_names = {
    {"random", OrientationChoice::random},
    {"all_permutations", OrientationChoice::all_permutations},
    {"azimuths", OrientationChoice::azimuths},
    {"as_recorded", OrientationChoice::as_recorded}};

inline constexpr EnumNames<OrientationRule> orientation_rule_names = {
    {"largest", OrientationRule::largest}, {"median", OrientationRule::median}};

inline constexpr EnumNames<DisplacementMeasure> displacement_names = {
    {"srss", DisplacementMeasure::srss}, {"vector", DisplacementMeasure::vector}};

inline constexpr EnumNames<SlidingAxes> axes_names = {{"one", SlidingAxes::one},
                                                      {"two", SlidingAxes::two}};

inline constexpr EnumNames<FrictionValue> friction_value_names = {
    {"sampled", FrictionValue::as_drawn}, {"design", FrictionValue::design}};

inline constexpr EnumNames<Standard> standard_names = {{"seaoc_pv1_2012", Standard::seaoc_pv1_2012},
                                                       {"asce7_16", Standard::asce7_16}};

inline constexpr EnumNames<ComponentChoice> component_names = {{"first", ComponentChoice::first},
                                                               {"second", ComponentChoice::second},
                                                               {"random", ComponentChoice::random}};

inline constexpr EnumNames<SignChoice> sign_names = {{"positive", SignChoice::positive},
                                                     {"negative", SignChoice::negative},
                                                     {"random", SignChoice::random}};

inline constexpr EnumNames<SamplingMethod> sampling_method_names = {
    {"sobol", SamplingMethod::sobol}, {"monte_carlo", SamplingMethod::monte_carlo}};

}  // namespace glissade
