// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "glissade/report/table.hpp"
#include "glissade/study/analysis/model_uncertainty.hpp"

namespace glissade {

/// A number that a table has three times: at both ends, and as calculated.
struct NumberAtEnds {
  Column column;
  AtEnds PremiseEffect::*numbers;
  std::function<Cell(double)> cell;
};
/// Of a study and of a calculation package: what each premise changes, and the records.
Table model_uncertainty_table(const std::vector<ModelUncertainty>& all, const std::string& title,
                              const std::vector<NumberAtEnds>& numbers);
/// "records decide (building period: 41 %; records, 95 % interval: 62 %)", where the interval of
/// the records is known.
std::string deciding_text(const ModelUncertainty& uncertainty);

}  // namespace glissade
