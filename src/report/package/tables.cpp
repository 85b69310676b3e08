// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <tuple>

#include "analysis/hazard/hazard.hpp"
#include "analysis/model_uncertainty/model_uncertainty.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/units.hpp"
#include "glissade/design/of_project.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/report/format.hpp"
#include "package/print/print_head.hpp"
#include "package/units.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

constexpr const char* approval_sentence =
    "Outside its conditions an unanchored array requires the approval of the authority.";

/// Of a required separation, rounded up: "1.38".
NumberCell required_ft(double length_m) { return fixed(rounded_up(length_m / foot_m, 0.01), 2); }

/// "12.7 in (1.06 ft)", or "0.322 m".
NumberCell with_feet(double length_m, const NumberCell& feet) {
  NumberCell length = length_cell(length_m);
  if (in_inches()) length.beside = " (" + text_of(feet) + " ft)";
  return length;
}

Cell cell_of(const ExceedanceAt& e) { return NumberCell{{e.probability, e.interval}}; }

/// Of probabilities with their intervals.
Column share_column(const char* stem, const std::string& heading) {
  return {stem, "", heading + " [95 %]", ColumnKind::share, "", true};
}

std::vector<std::string> warnings_that(bool are_open_items, const DesignClearance& design) {
  std::vector<DesignWarning> found = design.warnings;
  std::erase_if(found, [&](const DesignWarning& w) { return w.is_open_item != are_open_items; });
  return capitalised(texts_of(found));
}

}  // namespace

std::vector<std::string> warnings_of(const DesignClearance& design) {
  return capitalised(texts_of(design.warnings));
}

std::vector<std::string> open_items(const DesignClearance& design) {
  return warnings_that(true, design);
}

std::vector<std::string> other_warnings(const DesignClearance& design) {
  return warnings_that(false, design);
}

const char* to_string(SeparationVerdict verdict) {
  switch (verdict) {
    case SeparationVerdict::insufficient:
      return "not sufficient";
    case SeparationVerdict::not_applicable:
      return "not applicable";
    case SeparationVerdict::open:
      return "open";
    case SeparationVerdict::sufficient:
      return "sufficient";
    case SeparationVerdict::not_stated:
      return "not stated";
  }
  return "";
}

std::string verdict_text(const ProjectSeparation& separation, const CalculationPackage& package) {
  const SeparationVerdict verdict = verdict_on(separation, package.project, package.design);
  if (verdict != SeparationVerdict::insufficient) return to_string(verdict);
  return "NOT SUFFICIENT: " + length_in(separation.required.value_m - *separation.available_m) +
         " short";
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
  std::vector<std::string> lacking, not_stated;
  for (const ProjectSeparation& s : package.design.separations) {
    const SeparationVerdict verdict = verdict_on(s, package.project, package.design);
    if (verdict == SeparationVerdict::insufficient)
      lacking.push_back(
          fmt::format("{} ({} short)", s.text(), length_in(s.required.value_m - *s.available_m)));
    if (verdict == SeparationVerdict::not_stated) not_stated.push_back(s.text());
  }
  const std::string others = not_stated.empty() ? ""
                                                : fmt::format(" Not stated: what is available {}.",
                                                              fmt::join(not_stated, ", "));
  const std::string violated = of_standard(package.project, package.design).violated(),
                    not_applicable = "NOT APPLICABLE: " + violated + ". " + approval_sentence;
  switch (verdict_on(package.project, package.design)) {
    case SeparationVerdict::insufficient:
      return fmt::format("Available separations are NOT SUFFICIENT {}.", fmt::join(lacking, ", ")) +
             others + (violated.empty() ? "" : " " + not_applicable);
    case SeparationVerdict::not_applicable:
      return not_applicable + others;
    case SeparationVerdict::open:
      return "OPEN: no available separation is below the required one, but there are open items." +
             others;
    case SeparationVerdict::not_stated:
      return not_stated.size() == package.design.separations.size()
                 ? "Available separations are not stated."
                 : "The available separations that are stated are sufficient." + others;
    case SeparationVerdict::sufficient:
      return "The available separations are sufficient.";
  }
  return "";
}

Table open_items_table(const CalculationPackage& package) {
  Table table{"open_items",
              "Open items: before they are settled no separation is sufficient",
              {text_column("item", "Open item")},
              {}};
  for (std::string& item : open_items(package.design)) table.add({std::move(item)});
  return table;
}

