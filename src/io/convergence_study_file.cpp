// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "convergence_names.hpp"
#include "glissade/io/convergence_file.hpp"
#include "number_list.hpp"
#include "suite_choice.hpp"
#include "toml_table.hpp"

namespace glissade {
namespace {

constexpr double largest_substeps = 65536;
constexpr NumberRule slope_rule{"in degrees, -89.9 to 89.9",
                                [](double x) { return std::abs(x) <= 89.9; }};
constexpr NumberRule substeps_rule{"a whole number, 1 to 65536", [](double x) {
                                     return x >= 1.0 && x <= largest_substeps && x == std::floor(x);
                                   }};

void read_grid(const TomlTable& table, ConvergenceConfig& study) {
  study.slope_deg = read_increasing(table, "slope_deg", slope_rule);
  study.mu = read_increasing(table, "mu", friction_rule);
  study.ppa_g = read_increasing(table, "ppa_g", not_negative);
  if (study.ppa_g == std::vector<double>{0.0}) {
    table.report("ppa_g", "convergence.ppa_g has no value above 0", "shake the roof");
  }
  for (const double p : read_increasing(table, "substeps", substeps_rule))
    study.substeps.push_back(static_cast<int>(p));
  if (study.substeps.size() == 1) {
    table.report("substeps", "convergence.substeps has one value, and convergence needs two",
                 "give the numbers of substeps to compare, the finest last: [1, 2, 4, 8]");
  }
  study.component = table.choice<HorizontalComponent>("component", component_names())
                        .value_or(HorizontalComponent::first);
}

}  // namespace

bool is_convergence_study(const std::filesystem::path& file) {
  return TomlDocument(file).root().has("convergence");
}

ConvergenceConfig read_convergence_study(const std::filesystem::path& file) {
  TomlDocument document(file);
  const TomlTable root = document.root();
  const TomlTable head = root.required_table("study"), suite = root.required_table("suite");
  ConvergenceConfig study;
  study.file = file;
  study.source_text = document.text();
  study.name = head.required_text("name");
  study.description = head.text("description").value_or("");
  const SuiteChoice chosen = read_suite_choice(suite, file);
  study.suite_file = chosen.file;
  study.records = chosen.records;
  const TomlTable grid = root.required_table("convergence");
  if (grid.exists()) read_grid(grid, study);
  document.finish();
  return study;
}

}  // namespace glissade
