// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <tuple>

#include "analysis/hazard/hazard.hpp"
#include "glissade/core/units.hpp"
#include "glissade/design/of_project.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/report/format.hpp"
#include "package/units.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

std::string or_blank(const std::string& text) {
  return text.empty() ? "____________________" : text;
}

std::string target_text(const Project& project) {
  const DesignTarget& target = project.site.target;
  if (!target.period_s.empty())
    return fmt::format("{}, spectrum of {} points, {}{}", edition_name(target.edition),
                       target.period_s.size(), project.spectrum_file,
                       project.site.mapped ? "; beside it " + to_string(*project.site.mapped) : "");
  if (target.sds_g > 0.0)
    return fmt::format("{}, S_DS {:.3f} g and S_D1 {:.3f} g as given", edition_name(target.edition),
                       target.sds_g, target.sd1_g);
  std::string classes;
  for (const SiteClass site : target.site_classes)
    classes += (classes.empty() ? "" : ", ") + to_string(site);
  return fmt::format("{}, S_S {:.3f} g, S_1 {:.3f} g, site class {}{}",
                     edition_name(target.edition), target.ss_g, target.s1_g, classes,
                     target.site_classes.size() > 1 ? " (the largest)" : "");
}

/// "12.7 in (1.06 ft)", or "0.322 m".
std::string prescribed_separation(double length_m) {
  return in_inches() ? fmt::format("{} ({})", length_in(length_m), separation_in(length_m))
                     : length_in(length_m);
}

/// "2.5 % [0 %, 44 %]"
std::string share_text(const ExceedanceAt& e) {
  return fmt::format("{} [{}, {}]", format_share(e.probability), format_share(e.interval.low),
                     format_share(e.interval.high));
}

}  // namespace

std::vector<std::string> warnings_of(const CalculationPackage& package) {
  std::vector<std::string> warnings = package.design.warnings;
  if (package.files.empty()) warnings.insert(warnings.begin(), simulated_motions_warning);
  std::ranges::stable_partition(
      warnings, [](const std::string& warning) { return warning.starts_with("NOT FOR DESIGN"); });
  for (std::string& warning : warnings) {  // a sentence, but for the name of a key
    const std::string first = warning.substr(0, warning.find(' '));
    if (first.find_first_of("._") == std::string::npos)
      warning[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(warning[0])));
  }
  return warnings;
}

std::vector<std::string> shown_warnings(const CalculationPackage& package) {
  std::vector<std::string> shown = warnings_of(package);
  for (const std::string& reservation : reservations_on(package.project, package.design))
    std::erase_if(shown, [&](const std::string& warning) {  // but for its first letter
      return warning.substr(1) == reservation.substr(1);
    });
  return shown;
}

std::string range_text(const std::vector<double>& values, const char* unit) {
  if (values.size() == 1) return fmt::format("{:.3g}{}", values.front(), unit);
  return fmt::format("{:.3g} to {:.3g}{}", values.front(), values.back(), unit);
}

std::string governed_by(const CalculationPackage& package) {
  if (!package.design.floor_governs) return "nonlinear response history analysis";
  const auto& prescribed = package.design.prescribed;
  const auto value =
      std::ranges::find(prescribed, package.project.standard, &PrescribedValue::standard);
  return fmt::format("{}: {:.0f} % of the prescribed value", standard_name(value->standard),
                     100.0 * value->floor_share);
}

