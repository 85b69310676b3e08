// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "glissade/study/cases/case.hpp"

namespace glissade {

struct StudyConfig;

/// A quantity of which a study runs several values.
struct CaseAxis {
  std::string key;   ///< "building.period_s"
  std::string unit;  ///< "s"; "-" where `names` say what the values are
  std::vector<double> values;
  std::vector<std::string>
      names;  ///< of values that are choices: "sampled", "anchored"; else empty

  std::size_t size() const { return values.size(); }
  std::string words() const;                  ///< "building period", "array"
  std::string describe(std::size_t i) const;  ///< "building period 0.5 s", "anchored array"
  bool operator==(const CaseAxis&) const = default;
};

/// The cases of a study: every combination of what it lists, each with all its samples, each of
/// these in all its orientations.
struct CaseSet {
  std::vector<CaseAxis> axes;  ///< those with two values or more, the first varies slowest
  std::size_t samples = 1;
  std::size_t orientations = 1;  ///< of every sample; 1 where one is drawn
  std::vector<Case> cases;       ///< by (combination, sample, orientation)

  std::size_t size() const { return cases.size(); }
  std::size_t combinations() const;
  std::size_t per_combination() const { return samples * orientations; }
  std::size_t index(std::size_t combination, std::size_t sample, std::size_t orientation) const {
    return (combination * samples + sample) * orientations + orientation;
  }
  /// Which of the blocks a case is of.
  std::size_t block(std::size_t i, SampleBlocks blocks) const {
    return i / orientations / blocks.size % blocks.count;
  }
  /// A combination's place on each axis, and back.
  std::vector<std::size_t> places(std::size_t combination) const;
  std::size_t combination(const std::vector<std::size_t>& places) const;
  /// Position of an axis; axes.size() where the study has one value.
  std::size_t axis(const std::string& key) const;
  /// "sampled", "design", "period_s_0_5", where one is long "combination_1" and so on: fit for a
  /// file's name (a to z, 0 to 9, _ and -). Where nothing is listed what friction is: "constant",
  /// "sampled" or "design".
  std::string label(std::size_t combination) const;
  /// "design friction, building period 0.5 s", without one axis; empty where nothing is listed.
  std::string describe(std::size_t combination, const std::string& without = "") const;
};

CaseSet make_cases(const StudyConfig& config);

/// By case: the first that has the same histories but for the sign of what moves across the slope.
/// What acts across is then mirrored, or has no part in the model; a flat roof mirrored is itself.
/// It is of the same block.
std::vector<std::size_t> same_as(const CaseSet& set, bool two_axes, SampleBlocks blocks = {});

}  // namespace glissade
