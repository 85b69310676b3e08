// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/block/friction_law.hpp"
#include "glissade/block/tipping.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/sampling/distribution.hpp"
#include "glissade/sampling/point_set.hpp"
#include "glissade/standards/prescriptive.hpp"

namespace glissade {

/// What the levels of a study mean. Record i at level x runs with the factor that gives it that
/// intensity.
enum class IntensityMeasure {
  sds_g,     ///< the whole suite scaled so that its average SRSS spectrum meets the design spectrum
             ///< with this S_DS
  pga_g,     ///< geometric mean of the horizontals' peak ground accelerations
  sa_g,      ///< geometric mean of the horizontals' Sa at sa_period_s, 5 %
  avg_sa_g,  ///< geometric mean of Sa over avg_sa_periods_s and both horizontals, 5 %
  ppa_g,     ///< peak roof acceleration along the slope's plan direction (depends on the sample's
             ///< building)
};
std::string to_string(IntensityMeasure measure);

struct IntensityConfig {
  IntensityMeasure measure = IntensityMeasure::sds_g;
  std::vector<double> levels;  ///< > 0, strictly increasing
  std::optional<DesignTarget>
      target;                ///< sds_g: shape of the design spectrum; else the suite's own
  double sa_period_s = 0.0;  ///< sa_g only, >= 0
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
  SlidingAxes axes = SlidingAxes::one;
  DisplacementMeasure displacement = DisplacementMeasure::srss;  ///< of two axes
};

/// How strong a yielding building is: by one of the first two.
struct StrengthConfig {
  std::optional<double> response_modification;  ///< R >= 1: the yield force is the design
                                                ///< spectrum's elastic demand at the building's
                                                ///< period over R; needs a target spectrum
  std::optional<double> yield_coefficient;      ///< > 0: yield force over the building's weight
  double hardening_ratio = 0.0;                 ///< stiffness after yielding over before, [0, 1)
};

struct BuildingConfig {
  Distribution period_s = Fixed{0.0};    ///< 0: rigid
  Distribution damping = Fixed{0.05};    ///< ratio, [0, 1)
  Distribution mass_ratio = Fixed{0.0};  ///< the array's mass over the building's, [0, 1]
  double period_ratio = 1.0;  ///< two axes: period along the building's second axis over that along
                              ///< its first, > 0
  std::optional<StrengthConfig> strength;  ///< none: it stays elastic
};

struct RoofConfig {
  Distribution slope_deg = Fixed{0.0};    ///< [-89.9, 89.9]; in a study usually >= 0
  Distribution azimuth_deg = Fixed{0.0};  ///< two axes: from the building's first axis to where the
                                          ///< roof falls, toward the second; [-360, 360]
};

struct FrictionConfig {
  Distribution mu = Fixed{0.5};  ///< >= 0; `mean`/`std` in the file become a normal truncated at 0
  std::optional<Distribution> across;  ///< two axes: across the slope; none: the same as along it
  FrictionLaw law;
  bool design_run = true;  ///< also run with mu = mean - 2 std (skipped where std = 0)
  std::string note;        ///< where it comes from, if a reader must know: pull tests
};

enum class ComponentChoice { first, second, random, both };  ///< `random` by sample; `both`: charts
enum class SignChoice { positive, negative, random, both };  ///< likewise
struct OrientationConfig {
  ComponentChoice component = ComponentChoice::random;  ///< which horizontal acts along the slope;
                                                        ///< of two axes: along the building's first
  SignChoice sign = SignChoice::random;                 ///< of that component
  SignChoice second_sign = SignChoice::random;          ///< two axes: of the other
};

enum class VerticalChoice { none, if_available, required };
struct VerticalConfig {
  VerticalChoice use = VerticalChoice::if_available;
  double period_s = 0.0;  ///< 0: the vertical reaches the roof unchanged (Walters 2012)
  double damping = 0.05;
};

struct SamplingConfig {
  SamplingMethod method = SamplingMethod::sobol;
  std::uint64_t samples = 1024;  ///< >= 1
  int bootstrap_replicates = 1000;
};

enum class Standard { seaoc_pv1_2012, asce7_16 };
struct StandardsConfig {
  std::vector<Standard> compare;  ///< only with sds_g
  SeismicDesignCategory category = SeismicDesignCategory::d;
  double importance = 1.0;
};

/// A number to be read off a chart.
struct ChartQuestion {
  double level = 0.0, slope_deg = 0.0;   ///< within the chart's axes
  std::optional<double> mu;              ///< asks for the displacement
  std::optional<double> displacement_m;  ///< asks for the friction needed to keep slip within it
};

/// A design chart: every combination of slope, friction, building period and level is run, in every
/// orientation, in place of random samples.
struct ChartConfig {
  std::vector<double> slope_deg;  ///< two or more, strictly increasing; a negative slope counts for
                                  ///< its mirror image
  std::vector<double> mu;         ///< two or more, strictly increasing, >= 0
  std::vector<double> period_s;   ///< one or more, strictly increasing; 0: rigid
  double shown_slope_deg = 0.0, shown_mu = 0.0, shown_level = 0.0;  ///< on the axes: where figures
                                                                    ///< cut through the chart
  std::vector<ChartQuestion> questions;
};

/// A study as its file tells it: checked, defaults filled in, nothing read or run yet.
struct StudyConfig {
  std::string name;
  std::string description;
  std::uint64_t seed = 0;
  std::filesystem::path file;        ///< the study file
  std::string source_text;           ///< the study file, verbatim
  std::filesystem::path suite_file;  ///< resolved against the study file's folder
  std::vector<std::string> records;  ///< ids of the suite's records to run; empty: all
  IntensityConfig intensity;
  ModelConfig model;
  BuildingConfig building;
  RoofConfig roof;
  FrictionConfig friction;
  OrientationConfig orientation;
  VerticalConfig vertical;
  SamplingConfig sampling;
  std::vector<double> thresholds_m;  ///< > 0, strictly increasing
  /// Levels above the one at which a history reaches the largest threshold are not run: slip there
  /// is told as infinite.
  bool stop_at_largest_threshold = false;
  bool impact = false;  ///< when and how fast each threshold is first reached is kept too
  StandardsConfig standards;
  std::optional<RigidBase> base;     ///< of the array: asks for the tipping check
  std::optional<ChartConfig> chart;  ///< then friction, slope and period are its axes, and there
                                     ///< are no samples and no thresholds
};

/// Axis label of the intensity measure with its unit: "S_DS (g)", "Sa(1 s) (g)" ...
std::string intensity_label(const IntensityConfig& intensity);

/// What a standard prescribes at an S_DS.
Prescription prescribed_displacement(Standard standard, double sds_g,
                                     const StandardsConfig& standards);

/// "uniform, 0.2 to 2", "one of 1.19, 2.39" ...
std::string describe(const Distribution& distribution);

/// The design coefficient of friction, mean - 2 std (Walters 2012), not below 0.
double design_friction(const Distribution& mu);

}  // namespace glissade