std::string hazard_sentence(const CalculationPackage& package) {
  if (package.project.of_roof)
    return "Annual rates are not computed: the motions are of the roof, and a hazard curve is of "
           "the ground.";
  if (!package.probability.hazard)
    return "Annual rates and the displacement that adds up over the design life are not computed: "
           "give [hazard] in the project file (curve, or k0 and k; design_life_years).";
  const HazardResults& hazard = *package.probability.hazard;
  const ThresholdRate& governing = package.design.compared.front().rate.value();
  const auto largest_of = [&](LifeQuantity quantity) -> const LifeDisplacement& {
    const auto life = [&](const HazardRun& r) -> const LifeDisplacement& {
      return found_in(r.life, quantity, "a design life", &LifeDisplacement::quantity);
    };
    return life(*std::ranges::max_element(hazard.runs, {},
                                          [&](const HazardRun& r) { return life(r).p95_m.value; }));
  };
  const LifeDisplacement &sum = largest_of(LifeQuantity::accumulated),
                         &farthest = largest_of(LifeQuantity::farthest);
  const auto length = [](double length_m) {
    return std::isfinite(length_m) ? length_in_both(length_m) : "beyond the levels of the study";
  };
  const std::string exceeded = fmt::format(
      "With the hazard curve {}, at the period with the largest rate: the governing displacement "
      "is exceeded {} once in {} years, in 50 years with a probability of {}. Over {}, {}, at the "
      "period at which it is largest: ",
      curve_name(hazard), governing.is_mostly_assumed() ? "at most" : "about",
      format_number(rounded_to(1.0 / governing.annual_rate.value, 2)),
      format_share(probability_in(50.0, governing.annual_rate.value)), life_text(hazard),
      not_returned);
  if (farthest.p95_m.value == 0.0) return exceeded + "it does not slide in 95 % of such spans.";
  return exceeded + fmt::format(
                        "displacement that adds up, median {}, 95th percentile {}; largest "
                        "distance from the initial position at any time, 95th percentile {}.",
                        length(sum.median_m.value), length(sum.p95_m.value),
                        length(farthest.p95_m.value));
}

std::string verdict_sentence(const CalculationPackage& package) {
  std::string lacking;
  std::size_t known = 0;
  for (const ProjectSeparation& s : package.design.separations) {
    if (!s.available_m) continue;
    ++known;
    if (*s.available_m < s.required.value_m)
      lacking += fmt::format("{}{} ({} short)", lacking.empty() ? "" : ", ", s.required.what,
                             length_in(s.required.value_m - *s.available_m));
  }
  if (known == 0) return "Available clearances are not stated.";
  if (!lacking.empty()) return "Available clearances are NOT SUFFICIENT " + lacking + ".";
  return reservations_on(package.project, package.design).empty()
             ? "The available clearances are sufficient."
             : "The available clearances are sufficient, with the reservations below.";
}

Table title_table(const Project& project) {
  Table table{"title", "Project", {text_column("item", ""), text_column("value", "")}, {}};
  table.add({std::string("Project"), or_blank(project.title.name)});
  table.add({std::string("Address"), or_blank(project.title.address)});
  table.add({std::string("Engineer"), or_blank(project.title.engineer)});
  table.add({std::string("Date"), or_blank(project.title.date)});
  table.add({std::string("Signature"), or_blank("")});
  table.add({std::string("Checked by"), or_blank("")});
  return table;
}

Table inputs_table(const CalculationPackage& package) {
  const Project& p = package.project;
  Table table{"inputs",
              "Inputs and their sources",
              {text_column("input", "Input"), text_column("value", "Value"),
               text_column("source", "Source")},
              {}};
  const auto add = [&](const std::string& input, const std::string& value,
                       const std::string& source) {
    table.add({input, value, source});
  };
  add("Site", target_text(p), "project file, [site]");
  add("Risk category", to_string(p.site.risk),
      fmt::format("project file; importance factor {:g}", p.importance));
  if (p.of_roof)
    add("Building", "none is computed: the motions are those of its roof", "suite file");
  else
    add("Building period", range_text(p.building.period_s, " s"), p.building.period_basis);
  if (p.building.storeys) add("Storeys", fmt::format("{:g}", *p.building.storeys), "project file");
  if (!p.of_roof)
    add("Model of the building",
        p.building.alpha.empty() ? "one mass on one spring"
                                 : "modes of a uniform cantilever of flexure and shear, alpha " +
                                       range_text(p.building.alpha, ""),
        p.building.model_basis);
  if (!p.of_roof) {
    add("Damping of the building", fmt::format("{:g} %", 100.0 * p.building.damping),
        "project file");
    add("Mass of array over building", range_text(p.building.mass_ratio, ""),
        p.building.mass_basis);
  }
  std::vector<double> rises;
  for (const double slope_deg : p.slope_deg)
    rises.push_back(12.0 * std::tan(slope_deg * rad_per_deg));
  add("Roof slope",
      fmt::format("{} (rise in 12: {})", range_text(p.slope_deg, " degrees"),
                  range_text(rises, "")),
      "project file");
  add("Coefficient of friction, mean", fmt::format("{:.3f}", p.friction.mean), p.friction.source);
  add("its standard deviation", fmt::format("{:.3f}", p.friction.std), "as the mean");
  add("its design value", fmt::format("{:.3f}", p.friction.design()),
      "mean - 2 std (Walters et al. 2012)");
  for (const DirectionFriction& d : p.friction.tested)
    add(d.direction == p.friction.direction ? "Pull tests, taken" : "Pull tests",
        fmt::format("{}: mean {:.3f}, std {:.3f}, mean - 2 std {:.3f}", d.direction, d.sliding.mean,
                    d.sliding.std, d.sliding.mean_minus_2_std),
        fmt::format("each test, as in the file: {:.3f}", fmt::join(d.sliding_mu, ", ")));
  if (p.friction.lower_bound)
    add(bound_name(p.friction), fmt::format("{:.3f}", *p.friction.lower_bound),
        "with 95 % confidence, 97.7 % of pulls have more (normal friction, this number of tests)");
  add(p.of_roof ? "Motions of the roof" : "Ground motions",
      fmt::format("{}, {} records", package.demand.suites.front().name,
                  package.demand.records.size()),
      p.suite.filename().string());
  if (p.of_roof)
    add("Factor on them at DBE", fmt::format("{:g}", p.roof_factor), "project file, or 1");
  return table;
}

