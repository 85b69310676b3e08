// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <span>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/standards_tables.hpp"
#include "glissade/sampling/pull_test.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

struct StandardsOptions {
  double sds_g = 0.0, importance = 1.0;
  std::string sdc = "D", risk_category;
  ArrayFacts array;
  bool json = false;
};

/// What a standard says of an array.
struct Provision {
  Standard standard;
  Prescription displacement;
  std::vector<CodeCondition> conditions;
  std::vector<Separation> separations;  ///< none where it does not apply
  std::string not_applicable;           ///< the conditions that are not met
};

Provision provision_of(Standard standard, const StandardsOptions& o) {
  Provision p{.standard = standard,
              .displacement =
                  standard == Standard::asce7_16
                      ? asce7_16_displacement(o.sds_g, o.importance)
                      : seaoc_pv1_2012_displacement(o.sds_g, parse_seismic_design_category(o.sdc)),
              .conditions = conditions_of(standard, o.array)};
  p.not_applicable = not_met_text(p.conditions, /*unknown=*/false);
  if (p.not_applicable.empty()) p.separations = separations_of(standard, p.displacement.value_m);
  return p;
}

std::vector<std::string> warnings_on(const StandardsOptions& o) {
  if (o.sds_g <= most_probable_g) return {};
  return {fmt::format("S_DS of {:g} g is above {:g} g: no site is known for it", o.sds_g,
                      most_probable_g)};
}

using Json = nlohmann::ordered_json;

Json to_json(const std::vector<Separation>& separations) {
  Json json = Json::array();
  for (const Separation& s : separations)
    json.push_back({{"between", s.what},
                    {"factor", s.factor},
                    {"least_m", s.least_m},
                    {"separation_m", s.value_m},
                    {"provenance", provenance_label(s.provenance)}});
  return json;
}

/// Without a value where the standard does not apply.
Json value_json(const Provision& p) {
  return p.not_applicable.empty() ? Json(p.displacement.value_m) : Json();
}

Json to_json(const Provision& p) {
  Json json{{"applies", p.not_applicable.empty()},
            {"not_met", p.not_applicable},
            {"value_m", value_json(p)},
            {"provenance", provenance_label(p.displacement.provenance)},
            {"basis", p.displacement.basis},
            {"separations", to_json(p.separations)}};
  for (const CodeCondition& c : p.conditions)
    json["conditions"].push_back({{"condition", c.what},
                                  {"limit", c.limit},
                                  {"found", c.found},
                                  {"is_met", c.is_met ? Json(*c.is_met) : Json()},
                                  {"clause", c.clause},
                                  {"provenance", provenance_label(c.provenance)}});
  return json;
}

/// In metres and inches.
const Column metres{"length", "m", "m", ColumnKind::number, "", false, 3},
    inches{"length", "in", "in", ColumnKind::number, "", false, 1};

/// Equal values differ in their last bit: the half is rounded up for all.
double in_inches(double length_m) { return length_m / inch_m * (1.0 + 1e-12); }

Table displacements_table(std::span<const Provision> provisions) {
  Table table{"displacements",
              "Prescribed displacements",
              {text_column("standard", "Standard"), metres, inches, text_column("basis", "Basis")},
              {},
              {}};
  for (const Provision& p : provisions) {
    if (p.not_applicable.empty())
      table.add({standard_name(p.standard), p.displacement.value_m,
                 in_inches(p.displacement.value_m),
                 fmt::format("{} [{}]", p.displacement.basis,
                             provenance_label(p.displacement.provenance))});
    else
      table.add({standard_name(p.standard), std::nan(""), std::nan(""),
                 "not applicable: " + p.not_applicable});
  }
  return table;
}

