// SPDX-License-Identifier: GPL-3.0-or-later
#include "clearance/calculation_record.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/design/premises.hpp"
#include "run/run_record.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;
using CalculationJson = nlohmann::ordered_json;

/// Null where run.json is not there or is not of a calculation.
CalculationJson record_in(const fs::path& folder) {
  const CalculationJson json = read_run_json(folder / "run.json");
  const bool is_ours = json.is_object() && json.value("command", CalculationJson()) == "clearance";
  return is_ours ? json : CalculationJson();
}

CalculationJson head_of_calculation(const CalculationIdentity& identity, RunState state) {
  return {{"command", "clearance"},
          {"project", identity.project.string()},
          {"project_sha256", identity.project_sha256},
          {"status", name_of(state)}};
}

/// run.json of a finished one.
/// @param program that made it, of one program; @param results what it found
void write_end(const CalculationIdentity& identity, const CalculationJson& program, int ranks,
               const CalculationJson& results, const fs::path& folder) {
  CalculationJson json = head_of_calculation(identity, RunState::finished);
  json.update(program);
  json["finished_utc"] = now_utc();
  json["ranks"] = ranks;
  json.update(results);
  write_text_file(folder / "run.json", json_text(json));
}

void add_results(CalculationJson& json, const Project& project, const DesignClearance& design) {
  json["governing_m"] = design.governing_m;
  json["rounded_m"] = design.rounded_m;
  json["verdict"] = to_string(verdict_on(project, design));
  for (const ProjectSeparation& s : design.separations)
    json["separations"].push_back(
        {{"between", s.text()},
         {"factor", s.required.factor},
         {"least_m", s.required.least_m},
         {"required_m", s.required.value_m},
         {"available_m", s.available_m ? CalculationJson(*s.available_m) : CalculationJson()},
         {"verdict", to_string(verdict_on(s, project, design))}});
}

CalculationJson json_of(const ExceedanceAt& e, bool of_roof) {
  CalculationJson json{{"level", e.level}, {of_roof ? "factor" : "sds_g", e.intensity}};
  if (!of_roof) json["period_s"] = e.period_s;
  json.update(
      {{"probability", e.probability}, {"low95", e.interval.low}, {"high95", e.interval.high}});
  return json;
}

/// @param has_alpha the building is a cantilever; of a wall alpha is 0
CalculationJson json_of(const RoofPeak& roof, bool has_alpha) {
  CalculationJson json = CalculationJson::object();
  if (roof.period_s > 0.0) json["period_s"] = roof.period_s;
  if (has_alpha) json["alpha"] = roof.alpha;
  json.update(
      {{"median_g", roof.median_g}, {"p84_g", roof.p84_g}, {"asce7_16_g", roof.asce7_16_g}});
  if (roof.asce7_22_g) json["asce7_22_g"] = *roof.asce7_22_g;
  return json;
}

CalculationJson prescribed_json(const PrescribedValue& value) {
  CalculationJson json{{"standard", key_of(value.standard)},
                       {"value_m", value.prescribed.value_m},
                       {"conditions_met", value.may_be_used()},
                       {"conditions_not_met", value.not_met()}};
  for (const Separation& s : separations_of(value.standard, value.prescribed.value_m))
    json["separations_m"].push_back(s.value_m);
  return json;
}

