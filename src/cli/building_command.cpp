// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "glissade/building/mode_rules.hpp"
#include "glissade/core/error.hpp"
#include "glissade/io/mode_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/report/table.hpp"
#include "glissade/standards/floor_acceleration.hpp"
#include "glissade/study/cases/probable.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

constexpr std::size_t most_storeys = 200;
constexpr double usual_sd1 = 0.6;  ///< over S_DS, where it is not stated: said with the result

/// CLI's own ranges take "nan", and print their ends with all digits.
CLI::Validator from_to(double least, double most) {
  return {[least, most](const std::string& text) {
            const double value = std::strtod(text.c_str(), nullptr);
            return value >= least && value <= most
                       ? std::string()
                       : fmt::format("{} is not from {:g} to {:g}", text, least, most);
          },
          fmt::format("{:g} to {:g}", least, most)};
}

struct BuildingOptions {
  std::string modes, axis, spectrum;
  std::vector<double> roof_shape;
  double period_s = 0.0;
  std::optional<double> alpha, sds_g, sd1_g;
  std::optional<std::size_t> storeys;
  std::vector<double> masses, stiffnesses;
  double tl_s = 8.0;
  bool json = false;
};

ModeFile modes_of(const BuildingOptions& o) {
  if (!o.modes.empty()) {
    ModeFileOptions file{.axis = {}, .roof_shape = o.roof_shape};
    if (!o.axis.empty()) file.axis = o.axis == "x" ? ModeAxis::x : ModeAxis::y;
    return read_modes(o.modes, file);
  }
  if (!o.masses.empty() || !o.stiffnesses.empty())
    return {shear_building_modes(o.masses, o.stiffnesses)};
  if (!(o.period_s > 0.0))
    throw InputError(
        {"--period-s", "no building is stated",
         "give --period-s with --alpha or --storeys, or --masses and --stiffnesses, or "
         "--modes FILE.csv",
         ""});
  if (o.storeys) {
    const std::vector<double> equal(*o.storeys, 1.0);
    return {with_first_period(shear_building_modes(equal, equal), o.period_s)};
  }
  if (!o.alpha)
    throw InputError({"--period-s", "a period alone is no building of several storeys",
                      std::string("give --storeys, or --alpha: ") + usual_alpha, ""});
  constexpr std::size_t enough = 20;
  return {cantilever_modes(o.period_s, *o.alpha, enough)};
}

/// Peak accelerations of the roof under a design spectrum, in g.
struct FloorAccelerations {
  double by_modes, one_mass, asce7_16, asce7_22;
};

/// That of S_DS, or the one by points; nothing where none is stated.
std::optional<DesignTarget> spectrum_of(const BuildingOptions& o) {
  if (o.spectrum.empty() && !o.sds_g) return std::nullopt;
  DesignTarget target;
  if (!o.spectrum.empty()) {
    target = read_spectrum(o.spectrum);
  } else {
    target.sds_g = *o.sds_g;
    target.sd1_g = o.sd1_g.value_or(usual_sd1 * *o.sds_g);
    target.tl_s = o.tl_s;
  }
  return target;
}

/// Where a spectrum by points does not reach the modes or the period 0.
std::string spectrum_warning(const DesignTarget& target, const std::vector<Mode>& modes) {
  const std::vector<double>& periods_s = target.period_s;
  if (periods_s.empty()) return "";
  constexpr double near_zero_s = 0.01;
  if (periods_s.front() > std::max(near_zero_s, modes.back().period_s))
    return fmt::format("below {:g} s, where the spectrum begins, its first value is taken",
                       periods_s.front());
  if (periods_s.back() < modes.front().period_s)
    return fmt::format("beyond {:g} s, where the spectrum ends, it is taken to fall as 1/T",
                       periods_s.back());
  return "";
}

