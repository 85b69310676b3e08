// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/table.hpp"
#include "glissade/standards/code_values.hpp"
#include "glissade/standards/prescriptive.hpp"

namespace glissade::cli {
namespace {

struct StandardsOptions {
  double sds_g = 0.0, importance = 1.0;
  std::string sdc = "D", risk_category;
  bool json = false;
};

std::vector<std::string> warnings_on(const StandardsOptions& o) {
  if (o.sds_g <= most_probable_g) return {};
  return {fmt::format("S_DS of {:g} g is above {:g} g: no site is known for it", o.sds_g,
                      most_probable_g)};
}

nlohmann::ordered_json to_json(const Prescription& p) {
  return {
      {"value_m", p.value_m}, {"provenance", provenance_label(p.provenance)}, {"basis", p.basis}};
}

/// In metres and inches.
const Column metres{"length", "m", "m", ColumnKind::number, false, 3},
    inches{"length", "in", "in", ColumnKind::number, false, 1};

/// Equal values differ in their last bit: the half is rounded up for all.
double in_inches(double length_m) { return length_m / inch_m * (1.0 + 1e-12); }

void run(const StandardsOptions& o) {
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
  const Prescription seaoc =
      seaoc_pv1_2012_displacement(o.sds_g, parse_seismic_design_category(o.sdc));
  const Prescription asce = asce7_16_displacement(o.sds_g, o.importance);
  const std::vector<Separation> separations = asce7_16_separations(asce.value_m);
  if (o.json) {
    nlohmann::ordered_json json{{"sds_g", o.sds_g},
                                {"importance", o.importance},
                                {"sdc", o.sdc},
                                {"seaoc_pv1_2012_m", seaoc.value_m},
                                {"asce7_16_m", asce.value_m},
                                {"warnings", warnings_on(o)}};
    json["separations"] = nlohmann::ordered_json::array();
    for (const Separation& s : separations) {
      json["separations"].push_back({{"between", s.what},
                                     {"factor", s.factor},
                                     {"separation_m", s.value_m},
                                     {"provenance", provenance_label(s.provenance)}});
    }
    json["seaoc_pv1_2012"] = to_json(seaoc);
    json["asce7_16"] = to_json(asce);
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("Prescribed displacement of an unanchored array at S_DS = {:g} g, in plan\n", o.sds_g);
  for (const std::string& warning : warnings_on(o))
    fmt::print("{}\n", wrapped("WARNING: " + warning, terminal_width, 2));
  Table displacements{
      "displacements",
      "Prescribed displacements",
      {text_column("standard", "Standard"), metres, inches, text_column("basis", "Basis")},
      {},
      {}};
  for (const auto& [name, p] : {std::pair{"SEAOC PV1-2012", seaoc}, {"ASCE 7-16", asce}})
    displacements.add({name, p.value_m, in_inches(p.value_m),
                       fmt::format("{} [{}]", p.basis, provenance_label(p.provenance))});
  Table distances{"separations",
                  "ASCE 7-16 separations",
                  {text_column("between", "Between"),
                   {"factor", "", "Factor"},
                   metres,
                   inches,
                   text_column("known", "Known")},
                  {},
                  {}};
  for (const Separation& s : separations)
    distances.add(
        {s.what, s.factor, s.value_m, in_inches(s.value_m), provenance_label(s.provenance)});
  fmt::print("{}\n{}", to_text(displacements), to_text(distances));
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
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] {
    for (const RiskCategory risk :
         {RiskCategory::i, RiskCategory::ii, RiskCategory::iii, RiskCategory::iv}) {
      if (o->risk_category == to_string(risk)) o->importance = importance_factor(risk);
    }
    run(*o);
  });
}

}  // namespace glissade::cli
