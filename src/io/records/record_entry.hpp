// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "glissade/io/record_file.hpp"
#include "glissade/motion/motion.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// A component of a [[record]].
struct ComponentEntry {
  std::string file;  ///< with #component, as written
  double start_s = 0.0;
  RecordFileOptions options;
};

/// The units that a table states by the key `units`.
std::optional<AccelerationUnits> read_units(const TomlTable& table);

/// `key = "file"` or `key = { file, start_s, dt_s, units, counts_per_unit }`; nothing where the key
/// is absent.
std::optional<ComponentEntry> read_component_entry(const TomlTable& record, const char* key);

/// What a [[record]] states of its motion besides the samples.
Motion read_metadata(const TomlTable& record);

}  // namespace glissade