std::string numbers_json(const CalculationPackage& package) {
  const DesignClearance& design = package.design;
  CalculationJson json{{"sds_g", design.site.sds_g},
                       {"sd1_g", design.site.sd1_g},
                       {"seismic_design_category", to_string(design.site.category)},
                       {"slope_deg", design.slope_deg}};
  const bool of_roof = package.project.of_roof;
  if (of_roof)
    json.update({{"motions", "roof"}, {"factor", package.project.roof_factor}});
  else
    json.update({{"mass_ratio", design.mass_ratio}, {"period_s", design.period_s}});
  if (!package.project.building.alpha.empty()) json["alpha"] = design.alpha;
  json.update({{"analysis_m", design.analysis_m}, {"least_value_m", design.floor_m}});
  add_results(json, package.project, design);
  for (const PrescribedValue& value : design.prescribed)
    json["prescribed"].push_back(prescribed_json(value));
  for (const PeriodDemand& d : design.demand) {
    CalculationJson& row = json["demand"].emplace_back(CalculationJson::object());
    if (!of_roof) row["period_s"] = d.period_s;
    row.update(
        {{"mean_m", d.mean_m}, {"p84_m", d.p84_m}, {"p95_m", d.p95_m}, {"largest_m", d.largest_m}});
  }
  for (const RoofPeak& roof : design.roof)
    json["roof_acceleration"].push_back(json_of(roof, !package.project.building.alpha.empty()));
  json["mce_analysis_m"] = design.mce_analysis_m;
  if (design.bound_analysis_m) json["bound_analysis_m"] = *design.bound_analysis_m;
  for (const PremiseEffect& effect : design.uncertainty.effects)
    json["model_uncertainty"].push_back({{"premise", effect.name()},
                                         {"ends", effect.ends},
                                         {"low", effect.low},
                                         {"high", effect.high},
                                         {"low_m", effect.result.low},
                                         {"calculated_m", effect.result.calculated},
                                         {"high_m", effect.result.high},
                                         {"change", effect.result.change()}});
  for (const ExceedanceAt& e : design.exceedance) json["exceedance"].push_back(json_of(e, of_roof));
  for (const DisplacementExceedance& row : design.compared) {
    const char* governing = "governing displacement";
    CalculationJson compared{
        {"what", row.separation ? design.separations[*row.separation].text() : governing},
        {"displacement_m", row.displacement_m},
        {"dbe", json_of(row.dbe, of_roof)},
        {"mce", json_of(row.mce, of_roof)}};
    if (row.rate) compared["annual_rate"] = row.rate->annual_rate.value;
    json["compared"].push_back(std::move(compared));
  }
  json["accepted"] = {{"probability", accepted_exceedance},
                      {"displacement_m", design.accepted.displacement_m},
                      {"low95", design.accepted.interval.low},
                      {"high95", design.accepted.interval.high}};
  if (package.probability.hazard) {
    for (const HazardRun& run : package.probability.hazard->runs)
      for (const ThresholdRate& rate : run.thresholds)
        if (rate.threshold_m == design.governing_m)
          json["annual_rate"].push_back(rate.annual_rate.value);
  }
  for (const DesignCheck& check : design.checks)
    json["checks"].push_back(
        {{"check", check.what}, {"found", check.found}, {"is_met", check.is_met}});
  for (const Premise& premise : premises_of(package.project))
    json["premises"].push_back({{"premise", premise.what},
                                {"key", premise.key},
                                {"value", premise.found.text},
                                {"required", premise.required},
                                {"is_met", premise.found.is_met}});
  json["warnings"] = warnings_of(design);
  return json_text(json);
}

}  // namespace

void check_project_path(const fs::path& project) {
  try {
    static_cast<void>(CalculationJson(project.string()).dump());
  } catch (const CalculationJson::type_error&) {
    throw InputError({project.string(), "its name, or that of a folder above it, is not UTF-8",
                      "rename it: run.json could not state it", ""});
  }
}

bool is_calculation(const fs::path& folder) { return !record_in(folder).is_null(); }

bool is_finished_calculation(const fs::path& folder) {
  return is_calculation(folder) && state_in(folder / "run.json") == RunState::finished;
}

