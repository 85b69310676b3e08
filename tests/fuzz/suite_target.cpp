// SPDX-License-Identifier: GPL-3.0-or-later
// Suite files: recorded ones (the record "a.txt" is there) and recipes, of which one motion is
// simulated, with the coarsest step: the whole takes seconds. Reports of a search, of which "a.txt"
// may be a record.
#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "check.hpp"
#include "glissade/io/recipe_writer.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/io/suite_import.hpp"

namespace {

using glissade::fuzz::check;

bool all_finite(std::span<const double> samples) {
  return std::all_of(samples.begin(), samples.end(), [](double a) { return std::isfinite(a); });
}

void check_motions(const glissade::Suite& suite) {
  check(!suite.motions.empty(), "a suite has motions");
  for (const glissade::Motion& motion : suite.motions) {
    const auto& [first, second] = motion.horizontal_mps2;
    check(motion.dt_s > 0.0 && !first.empty(), "a motion has a step and a first component");
    check(second.empty() || second.size() == first.size(), "components are equally long");
    check(all_finite(first) && all_finite(second) && all_finite(motion.vertical_mps2),
          "samples are finite");
  }
}

/// What is read is written and read again unchanged.
void check_round_trip(const glissade::SyntheticRecipe& recipe) {
  const std::string text = recipe_toml(recipe, {"fuzz"});
  const auto copy = glissade::fuzz::folder().write("copy.toml", text);
  check(recipe_toml(glissade::read_recipe(copy), {"fuzz"}) == text, "a recipe survives its file");
}

/// What the reader takes can be simulated.
void check_first_motion(glissade::SyntheticRecipe recipe) {
  recipe.dt_s = 0.05;
  recipe.motions.resize(1);
  check_motions(simulate_suite(recipe));
}

/// What is imported with a report is a suite that can be read.
void check_import(const std::filesystem::path& report, const std::filesystem::path& record) {
  glissade::ImportOptions options;
  options.inputs = {record};
  options.report = report;
  options.keep_single = true;
  options.missing.units_if_not_stated = glissade::AccelerationUnits::mps2;
  const glissade::SuiteImport found = import_suite(options);
  if (found.records.empty()) return;
  const auto suite = glissade::fuzz::folder().write(
      "imported.toml", imported_suite_toml(found, {"fuzz", {}, options.missing.units_if_not_stated},
                                           record.parent_path()));
  try {
    check_motions(glissade::load_suite(suite));
  } catch (const glissade::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    check(false, "an imported suite can be read");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto record =
      glissade::fuzz::folder().write("a.txt", "0 0.1\n0.01 -0.2\n0.02 0.05\n");
  const auto file = glissade::fuzz::input_file(data, size, "suite.toml");
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (text.find("Record Sequence Number") != std::string_view::npos ||
      text.find("event_id") != std::string_view::npos) {
    glissade::fuzz::may_refuse([&] { check_import(file, record); });
  } else if (text.find("simulation") == std::string_view::npos) {
    glissade::fuzz::may_refuse([&] { check_motions(glissade::load_suite(file)); });
  } else {
    glissade::fuzz::may_refuse([&] {
      const glissade::SyntheticRecipe recipe = glissade::read_recipe(file);
      try {
        check_round_trip(recipe);
        check_first_motion(recipe);
      } catch (const glissade::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        check(false, "a recipe that is taken can be written, read and simulated");
      }
    });
  }
  return 0;
}