Table site_table(const CalculationPackage& package) {
  const SiteValues& site = package.design.site;
  Table table{"site",
              "Design spectral accelerations",
              {text_column("quantity", "Quantity"), text_column("value", "Value"),
               text_column("basis", "Basis")},
              {}};
  const auto add = [&](const char* quantity, const std::string& value, const std::string& basis) {
    table.add({std::string(quantity), value, basis});
  };
  const DesignTarget& target = package.project.site.target;
  if (site.fa > 0.0) {
    const std::string edition = edition_name(target.edition);
    const bool is_default = target.site_classes == std::vector{SiteClass::unknown};
    add("F_a", fmt::format("{:.3f}", site.fa),
        edition + ", table 11.4-1" +
            (!is_default                               ? ""
             : target.edition == AsceEdition::asce7_16 ? ", class D, and 1.2 or more"
                                                       : ", class D"));
    add("F_v", fmt::format("{:.3f}", site.fv),
        edition + ", table 11.4-2" + (is_default ? ", class D" : ""));
  }
  const bool points = !target.period_s.empty();
  add("S_MS", fmt::format("{:.3f} g", site.sms_g()), target.is_mapped() ? "F_a S_S" : "1.5 S_DS");
  add("S_M1", fmt::format("{:.3f} g", site.sm1_g()), target.is_mapped() ? "F_v S_1" : "1.5 S_D1");
  add("S_DS", fmt::format("{:.3f} g", site.sds_g),
      points               ? "90 % of the largest of the spectrum, 0.2 to 5 s (21.4, recalled)"
      : target.is_mapped() ? "2/3 S_MS"
                           : "as given");
  add("S_D1", fmt::format("{:.3f} g", site.sd1_g),
      points               ? "largest S_a T of its points, 1 to 5 s (21.4, recalled)"
      : target.is_mapped() ? "2/3 S_M1"
                           : "as given");
  if (!points && !package.project.of_roof)
    add("T_L", fmt::format("{:g} s", target.tl_s),
        package.project.site.states_tl ? "project file" : "NOT STATED: assumed");
  add("Seismic design category",
      category_text(package.project.site, site) +
          (target.is_mapped() || package.project.site.mapped ? "" : " (S_1 is not stated)"),
      edition_name(target.edition) + ", tables 11.6-1 and 11.6-2 (recalled)");
  return table;
}

