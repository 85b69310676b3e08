// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "study/grammar.hpp"

namespace glissade {

/// The keys of a product file that a study has not.
const std::vector<GrammarKey>& product_grammar();

}  // namespace glissade
