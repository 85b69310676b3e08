// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/clearance_study.hpp"
#include "toml_table.hpp"

// The names in study files and in results files of clearance studies.
namespace glissade {

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

inline EnumNames<VerticalChoice> vertical_names() {
  static constexpr EnumNames<VerticalChoice> names = {
      {"none", VerticalChoice::none},
      {"if_available", VerticalChoice::if_available},
      {"required", VerticalChoice::required}};
  return names;
}

inline EnumNames<OrientationChoice> orientation_names() {
  static constexpr EnumNames<OrientationChoice> names = {{"sixteen", OrientationChoice::sixteen},
                                                         {"azimuths", OrientationChoice::azimuths},
                                                         {"stated", OrientationChoice::stated}};
  return names;
}

inline EnumNames<DisplacementMeasure> displacement_names() {
  static constexpr EnumNames<DisplacementMeasure> names = {{"srss", DisplacementMeasure::srss},
                                                           {"vector", DisplacementMeasure::vector}};
  return names;
}

inline EnumNames<ClearanceTopic> topic_names() {
  static constexpr EnumNames<ClearanceTopic> names = {{"spectra", ClearanceTopic::spectra},
                                                      {"period", ClearanceTopic::period},
                                                      {"level", ClearanceTopic::level},
                                                      {"yielding", ClearanceTopic::yielding},
                                                      {"base_shear", ClearanceTopic::base_shear},
                                                      {"slope", ClearanceTopic::slope},
                                                      {"mce", ClearanceTopic::mce},
                                                      {"vertical", ClearanceTopic::vertical},
                                                      {"mass", ClearanceTopic::mass},
                                                      {"orientation", ClearanceTopic::orientation}};
  return names;
}

}  // namespace glissade
