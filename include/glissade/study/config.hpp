// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "glissade/building/building_model.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/motion/scaling_rule.hpp"
#include "glissade/sampling/distribution.hpp"
#include "glissade/sampling/point_set.hpp"
#include "glissade/study/analyses.hpp"
#include "glissade/study/cases/case.hpp"
#include "glissade/study/intensity_measure.hpp"

namespace glissade {

struct IntensityConfig {
  IntensityMeasure measure = IntensityMeasure::sds_g;
  std::vector<double> levels;  ///< > 0, strictly increasing
  std::optional<DesignTarget>
      target;  ///< sds_g: shape of the design spectrum; else the suite's own
  /// How a suite is scaled to its target (sds_g), or is to be scaled in its
  /// file (mce_fraction).
  ScalingRule scaling_rule = ScalingRule::walters_2012;
  bool to_one_and_a_half = false;  ///< as in FirstPeriods
  /// walters_2012, sds_g: beyond 2 s, to here, 0.9 of the target is enough, by
  /// no clause of ASCE 7.
  double scaled_to_s = longest_scaled_period_s;
  double sa_period_s = 0.0;              ///< sa_g only, >= 0
  std::vector<double> avg_sa_periods_s;  ///< avg_sa_g only
  bool of_roof = false;                  ///< as that of the suites, known once they are read
};

/// Along how many horizontal axes the array may slide.
enum class SlidingAxes { one, two };

/// What the displacement of a history on two axes is.
enum class DisplacementMeasure {
  srss,   ///< SRSS of the two axes' separate maxima (Walters et al. 2012)
  vector  ///< the longest displacement vector; never more than the SRSS
};

struct ModelConfig {
  SlidingAxes axes = SlidingAxes::two;
  DisplacementMeasure displacement = DisplacementMeasure::srss;  ///< of two axes
};

/// A physical quantity of a study: a list (one value, or several that are all run) or a
/// distribution (a value is drawn for each sample).
struct Quantity {
  std::vector<double> values;         ///< strictly increasing; empty where it is drawn
  std::optional<Distribution> drawn;  ///< never Fixed
  bool drawn_as_rise_in_12 = false;   ///< a slope: a rise in 12 is drawn, not an angle
  bool is_stated = false;             ///< by its key in the study file

  bool is_drawn() const { return drawn.has_value(); }
  bool is_always(double value) const {
    return !drawn && values.size() == 1 && values.front() == value;
  }
  /// No value is above this.
  double largest() const { return drawn ? support(*drawn).max : values.back(); }
};

/// The angle of a slope that rises so much in 12.
double slope_of_rise_deg(double rise);

/// A quantity for each row of parameters().
class Quantities {
 public:
  Quantities();  ///< each as a default Case has it
  Quantity& operator[](std::size_t parameter) { return all_[parameter]; }
  const Quantity& operator[](std::size_t parameter) const { return all_[parameter]; }
  const Quantity& at(const char* table, const char* key) const {
    return all_[parameter_index(table, key)];
  }
  Quantity& at(const char* table, const char* key) { return all_[parameter_index(table, key)]; }

 private:
  std::vector<Quantity> all_;
};

struct FrictionConfig {
  bool across_is_given = false;  ///< friction across the slope is a quantity of its own
  /// Of friction that is drawn: which of its values are run.
  std::vector<FrictionValue> values = {FrictionValue::as_drawn, FrictionValue::design};
  std::string note;  ///< where it comes from, if that must be reported: pull tests
};

/// Which components act along the slope, drawn one a sample.
enum class ComponentChoice { first, second, random };
enum class SignChoice { positive, negative, random };
struct OrientationConfig {
  OrientationChoice choice = OrientationChoice::random;
  std::vector<SlopeAxis> slope_axis = {SlopeAxis::e_w};
  // Of a random choice:
  ComponentChoice component = ComponentChoice::random;
  SignChoice sign = SignChoice::random;
  SignChoice second_sign = SignChoice::random;  ///< two axes
};

/// Fewer scrambles do not decide whether an error of the samples is small enough.
inline constexpr std::uint64_t least_scrambles = 8;
/// When a run may end before all scrambles are run.
struct SamplingTarget {
  double error = 0.0;  ///< > 0: half of the 95 % interval of ln median, of the samples alone
  std::uint64_t most_scrambles = 0;  ///< where it is not reached
};

struct SamplingConfig {
  SamplingMethod method = SamplingMethod::sobol;
  std::uint64_t samples = 1024;  ///< >= 1
  std::uint64_t scrambles = 1;   ///< independent blocks of the samples, of equal size
  std::optional<SamplingTarget> target;
  /// Run before the target is first looked at: an error of few is more often too small by chance.
  std::uint64_t scrambles_to_target = least_scrambles;
  int bootstrap_replicates = 1000;