const char* varied_of_building(const Project& project) {
  return project.building.alpha.empty() ? "mass ratio" : "\u03b1_0";
}

Table demand_table(const CalculationPackage& package) {
  Table table{
      "demand",
      fmt::format(
          "Displacement demand at DBE, friction {:.3g}: the largest over "
          "slope,{} with and without vertical motion, over {}",
          package.project.friction.design(),
          package.project.of_roof ? "" : fmt::format(" {},", varied_of_building(package.project)),
          counted_records(package.demand)),
      {text_column("period", "Period"), text_column("mean", "Mean"),
       text_column("p84", "84th percentile"), text_column("p95", "95th percentile"),
       text_column("largest", "Largest record, any orientation"),
       text_column("median", "Mean, median orientation"),
       text_column("orientation", "Governing orientation")},
      {}};
  for (const PeriodDemand& d : package.design.demand) {
    table.add({significant(d.period_s, 3, "s"), length_cell(d.mean_m), length_cell(d.p84_m),
               length_cell(d.p95_m), length_cell(d.largest_m), length_cell(d.median_orientation_m),
               d.orientation});
  }
  table.notes.push_back(std::string("Mean and percentiles: over the records, all in the governing "
                                    "orientation; that of the mean is in the last column. ") +
                        percentile_note);
  table.add_note(open_percentile(package.demand));
  return package.project.of_roof ? table.without("period") : table;
}

Table record_displacements_table(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  Table table{"record_displacements",
              "Displacement under each record in the governing case, at DBE",
              {{"number", "", "No.", ColumnKind::count},
               text_column("id", "Record"),
               text_column("factor", "Factor to DBE"),
               text_column("displacement", in_inches() ? "Displacement, in" : "Displacement, m")},
              {}};
  const auto length = [](double length_m) {
    return in_inches() ? fixed(length_m / inch_m, 2) : fixed(length_m, 4);
  };
  double sum_m = 0.0;
  for (std::size_t i = 0; i < design.by_record_m.size(); ++i) {
    const RecordSummary& r = package.demand.records[i];
    table.add({static_cast<double>(i + 1), r.id,
               fixed(r.factor_at_unit_level * dbe_level(package.project), 3),
               length(design.by_record_m[i])});
    sum_m += design.by_record_m[i];
  }
  const auto count = design.by_record_m.size();
  const double mean_m = sum_m / static_cast<double>(count);
  const auto add = [&](const std::string& what, double value_m) {
    table.add({std::string(), what, std::string(), length(value_m)});
  };
  add("Sum", sum_m);
  add(fmt::format("Mean, sum / {}", count), mean_m);
  if (design.of_largest)
    add(fmt::format("{:g} \u00d7 the largest, any orientation", design.factor), design.analysis_m);
  else
    add(fmt::format("{:g} \u00d7 mean", design.factor), design.analysis_m);
  table.notes.push_back(fmt::format(
      "Governing case: {}slope {:.3g} degrees, friction {:.3f}, {} vertical motion, orientation "
      "{}.",
      package.project.of_roof ? ""
      : package.project.building.alpha.empty()
          ? fmt::format("building period {:.3g} s, mass ratio {:.3g}, ", design.period_s,
                        design.mass_ratio)
          : fmt::format("building period {:.3g} s, \u03b1_0 {:.3g}, ", design.period_s,
                        design.alpha),
      design.slope_deg, package.project.friction.design(),
      design.vertical == VerticalChoice::none ? "without" : "with", design.orientation));
  return table;
}

Table by_hand_table(const CalculationPackage& package) {
  const Project& project = package.project;
  const PrescribedValue& standard = of_standard(project, package.design);
  Table table{
      "by_hand",
      fmt::format("Separations by the prescribed displacement, {}, beside those required here",
                  length_in_both(standard.prescribed.value_m)),
      {text_column("separation", "Separation"), text_column("factor", "Factor"),
       text_column("prescribed", "Prescribed"), text_column("required", "Required here"),
       text_column("ratio", "Ratio")},
      {}};
  const std::vector<Separation> prescribed =
      separations_of(project.standard, standard.prescribed.value_m);
  for (std::size_t i = 0; i < prescribed.size(); ++i) {
    const double required_m =
        std::ranges::find(package.design.separations, i, &ProjectSeparation::kind)
            ->required.value_m;
    table.add({prescribed[i].what, fixed(prescribed[i].factor, 1),
               with_feet(prescribed[i].value_m, fixed(prescribed[i].value_m / foot_m, 2)),
               with_feet(required_m, required_ft(required_m)),
               fixed(required_m / prescribed[i].value_m, 2)});
  }
  return table;
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
               length_cell_in_both(value.prescribed.value_m),
               not_met.empty() ? "met" : "NOT MET or not stated: " + not_met,
               length_in(value.floor_share * value.prescribed.value_m) + ", " + value.floor_basis,
               value.prescribed.basis});
  }
  return table;
}

