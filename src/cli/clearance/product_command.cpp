// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <optional>

#include "clearance/calculation_folder.hpp"
#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/io/product_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/parallel/together.hpp"
#include "glissade/report/product_sheet.hpp"
#include "shared/build.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> studies_of(const Product& product) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < product.targets.size(); ++i)
    names.push_back(fmt::format("target_{}", i + 1));
  return names;
}

void write(const Product& product, CalculationFolder& folder, const Communicator& world) {
  const std::vector<std::string> studies = studies_of(product);
  ProductSheet sheet{.product = product,
                     .is_simulated = record_files(product.suite).empty(),
                     .product_sha256 = folder.identity().project_sha256,
                     .suite_sha256 = sha256_of_file(product.suite),
                     .build = build_text()};
  for (std::size_t i = 0; i < studies.size(); ++i) {
    const Results results = read_results(folder.path() / studies[i] / "results.h5");
    sheet.targets.push_back(sheet_target(product, product.targets[i], results));
    sheet.program_version = results.program_version;
  }
  bool is_printed = false;
  folder.finish(
      [&] { is_printed = write_product_sheet(sheet, folder.path()); },
      [&] { write_finished_product(folder.identity(), sheet, world.size(), folder.path()); });
  put("{}\nSheet    {}\n", sheet_screen(sheet), page_text(folder.path(), "product", is_printed));
}

}  // namespace

void run_product(const ClearanceOptions& options, const Communicator& world) {
  CalculationFolder folder(options, world, "product");
  std::optional<Product> product;  // on root
  std::vector<char> count;         // one for each target
  folder.begin([&](const fs::path& file) {
    product = read_product(file);
    return studies_of(*product);
  });
  if (product) count.assign(product->targets.size(), 0);
  world.broadcast(count);
  try {
    for (std::size_t i = 0; i < count.size(); ++i)
      folder.run(fmt::format("target_{}", i + 1),
                 [&] { return product_study(*product, i, folder.path()); });
    on_root(world, [&] { write(*product, folder, world); });
  } catch (const ExitStatus& exit) {
    if (world.is_root()) folder.leave(exit.status);
    throw;
  }
}

}  // namespace glissade::cli