/// SRSS of the modes, and of what is left out, which moves with the ground.
FloorAccelerations roof_acceleration(const std::vector<Mode>& modes,
                                     const TargetSpectrum& spectrum) {
  double sum = 0.0, left = 1.0;
  for (const Mode& mode : modes) {
    sum += std::pow(mode.participation * spectrum.design_sa_g(mode.period_s), 2);
    left -= mode.participation;
  }
  sum += std::pow(left * spectrum.design_sa_g(0.0), 2);
  const double period_s = modes.front().period_s;
  return {std::sqrt(sum), spectrum.design_sa_g(period_s),
          asce7_16_floor_acceleration_g(spectrum.sds_g()),
          asce7_22_floor_acceleration_g(spectrum.sds_g(), period_s)};
}

std::vector<std::string> warnings_on(const BuildingOptions& o, const ModeFile& building) {
  std::vector<std::string> warnings = improbable_modes(building.modes, building.has_damping);
  const Parameter& period = parameters()[parameter_index("building", "period_s")];
  if (const std::string text = improbable_value(period, building.modes.front().period_s);
      !text.empty())
    warnings.push_back(text + (o.masses.empty() ? ""
                                                : " Masses in t go with stiffnesses in kN/m, "
                                                  "masses in kg with N/m"));
  if (o.storeys || !o.masses.empty())
    if (std::string text =
            improbable_storeys(building.modes.size(), building.modes.front().period_s);
        !text.empty())
      warnings.push_back(std::move(text));
  if (building.has_damping && (o.sds_g || !o.spectrum.empty()))
    warnings.emplace_back(
        "the design spectrum is of 5 % damping: peak accelerations are not those of the damping in "
        "the file");
  if (o.sd1_g && *o.sd1_g > 1.5 * *o.sds_g)
    warnings.emplace_back("S_D1 above 1.5 S_DS is no design spectrum of a site");
  return warnings;
}

Table modes_table(const std::vector<Mode>& modes, std::size_t all) {
  Table table{"modes",
              "Modes along one axis, at the array",
              {{"mode", "", "Mode", ColumnKind::count},
               {"period", "s", "Period, s", ColumnKind::number, "", false, 4},
               {"participation", "", "Participation", ColumnKind::number, "", false, 4},
               {"mass_share", "", "Mass share", ColumnKind::number, "", false, 4},
               {"mass_so_far", "", "so far", ColumnKind::number, "", false, 4}},
              {}};
  double mass = 0.0;
  for (const Mode& mode : modes) {
    mass += mode.mass_share;
    table.add({static_cast<double>(table.rows.size() + 1), mode.period_s, mode.participation,
               mode.mass_share, mass});
  }
  if (all > modes.size())
    table.notes.push_back(fmt::format(
        "{} of {}: the first, and those with the largest mass shares, to 95 % of the mass, without "
        "periods below 0.05 s, at most six. The accelerations are of all.",
        modes.size(), all));
  return table;
}

using Json = nlohmann::ordered_json;