std::string separation_letter(std::size_t row) {
  constexpr std::size_t letters = 26;
  const std::string letter(1, static_cast<char>('A' + row % letters));
  return row < letters ? letter : letter + std::to_string(row / letters);
}

Table separations_table(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  Table table{
      "separations",
      fmt::format("Required separations: each a factor on the governing displacement, {}, rounded "
                  "up to {}",
                  length_in_both(design.governing_m, 1), length_in(package.project.round_up_m)),
      {text_column("letter", ""), text_column("separation", "Separation"),
       text_column("factor", "Factor"), text_column("required", "Required"),
       text_column("required_ft", "In feet"), text_column("available", "Available"),
       text_column("verdict", "Verdict")},
      {}};
  for (const ProjectSeparation& s : design.separations) {
    const bool known = s.available_m.has_value();
    table.add({separation_letter(table.rows.size()), s.text(), fixed(s.required.factor, 1),
               length_cell_in_both(s.required.value_m), required_ft(s.required.value_m),
               known ? Cell(length_cell_in_both(*s.available_m)) : "not stated",
               verdict_text(s, package)});
  }
  table.notes.push_back(verdict_sentence(package));
  const Standard standard = package.project.standard;
  for (const Separation& s : separations_of(standard, design.governing_m)) {
    if (!s.basis.empty())
      table.notes.push_back(fmt::format("{}: {:g} times the displacement; {}.", capitalised(s.what),
                                        s.factor, s.basis));
  }
  table.notes.push_back(qualifying_parapet(standard) + ".");
  return in_inches() ? table : table.without("required_ft");
}

std::string deciding_sentence(const DesignClearance& design) {
  return fmt::format(
      "Largest change of the displacement of the analysis from one end to the other: {}.",
      deciding_text(design.uncertainty));
}

Table uncertainty_table(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  Table table =
      model_uncertainty_table(
          {design.uncertainty},
          "What the premises and the records change: the displacement of the analysis with one at "
          "either end, the largest over all else that the project states",
          {{text_column("displacement", "displacement"), &PremiseEffect::result,
            [](double displacement_m) -> Cell {
              if (std::isinf(displacement_m)) return "slides without an earthquake";
              return length_cell_in_both(displacement_m);
            }}})
          .without("threshold");
  table.notes.push_back(deciding_sentence(design));
  table.notes.push_back(fmt::format("At the MCE the displacement of the analysis is {}.",
                                    length_in_both(design.mce_analysis_m)));
  if (design.floor_governs)
    table.notes.push_back(
        fmt::format("The least value of the standard governs, {}: a change up to "
                    "there has no effect on the separations.",
                    length_in_both(design.floor_m, 1)));
  const ProjectFriction& mu = package.project.friction;
  if (mu.lower_bound && *mu.lower_bound < mu.design())
    table.notes.push_back(fmt::format(
        "With the friction that the tests support with 95 % confidence, {:.3f}, {}.",
        *mu.lower_bound,
        design.bound_analysis_m
            ? "the displacement is " + length_in_both(*design.bound_analysis_m)
            : "the array slides without an earthquake on the steepest slope: no displacement"));
  return table;
}

Table exceedance_table(const CalculationPackage& package) {
  const Project& project = package.project;
  const double dbe = dbe_level(project), mce = mce_over_dbe * dbe;
  const auto at = [&](const char* level, const char* name, double intensity) {
    return project.of_roof ? fmt::format("At {}, factor {:g}", level, intensity)
                           : fmt::format("At {}, {} = {:.3f} g", level, name, intensity);
  };
  Table table{
      "exceedance",
      fmt::format("Probability that the displacement exceeds the governing one, {}",
                  length_in_both(package.design.governing_m, 1)),
      {text_column("period", "Building period"), share_column("dbe", at("DBE", "S_DS", dbe)),
       share_column("mce", at("MCE", "S_MS", mce))},
      {}};
  const std::vector<ExceedanceAt>& dbe_then_mce = package.design.exceedance;
  const std::size_t periods = dbe_then_mce.size() / 2;
  for (std::size_t p = 0; p < periods; ++p)
    table.add({significant(dbe_then_mce[p].period_s, 3, "s"), cell_of(dbe_then_mce[p]),
               cell_of(dbe_then_mce[periods + p])});
  table.notes.push_back(fmt::format(
      "The probability is the observed share of the histories, without a fitted curve. {} drawn "
      "within the project's ranges, and the orientation; the slope is the "
      "steepest: {} for each of {}. The interval is over {}; "
      "it is never narrower than that of a binomial with one trial for each of them.",
      project.of_roof ? "Friction is"
                      : fmt::format("Friction and {} are", varied_of_building(project)),
      counted(package.probability.cases.samples, "sample"), counted_records(package.probability),
      units_name(package.probability)));
  return project.of_roof ? table.without("period") : table;
}

