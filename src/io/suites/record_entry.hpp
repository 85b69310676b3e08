// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "glissade/io/record_file.hpp"
#include "glissade/motion/motion.hpp"
#include "glissade/motion/motion_processing.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// A component of a [[record]].
struct ComponentEntry {
  std::string file;  ///< with #component, as written
  double start_s = 0.0;
  std::optional<double> azimuth_deg;  ///< clockwise from north
  RecordFileOptions options;
  std::string sha256 = {};  ///< of the file as it was when the suite was made; empty: any
};

/// A [[record]].
struct RecordEntry {
  Motion metadata;                      ///< without samples
  std::string magnitude_kind;           ///< "Mw", "ML" ...; empty: moment magnitude
  std::string distance_kind;            ///< "joyner_boore", "epicentral"; empty: to the rupture
  std::optional<double> step_s, end_s;  ///< of its components, changed where they differ
  std::optional<double> strike_deg;     ///< of the fault
  MotionProcessing processing;
  std::map<std::string, ComponentEntry> components;  ///< by key
};

/// The units that a table states by the key `units`.
std::optional<AccelerationUnits> read_units(const TomlTable& table);

/// `key = "file"` or `key = { file, start_s, azimuth_deg, dt_s, units, counts_per_unit }`; nothing
/// where the key is absent.
std::optional<ComponentEntry> read_component_entry(const TomlTable& record, const char* key);

/// What a [[record]] states, without its components. A magnitude or distance of another kind than
/// expected is a note of the motion.
RecordEntry read_record_entry(const TomlTable& record);

/// The table `processing` of a suite or of a record.
MotionProcessing read_processing(const TomlTable& above);

/// A [[record]], with all that is stated; numbers are exact.
std::string record_toml(const RecordEntry& entry);

}  // namespace glissade
