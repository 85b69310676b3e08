// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "suite/conditional_options.hpp"

namespace glissade::cli {

/// A selection of records to a conditional spectrum.
struct ConditionalRequest {
  std::string library, out, figures;  ///< the latter two: empty, none is written
  ConditionalOptions target;
  SelectionCriteria criteria;
  std::uint64_t seed = 1;
  bool json = false, overwrite = false;
};
void select_to_conditional(const ConditionalRequest& request);

}  // namespace glissade::cli
