// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/family.hpp"
#include "analysis/conditions/view.hpp"
#include "glissade/report/base_shear_report.hpp"

namespace glissade {
namespace {

using enum ConditionAxis;

/// Fig. 16: base shear over the period by support.
Figure by_support_figure(const Results& results) {
  Family family(results, period_label, results.conditions->grid.period_s);
  const Places supports = shown_along(results.conditions->grid, support);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    family.add(label_of(results.conditions->grid, support, i), family_look(i, supports.size()),
               along(results.conditions->grid, period, supports[i]),
               {.number = HistoryNumber::base_shear});
  }
  return {"base_shear",
          has_several(results.conditions->grid, support)
              ? "Base shear of the building: array isolated, anchored, none"
              : "Base shear of the building",
          below_text(results),
          "After Walters et al. (2012), Fig. 16. Mean over the suite of each history's SRSS of the "
          "peak base shears along both axes, over the weight of the building without the array.",
          family.ratios("Base shear over the building's weight without the array")};
}

/// The same over that without an array, which must be among the supports.
Figure ratio_figure(const Results& results) {
  const ConditionGrid& grid = results.conditions->grid;
  const std::size_t bare = *place_of(grid, ArraySupport::no_array);
  Family family(results, period_label, grid.period_s);
  std::size_t drawn = 0;
  for (const ArraySupport kind : {ArraySupport::isolated, ArraySupport::anchored}) {
    const auto place = place_of(grid, kind);
    if (!place) continue;
    std::vector<std::vector<double>> ratios;
    for (const Condition& at : shown_along(grid, period))
      ratios.push_back(ratios_by_orientation(results, {.number = HistoryNumber::base_shear},
                                             at.with(support, *place), at.with(support, bare)));
    family.add_numbers(label_of(grid, support, *place), family_look(drawn++, 3), ratios);
  }
  family.add_level(1.0, "no array", look(Role::reference));
  return {"base_shear_ratio", "Effect of the array on the base shear of its building",
          below_text(results),
          "The same relative to the building without an array: below 1 the array reduces the base "
          "shear. An anchored array adds its mass.",
          family.ratios("Base shear over that without an array", Family::From::lowest)};
}

}  // namespace

std::vector<Figure> base_shear_figures(const Results& results) {
  const ConditionGrid& grid = results.conditions->grid;
  std::vector<Figure> figures;
  if (!has_several(grid, ConditionAxis::period) && !has_several(grid, ConditionAxis::support))
    return figures;
  figures.push_back(by_support_figure(results));
  if (has_several(grid, ConditionAxis::support) && place_of(grid, ArraySupport::no_array))
    figures.push_back(ratio_figure(results));
  for (Figure& figure : figures) figure.labels_at_lines = true;
  return figures;
}

}  // namespace glissade
