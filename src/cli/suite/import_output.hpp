// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "glissade/io/suite_import.hpp"
#include "glissade/report/table.hpp"

namespace glissade::cli {

/// The options --units and --dt-s, of files that do not state theirs.
struct MissingOptions {
  std::string units;
  std::optional<double> dt_s;
  void add_to(CLI::App& command);
  /// Throws InputError, naming the option.
  RecordFileOptions of_files() const;
};

/// What was read of each file: component, step, unit, PGA, processed or not.
Table components_table(const SuiteImport& found);
/// The channels of structures, by location; no rows where there are none.
Table channels_table(const SuiteImport& found);
void put_warnings(const SuiteImport& found);
/// Each file that is left out and why; no lines where there are none.
std::string left_out_text(const SuiteImport& found);
void put_left_out(const SuiteImport& found);

}  // namespace glissade::cli
