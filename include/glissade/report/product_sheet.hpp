// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/design/product.hpp"

// The product sheet of a manufacturer: design displacements to read by site, slope and friction.
namespace glissade {

/// What the sheet has of the study of a target.
struct SheetTarget {
  ProductTarget target;
  TargetDisplacements found;
  std::string counted;  ///< how a displacement is counted, of which buildings
  std::string suite, kernel, plan_hash;
  std::vector<std::string> warnings;
  std::vector<RecordSummary> records;
};
SheetTarget sheet_target(const Product& product, const ProductTarget& target,
                         const Results& results);

struct ProductSheet {
  const Product& product;
  std::vector<SheetTarget> targets;
  bool is_simulated = false;  ///< its motions
  std::string product_sha256, suite_sha256, program_version, build;
};

/// The design displacements, in plain ASCII.
std::string sheet_screen(const ProductSheet& sheet);

/// Writes out_dir/product.html and product.xlsx, with tables beside them, in the place of earlier
/// ones (results_folder.hpp), and prints the page to product.pdf: false where WeasyPrint is not
/// installed.
bool write_product_sheet(const ProductSheet& sheet, const std::filesystem::path& out_dir);

}  // namespace glissade