  SampleBlocks blocks() const { return {scrambles, samples / scrambles}; }
  /// Those that are run one after the other.
  SampleBlocks blocks_in_turn() const { return target ? blocks() : SampleBlocks(); }
  /// The samples of the first blocks.
  SamplingConfig first_blocks(std::uint64_t blocks) const {
    SamplingConfig first = *this;
    first.samples = samples / scrambles * blocks;
    first.scrambles = blocks;
    return first;
  }
};

/// A value of a publication, drawn in the figure of that name.
struct PublishedPoint {
  std::string figure, source;  ///< source: with its value, for the key
  double x = 0.0, y = 0.0;     ///< as on the figure's axes, lengths in m
};

/// A study as its file states it: checked, defaults filled in, nothing read or run yet. Of its
/// analyses each has its own part.
struct StudyConfig : Analyses::InStudy {
  std::string name;
  std::string description;
  std::uint64_t seed = 0;
  UnitSystem units = UnitSystem::si;  ///< of its report
  /// Of a study in US units: "thresholds_m = 1 (3.28 ft)", without a unit in the file.
  std::vector<std::string> unmarked_numbers;
  /// What holds for a key that the file leaves out.
  struct NotStated {
    std::string text;                      ///< "building.damping: 0.05"
    const Parameter* parameter = nullptr;  ///< that it is; null: of no case
  };
  std::vector<NotStated> not_stated;
  std::filesystem::path file;  ///< the study file
  std::string source_text;     ///< the study file, verbatim
  /// Texts of the files that it names but suites (pull tests, curves, spectra), by their names.
  std::map<std::string, std::string> data_files;
  std::string hashed_text;  ///< the study file with all quantities in the units of their keys, and
                            ///< files without their folders
  std::vector<std::filesystem::path> suite_files;  ///< one at least, resolved
  bool by_stripes = false;  ///< multiple stripes: the records of suite i are run at level i alone
  std::vector<std::string> records;  ///< ids of the records to run; empty: all
  bool normalise_by_pgv = false;     ///< each suite, of those records
  IntensityConfig intensity;
  ModelConfig model;
  Quantities quantities;
  BuildingModel building;
  std::vector<ArraySupport> support = {ArraySupport::isolated};
  std::vector<VerticalChoice> vertical = {VerticalChoice::if_available};
  FrictionConfig friction;
  NeighbourSlope neighbour_slope = NeighbourSlope::same;
  OrientationConfig orientation;
  SamplingConfig sampling;
  std::vector<PublishedPoint> published;

  /// A clearance also of a suite that does not meet its target: not for design.
  bool is_without_target() const {
    return (clearance && clearance->without_target) || (chart && chart->without_target);
  }
  bool two_axes() const { return model.axes == SlidingAxes::two; }
  const std::vector<double>& thresholds_m() const;  ///< of the fragility; empty without one
  bool draws() const;                               ///< any quantity or the orientation
  bool samples_friction() const;                    ///< runs friction as drawn
  bool has_neighbours() const;                      ///< arrays have a second one beside them
};

/// Axis label of the intensity measure, its definition with its unit: "S_DS (g)" ...
std::string intensity_label(const IntensityConfig& intensity);

/// "uniform, 0.2 to 2", "one of 1.19, 2.39" ...
std::string describe(const Distribution& distribution);

/// "0.47", "0.2, 0.4, 0.7", "uniform, 0.2 to 2".
std::string describe(const Quantity& quantity);

/// As the user states it: of the parent where a normal is cut.
double stated_mean(const Distribution& distribution);

/// Along the slope: of friction that is drawn the stated mean, whatever was drawn.
double stated_friction(const StudyConfig& config, const Case& c);

/// The design coefficient of friction, mean - 2 std (Walters et al. 2012), not below 0.
double design_friction(const Distribution& mu);

}  // namespace glissade
