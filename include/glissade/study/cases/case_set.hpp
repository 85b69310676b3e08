// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <ranges>
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
  std::vector<std::string> described;  ///< of these: "design friction", "no array"

  std::size_t size() const { return values.size(); }
  std::string words() const;                  ///< "building period", "array"
  std::string describe(std::size_t i) const;  ///< "building period 0.5 s", "anchored array"
  bool operator==(const CaseAxis&) const = default;
};

/// How the cases of a study are numbered: every combination of what it lists, each with all its
/// samples, each of these in all its orientations.
struct CaseGrid {
  std::vector<CaseAxis> axes;  ///< those with two values or more, the first varies slowest
  std::size_t samples = 1;
  std::size_t orientations = 1;  ///< of every sample; 1 where one is drawn

  std::size_t size() const { return combinations() * per_combination(); }
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
  /// "design friction, building period 0.5 s", without some axes; empty where nothing is listed.
  std::string describe(std::size_t combination, const std::vector<std::string>& without = {}) const;
};

/// The cases of results, stored.
struct CaseSet : CaseGrid {
  std::vector<Case> cases;  ///< by (combination, sample, orientation)

  std::size_t size() const { return cases.size(); }
  /// "sampled", "design", "period_s_0_5", where one is long "combination_1" and so on: fit for a
  /// file's name (a to z, 0 to 9, _ and -). Where nothing is listed what friction is: "constant",
  /// "sampled" or "design".
  std::string label(std::size_t combination) const;
};

/// The choice that these orientations are of; what was drawn and is all as recorded counts as that.
OrientationChoice orientation_choice(const CaseSet& set);

/// Position of a case in a plan or in results.
using CaseNumber = std::uint32_t;

class SampleDraw;

/// The cases of a plan, each made where it is wanted: every rank has them all.
class PlannedCases : public CaseGrid {
 public:
  PlannedCases() = default;
  /// Throws InputError where there are more than 2^32 - 1.
  explicit PlannedCases(const StudyConfig& config);
  /// By (combination, sample, orientation).
  Case operator[](std::size_t i) const;
  Case operator()(std::size_t i) const { return (*this)[i]; }
  auto all() const {
    return std::views::iota(std::size_t{0}, size()) |
           std::views::transform([this](std::size_t i) { return (*this)[i]; });
  }
  CaseSet stored() const;
  /// Stores what is drawn (8 bytes a sample for each drawn quantity, 24 for its orientation), for
  /// many passes over the cases; copies share it.
  void store_draws();
  void drop_draws();

 private:
  Case usual_;                                                ///< with all that has one value
  std::vector<std::function<void(Case&, std::size_t)>> put_;  ///< by axis: one of its values
  std::shared_ptr<SampleDraw> draw_;
  std::vector<Orientation> orientations_;  ///< of each sample
  bool across_is_given_ = false;
  /// Of drawn friction: mean - 2 std.
  std::optional<double> design_along_, design_across_, design_neighbour_;
};

/// By case: the first that has the same histories but for the sign of what moves across the slope.
/// What acts across is then mirrored, or has no part in the model; a flat roof mirrored is itself.
/// It is of the same block.
std::vector<CaseNumber> same_as(const CaseGrid& cases,
                                const std::function<Case(std::size_t)>& case_of, bool two_axes,
                                SampleBlocks blocks = {});

/// By number below `count`: the first with an equal key.
/// @param key_of a number's key, made each time: all of them would take more memory than the cases
std::vector<CaseNumber> first_with_same_key(
    std::size_t count, const std::function<std::vector<double>(CaseNumber)>& key_of);

}  // namespace glissade
