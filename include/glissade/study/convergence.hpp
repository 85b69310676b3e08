// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/study/results.hpp"

// The convergence study of Rodriguez-Nikl et al. (2019), "Convergence": the published scheme over a
// grid of scenes at rising numbers P of substeps, with the exact solution beside it. The roof is
// rigid and moves horizontally only.
namespace glissade {

enum class HorizontalComponent { first, second };

/// A convergence study as its file tells it: checked, nothing read or run yet.
struct ConvergenceConfig {
  std::string name, description;
  std::filesystem::path file;        ///< the study file
  std::string source_text;           ///< the study file, verbatim
  std::filesystem::path suite_file;  ///< resolved against the study file's folder
  std::vector<std::string> records;  ///< ids of the suite's records to run; empty: all
  std::vector<double> slope_deg;     ///< strictly increasing, within +-89.9
  std::vector<double> mu;            ///< strictly increasing, >= 0
  std::vector<double> ppa_g;         ///< strictly increasing, >= 0: peak acceleration of the roof
  std::vector<int> substeps;         ///< P: two or more, strictly increasing, >= 1
  HorizontalComponent component = HorizontalComponent::first;
};

/// One point of the grid. Every record is scaled to the scene's peak acceleration.
struct ConvergenceScene {
  double slope_deg = 0.0, mu = 0.0, ppa_g = 0.0;
};

/// What would be run; one unit of work a record. Immutable once made.
struct ConvergencePlan {
  ConvergenceConfig config;
  Suite suite;                           ///< the records asked for, in the suite's order
  std::vector<ConvergenceScene> scenes;  ///< by (slope, mu, ppa), ppa fastest
  std::string hash;                      ///< of everything that decides the results

  std::uint64_t histories() const;  ///< of the published scheme: records x scenes x substeps
};

/// Throws InputError where study and suite do not fit: unknown record ids, no second component, a
/// record without any motion.
ConvergencePlan make_plan(const ConvergenceConfig& config, Suite suite);

/// A page of text: what the plan would run (for --dry-run).
std::string to_string(const ConvergencePlan& plan);

/// slide() of one scene, in plan.
struct ExactSlip {
  double residual_m = 0.0;  ///< signed, by slide()'s rule for the end of the record
  double peak_m = 0.0;      ///< max |displacement|
  std::uint8_t uplift = 0;  ///< 1: outside the model
};

/// Seconds of every history of a record.
struct HistoryTimes {
  std::vector<double> published_s;  ///< by (scene, substeps)
  std::vector<double> exact_s;      ///< slide(), by scene
  std::vector<double> kernel_s;     ///< peak_slip(), by scene; its table was there already
  double table_s = 0.0;             ///< making that table
};

/// What one record gave.
struct ConvergenceUnit {
  std::size_t record = 0;
  std::vector<double> residual_m;  ///< of the published scheme, by (scene, substeps)
  std::vector<ExactSlip> exact;    ///< by scene
  HistoryTimes times;              ///< all that another run would find otherwise
};

/// Seconds since an instant of its own: the clock stays with the caller.
using Stopwatch = std::function<double()>;

/// How often a history of so many substeps is run to be timed, the shortest time told; the exact
/// ones as often as those of one substep.
int timings(int substeps);

/// Runs one record. All but `times` is a free function of the plan and the record.
ConvergenceUnit execute(const ConvergencePlan& plan, std::size_t record, const Stopwatch& now);

struct ConvergenceRecord {
  std::string id, event, station;
  double dt_s = 0.0;
  std::uint64_t samples = 0;
  double pga_g = 0.0;  ///< of the component used, as recorded
};

/// Everything a convergence study found, and nothing about when, where or how fast.
struct ConvergenceResults {
  std::string study_name, study_description, program_version, plan_hash, study_text;
  std::string suite_name, suite_description;
  HorizontalComponent component = HorizontalComponent::first;
  std::vector<int> substeps;
  std::vector<ConvergenceScene> scenes;
  std::vector<ConvergenceRecord> records;
  Array3<double> residual_m;     ///< of the published scheme, by (record, scene, substeps)
  std::vector<ExactSlip> exact;  ///< by (record, scene), scene fastest

  const ExactSlip& exact_at(std::size_t record, std::size_t scene) const {
    return exact[record * scenes.size() + scene];
  }
};

/// Puts the units together in plan order. They may come in any order; each record must be there
/// once.
ConvergenceResults reduce(const ConvergencePlan& plan, const std::vector<ConvergenceUnit>& units);

// Messages between the ranks of one run.
std::vector<char> pack(const std::vector<ConvergenceUnit>& units);
std::vector<ConvergenceUnit> unpack_convergence_units(const std::vector<char>& bytes);

}  // namespace glissade
