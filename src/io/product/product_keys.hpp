// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/design/product.hpp"
#include "keys/key.hpp"

namespace glissade {

/// The keys of a product file that a study has not: those of [product] and [hazard], and of each
/// [[target]]. `value` is an example.
const std::vector<KeyTable<Product>>& product_tables();
const KeyTable<DesignTarget>& product_target_table();
const std::vector<GrammarKey>& product_grammar();

}  // namespace glissade