std::string accepted_sentence(const DesignClearance& design) {
  const auto length = [](double length_m) {
    return std::isfinite(length_m) ? length_in(length_m) : std::string("any displacement");
  };
  const auto [low_m, high_m] = design.accepted.interval;
  return fmt::format(
      "{:g} % of the histories at the DBE exceed {} (95 % interval {})",
      100.0 * accepted_exceedance, length(design.accepted.displacement_m),
      length(low_m) + (std::isfinite(high_m) ? " to " + length(high_m) : " or more"));
}

Table compared_table(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  Table table{"compared",
              "Probability that each available separation is not sufficient",
              {text_column("displacement", "Displacement"), share_column("dbe", "At DBE"),
               share_column("mce", "At MCE")},
              {}};
  const bool has_rate = design.compared.front().rate.has_value();
  if (has_rate) {
    table.columns.push_back(
        {"annual_rate", "per_year", "Annual rate [95 %]", ColumnKind::rate, "", true});
    table.columns.push_back(
        share_column("life_probability", "In " + life_text(*package.probability.hazard)));
  }
  for (const DisplacementExceedance& row : design.compared) {
    std::string what = "governing: " + length_in(row.displacement_m);
    if (row.separation) {
      const ProjectSeparation& separation = design.separations[*row.separation];
      what =
          fmt::format("{}: {} / {:g} = {}", separation.text(), length_in(*separation.available_m),
                      separation.required.factor, length_in(row.displacement_m));
    }
    std::vector<Cell> cells{what, cell_of(row.dbe), cell_of(row.mce)};
    if (has_rate) {
      const char* sign = sign_of(*row.rate);
      cells.emplace_back(NumberCell{row.rate->annual_rate, sign});
      cells.emplace_back(NumberCell{row.rate->life_probability, sign});
    }
    table.add(std::move(cells));
  }
  table.notes.push_back(
      "A separation allows the displacement separation / factor; between "
      "similar arrays only where both slide alike. " +
      std::string(package.project.of_roof
                      ? ""
                      : "Each number is that of the building period where it is largest. ") +
      accepted_sentence(design) + ".");
  if (has_rate)
    table.notes.emplace_back(
        "<: an upper bound, without an interval: more than half of the rate is of shaking above "
        "the highest level, all of which counts as exceeding.");
  return table;
}

Table roof_accelerations_table(const CalculationPackage& package) {
  Table table{"roof_accelerations",
              "Peak acceleration of the roof at DBE, computed and by the standards",
              {text_column("period", "Building period"), text_column("alpha", "\u03b1_0"),
               text_column("median", "Median, g"), text_column("p84", "84th percentile, g"),
               text_column("asce7_16", "ASCE 7-16, 13.3-1, g"),
               text_column("asce7_22", "ASCE 7-22, H_f, g"),
               text_column("ratio", "Median over the larger")},
              {}};
  const auto& [of_roof, building] = std::tie(package.project.of_roof, package.project.building);
  for (const RoofPeak& roof : package.design.roof)
    table.add({significant(roof.period_s, 3, "s"), significant(roof.alpha, 3),
               fixed(roof.median_g, 3), fixed(roof.p84_g, 3), fixed(roof.asce7_16_g, 3),
               fixed(roof.asce7_22_g.value_or(nan), 3), fixed(roof.over_standards(), 2)});
  table.notes.push_back(fmt::format(
      "Computed: over {}, of each the geometric mean of both horizontal axes{}. ASCE 7-16: "
      "0.4 S_DS (1 + 2 z/h) with z/h = 1.",
      counted_records(package.demand), of_roof ? "" : ", without the array"));
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
