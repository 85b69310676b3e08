// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/design/design_clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/design/of_project.hpp"
#include "glissade/fragility/share.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/study/analysis/exceeded_displacement.hpp"
#include "warnings.hpp"

namespace glissade {
namespace {

/// The inputs of a condition that a project varies.
struct Inputs {
  double friction = 0.0, slope_deg = 0.0, mass_ratio = 0.0, level = 0.0, period_s = 0.0,
         alpha = 0.0, damping = 0.0;
  VerticalChoice vertical = VerticalChoice::if_available;
};

Inputs inputs_of(const Results& results, const SuiteMean& mean) {
  const ConditionGrid grid(results);
  const Case& c = grid.case_at(mean.at);
  const double level = grid.value(ConditionAxis::level, mean.at);
  return {c.friction, c.slope_deg, c.mass_ratio, level, c.period_s, c.alpha, c.damping, c.vertical};
}

bool is_among(const std::vector<double>& values, double value) {
  return std::ranges::find(values, value) != values.end();
}

/// What a mean requires; of few records the largest of them.
double required_m(const Results& demand, const SuiteMean& mean) {
  return demand.clearance->factor *
         (demand.records.size() < least_records ? mean.largest : mean.range.highest);
}

/// One of the project's own conditions at S_DS: none that was added for the model uncertainty.
bool is_condition_of(const Project& project, const Results& demand, const Inputs& inputs,
                     double friction) {
  return inputs.friction == friction && inputs.level == demand.levels.front() &&
         is_among(project.slope_deg, inputs.slope_deg) &&
         is_among(project.building.mass_ratio, inputs.mass_ratio) &&
         is_among(project.building.period_s, inputs.period_s) &&
         (project.of_roof || inputs.damping == project.building.damping) &&
         (project.building.alpha.empty() || is_among(project.building.alpha, inputs.alpha));
}

/// The largest requirement.
const SuiteMean& governing_mean(const Project& project, const Results& demand, double friction) {
  const SuiteMean* governing = nullptr;
  for (const SuiteMean& mean : demand.clearance->by_period) {
    if (!is_condition_of(project, demand, inputs_of(demand, mean), friction)) continue;
    if (governing == nullptr || required_m(demand, mean) > required_m(demand, *governing))
      governing = &mean;
  }
  expect_of_project(governing != nullptr, "the conditions of the project");
  return *governing;
}

/// Under each record, all in the orientation with the largest mean.
struct WorstOrientation {
  std::string orientation;
  std::vector<double> by_record_m;
};

WorstOrientation worst_orientation(const Results& demand, const SuiteMean& mean) {
  const auto worst = static_cast<std::size_t>(std::ranges::max_element(mean.by_orientation) -
                                              mean.by_orientation.begin());
  WorstOrientation found{to_string(orientation_at(demand, worst)), {}};
  const ConditionGrid grid(demand);
  for (std::size_t record = 0; record < demand.records.size(); ++record)
    found.by_record_m.push_back(grid.history(record, worst, mean.at).displacement_m());
  return found;
}

PeriodDemand demand_at(const Results& demand, const SuiteMean& mean) {
  auto [orientation, by_record] = worst_orientation(demand, mean);
  std::ranges::sort(by_record);
  return {.period_s = inputs_of(demand, mean).period_s,
          .orientation = orientation,
          .mean_m = mean.range.highest,
          .p84_m = quantile_of(by_record, 0.84),
          .p95_m = quantile_of(by_record, 0.95),
          .largest_m = mean.largest,
          .median_orientation_m = mean.range.median};
}

/// By period, each number the largest of the project's conditions: slopes, mass ratios, with and
/// without vertical motion. The orientation is that of the largest mean.
std::vector<PeriodDemand> largest_demands(const Project& project, const Results& demand) {
  std::vector<PeriodDemand> found;
  for (const SuiteMean& mean : demand.clearance->by_period) {
    if (!is_condition_of(project, demand, inputs_of(demand, mean), project.friction.design()))
      continue;
    const PeriodDemand here = demand_at(demand, mean);
    const auto same = std::ranges::find(found, here.period_s, &PeriodDemand::period_s);
    if (same == found.end()) {
      found.push_back(here);
      continue;
    }
    if (here.mean_m > same->mean_m) same->orientation = here.orientation;
    for (double PeriodDemand::*number :
         {&PeriodDemand::mean_m, &PeriodDemand::p84_m, &PeriodDemand::p95_m,
          &PeriodDemand::largest_m, &PeriodDemand::median_orientation_m})
      (*same).*number = std::max((*same).*number, here.*number);
  }
  std::ranges::sort(found, {}, &PeriodDemand::period_s);
  return found;
}

/// What the project's conditions require with one input changed.
template <class T>
double required_with(T Inputs::*input, T value, const Project& project, const Results& results,
                     const Inputs& governing) {
  double most_m = -1.0;
  for (const SuiteMean& mean : results.clearance->by_period) {
    Inputs others = inputs_of(results, mean);
    if (others.*input != value) continue;
    others.*input = governing.*input;
    if (is_condition_of(project, results, others, project.friction.design()))
      most_m = std::max(most_m, required_m(results, mean));
  }
  expect_of_project(most_m >= 0.0, "the conditions with one input changed");
  return most_m;
}

}  // namespace

SeparationVerdict verdict_on(const ProjectSeparation& separation, const Project& project,
                             const DesignClearance& design) {
  using enum SeparationVerdict;
  if (!separation.available_m) return not_stated;
  if (*separation.available_m < separation.required.value_m) return insufficient;
  if (!of_standard(project, design).violated().empty()) return not_applicable;
  return std::ranges::any_of(design.warnings, &DesignWarning::is_open_item) ? open : sufficient;
}

SeparationVerdict verdict_on(const Project& project, const DesignClearance& design) {
  SeparationVerdict worst = of_standard(project, design).violated().empty()
                                ? SeparationVerdict::sufficient
                                : SeparationVerdict::not_applicable;
  for (const ProjectSeparation& s : design.separations)
    worst = std::min(worst, verdict_on(s, project, design));
  return worst;
}

double rounded_up(double value, double step) {
  GLISSADE_EXPECTS(step > 0.0);
  return step * std::ceil(value / step - 1e-9) + 0.0;  // no -0
}

DesignClearance design_clearance(const Project& project, const Results& demand,
                                 const Suite& suite) {
  expect_of_project(demand.clearance && demand.levels.size() == demand_levels &&
                        demand.suites.size() == 1 &&
                        (project.of_roof ? demand.suites.front().of_roof
                                         : !demand.suites.front().spectra.target_g.empty()),
                    "displacements of one suite, of the ground with a target, at DBE and MCE");
  const SuiteMean& governing = governing_mean(project, demand, project.friction.design());
  const Inputs inputs = inputs_of(demand, governing);

  DesignClearance design{.site = site_values(project.site)};
  design.slope_deg = inputs.slope_deg;
  design.mass_ratio = inputs.mass_ratio;
  design.vertical = inputs.vertical;
  design.period_s = inputs.period_s;
  design.alpha = inputs.alpha;
  WorstOrientation worst = worst_orientation(demand, governing);
  design.orientation = std::move(worst.orientation);
  design.by_record_m = std::move(worst.by_record_m);
  design.factor = demand.clearance->factor;
  design.of_largest = demand.records.size() < least_records;
  design.analysis_m = required_m(demand, governing);
  design.roof = roof_peaks(project, demand, suite);
  design.demand = largest_demands(project, demand);
  for (const PeriodDemand& d : design.demand)
    design.median_analysis_m =
        std::max(design.median_analysis_m, design.factor * d.median_orientation_m);

  design.prescribed = prescribed_values(project, design.site);
  for (const PrescribedValue& value : design.prescribed) {
    if (value.standard == project.standard && !project.peer_reviewed)
      design.floor_m = value.floor_share * value.prescribed.value_m;
  }
  design.governing_m = std::max(design.analysis_m, design.floor_m);
  design.floor_governs = design.floor_m > design.analysis_m;
  design.rounded_m = rounded_up(design.governing_m, project.round_up_m);
  std::vector<Separation> separations = separations_of(project.standard, design.governing_m);
  for (std::size_t i = 0; i < separations.size(); ++i) {
    separations[i].value_m = rounded_up(separations[i].value_m, project.round_up_m);
    const auto is_of_kind = [&](const ProjectGap& gap) { return gap.kind == i; };
    if (project.available_m[i] || std::ranges::none_of(project.gaps, is_of_kind))
      design.separations.push_back({separations[i], project.available_m[i], i});
    for (const ProjectGap& gap : project.gaps)
      if (is_of_kind(gap))
        design.separations.push_back({separations[i], gap.available_m, i, gap.name});
  }
  design.mce_analysis_m =
      required_with(&Inputs::level, demand.levels[at_mce], project, demand, inputs);
  for (const StudiedFriction& mu : frictions_of(project))
    if (mu.what == bound_name(project.friction))
      design.bound_analysis_m = required_m(demand, governing_mean(project, demand, mu.value));
  design.checks = checks_of(project, demand, design);
  design.warnings = warnings_on(project, demand, design);
  return design;
}

void add_model_uncertainty(const Project& project, const Results& demand,
                           const Results& uncertainty, DesignClearance& design) {
  expect_of_project(uncertainty.clearance && uncertainty.levels == std::vector{dbe_level(project)},
                    "displacements at both ends of friction and damping, at DBE");
  const Inputs governing =
      inputs_of(demand, governing_mean(project, demand, project.friction.design()));
  ModelUncertainty& found = design.uncertainty;
  const auto add = [&](const char* premise, const char* unit, const std::string& ends, double low,
                       double high, double low_m, double high_m) {
    found.effects.push_back({premise, unit, ends, low, high, {low_m, design.analysis_m, high_m}});
  };
  const auto vary = [&](const char* premise, const char* unit, const std::string& added,
                        std::size_t stated, double Inputs::*input,
                        const std::vector<double>& values, const Results& results) {
    if (values.size() < 2) return;
    const auto at = [&](double value) {
      return required_with(input, value, project, results, governing);
    };
    add(premise, unit, stated > 1 ? "range of the project" : added, values.front(), values.back(),
        at(values.front()), at(values.back()));
  };
  const ProjectBuilding& building = project.building;
  if (const auto ends = friction_ends(project)) {
    const auto at = [&](double mean) {
      const double design_mu = design_friction(Normal{mean, project.friction.std});
      return slides_freely_on(project, design_mu)
                 ? infinity
                 : required_with(&Inputs::friction, design_mu, project, uncertainty, governing);
    };
    add("friction, mean", "", ends->what, ends->low, ends->high, at(ends->low), at(ends->high));
  }
  vary("building damping", "", "half and twice", 1, &Inputs::damping, dampings_of(project),
       uncertainty);
  vary("building period", "s", "0.9 and 1.1 times", building.period_s.size(), &Inputs::period_s,
       periods_of(project), demand);
  vary("\u03b1_0 of the building", "", "", building.alpha.size(), &Inputs::alpha, building.alpha,
       demand);
  vary("mass ratio", "", "as stated, and more", building.mass_ratio.size(), &Inputs::mass_ratio,
       mass_ratios_of(project), demand);
  vary("roof slope", "degrees", "as stated, and 1 degree more", project.slope_deg.size(),
       &Inputs::slope_deg, slopes_of(project), demand);
  const auto with_vertical = [&](VerticalChoice use) {
    return required_with(&Inputs::vertical, use, project, demand, governing);
  };
  add("vertical motion", "", "without; with", nan, nan, with_vertical(VerticalChoice::none),
      with_vertical(VerticalChoice::if_available));
  if (!design.of_largest) {
    const auto [low, high] = positive_mean_interval(demand.histories.by_unit(design.by_record_m));
    add("records", "", fmt::format("95 % interval of {}", design.by_record_m.size()), nan, nan,
        design.factor * low, design.factor * high);
    found.effects.back().is_of_records = true;
  }
  sort_by_change(found.effects);
  found.not_varied = project.of_roof ? "the roof motions" : "the roof diaphragm";
  if (!project.of_roof && mass_ratios_of(project).size() < 2)
    found.not_varied += ", the mass ratio";
}

namespace {

/// Beyond the MCE, of which the demand study gives it.
void warn_of_uplift(const Project& project, const Results& probability, DesignClearance& design) {
  const HistoryTable& histories = probability.histories;
  if (histories.fields.uplift.empty()) return;
  for (std::size_t level = 0; level < probability.levels.size(); ++level) {
    const double intensity = probability.levels[level];
    if (intensity <= mce_over_dbe * dbe_level(project)) continue;
    const std::size_t lifted = records_with_uplift(probability, level).size();
    if (lifted == 0) continue;
    design.warnings.push_back({fmt::format(
        "from {} on the array lifts off under some records ({} of {} there), which is "
        "outside the model: probabilities and annual rates of stronger shaking are of an array "
        "without friction while lifted",
        project.of_roof ? fmt::format("a factor of {:.3g}", intensity)
                        : fmt::format("S_DS = {:.3g} g", intensity),
        lifted, probability.records.size())});
    return;
  }
}

/// At each building period.
std::vector<ExceedanceAt> exceedance_of(const Results& probability, double displacement_m,
                                        const std::string& name, double intensity) {
  const double& level = found_in(probability.levels, intensity, "the level of " + name);
  const auto at = static_cast<std::size_t>(&level - probability.levels.data());
  std::vector<ExceedanceAt> found;
  for (const RunResults& run : probability.runs) {
    const ThresholdFragility& threshold =
        found_in(run.fragilities, displacement_m, "the displacement that is compared",
                 &ThresholdFragility::threshold_m);
    const double share = threshold.probability[at];
    found.push_back(
        {name, level, probability.cases.cases[run.first_case].period_s, share,
         widened(threshold.probability_interval[at], share, effective_units(probability))});
  }
  return found;
}

/// Of equal ones that of the governing period.
const ExceedanceAt& largest_of(const std::vector<ExceedanceAt>& by_period, double governing_s) {
  return *std::ranges::max_element(by_period, {}, [&](const ExceedanceAt& e) {
    return std::pair(e.probability, e.period_s == governing_s);
  });
}

/// Nothing without a hazard curve.
std::optional<ThresholdRate> largest_rate(const Results& probability, double displacement_m) {
  std::optional<ThresholdRate> largest;
  if (!probability.hazard) return largest;
  for (const HazardRun& run : probability.hazard->runs) {
    const ThresholdRate& rate = found_in(run.thresholds, displacement_m,
                                         "the rate of a displacement", &ThresholdRate::threshold_m);
    if (!largest || rate.annual_rate.value > largest->annual_rate.value) largest = rate;
  }
  return largest;
}

/// What a clearance allows; 0 where none is stated, or more than a roof has.
double allowed_m(const Separation& separation, const std::optional<double>& available_m) {
  const double displacement_m = available_m.value_or(0.0) / separation.factor;
  return displacement_m > largest_probable_clearance_m ? 0.0 : displacement_m;
}

QuantileDisplacement accepted_displacement(const Project& project, const Results& probability) {
  const double dbe = dbe_level(project);
  if (project.of_roof) {
    const RunResults& run = probability.runs.front();
    const double& level = found_in(probability.levels, dbe, "the level of DBE");
    const ExceededDisplacement accepted = exceeded_displacement(
        probability, {run.first_case, run.cases},
        static_cast<std::size_t>(&level - probability.levels.data()), accepted_exceedance);
    return {accepted.value_m, accepted.interval};
  }
  expect_of_project(probability.verdict.has_value(), "a verdict");
  const VerdictRow& row =
      found_in(probability.verdict->rows, dbe, "a verdict at DBE", &VerdictRow::sds_g);
  expect_of_project(!row.displacement_m.empty(), "a displacement that is accepted");
  return {row.displacement_m.front(), row.displacement_interval.front()};
}

}  // namespace

std::vector<double> compared_displacements_m(const Project& project, double governing_m) {
  std::vector<double> all{governing_m};
  const std::vector<Separation> separations = separations_of(project.standard, governing_m);
  const auto add = [&](std::size_t kind, const std::optional<double>& available_m) {
    const double displacement_m = allowed_m(separations[kind], available_m);
    if (displacement_m > 0.0) all.push_back(displacement_m);
  };
  for (std::size_t i = 0; i < separations.size(); ++i) add(i, project.available_m[i]);
  for (const ProjectGap& gap : project.gaps) add(gap.kind, gap.available_m);
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

void add_exceedance(const Project& project, const Results& probability, DesignClearance& design) {
  expect_of_project(
      !probability.runs.empty() && (!probability.hazard || !probability.hazard->runs.empty()),
      "probabilities");
  warn_of_uplift(project, probability, design);
  const double dbe_intensity = dbe_level(project), mce_intensity = mce_over_dbe * dbe_intensity;
  const auto compare = [&](double displacement_m, std::optional<std::size_t> separation) {
    const auto at = [&](const char* name, double intensity) {
      return exceedance_of(probability, displacement_m, name, intensity);
    };
    const std::vector<ExceedanceAt> dbe = at("DBE", dbe_intensity), mce = at("MCE", mce_intensity);
    if (!separation)
      for (const auto& by_period : {dbe, mce})
        design.exceedance.insert(design.exceedance.end(), by_period.begin(), by_period.end());
    design.compared.push_back({separation, displacement_m, largest_of(dbe, design.period_s),
                               largest_of(mce, design.period_s),
                               largest_rate(probability, displacement_m)});
  };
  compare(design.governing_m, std::nullopt);
  for (std::size_t i = 0; i < design.separations.size(); ++i) {
    const ProjectSeparation& s = design.separations[i];
    if (const double displacement_m = allowed_m(s.required, s.available_m); displacement_m > 0.0)
      compare(displacement_m, i);
  }
  design.accepted = accepted_displacement(project, probability);
  const ExceedanceAt& at_dbe = design.compared.front().dbe;
  const bool is_rare = at_dbe.probability <= accepted_exceedance;
  design.checks.push_back(
      {"probability that the governing displacement is exceeded at the DBE",
       fmt::format("{:.3g} % (95 % interval {:.2g} to {:.2g} %)", 100.0 * at_dbe.probability,
                   100.0 * at_dbe.interval.low, 100.0 * at_dbe.interval.high) +
           (is_rare || !std::isfinite(design.accepted.displacement_m)
                ? ""
                : fmt::format("; {:g} % from {} on", 100.0 * accepted_exceedance,
                              both_units(design.accepted.displacement_m, project.units))),
       fmt::format("{:g} % or less (a limit of this program)", 100.0 * accepted_exceedance),
       is_rare});
  if (!is_rare) {
    design.warnings.push_back({not_met_text(design.checks.back()), true});
    design.warnings.push_back(
        {fmt::format("the governing displacement is exceeded with a probability of {:.3g} % at the "
                     "DBE and {:.3g} % at the MCE",
                     100.0 * at_dbe.probability, 100.0 * design.compared.front().mce.probability)});
  }
  for (const auto& [text, of_fitted_curves] : probability.warnings) {
    if (of_fitted_curves) continue;  // none is used
    if (std::ranges::find(design.warnings, text, &DesignWarning::text) == design.warnings.end())
      design.warnings.push_back({text});
  }
}

}  // namespace glissade
