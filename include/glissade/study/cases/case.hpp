// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "glissade/block/friction_law.hpp"
#include "glissade/building/building_model.hpp"
#include "glissade/study/cases/orientation.hpp"

namespace glissade {

/// How the array stands on the building.
enum class ArraySupport {
  isolated,  ///< friction alone
  anchored,  ///< it does not slide: its mass is the building's
  no_array,
};

/// Where a second array stands.
enum class NeighbourSlope {
  same,    ///< on the slope of the first, below it or beside it
  facing,  ///< on one that falls toward it, across a valley
};

enum class VerticalChoice { none, if_available, required };

/// Which friction of a drawn one: that of the sample, or mean - 2 std (Walters et al. 2012).
enum class FrictionValue { as_drawn, design };

/// All that is particular to one array on one building.
struct Case {
  double friction = 0.5;            ///< along the slope
  double friction_across = 0.5;     ///< across it; counts on two axes only
  double neighbour_friction = 0.0;  ///< two axes: of a second array on the same roof, with the same
                                    ///< ratio of both axes; 0: there is none
  double neighbour_over_mu = 0.0;   ///< its friction over that of the first, where that is stated
  NeighbourSlope neighbour_slope = NeighbourSlope::same;
  FrictionLaw law;
  double slope_deg = 0.0;     ///< falls toward the building's first axis; < 0: the other way
  double azimuth_deg = 0.0;   ///< two axes: from the building's first axis to where the roof falls
  double period_s = 0.0;      ///< of the building along its first axis, without the array; 0: rigid
  double period_ratio = 1.0;  ///< two axes: period along the second axis over that along the first
  double damping = 0.05;
  double alpha = 0.0;       ///< of a cantilever of flexure and shear alone (BuildingModel)
  double mass_ratio = 0.0;  ///< array over building
  double response_modification = 0.0;  ///< R: yields at the design spectrum's elastic demand over
                                       ///< R; 0: it stays elastic
  double yield_coefficient = 0.0;      ///< yields at this part of its weight; 0: it stays elastic
  double hardening_ratio = 0.0;
  double vertical_period_s = 0.0;  ///< of the roof's vertical oscillator; 0: moves as the ground
  double vertical_damping = 0.05;
  ArraySupport support = ArraySupport::isolated;
  VerticalChoice vertical = VerticalChoice::if_available;
  FrictionValue friction_value = FrictionValue::as_drawn;
  Orientation orientation;

  /// Along an axis of the array.
  double friction_on(SlopeAxis axis) const {
    return orientation.slope_axis == axis ? friction : friction_across;
  }
  bool yields() const { return response_modification > 0.0 || yield_coefficient > 0.0; }
};

/// The range of a parameter, ends included.
struct ParameterRange {
  double min, max;
  const char* text;  ///< "0 or more"
};

/// A number of a case that a study may fix, list or draw. All its properties are in
/// one row: the study's reader, the drawing of samples, the results file, the documentation and the
/// plan's hash go through this table.
struct Parameter {
  const char* table;  ///< of the study file: "building"
  const char* key;    ///< "period_s"
  const char* words;  ///< "building period"
  const char* unit;   ///< "s"
  ParameterRange range;
  std::uint32_t dimension;  ///< its place in the unit cube: fixed for ever, so that a sample's
                            ///< numbers stay as they are when another parameter becomes uncertain
  const char* meaning;
  double& (*of)(Case&);
  enum class Axes { any, two } axes = Axes::any;  ///< two: allowed with [model] axes = 2 only
  const char* needs = nullptr;  ///< the key of its table that must not be as usual, for it to count
  const char* absent = nullptr;  ///< "one mass": where no number is as its absence
  /// Whether a building has it; null: every building has.
  bool (*is_of)(const BuildingModel&) = nullptr;

  /// It decides how the roof moves: cases that differ in no such parameter share a roof.
  bool moves_roof() const;
  std::string name() const { return std::string(table) + "." + key; }  ///< "building.period_s"
  /// Of its numbers in files.
  std::string description() const;
};
/// NaN where the building has no such number.
double value_of(const Parameter& parameter, const Case& c, const BuildingModel& building);
std::span<const Parameter> parameters();
/// The row of a key. Precondition: there is one.
std::size_t parameter_index(const char* table, const char* key);

inline double value_of(const Parameter& parameter, const Case& c) {
  return parameter.of(const_cast<Case&>(c));
}

/// The places of what is drawn beside the parameters.
inline constexpr std::uint32_t component_dimension = 4, sign_dimension = 5,
                               second_sign_dimension = 9;

/// Blocks of the samples of a study, of equal size.
struct SampleBlocks {
  std::size_t count = 1, size = 1;
};

/// Whether friction cannot stop the array: tan(slope) at or above the friction along the slope.
bool slides_freely(const Case& c);

}  // namespace glissade
