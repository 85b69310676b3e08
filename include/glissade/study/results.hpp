// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "glissade/core/finite.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/study/cases/case_set.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/run/history_table.hpp"

namespace glissade {

struct RecordSummary {
  std::uint64_t suite = 0;  ///< position of its suite
  std::string id, event, station;
  double magnitude = 0.0, distance_km = 0.0, vs30_mps = 0.0;  ///< 0 where not given
  double suite_scale = 1.0;                                   ///< the suite file's factor
  double factor_at_unit_level = 0.0;  ///< factor on the record at intensity 1 (0 for ppa_g: depends
                                      ///< on the roof)
  double pga_g = 0.0, pgv_mps = 0.0, pgd_m = 0.0;  ///< geometric means of the horizontals, as
                                                   ///< recorded
  double duration_s = 0.0;                         ///< D5-95 of both horizontals together
  double dt_s = 0.0;
  std::uint64_t samples = 0;
  bool has_second = false, has_vertical = false;
  std::uint64_t stronger = 0;  ///< the component with the larger integral of a^2: 0 or 1
  /// As recorded, geometric means of the horizontals; NaN or empty where not known.
  double arias_mps = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sa_g, roof_velocity_mps;  ///< 5 % damped, at Results::record_periods_s
  std::string processing;                       ///< what its suite asked for and was done with it
};

/// 5 % spectra of the suite, of the horizontals together as the rule of its
/// scaling takes them (SRSS, RotD100), scaled to `reference_level` (sds_g) or
/// by the suite's own factors (else).
struct SuiteSpectra {
  std::vector<double> periods_s;
  std::vector<std::vector<double>> records_g;  ///< [record][period]
  std::vector<double> average_g;               ///< [period]
  std::vector<double> target_g;                ///< [period]; empty without a target
  double reference_level = 0.0;                ///< 0: as scaled in the suite file
  /// Of the average, over the periods of the rule; NaN without a target.
  SpectralRatios to_target;
  ScalingRule rule = ScalingRule::walters_2012;
  PeriodRange range{0.0, longest_scaled_period_s};               ///< of the rule
  double mean_ratio = std::numeric_limits<double>::quiet_NaN();  ///< not of walters_2012

  const char* combination() const { return text_of(rule).combination; }
};

/// The model in sentences, empty where there is nothing to report, and the earthquakes it is under.
struct ModelText {
  std::string kernel;        ///< what computed the histories
  std::string modes;         ///< of a building of several: which, how many, how much of its mass
  std::string building;      ///< how it yields
  std::string friction;      ///< what differs from Coulomb's law
  std::string displacement;  ///< of two axes: what a history's displacement is
  double dbe_level = 0.0;    ///< S_DS of the one design target of a study by sds_g; else 0
};

struct SuiteSummary {
  std::string name, description;
  std::string target;  ///< "ASCE 7-16, S_S 1.5 g, S_1 0.6 g, site class D"; empty without one
  SuiteSpectra spectra;
  bool of_roof = false;             ///< as that of Suite
  bool target_is_envelope = false;  ///< over several site classes
  /// Of Walters et al. (2012), if the target has its mapped values; else -1.
  int intensity_level = -1;
};

/// A sentence before the results.
struct Warning {
  Warning(std::string words, bool is_of_curves = false)
      : text(std::move(words)), of_fitted_curves(is_of_curves) {}
  std::string text;
  bool of_fitted_curves;  ///< not of the shares of the histories
  bool operator==(const Warning&) const = default;
};
std::vector<std::string> texts_of(const auto& warnings) {
  std::vector<std::string> texts;
  for (const auto& warning : warnings) texts.push_back(warning.text);
  return texts;
}

/// Everything a study found, and nothing about when, where or on how many ranks.
/// Of each analysis its own part.
struct Results : Analyses::InResults {
  std::string study_name, study_description, program_version, plan_hash, study_text;
  std::map<std::string, std::string> study_data_files;  ///< StudyConfig::data_files
  std::uint64_t seed = 0;
  UnitSystem units = UnitSystem::si;  ///< what stands first in the report
  IntensityMeasure measure = IntensityMeasure::sds_g;
  std::string intensity_label;   ///< for axes: "S_DS (g)", "Sa(1.0 s) (g)" ...
  std::string intensity_symbol;  ///< in sentences: "S_DS", "Sa(1.0 s)"
  std::vector<SuiteSummary> suites;
  ModelText model;
  BuildingModel building;
  SlidingAxes axes = SlidingAxes::one;
  DisplacementMeasure displacement = DisplacementMeasure::srss;  ///< of two axes
  std::vector<double> levels, thresholds_m;
  bool by_stripes = false;  ///< as that of StudyConfig
  std::vector<PublishedPoint> published;
  CaseSet cases;
  std::vector<RecordSummary> records;           ///< those of one suite together
  std::vector<double> record_periods_s;         ///< of their spectra as recorded
  HistoryTable histories;                       ///< by (record, case)
  std::optional<ReachedTarget> reached_target;  ///< with sampling.target_error
  std::vector<Warning> warnings;
  std::vector<std::string> notes;  ///< remarks on the results
  /// So many of them, the first, are of the run; the others of the analyses.
  std::size_t warnings_of_run = 0, notes_of_run = 0;
};

/// What intervals are over: the events of the records, where they are stated.
std::vector<std::size_t> event_units(const std::vector<RecordSummary>& records);
std::size_t unit_count(const Results& results);
double effective_units(const Results& results);  ///< as many of one record each (Kish 1965)

inline bool slides_on_two_axes(const Results& results) { return results.axes == SlidingAxes::two; }

/// Of a history, by the study's measure; infinite where the array slides freely.
inline double displacement_m(const Results& results, std::size_t record, std::size_t i,
                             std::size_t level) {
  return slides_freely(results.cases.cases[i]) ? infinity
                                               : results.histories.displacement_m(record, i, level);
}

/// Which of the frictions of a sample a run has.
FrictionValue friction_value_of(const Results& results, const RunResults& run);
/// Of the runs with the friction value of the first the one whose order (a number, or a pair) is
/// largest; the first of equal ones. @param order of the position of a run
template <class Order>
std::size_t run_of_largest(const Results& results, const Order& order) {
  std::size_t found = 0;
  for (std::size_t i = 1; i < results.runs.size(); ++i)
    if (friction_value_of(results, results.runs[i]) ==
            friction_value_of(results, results.runs[0]) &&
        order(i) > order(found))
      found = i;
  return found;
}
/// Which combination sentences are of: with the friction of the first the one that exceeds its
/// clearances most, by the annual rates where there are some, else by the shares over all levels.
std::size_t governing_run(const Results& results);

}  // namespace glissade
