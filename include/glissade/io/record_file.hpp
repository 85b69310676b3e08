// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"

namespace glissade {

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
};

/// Reads one component, recognised by content and not by name:
/// - PEER AT2: header lines, one of which has NPTS and DT (`NPTS=  5590, DT=   .0100 SEC,` or `7997
/// 0.0050 NPTS, DT`),
///   then any number of values a line. Velocities and displacements (VT2, DT2) are an error that
///   says so.
/// - one column: accelerations.
/// - two columns: time (s) and acceleration, separated by blanks, tabs or a comma. The times must
/// be evenly spaced to
///   the decimals they are printed with; the step is (last - first) / (n - 1), to the fewest
///   decimals that give the last time.
/// In text files `#` begins a comment. Comments before the first sample may state units ("# units:
/// m/s2", "# time_s acceleration_g"), the step ("# DT = 0.01") and the number of samples ("# NPTS =
/// 5590").
///
/// Throws InputError (file:line, value, rule, what to do) for anything else, for values that are no
/// finite numbers, for counts that differ from NPTS, for units that are not stated, and for a
/// column that begins with its count or its step. The options have the names of a suite's keys
/// there: dt_s, units.
Record read_record(const std::filesystem::path& file, const RecordFileOptions& options = {});

/// What the sources of a motion's components contradict: two stations, a vertical component as a
/// horizontal one or the reverse, horizontals that are not perpendicular. Of files that do not
/// state their source: nothing.
std::vector<std::string> source_contradictions(const TimedRecord& first,
                                               const std::optional<TimedRecord>& second,
                                               const std::optional<TimedRecord>& vertical);

}  // namespace glissade