Table spectrum_table(const Project& project) {
  const DesignTarget& target = project.site.target;
  Table table{"spectrum",
              fmt::format("Target spectrum as given, {} (SHA-256 {})", project.spectrum_file,
                          project.spectrum_sha256),
              {text_column("period", "Period, s"), text_column("design", "Design S_a, g"),
               text_column("mce", "MCE_R S_a, g")},
              {}};
  for (std::size_t i = 0; i < target.period_s.size(); ++i)
    table.add({fmt::format("{:g}", target.period_s[i]),
               fmt::format("{:.4g}", target.design_sa_g[i]),
               fmt::format("{:.4g}", mce_over_dbe * target.design_sa_g[i])});
  return table;
}

Table hazard_curve_table(const ProjectHazard& hazard) {
  Table table{"hazard_curve",
              fmt::format("Hazard curve of the site as given, {} (SHA-256 {})", hazard.curve,
                          hazard.sha256),
              {text_column("sds", "S_DS, g"), text_column("rate", "Annual rate")},
              {}};
  for (const HazardPoint& point : hazard.points)
    table.add({fmt::format("{:.4g}", point.intensity), fmt::format("{:.4g}", point.annual_rate)});
  return table;
}

Table demand_table(const CalculationPackage& package) {
  Table table{
      "demand",
      fmt::format("Displacement demand at DBE, friction {:.3g}: the largest over the roof's "
                  "slopes,{} with and without vertical motion, over {} records",
                  package.project.friction.design(), package.project.of_roof ? "" : " mass ratios,",
                  package.demand.records.size()),
      {text_column("period", "Period"), text_column("mean", "Mean"),
       text_column("p84", "84th percentile"), text_column("p95", "95th percentile"),
       text_column("largest", "Largest record, any orientation"),
       text_column("median", "Mean, median orientation"),
       text_column("orientation", "Governing orientation")},
      {}};
  for (const PeriodDemand& d : package.design.demand) {
    table.add({fmt::format("{:.3g} s", d.period_s), length_in(d.mean_m), length_in(d.p84_m),
               length_in(d.p95_m), length_in(d.largest_m), length_in(d.median_orientation_m),
               d.orientation});
  }
  table.notes.push_back(std::string("Mean and percentiles: over the records, all in the governing "
                                    "orientation; that of the mean is in the last column. ") +
                        percentile_note);
  return package.project.of_roof ? table.without("period") : table;
}

Table prescribed_table(const CalculationPackage& package) {
  Table table{"prescribed",
              "Prescribed displacements, and the least value of an analysis",
              {text_column("standard", "Standard"), text_column("value", "Prescribed"),
               text_column("conditions", "Conditions of its use"),
               text_column("floor", "Least of an analysis"), text_column("basis", "Basis")},
              {}};
  for (const PrescribedValue& value : package.design.prescribed) {
    const std::string not_met = value.not_met();
    table.add({standard_name(value.standard) +
                   (value.standard == package.project.standard ? " (of the project)" : ""),
               length_in_both(value.prescribed.value_m),
               not_met.empty() ? "met" : "NOT MET or not stated: " + not_met,
               length_in(value.floor_share * value.prescribed.value_m) + ", " + value.floor_basis +
                   " (recalled)",
               value.prescribed.basis});
    table.notes.push_back(analysis_provision(value.standard) + ".");
  }
  return table;
}

Table separations_table(const CalculationPackage& package) {
  const Prescription& prescribed = of_standard(package.project, package.design).prescribed;
  Table table{
      "separations",
      fmt::format(
          "Required separations: each a factor on the governing displacement, {}, rounded up",
          length_in_both(package.design.governing_m)),
      {text_column("separation", "Separation"), text_column("factor", "Factor"),
       text_column("required", "Required"), text_column("required_ft", "In feet"),
       text_column("prescribed", fmt::format("By the full prescribed value, {}, {}",
                                             standard_name(package.project.standard),
                                             length_in(prescribed.value_m))),
       text_column("available", "Available"), text_column("verdict", "Verdict")},
      {}};
  const Standard standard = package.project.standard;
  const std::vector<Separation> of_prescribed = separations_of(standard, prescribed.value_m);
  const std::vector<std::string> reservations = reservations_on(package.project, package.design);
  std::size_t row = 0;
  for (const ProjectSeparation& s : package.design.separations) {
    const bool known = s.available_m.has_value();
    table.add({s.required.what, fmt::format("{:.1f}", s.required.factor),
               length_in_both(s.required.value_m),
               fmt::format("{:.2f}", rounded_up(s.required.value_m / foot_m, 0.01)),
               prescribed_separation(of_prescribed.at(row++).value_m),
               known ? length_in_both(*s.available_m) : "not stated",
               std::string(!known ? "-"
                           : *s.available_m < s.required.value_m
                               ? "NOT SUFFICIENT: " +
                                     length_in(s.required.value_m - *s.available_m) + " short"
                           : reservations.empty() ? "sufficient"
                                                  : "sufficient, with reservation")});
  }
  for (const std::string& reservation : reservations)
    table.notes.push_back("Reservation: " + reservation + ".");
  for (const Separation& s : of_prescribed) {
    if (!s.basis.empty())
      table.notes.push_back(fmt::format("{}: {:g} times the displacement; {}.", capitalised(s.what),
                                        s.factor, s.basis));
  }
  table.notes.push_back(qualifying_parapet(standard) + ".");
  return in_inches() ? table : table.without("required_ft");
}

