// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "glissade/core/contract.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/motion/improbable.hpp"
#include "toml/toml_text.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// Any value between the lowest and the highest.
std::string between(const std::vector<double>& values) {
  if (values.size() == 1) return list_of(values);
  return fmt::format("{{ distribution = \"uniform\", min = {}, max = {} }}", values.front(),
                     values.back());
}

/// An inline table.
std::string target_of(const Project& project, const fs::path& folder) {
  const DesignTarget& target = project.site.target;
  if (target.period_s.empty())
    return fmt::format("{{ {} }}", fmt::join(target_fields(target), ", "));
  return fmt::format("{{ edition = {}, spectrum = {} }}", quoted(to_string(target.edition)),
                     path_from(project.file.parent_path() / project.spectrum_file, folder));
}

std::string hazard_of(const Project& project, const fs::path& folder) {
  if (!project.hazard) return "";
  const ProjectHazard& hazard = *project.hazard;
  const std::string curve =
      hazard.curve.empty()
          ? fmt::format("k0 = {}\nk = {}", hazard.k0, hazard.k)
          : "curve = " + path_from(project.file.parent_path() / hazard.curve, folder);
  return fmt::format("\n[hazard]\n{}\ndesign_life_years = {}\n", curve, hazard.design_life_years);
}

/// The rule; that of Walters goes on to 1.5 times the longest building period.
std::string scaled_by(const Project& project) {
  if (project.scaling_rule != ScalingRule::walters_2012)
    return fmt::format("scaling_rule = {}\n", quoted(text_of(project.scaling_rule).key));
  if (project.without_target) return "";
  const double to_s = judged_to_s(periods_of(project).back());
  return to_s > longest_scaled_period_s ? fmt::format("scaled_to_s = {}\n", to_s) : "";
}

/// What both studies have in common.
std::string head_of(const Project& project, const fs::path& folder, const std::string& name,
                    const std::string& what, const std::vector<double>& levels) {
  const std::string intensity =
      project.of_roof
          ? fmt::format("measure = \"factor\"\nlevels = [{}]\n", fmt::join(levels, ", "))
          : fmt::format("measure = \"sds_g\"\nlevels = [{}]\ntarget = {}\n{}",
                        fmt::join(levels, ", "), target_of(project, folder), scaled_by(project));
  return fmt::format(
      "# Made by `glissade clearance` from {}.\n"
      "[study]\nname = {}\ndescription = {}\nseed = {}\nunits = \"{}\"\n\n"
      "[suite]\nfile = {}\n\n"
      "[intensity]\n{}\n",
      quoted(project.file.filename().string()), quoted(name),
      quoted(project.title.name + ": " + what +
             ". Part of a calculation: the governing displacement is in package.html, one folder "
             "above"),
      project.seed, project.units == UnitSystem::us_customary ? "us" : "si",
      path_from(project.suite, folder), intensity);
}

/// Nothing where the motions are those of its roof.
/// @param write how ranges are written: as a list or as what lies between
std::string building_of(const Project& project, const std::vector<double>& periods_s,
                        const std::vector<double>& mass_ratios,
                        std::string (*write)(const std::vector<double>&),
                        const std::vector<double>& dampings) {
  if (project.of_roof) return "";
  const std::vector<double>& alpha = project.building.alpha;
  const char* one_storey = "storeys = 1   # computed as one mass, of which the project warns\n";
  return fmt::format("[building]\nperiod_s = {}\n{}mass_ratio = {}\ndamping = {}\n\n",
                     list_of(periods_s),
                     alpha.empty() ? one_storey : fmt::format("alpha = {}\n", write(alpha)),
                     write(mass_ratios), list_of(dampings));
}

/// What both studies compare with is of S_DS, which the motions of a roof do not have.
std::string standards_of(const Project& project) {
  if (project.of_roof) return "";
  return fmt::format(
      "\n[standards]\ncompare = [\"asce7_16\", \"seaoc_pv1_2012\"]\nimportance = {}\n"
      "seismic_design_category = {}\n\n"
      "[verdict]\nexceedance = [{}]\n",
      project.importance, quoted(to_string(site_values(project.site).category)),
      accepted_exceedance);
}

/// Of displacements, in all orientations, with and without vertical motion.
std::string displacement_study(const Project& project, const std::string& head,
                               const std::string& building, const std::vector<double>& slopes_deg,
                               const std::string& friction) {
  return head + building +
         fmt::format(
             "[vertical]\nuse = [\"none\", \"if_available\"]\n\n"
             "[roof]\nslope_deg = {}\n\n"
             "[friction]\nmu = {}\n\n"
             "[orientation]\nchoice = \"all_permutations\"\n\n"
             "[clearance]\n{}",
             list_of(slopes_deg), friction,
             project.without_target ? "without_target = true\n" : "");
}

}  // namespace

std::string demand_study(const Project& project, const fs::path& folder) {
  const double dbe = dbe_level(project);
  std::vector<double> frictions;
  std::vector<std::string> what;
  for (const StudiedFriction& mu : frictions_of(project)) {
    frictions.push_back(mu.value);
    what.push_back(mu.what);
  }
  return displacement_study(
      project, head_of(project, folder, "demand", "displacement demand", {dbe, mce_over_dbe * dbe}),
      building_of(project, periods_of(project), mass_ratios_of(project), list_of,
                  {project.building.damping}),
      slopes_of(project), fmt::format("{}   # {}", list_of(frictions), fmt::join(what, ", ")));
}

std::string uncertainty_study(const Project& project, const fs::path& folder) {
  std::set<double> frictions{project.friction.design()};
  if (const auto ends = friction_ends(project))
    for (const double mean : {ends->low, ends->high}) {
      const double design = design_friction(Normal{mean, project.friction.std});
      if (!slides_freely_on(project, design)) frictions.insert(design);
    }
  return displacement_study(
      project,
      head_of(project, folder, "uncertainty", "ends of friction and damping", {dbe_level(project)}),
      building_of(project, periods_of(project), project.building.mass_ratio, list_of,
                  dampings_of(project)),
      project.slope_deg, list_of({frictions.begin(), frictions.end()}));
}

std::string probability_study(const Project& project, const fs::path& folder,
                              const std::vector<double>& thresholds_m) {
  GLISSADE_EXPECTS(!thresholds_m.empty());
  std::vector<std::string> thresholds;
  for (const double threshold_m : thresholds_m)
    thresholds.push_back(fmt::format("\"{} m\"", threshold_m));
  const ProjectFriction& mu = project.friction;
  const std::string friction = mu.std > 0.0
                                   ? fmt::format("{{ mean = {}, std = {} }}", mu.mean, mu.std)
                                   : fmt::format("{}", mu.mean);
  return head_of(project, folder, "probability", "probability of exceedance", levels_of(project)) +
         building_of(project, project.building.period_s, project.building.mass_ratio, between,
                     {project.building.damping}) +
         fmt::format(
             "[roof]\nslope_deg = {}\n\n"
             "[friction]\nmu = {}\n{}\n"
             "[orientation]\nchoice = \"random\"\n\n"
             "[sampling]\nsamples = {}\n\n"
             "[fragility]\nthresholds_m = [{}]\n",
             project.slope_deg.back(), friction, mu.std > 0.0 ? "value = \"sampled\"\n" : "",
             project.samples, fmt::join(thresholds, ", ")) +
         standards_of(project) + hazard_of(project, folder);
}

}  // namespace glissade
