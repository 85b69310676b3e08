// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade {

class StationMetadata;

enum class AccelerationUnits { g, mps2, cmps2 };

/// "g", "m/s2", "cm/s2" or "gal"; InputError otherwise.
AccelerationUnits parse_acceleration_units(const std::string& text);
std::string to_string(AccelerationUnits units);

/// What a file does not state, or states wrongly.
struct RecordFileOptions {
  /// The step. Mends one an AT2 header prints with too few decimals (`DT= .0039` is 1/256), by 2 %
  /// at most; must agree with a time column; needed for one column. > 0.
  std::optional<double> dt_s;
  /// The units; must agree with a header that names them.
  std::optional<AccelerationUnits> units;
  /// Of a file that states none, where `units` is not given either: those of its suite.
  std::optional<AccelerationUnits> units_if_not_stated = std::nullopt;
  /// Of a file of several components: the name or the number of one. With no other it is an error.
  /// Of an archive: the file in it, and its component behind #.
  std::string component = {};
  /// Counts of the recorder for one of `units`, of files that hold counts (miniSEED, COSMOS V0). >
  /// 0.
  std::optional<double> counts_per_unit = std::nullopt;
  /// StationXML, of channels of miniSEED whose gain is not stated; nullptr: none.
  const StationMetadata* stations = nullptr;
};

/// "floor.csv" and "U1" of "floor.csv#U1", "all.zip" and "a.csv#U1" of "all.zip#a.csv#U1": a file
/// that is there and what follows, else up to the last #; no component where the whole is a file.
struct ComponentAddress {
  std::string file, component;
};
ComponentAddress split_address(const std::string& name);

/// Reads one component of a file, or of a file in an archive (zip, tar, gzip), in any of the
/// formats of suites/README.md, recognised by content and not by name: PEER AT2, K-NET, ESM,
/// COSMOS, CSMIP, SMC, GeoNet, SAC, miniSEED and others, tables with a heading, and plain columns.
/// Units and step are those of its header; what it does not state the options must, and nothing is
/// assumed.
/// - one column: accelerations.
/// - two columns: time (s) and acceleration, separated by blanks, tabs or a comma. The times must
/// be evenly spaced to the decimals they are printed with; the step is (last - first) / (n - 1), to
/// the fewest decimals that give the last time, or a whole rate that does (1/256 s).
/// In text files `#` begins a comment. Lines above the first sample may state units ("units: m/s2",
/// "# time_s acceleration_g"), the step ("DT = 0.01", "Sampling rate: 100 Hz") and the number of
/// samples ("npts: 5590").
///
/// Throws InputError (file:line, value, rule, what to do) for anything else, for values that are no
/// finite numbers, for counts that differ from the stated ones, for units that are not stated, for
/// velocities, displacements, spectra and seismometers, and for a column that begins with its count
/// or its step. The options have the names of a suite's keys there: dt_s, units, counts_per_unit.
/// What was found or changed in reading is in the record's notes.
Record read_record(const std::filesystem::path& file, const RecordFileOptions& options = {});

/// Clockwise from north, where the file of a horizontal component states it.
std::optional<double> stated_azimuth_deg(const Record& record);
bool is_stated_vertical(const Record& record);
/// In place of the one that its file states.
void state_direction(Record& record, const std::string& direction);

/// What the sources of a motion's components contradict: two stations, horizontals that are not
/// perpendicular. InputError for a component that its file states as the vertical, given as a
/// horizontal, and for the reverse. Of files that state neither: nothing.
std::vector<std::string> source_contradictions(const TimedRecord& first,
                                               const std::optional<TimedRecord>& second,
                                               const std::optional<TimedRecord>& vertical);

}  // namespace glissade
