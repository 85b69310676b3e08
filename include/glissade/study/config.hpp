// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/block/tipping.hpp"
#include "glissade/core/units.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/sampling/distribution.hpp"
#include "glissade/sampling/point_set.hpp"
#include "glissade/standards/prescriptive.hpp"
#include "glissade/study/cases/case.hpp"
#include "glissade/study/intensity_measure.hpp"

namespace glissade {

struct IntensityConfig {
  IntensityMeasure measure = IntensityMeasure::sds_g;
  std::vector<double> levels;  ///< > 0, strictly increasing
  std::optional<DesignTarget>
      target;  ///< sds_g: shape of the design spectrum; else the suite's own
  /// sds_g: beyond 2 s, to here, 0.9 of the target is enough (ASCE 7-16, 16.2, recalled).
  double scaled_to_s = longest_scaled_period_s;
  double sa_period_s = 0.0;              ///< sa_g only, >= 0
  std::vector<double> avg_sa_periods_s;  ///< avg_sa_g only
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

enum class Standard { seaoc_pv1_2012, asce7_16 };
struct StandardsConfig {
  std::vector<Standard> compare;  ///< only with sds_g
  SeismicDesignCategory category = SeismicDesignCategory::d;
  double importance = 1.0;
};

/// A number to be read off a chart.
struct ChartQuestion {
  double level = 0.0, slope_deg = 0.0;  ///< within the chart's axes
  std::optional<double> mu;             ///< given: the displacement is required
  std::optional<double>
      displacement_m;  ///< given: the friction that keeps the slip within it is required
};

/// A chart of displacement over the study's slopes, frictions and building periods.
struct ChartConfig {
  double shown_slope_deg = 0.0, shown_mu = 0.0, shown_level = 0.0;  ///< where figures cut through
  std::vector<ChartQuestion> questions;
  bool without_target = false;  ///< also of a suite that does not meet its target
};

/// Which of the orientations of the records a required clearance is of: the largest, or the median,
/// as Walters et al. (2012) take it.
enum class OrientationRule { largest, median };

/// The clearance that Walters et al. (2012) recommend: a factor on the suite's mean displacement,
/// the largest over the building periods.
struct ClearanceConfig {
  double factor = 1.1;  ///< >= 1
  OrientationRule orientation = OrientationRule::largest;
  bool without_target = false;  ///< also of a suite that does not meet its target
};

struct FragilityConfig {
  std::vector<double> thresholds_m;  ///< > 0, strictly increasing
  /// Levels above the one at which a history reaches the largest threshold are not run: slip there
  /// is reported as infinite.
  bool stop_at_largest = false;
};

/// How often the site has shaking of each intensity, and for how long the array stands there.
struct HazardConfig {
  HazardCurve curve;                          ///< in the study's intensity measure
  std::string source;                         ///< "hazard.csv", "1e-4 x^-2.5"
  double design_life_years = 0.0;             ///< > 0
  std::vector<double> target_rates_per_year;  ///< > 0, falling
  double sds_g = 0.0;                         ///< of the site, where stated; else 0
  bool is_assumed = false;                    ///< from sds_g: no site's curve
};

/// The probabilities of exceedance that prescribed displacements are judged by: the first is
/// accepted at DBE.
struct VerdictConfig {
  std::vector<double> exceedance = {0.1, 0.05, 0.01};  ///< falling, (0, 1)
};

/// Probabilities of small exceedance, with samples from wider distributions.
struct RareConfig {
  std::vector<double> thresholds_m;  ///< > 0, strictly increasing
  double widening = 3.0;  ///< >= 1: on the standard normal numbers of unbounded quantities
};

/// Intensity measures are ranked by what they say about the capacities of [fragility].
struct IntensityMeasuresConfig {
  std::vector<double> sa_periods_s = {0.2, 0.5, 1.0, 2.0};  ///< rising, 0.02 to 4
};

/// A study as its file states it: checked, defaults filled in, nothing read or run yet.
struct StudyConfig {
  std::string name;
  std::string description;
  std::uint64_t seed = 0;
  UnitSystem units = UnitSystem::si;  ///< of its report
  std::filesystem::path file;         ///< the study file
  std::string source_text;            ///< the study file, verbatim
  std::string hashed_text;            ///< the same with all quantities in the units of their keys
  std::vector<std::filesystem::path> suite_files;  ///< one at least, resolved
  std::vector<std::string> records;                ///< ids of the records to run; empty: all
  IntensityConfig intensity;
  ModelConfig model;
  Quantities quantities;
  std::vector<ArraySupport> support = {ArraySupport::isolated};
  std::vector<VerticalChoice> vertical = {VerticalChoice::if_available};
  FrictionConfig friction;
  OrientationConfig orientation;
  SamplingConfig sampling;
  // Analyses, each where the study has its table:
  std::optional<FragilityConfig> fragility;
  std::optional<ChartConfig> chart;
  std::optional<ClearanceConfig> clearance;
  std::optional<HazardConfig> hazard;
  std::optional<VerdictConfig> verdict;
  std::optional<RareConfig> rare;
  std::optional<IntensityMeasuresConfig> intensity_measures;
  StandardsConfig standards;
  bool sensitivity = false;          ///< where the spread comes from
  bool shape = false;                ///< of the fragilities
  bool impact = false;               ///< when and how fast each threshold is first reached
  bool base_shear = false;           ///< two axes: peak base shear of the building
  std::optional<RigidBase> tipping;  ///< of the array

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

/// "largest", "median".
const char* to_string(OrientationRule rule);

/// Axis label of the intensity measure with its unit: "S_DS (g)", "Sa(1 s) (g)" ...
std::string intensity_label(const IntensityConfig& intensity);

/// What a standard prescribes at an S_DS.
Prescription prescribed_displacement(Standard standard, double sds_g,
                                     const StandardsConfig& standards);

/// "uniform, 0.2 to 2", "one of 1.19, 2.39" ...
std::string describe(const Distribution& distribution);

/// "0.47", "0.2, 0.4, 0.7", "uniform, 0.2 to 2".
std::string describe(const Quantity& quantity);

/// The design coefficient of friction, mean - 2 std (Walters et al. 2012), not below 0.
double design_friction(const Distribution& mu);

}  // namespace glissade
