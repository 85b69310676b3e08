// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

// Parts of the report on the shape of the fragilities.
namespace glissade {

std::string model_name(ShapeModel model);
/// The model with the highest score; none where models were not compared.
std::optional<ShapeModel> best_model(const ThresholdShape& shape);
/// Whether its score differs from the lognormal's by more than two standard errors.
bool differs_clearly(const ThresholdShape& shape, ShapeModel model);

Table shape_table(const Results& results);            ///< a row per threshold
Table shape_models_table(const Results& results);     ///< per threshold and model
Table shape_levels_table(const Results& results);     ///< per threshold and level
Table shape_crossings_table(const Results& results);  ///< neighbouring thresholds
Table shape_surface_table(const Results& results);    ///< beside the separate fits

Figure shape_figure(const Results& results);

}  // namespace glissade
