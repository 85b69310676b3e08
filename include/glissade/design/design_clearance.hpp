// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glissade/design/project.hpp"
#include "glissade/motion/motion.hpp"
#include "glissade/standards/conditions.hpp"
#include "glissade/study/analysis/model_uncertainty.hpp"
#include "glissade/study/results.hpp"

// From the results of a project's studies to one governing displacement and its separations.
namespace glissade {

struct Plan;

/// Design values of the site.
struct SiteValues {
  double sds_g = 0.0, sd1_g = 0.0;
  double fa = 0.0, fv = 0.0;  ///< of the class that governs; 0: the target is not mapped
  SeismicDesignCategory category = SeismicDesignCategory::d;

  double sms_g() const { return mce_over_dbe * sds_g; }
  double sm1_g() const { return mce_over_dbe * sd1_g; }
};
SiteValues site_values(const ProjectSite& site);
/// The seismic design category, or those that it may be where S_1 is not known: "D, E or F".
std::string category_text(const ProjectSite& site, const SiteValues& values);

/// Displacement at one building period over the records of the suite, all in the orientation with
/// the largest mean. Each number is the largest over the project's slopes, mass ratios, with and
/// without vertical motion; the orientation is that of the largest mean.
struct PeriodDemand {
  double period_s = 0.0;
  std::string orientation;
  double mean_m = 0.0, p84_m = 0.0, p95_m = 0.0;  ///< percentiles by Hyndman & Fan (1996) type 7
  double largest_m = 0.0;                         ///< of the records, in any orientation
  double median_orientation_m = 0.0;              ///< the mean in the median orientation
};

/// A prescriptive displacement at the site, whether it may be used, and the least value of an
/// analysis in its place.
struct PrescribedValue {
  Standard standard;
  Prescription prescribed;
  std::vector<CodeCondition> conditions;
  double floor_share = 0.0;  ///< of the prescribed value, unless an analysis is peer reviewed
  std::string floor_basis;

  bool may_be_used() const;
  /// Of the conditions that are not met or not known; else empty.
  std::string not_met() const;
  /// Of those that are known not to be met.
  std::string violated() const;
};
/// What both standards judge: the friction by its design value, which is below the mean.
ArrayFacts facts_of(const Project& project, const SiteValues& site);
std::vector<PrescribedValue> prescribed_values(const Project& project, const SiteValues& site);

/// Probability that the displacement exceeds the governing one, at one building period.
struct ExceedanceAt {
  std::string level;                       ///< "DBE"
  double intensity = 0.0, period_s = 0.0;  ///< as dbe_level()
  double probability = 0.0;
  /// 95 %, over records, and never narrower than that of a binomial without (or with
  /// nothing but) exceedances in as many trials as there are records.
  Interval interval;
};

/// How often a displacement is exceeded; each number at the building period where it is largest.
struct DisplacementExceedance {
  /// Of DesignClearance::separations: what the clearance at hand allows, clearance / factor; none:
  /// the governing displacement.
  std::optional<std::size_t> separation;
  double displacement_m = 0.0;
  ExceedanceAt dbe, mce;
  std::optional<ThresholdRate> rate;  ///< with a hazard curve
};

/// At DBE, at the building period where it is largest.
struct QuantileDisplacement {
  double displacement_m = 0.0;  ///< infinite where so many histories slide freely
  Interval interval;            ///< 95 %, over records
};
/// Probability of exceedance at DBE up to which no warning is given: a limit of this program.
inline constexpr double accepted_exceedance = 0.1;

/// A check of the calculation.
struct DesignCheck {
  std::string what, found, criterion;
  bool is_met = false;
};

/// Peak acceleration of the roof at DBE, without the array, over the records: of each the geometric
/// mean of both horizontal axes. Beside it what the standards have for a floor there.
struct RoofPeak {
  double period_s = 0.0, alpha = 0.0;  ///< 0: the motions are those of the roof
  double median_g = 0.0, p84_g = 0.0;
  double asce7_16_g = 0.0;
  std::optional<double> asce7_22_g;  ///< none: no period of a building is known