Table sensitivity_table(const CalculationPackage& package) {
  Table table{"sensitivity",
              "Sensitivity: the required displacement of the analysis with one input changed, the "
              "largest over all else that the project states",
              {text_column("input", "Input"), text_column("value", "Value"),
               text_column("displacement", "Required displacement"),
               text_column("ratio", "Ratio to the governing case")},
              {}};
  for (const Sensitivity& row : package.design.sensitivity) {
    table.add({row.what, row.value + (row.is_governing ? " *" : ""),
               length_in_both(row.clearance_m),
               fmt::format("{:.2f}", row.clearance_m / package.design.analysis_m)});
  }
  table.notes.push_back("*: as in the governing case.");
  const ProjectFriction& mu = package.project.friction;
  const auto has_bound = [&](const StudiedFriction& f) { return f.value == mu.lower_bound; };
  if (mu.lower_bound && *mu.lower_bound < mu.design() &&
      std::ranges::none_of(frictions_of(package.project), has_bound))
    table.notes.push_back(
        fmt::format("With the friction that the tests support with 95 % confidence, {:.3f}, the "
                    "array slides without an earthquake on the steepest slope: no displacement.",
                    *mu.lower_bound));
  return table;
}

Table exceedance_table(const CalculationPackage& package) {
  const Project& project = package.project;
  const double dbe = dbe_level(project), mce = mce_over_dbe * dbe;
  const auto at = [&](const char* level, const char* name, double intensity) {
    return project.of_roof ? fmt::format("At {}, factor {:g} [95 %]", level, intensity)
                           : fmt::format("At {}, {} = {:.3f} g [95 %]", level, name, intensity);
  };
  Table table{"exceedance",
              fmt::format("Probability that the displacement exceeds the governing one, {}",
                          length_in_both(package.design.governing_m)),
              {text_column("period", "Building period"), text_column("dbe", at("DBE", "S_DS", dbe)),
               text_column("mce", at("MCE", "S_MS", mce))},
              {}};
  const std::vector<ExceedanceAt>& dbe_then_mce = package.design.exceedance;
  const std::size_t periods = dbe_then_mce.size() / 2;
  for (std::size_t p = 0; p < periods; ++p)
    table.add({fmt::format("{:.3g} s", dbe_then_mce[p].period_s), share_text(dbe_then_mce[p]),
               share_text(dbe_then_mce[periods + p])});
  table.notes.push_back(fmt::format(
      "The probability is the observed share of the histories, without a fitted curve. {} drawn "
      "within the project's ranges, and the orientation; the slope is the "
      "steepest: {} samples for each of {} records. The interval is from resampling whole records; "
      "it is never narrower than that of a binomial with one trial for each record.",
      project.of_roof ? "Friction is" : "Friction and mass ratio are",
      package.probability.cases.samples, package.probability.records.size()));
  return project.of_roof ? table.without("period") : table;
}

std::string accepted_sentence(const DesignClearance& design) {
  const auto length = [](double length_m) {
    return std::isfinite(length_m) ? length_in(length_m) : std::string("any displacement");
  };
  return fmt::format("{:g} % of the histories at the DBE exceed {} (95 % interval {} to {})",
                     100.0 * accepted_exceedance, length(design.accepted.displacement_m),
                     length(design.accepted.interval.low), length(design.accepted.interval.high));
}

