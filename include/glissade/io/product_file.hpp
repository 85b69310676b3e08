// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "glissade/design/product.hpp"

namespace glissade {

/// A product file: a study file with [product] and a [[target]] for each site in place of [study]
/// and [intensity]. Throws InputError with what is wrong, also in the study.
Product read_product(const std::filesystem::path& file);

/// Whether the file has the [product] of a product file. Throws InputError where it is not TOML.
bool is_product(const std::filesystem::path& file);

/// The study of a target: the chart of the rest of the file at its levels. A study file, whose
/// paths are relative to `folder`.
std::string product_study(const Product& product, std::size_t target,
                          const std::filesystem::path& folder);

}  // namespace glissade