CalculationIdentity read_calculation(const fs::path& folder) {
  const CalculationJson json = record_in(folder);
  if (json.is_null())
    throw InputError({"--resume", folder.string() + " holds no calculation that was begun",
                      "give the --out of an earlier glissade clearance", ""});
  const auto text = [&](const char* key) {
    const CalculationJson value = json.value(key, CalculationJson());
    if (!value.is_string())
      throw InputError(
          {(folder / "run.json").string(),
           fmt::format("is not as glissade clearance writes it: it has no text \"{}\"", key),
           "begin again: glissade clearance PROJECT --overwrite --out " +
               quoted_for_shell(folder.string()),
           ""});
    return value.get<std::string>();
  };
  return {text("project"), text("project_sha256")};
}

void check_is_no_site(const fs::path& folder) {
  const fs::path above = (fs::absolute(folder) / "").lexically_normal().parent_path().parent_path();
  if (!is_calculation(folder) || !is_calculation(above) ||
      read_calculation(folder).project != read_calculation(above).project)
    return;
  throw InputError({"--resume", folder.string() + " is the folder of one site of several",
                    "go on with all of them: " + resume_calculation_command(above), ""});
}

void write_begun_calculation(const CalculationIdentity& identity, RunState state,
                             const fs::path& folder) {
  CalculationJson json = head_of_calculation(identity, state);
  json["what_to_do"] = resume_calculation_command(folder);
  write_text_file(folder / "run.json", json_text(json));
}

void write_finished_calculation(const CalculationIdentity& identity,
                                const CalculationPackage& package, int ranks,
                                const fs::path& folder) {
  write_text_file(folder / "package.json", numbers_json(package));
  CalculationJson results;
  results["studies"] = {"demand/run.json", "uncertainty/run.json", "probability/run.json"};
  add_results(results, package.project, package.design);
  results["warnings"] = warnings_of(package.design);
  write_end(identity,
            {{"program_version", package.demand.program_version}, {"build", package.build}}, ranks,
            results, folder);
}

void write_finished_sites(const CalculationIdentity& identity, const SiteSheets& sheets, int ranks,
                          const fs::path& folder) {
  CalculationJson numbers{{"name", sheets.name}};
  for (const SiteSheet& site : sheets.sites)
    numbers["sites"].push_back(
        {{"name", site.name},
         {"folder", site.folder},
         {"sds_g", site.sds_g},
         {"sd1_g", site.sd1_g},
         {"s1_g", site.s1_g ? CalculationJson(*site.s1_g) : CalculationJson()},
         {"design_friction", site.friction},
         {"governing_m", site.governing_m},
         {"largest_required_m", site.largest_required_m},
         {"verdict", site.verdict}});
  write_text_file(folder / "sites.json", json_text(numbers));
  const CalculationJson none = CalculationJson::object();
  write_end(identity, none, ranks, none, folder);
}

void write_finished_product(const CalculationIdentity& identity, const ProductSheet& sheet,
                            int ranks, const fs::path& folder) {
  CalculationJson numbers{{"product", sheet.product.name}};
  for (const SheetTarget& of : sheet.targets) {
    CalculationJson& json = numbers["targets"].emplace_back(
        CalculationJson{{"sds_g", of.target.target.sds_g}, {"sd1_g", of.target.target.sd1_g}});
    for (const ProductDisplacement& d : of.found.points) {
      CalculationJson& row =
          json["displacements"].emplace_back(CalculationJson{{"slope_deg", d.slope_deg},
                                                             {"mu", d.mu},
                                                             {"mean_m", d.slip.mean_m},
                                                             {"design_m", d.design_m}});
      if (of.target.hazard) row.update({{"event_m", d.event_m}, {"smaller_m", d.smaller_m}});
    }
  }
  write_text_file(folder / "product.json", json_text(numbers));
  write_end(identity, {{"program_version", sheet.program_version}, {"build", sheet.build}}, ranks,
            CalculationJson::object(), folder);
}

std::string resume_calculation_command(const fs::path& folder) {
  const fs::path above = folder.parent_path();  // of all sites
  if (!above.empty() && is_calculation(above)) return resume_calculation_command(above);
  return "glissade clearance --resume " + quoted_for_shell(folder.empty() ? "." : folder.string());
}

}  // namespace glissade::cli