Table compared_table(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  Table table{"compared",
              "Probability that each available clearance is not sufficient",
              {text_column("displacement", "Displacement"), text_column("dbe", "At DBE [95 %]"),
               text_column("mce", "At MCE [95 %]")},
              {}};
  const bool has_rate = design.compared.front().rate.has_value();
  if (has_rate) {
    table.columns.push_back(
        {"annual_rate", "per_year", "Annual rate [95 %]", ColumnKind::rate, "", true});
    table.columns.push_back({"life_probability", "",
                             "In " + life_text(*package.probability.hazard) + " [95 %]",
                             ColumnKind::share, "", true});
  }
  for (const DisplacementExceedance& row : design.compared) {
    std::string what = "governing: " + length_in(row.displacement_m);
    if (row.separation) {
      const ProjectSeparation& separation = design.separations[*row.separation];
      what = fmt::format("{}: {} / {:g} = {}", separation.required.what,
                         length_in(*separation.available_m), separation.required.factor,
                         length_in(row.displacement_m));
    }
    std::vector<Cell> cells{what, share_text(row.dbe), share_text(row.mce)};
    if (has_rate) {
      const char* sign = sign_of(*row.rate);
      cells.emplace_back(SignedEstimate{row.rate->annual_rate, sign});
      cells.emplace_back(SignedEstimate{row.rate->life_probability, sign});
    }
    table.add(std::move(cells));
  }
  table.notes.push_back(
      "A clearance allows the displacement clearance / factor; between "
      "similar arrays only where both slide alike. " +
      std::string(package.project.of_roof
                      ? ""
                      : "Each number is that of the building period where it is largest. ") +
      accepted_sentence(design) + ".");
  return table;
}

Table roof_accelerations_table(const CalculationPackage& package) {
  Table table{"roof_accelerations",
              "Peak acceleration of the roof at DBE, computed and by the standards",
              {text_column("period", "Building period"), text_column("alpha", "alpha"),
               text_column("median", "Median, g"), text_column("p84", "84th percentile, g"),
               text_column("asce7_16", "ASCE 7-16, 13.3-1, g"),
               text_column("asce7_22", "ASCE 7-22, H_f, g"),
               text_column("ratio", "Median over the larger")},
              {}};
  const auto& [of_roof, building] = std::tie(package.project.of_roof, package.project.building);
  for (const RoofPeak& roof : package.design.roof)
    table.add({fmt::format("{:.3g} s", roof.period_s), fmt::format("{:.3g}", roof.alpha),
               fmt::format("{:.3f}", roof.median_g), fmt::format("{:.3f}", roof.p84_g),
               fmt::format("{:.3f}", roof.asce7_16_g),
               roof.asce7_22_g ? fmt::format("{:.3f}", *roof.asce7_22_g) : std::string("-"),
               fmt::format("{:.2f}", roof.over_standards())});
  table.notes.push_back(fmt::format(
      "Computed: over {} records, of each the geometric mean of both horizontal axes{}. ASCE 7-16: "
      "0.4 S_DS (1 + 2 z/h) with z/h = 1.",
      package.demand.records.size(), of_roof ? "" : ", without the array"));
  if (of_roof) return table.without("period").without("alpha").without("asce7_22");
  table.notes.push_back(
      "ASCE 7-22: 0.4 S_DS H_f, H_f = 1 + a_1 + a_2, a_1 = 1/T, 2.5 at most, a_2 = 1 - (0.4 "
      "s/T)^2, "
      "0 at least; T, the building period, for T_a.");
  return building.alpha.empty() ? table.without("alpha") : table;
}

Table checks_table(const CalculationPackage& package) {
  Table table{"checks",
              "Checks of this calculation",
              {text_column("check", "Check"), text_column("found", "Found"),
               text_column("criterion", "Criterion"), text_column("verdict", "Verdict")},
              {}};
  for (const DesignCheck& check : package.design.checks)
    table.add(
        {check.what, check.found, check.criterion, std::string(check.is_met ? "met" : "NOT MET")});
  return table;
}

}  // namespace glissade