void run(const BuildingOptions& o) {
  const ModeFile building = modes_of(o);
  const std::vector<Mode>&all = building.modes, modes = governing_modes(all);
  std::vector<std::string> warnings = warnings_on(o, building);
  std::optional<FloorAccelerations> roof;
  const std::optional<DesignTarget> target = spectrum_of(o);
  double sds_g = 0.0, sd1_g = 0.0;
  if (target) {
    const TargetSpectrum spectrum(*target);
    sds_g = spectrum.sds_g(), sd1_g = spectrum.sd1_g();
    roof = roof_acceleration(all, spectrum);
    if (std::string text = spectrum_warning(*target, all); !text.empty()) warnings.push_back(text);
  }
  if (o.json) {
    Json json{{"modes", Json::array()}, {"governing", modes.size()}, {"warnings", warnings}};
    for (const Mode& mode : all)
      json["modes"].push_back({{"period_s", mode.period_s},
                               {"participation", mode.participation},
                               {"mass_share", mode.mass_share},
                               {"damping", mode.damping_ratio}});
    if (roof)
      json["peak_roof_acceleration_g"] = {{"modes", roof->by_modes},
                                          {"one_mass", roof->one_mass},
                                          {"asce7_16", roof->asce7_16},
                                          {"asce7_22", roof->asce7_22},
                                          {"sds_g", sds_g},
                                          {"sd1_g", sd1_g}};
    return put_json(json);
  }
  put("{}\n", to_text(modes_table(modes, all.size())));
  put_warnings(warnings);
  if (!roof) return;
  put("Peak roof acceleration under the design spectrum, S_DS = {:.4g} g, S_D1 = {:.4g} g{}\n"
      "  modes (SRSS)                        {:.3g} g\n"
      "  one mass of the first period        {:.3g} g\n"
      "  ASCE 7-16, 0.4 S_DS (1 + 2 z/h)     {:.3g} g   [recalled]\n"
      "  ASCE 7-22, 0.4 S_DS H_f             {:.3g} g   [recalled]\n",
      sds_g, sd1_g,
      !o.spectrum.empty() ? " (of its points)"
      : o.sd1_g           ? ""
                          : " (assumed)",
      roof->by_modes, roof->one_mass, roof->asce7_16, roof->asce7_22);
  if (all.size() == 1) return;
  put("\n");
  put_lines(fmt::format("A study with [building] period_s = {:.3g} computes one mass, whose peak "
                        "roof acceleration is {:.2g} times that of the modes. State "
                        "alpha, storeys or modes in [building], or use motions of its roof "
                        "(studies/README.md, The model).",
                        modes.front().period_s, roof->one_mass / roof->by_modes),
            0);
}

}  // namespace

void add_building(CLI::App& program) {
  auto o = std::make_shared<BuildingOptions>();
  CLI::App* command = program.add_subcommand(
      "building", "Modes of a building of several storeys, and how much its roof amplifies");
  CLI::Option* period =
      command->add_option("--period-s", o->period_s, "first period, with --alpha or --storeys")
          ->check(from_to(0.01, 30.0));
  CLI::Option* alpha =
      command
          ->add_option("--alpha", o->alpha,
                       std::string("uniform cantilever of flexure and shear: ") + usual_alpha)
          ->check(from_to(0.0, largest_alpha));
  CLI::Option* storeys =
      command->add_option("--storeys", o->storeys, "shear building of so many equal storeys")
          ->check(CLI::Range(std::size_t{1}, most_storeys))
          ->excludes(alpha);
  CLI::Option* masses =
      command
          ->add_option("--masses", o->masses,
                       "shear building: mass of each floor from the ground up (t with kN/m, kg "
                       "with N/m)")
          ->excludes(alpha)
          ->excludes(storeys)
          ->excludes(period);
  command->add_option("--stiffnesses", o->stiffnesses, "stiffness of each storey, likewise")
      ->needs(masses);
  CLI::Option* modes =
      command
          ->add_option("--modes", o->modes,
                       "CSV with period_s, participation, mass_share, or what ETABS, SAP 2000 "
                       "or OpenSees export (suites/README.md)")
          ->excludes(alpha)
          ->excludes(storeys)
          ->excludes(masses)
          ->excludes(period);
  command->add_option("--axis", o->axis, "of an exported table: x or y")
      ->check(CLI::IsMember({"x", "y"}))
      ->needs(modes);
  command
      ->add_option("--roof-shape", o->roof_shape,
                   "with participation factors in the file: the displacement of each mode at the "
                   "array, along the axis")
      ->needs(modes);
  CLI::Option* sds =
      command->add_option("--sds-g", o->sds_g, "S_DS of the site: the roof's peak acceleration")
          ->check(from_to(1e-3, most_possible_g));
  command->add_option("--sd1-g", o->sd1_g, "S_D1 [0.6 S_DS]")
      ->check(from_to(1e-3, most_possible_g))
      ->needs(sds);
  command->add_option("--tl-s", o->tl_s, "long-period transition")
      ->check(from_to(1.0, 30.0))
      ->needs(sds);
  command
      ->add_option("--spectrum", o->spectrum,
                   "design spectrum in place of S_DS and S_D1: CSV with period_s and design_sa_g")
      ->excludes(sds);
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] { run(*o); });
}

}  // namespace glissade::cli
