// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/design/premises.hpp"
#include "glissade/io/product_file.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/format.hpp"
#include "glissade/study/plan/plan.hpp"
#include "shared/option_errors.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

/// A folder of the system's temporary ones, removed in the end.
class TrialFolder {
 public:
  TrialFolder() {
    std::string name = (fs::temp_directory_path() / "glissade-check-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw InputError({name, "cannot be made", "set TMPDIR to a folder you may write to", ""});
    path_ = name;
  }
  ~TrialFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// @param of the user's file, of which a fault of the study is one
Plan plan_of(const fs::path& file, const fs::path& of, const std::string& study,
             const Suite& suite) {
  write_text_file(file, study);
  return with_place_of(file, of, [&] { return make_plan(read_study(file), {suite}); });
}

void print_plan(const char* name, const Plan& plan) {
  put("{:<12}{} x {} x {}, roughly {:.0f} s on one core\n", name,
      counted(plan.records.size(), "record"), counted(plan.cases.size(), "case"),
      counted(plan.config.intensity.levels.size(), "level"), std::ceil(plan.predicted_seconds()));
}

std::string range_text(const std::vector<double>& values) {
  return values.front() == values.back()
             ? fmt::format("{:.3g}", values.front())
             : fmt::format("{:.3g} to {:.3g}", values.front(), values.back());
}

/// What a wrong unit would show in.
void print_inputs(const Project& project) {
  const ProjectBuilding& building = project.building;
  put("{:<12}{}\n", "building",
      wrapped(project.of_roof
                  ? fmt::format("none is computed: the motions are those of its roof, factor {:g}",
                                project.roof_factor)
                  : fmt::format("period {} s ({}), {}, mass ratio {}, damping {:g}",
                                range_text(building.period_s), building.period_basis,
                                building.alpha.empty()
                                    ? "one mass"
                                    : "modes with alpha " + range_text(building.alpha),
                                range_text(building.mass_ratio), building.damping),
              terminal_width, 12));
  put("{:<12}slope {} degrees\n", "roof", range_text(project.slope_deg));
  const std::vector<Separation> separations = separations_of(project.standard, 1.0);
  std::string at_hand;
  const auto add = [&](double available_m, const std::string& what) {
    at_hand +=
        fmt::format("{}{} {}", at_hand.empty() ? "" : ", ", format_length(available_m), what);
  };
  for (std::size_t i = 0; i < separations.size(); ++i)
    if (project.available_m[i]) add(*project.available_m[i], separations[i].what);
  for (const ProjectGap& gap : project.gaps)
    add(gap.available_m, separations[gap.kind].what + " (" + gap.name + ")");
  if (!at_hand.empty()) put("{:<12}{}\n", "clearances", wrapped(at_hand, terminal_width, 12));
}

void print_prescribed(const std::vector<PrescribedValue>& prescribed) {
  for (const PrescribedValue& value : prescribed) {
    put("{:<16}{}\n", standard_name(value.standard),
        wrapped(fmt::format("prescribes {}; {}", format_length(value.prescribed.value_m),
                            value.may_be_used() ? "the conditions are met"
                                                : "not met or not stated: " + value.not_met()),
                terminal_width, 16));
  }
}

void print_end(const fs::path& file, const fs::path& out) {
  check_calculation_folder(out, false);
  put("{:<12}{}: free\n{:<12}glissade clearance {}\n", "folder", out.string(), "next",
      quoted_for_shell(file.string()));
}

}  // namespace

void check_product(const fs::path& file, const fs::path& out) {
  const Product product = read_product(file);
  const Suite suite = load_suite(product.suite);
  const TrialFolder trial;
  put("{:<12}{}\n", "product", wrapped(product.name, terminal_width, 12));
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < product.targets.size(); ++i) {
    const std::string name = fmt::format("target_{}", i + 1);
    const Plan plan = plan_of(trial.path() / (name + ".toml"), file,
                              product_study(product, i, trial.path()), suite);
    for (const std::string& warning : plan.warnings) {
      if (std::ranges::find(shown, warning) != shown.end()) continue;
      put_warning(warning);
      shown.push_back(warning);
    }
    print_plan(name.c_str(), plan);
  }
  print_end(file, out);
}

namespace {

void check_one(const Project& project) {
  const LengthUnits units(project.units);
  const SiteValues site = site_values(project.site);
  const std::vector<PrescribedValue> prescribed = prescribed_values(project, site);
  const Suite suite = load_suite(project.suite);
  const TrialFolder trial;
  const Plan demand = plan_of(trial.path() / "demand.toml", project.file,
                              demand_study(project, trial.path()), suite);
  const Plan uncertainty = plan_of(trial.path() / "uncertainty.toml", project.file,
                                   uncertainty_study(project, trial.path()), suite);
  const Plan probability = plan_of(
      trial.path() / "probability.toml", project.file,
      probability_study(project, trial.path(),
                        compared_displacements_m(project, prescribed.front().prescribed.value_m)),
      suite);

  std::vector<std::string> warnings = texts_of(warnings_on(project));
  for (const Plan* plan : {&demand, &probability}) {
    for (const std::string& warning : plan->warnings)
      if (std::ranges::find(warnings, warning) == warnings.end() &&
          !is_of_premise(project, warning))
        warnings.push_back(warning);
  }
  for (const auto& checks :
       {checks_of_scaling(project, demand), checks_before_analysis(project, suite.motions.size())})
    for (const DesignCheck& check : checks)
      if (!check.is_met) warnings.push_back(not_met_text(check));
  if (std::string text = separations_not_stated(project); !text.empty())
    warnings.push_back(std::move(text));
  put("{:<12}{}\n", "project", wrapped(project.title.name, terminal_width, 12));
  put_warnings(warnings);
  put("{:<12}S_DS {:.3f} g, S_D1 {:.3f} g, category {}\n", "site", site.sds_g, site.sd1_g,
      category_text(project.site, site));
  print_inputs(project);
  put("{:<12}mean {:.3f}, std {:.3f}, design {:.3f}\n", "friction", project.friction.mean,
      project.friction.std, project.friction.design());
  print_prescribed(prescribed);
  print_plan("demand", demand);
  print_plan("uncertainty", uncertainty);
  print_plan("probability", probability);
}

}  // namespace

void check_project(const fs::path& file, const fs::path& out) {
  const std::size_t sites = site_names(file).size();
  if (sites == 0) check_one(read_project(file));
  for (std::size_t i = 0; i < sites; ++i) {
    check_one(read_project(file, i));
    put("\n");
  }
  print_end(file, out);
}

}  // namespace glissade::cli
