// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/family.hpp"
#include "analysis/conditions/view.hpp"
#include "glissade/report/base_shear_report.hpp"

namespace glissade {
namespace {

using enum ConditionAxis;

/// Fig. 16: base shear over the period by support.
Figure by_support_figure(const Results& results) {
  const ConditionGrid grid(results);
  const View view =
      medians_over(results, period, base_shear_table(results), shown_along(grid, support),
                   [&](const Condition& at) { return label_of(grid, support, at); });
  return {"base_shear",
          grid.has_several(support) ? "Base shear of the building: array isolated, anchored, none"
                                    : "Base shear of the building",
          below_text(results),
          "After Walters et al. (2012), Fig. 16. Mean over the suite of each history's SRSS of the "
          "peak base shears along both axes, over the weight of the building without the array.",
          {means_panel(
              results, {view}, period_label, {},
              {"Base shear over the building's weight without the array", ColumnKind::number})}};
}

/// The same over that without an array, which must be among the supports.
Figure ratio_figure(const Results& results) {
  const ConditionGrid grid(results);
  Places supports = shown_along(grid, support);
  std::erase_if(supports, [&](const Condition& at) {
    return grid.case_at(at).support == ArraySupport::no_array;
  });
  View view = medians_over(results, period, base_shear_ratio_table(results), supports,
                           [&](const Condition& at) { return label_of(grid, support, at); });
  for (std::size_t i = 0; i < supports.size(); ++i)  // as beside the building without an array
    view.lines[i].look = family_look(i, 3);
  return {"base_shear_ratio",
          "Effect of the array on the base shear of its building",
          below_text(results),
          "The same relative to the building without an array: below 1 the array reduces the base "
          "shear. An anchored array adds its mass.",
          {means_panel(results, {view}, period_label,
                       {{Rule::Kind::horizontal, 1.0, look(Role::reference), "no array"}},
                       {"Base shear over that without an array", ColumnKind::number, false})}};
}

}  // namespace

std::vector<Figure> base_shear_figures(const Results& results) {
  const ConditionGrid grid(results);
  std::vector<Figure> figures;
  if (!grid.has_several(ConditionAxis::period) && !grid.has_several(ConditionAxis::support))
    return figures;
  figures.push_back(by_support_figure(results));
  if (!base_shear_ratio_table(results).rows.empty()) figures.push_back(ratio_figure(results));
  for (Figure& figure : figures) {
    figure.labels_at_lines = true;
    figure.suite = 0;
  }
  return figures;
}

}  // namespace glissade
