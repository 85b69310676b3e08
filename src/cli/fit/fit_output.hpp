// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/cloud.hpp"
#include "glissade/fragility/goodness_of_fit.hpp"
#include "glissade/fragility/shape.hpp"

// What `glissade fit` prints: text, or one JSON object. A quantity that has no value is left out of
// the text and is null in JSON; the status says why.
namespace glissade::cli {

struct FitOutput {
  FitSummary fit = {};
  GoodnessOfFit lognormal = {};                          ///< of capacities by record
  std::optional<ShapeComparison> models = std::nullopt;  ///< of counts by record
  std::optional<CloudSummary> cloud = std::nullopt;      ///< in place of `fit`
  std::vector<std::string> notes = {};                   ///< beside that of the fit
  std::string warning = {};
};

void print(const FitOutput& output, bool json);

}  // namespace glissade::cli