  /// The lowest ratio of the median to a standard's.
  double over_standards() const;
};
/// By period and alpha of the building; of motions of a roof one. `suite`: the motions of `demand`.
std::vector<RoofPeak> roof_peaks(const Project& project, const Results& demand, const Suite& suite);

/// What is possible and not probable, or to be decided by the engineer: shown before the result.
struct DesignWarning {
  std::string text;
  bool is_open_item = false;  ///< no separation is called sufficient before it is settled
};

/// Whether an available separation is enough; of several the first of these that one of them has,
/// or that the project has: not_applicable, where a condition of the standard is violated.
enum class SeparationVerdict { insufficient, not_applicable, open, not_stated, sufficient };

struct DesignClearance {
  SiteValues site;
  double slope_deg = 0.0, mass_ratio = 0.0, period_s = 0.0, alpha = 0.0;  ///< of the governing case
  VerticalChoice vertical = VerticalChoice::if_available;                 ///< likewise
  std::string orientation;                                                ///< likewise
  std::vector<double> by_record_m;   ///< likewise: the displacement under each record
  std::vector<PeriodDemand> demand;  ///< by period
  std::vector<RoofPeak> roof;
  double factor = 1.1;
  bool of_largest = false;  ///< fewer than 7 records: the largest counts in place of the mean
  double analysis_m = 0.0;  ///< factor x the largest mean over orientations and periods
  double median_analysis_m = 0.0;  ///< with the median of the orientations in place of the largest
  double mce_analysis_m = 0.0;     ///< at the MCE
  std::optional<double> bound_analysis_m;  ///< with the lower bound of the tests, where it is run
  std::vector<PrescribedValue> prescribed;
  double floor_m = 0.0;  ///< least value of an analysis by the standard of the project; 0: none
  double governing_m = 0.0;
  bool floor_governs = false;
  double rounded_m = 0.0;  ///< governing_m, rounded up
  std::vector<ProjectSeparation> separations;
  std::vector<DesignCheck> checks;
  // Until the other studies have run, these are empty.
  ModelUncertainty uncertainty;                  ///< of analysis_m
  std::vector<ExceedanceAt> exceedance;          ///< by level, those of a level by period
  std::vector<DisplacementExceedance> compared;  ///< first the governing displacement
  QuantileDisplacement accepted;  ///< that accepted_exceedance of the histories exceed
  std::vector<DesignWarning> warnings;
};

/// `demand`: the results of demand_study(), of the motions of `suite`. The rule after Walters et
/// al. (2012), with the largest of the orientations in place of their median; with or without
/// vertical motion, whichever is larger. With fewer than 7 records the largest record counts in
/// place of the mean (SEAOC PV1-2012, recalled).
DesignClearance design_clearance(const Project& project, const Results& demand, const Suite& suite);

/// The prescriptive value of the project's standard.
const PrescribedValue& of_standard(const Project& project, const DesignClearance& design);

SeparationVerdict verdict_on(const ProjectSeparation& separation, const Project& project,
                             const DesignClearance& design);
/// On all of them.
SeparationVerdict verdict_on(const Project& project, const DesignClearance& design);

/// What the project states that makes the result smaller, that is improbable, or that leaves an
/// item open: warnings that need no analysis.
std::vector<DesignWarning> warnings_on(const Project& project);

inline constexpr const char* simulated_motions_warning =
    "the motions of this suite are simulated and do not serve for a permit: repeat the calculation "
    "with recorded motions";

/// Of the number of records and the friction.
std::vector<DesignCheck> checks_before_analysis(const Project& project, std::size_t records);
/// Of the suite as the demand study scales it: whether it meets the spectrum of exception 2 of
/// 11.4.8, where that is taken.
std::vector<DesignCheck> checks_of_scaling(const Project& project, const Plan& demand);
/// Those that the project does not state: without them the verdict is "not stated"; empty: all are.
std::string separations_not_stated(const Project& project);
/// A warning.
std::string not_met_text(const DesignCheck& check);

/// The frictions of the demand study, with what each is, increasing.
struct StudiedFriction {
  double value = 0.0;
  std::string what;  ///< "mean - 2 std"
};
std::vector<StudiedFriction> frictions_of(const Project& project);
/// "95 % lower bound of the tests", with its direction where there are several.
std::string bound_name(const ProjectFriction& friction);

// What is added to the project's values is for the model uncertainty.

/// The slopes of the demand study: those of the project, and beside a single one a steeper one.
std::vector<double> slopes_of(const Project& project);
/// Those of the project, and of one value twice that too (0.05 of none).
std::vector<double> mass_ratios_of(const Project& project);
/// Those of the project, and of one above 0 also 0.9 and 1.1 times that, s.
std::vector<double> periods_of(const Project& project);
/// Half of the building's damping ratio, it, and twice it, 0.999 at most; of a roof's motions none.
std::vector<double> dampings_of(const Project& project);
/// The mean friction at both ends of the 95 % interval of the mean of the tests (Student's t), or
/// where their number is not known of mean - std to mean + std; from 0 to 2. None without scatter.
struct FrictionEnds {
  double low = 0.0, high = 0.0;
  std::string what;  ///< "95 % interval of the mean of 7 tests"
};
std::optional<FrictionEnds> friction_ends(const Project& project);
/// On the steepest slope of the project.
bool slides_freely_on(const Project& project, double friction);
/// The intensity of the design earthquake (DBE) in the studies: S_DS, g, or the factor on the
/// motions of a roof. That of the MCE is mce_over_dbe times it.
double dbe_level(const Project& project);
/// Levels of the probability study: from a quarter of that of the DBE to 3.75 times it
/// (most_probable_g at most), DBE and MCE among them. With a hazard curve from a tenth of it, where
/// nothing slides, in small steps where slip begins: what adds up over a design life comes from
/// there.
std::vector<double> levels_of(const Project& project);

/// The displacements of DesignClearance::compared, increasing, each once.
std::vector<double> compared_displacements_m(const Project& project, double governing_m);

/// Adds what the results of uncertainty_study() and of demand_study() give: the displacement of the
/// analysis with one premise at either end, the largest over the project's conditions in all else.
void add_model_uncertainty(const Project& project, const Results& demand,
                           const Results& uncertainty, DesignClearance& design);
/// Adds what the results of probability_study() give.
void add_exceedance(const Project& project, const Results& probability, DesignClearance& design);

/// Up to a whole number of steps; a value that is above one by 1e-9 of a step or less stays there.
double rounded_up(double value, double step);

}  // namespace glissade