void check(const StandardsOptions& o) {
  if (!(o.sds_g > 0.0))
    throw InputError({"--sds-g", fmt::format("S_DS = {:g} g is not above 0", o.sds_g), "", ""});
  if (o.sds_g > most_possible_g)
    throw InputError(
        {"--sds-g",
         fmt::format("S_DS = {:g} g: no site has more than {:g} g", o.sds_g, most_possible_g),
         fmt::format("if it is in percent of g, give {:g}", o.sds_g / 100.0), ""});
  if (!(o.importance >= 1.0 && o.importance <= 1.5)) {
    throw InputError({"--importance",
                      fmt::format("{:g} is not an importance factor: it must be between 1 and 1.5",
                                  o.importance),
                      "", ""});
  }
}

void run(const StandardsOptions& o) {
  check(o);
  const std::array provisions{provision_of(Standard::seaoc_pv1_2012, o),
                              provision_of(Standard::asce7_16, o)};
  const auto& [seaoc, asce] = provisions;
  if (o.json) {
    const Json json{{"sds_g", o.sds_g},
                    {"importance", o.importance},
                    {"sdc", o.sdc},
                    {"seaoc_pv1_2012_m", value_json(seaoc)},
                    {"asce7_16_m", value_json(asce)},
                    {"warnings", warnings_on(o)},
                    {"separations", to_json(asce.separations)},
                    {"seaoc_pv1_2012", to_json(seaoc)},
                    {"asce7_16", to_json(asce)}};
    put_json(json);
    return;
  }
  put("Prescribed displacement of an unanchored array at S_DS = {:g} g, in plan\n", o.sds_g);
  put_warnings(warnings_on(o));
  put("{}\n", to_text(displacements_table(provisions)));
  std::vector<StandardSeparations> separations;
  for (const Provision& p : provisions)
    if (!p.separations.empty()) separations.emplace_back(p.standard, p.separations);
  if (!separations.empty()) put("{}\n", to_text(separations_table(separations)));
  put("{}\n", to_text(conditions_table(o.array)));
  for (const std::string& note :
       {analysis_provision(Standard::asce7_16), analysis_provision(Standard::seaoc_pv1_2012),
        pull_test_provision()})
    put_note(note + " (recalled: verify)");
}

}  // namespace

void add_standards(CLI::App& program) {
  auto o = std::make_shared<StandardsOptions>();
  CLI::App* command =
      program.add_subcommand("standards", "Prescribed displacements and separations");
  command->add_option("--sds-g", o->sds_g, "design spectral acceleration at short periods, S_DS")
      ->required();
  CLI::Option* importance =
      command->add_option("--importance", o->importance, "importance factor I_e (ASCE 7-16)");
  command
      ->add_option("--risk-category", o->risk_category,
                   "I to IV, in place of its importance factor")
      ->check(CLI::IsMember({"I", "II", "III", "IV"}))
      ->excludes(importance);
  command->add_option("--sdc", o->sdc, "seismic design category, A to F (SEAOC PV1)");
  const auto add_fact = [&](const char* name, std::optional<double> ArrayFacts::*fact,
                            const char* meaning) {
    command->add_option(name, o->array.*fact, meaning)->check(CLI::NonNegativeNumber);
  };
  add_fact("--slope-deg", &ArrayFacts::slope_deg, "slope of the roof, for the conditions");
  add_fact("--mu", &ArrayFacts::friction, "design coefficient of friction");
  add_fact("--storeys", &ArrayFacts::storeys, "of the building");
  add_fact("--centre-of-mass-m", &ArrayFacts::centre_of_mass_m,
           "height of the array's centre of mass above the roof");
  add_fact("--support-spacing-m", &ArrayFacts::support_spacing_m,
           "least spacing of the array's supports");
  add_fact(
      "--interconnection", &ArrayFacts::interconnection,
      "horizontal strength across any section of the array over the weight of its lighter side");
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] {
    for (const RiskCategory risk :
         {RiskCategory::i, RiskCategory::ii, RiskCategory::iii, RiskCategory::iv}) {
      if (o->risk_category != to_string(risk)) continue;
      o->importance = importance_factor(risk);
      o->array.risk = risk;
    }
    o->array.sds_g = o->sds_g;
    run(*o);
  });
}

}  // namespace glissade::cli
