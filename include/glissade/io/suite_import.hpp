// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glissade/io/record_file.hpp"
#include "glissade/io/record_header.hpp"

// From folders of record files, as they are downloaded, to a suite.
namespace glissade {

struct ImportOptions {
  std::vector<std::filesystem::path> inputs;  ///< files, archives, folders with all below them
  std::optional<std::filesystem::path> report;
  RecordFileOptions missing;  ///< units_if_not_stated; dt_s, which no file may contradict
  bool trim = false;          ///< to the end of the shortest component
  bool resample = false;      ///< to the shortest step of the components
  bool keep_single = false;   ///< records with one horizontal
  /// Directions that nothing states are those that the files' names suggest.
  bool directions_from_names = false;
  /// Motions of a roof: of the channels of a structure whose location has these words ("roof"), or
  /// that have these numbers ("7, 8"). Nothing: motions of the ground.
  std::optional<std::string> roof = std::nullopt;
};

/// A component as it was read, without its samples.
struct FoundComponent {
  std::filesystem::path file;
  std::string member;   ///< of an archive, the file in it
  std::string address;  ///< behind the file: "#2"; empty: the only one
  std::string name;     ///< as the file names it; may be empty
  std::string format;
  RecordHeader header;
  std::string suggested_direction;  ///< by the file's name alone, where nothing states it
  double dt_s = 0.0;
  std::size_t samples = 0;
  double pga_g = 0.0;
  bool is_dead = false;  ///< all samples of one value
  std::vector<std::string> notes, faults;
  std::string sha256;                     ///< of the file, in an archive of the member
  std::uint64_t samples_hash = 0;         ///< of step and samples
  std::optional<double> stated_dt_s;      ///< by the options, which the file does not contradict
  std::optional<double> counts_per_mps2;  ///< by StationXML among the files

  /// Without folders.
  std::string file_name() const {
    return (member.empty() ? file : std::filesystem::path(member)).filename().string();
  }
  std::string shown() const { return file_name() + address; }
  /// Nothing states its direction, and that of the name was taken.
  bool has_direction_of_name() const {
    return !suggested_direction.empty() && suggested_direction == header.direction;
  }
  /// A channel that states a location other than the free field.
  bool is_of_structure() const;
  /// What a suite names.
  std::string whole_address() const { return (member.empty() ? "" : "#" + member) + address; }
};

struct LeftOut {
  std::string what;    ///< a file, a component or a record of the report
  std::string reason;  ///< and what to do
};

/// A record of the suite: its components by their position in the list of those that were found.
struct ImportedRecord {
  std::string id, event, station;
  double magnitude = 0.0, distance_km = 0.0, vs30_mps = 0.0, scale = 0.0;  ///< 0: not stated
  std::string magnitude_kind, distance_kind;
  std::array<std::optional<std::size_t>, 3> components;  ///< first, second, vertical
  std::optional<double> step_s, end_s;                   ///< where it is resampled, or trimmed
  std::vector<std::string> warnings;
};

struct SuiteImport {
  std::vector<FoundComponent> components;  ///< all that could be read
  std::vector<ImportedRecord> records;
  std::vector<LeftOut> left_out;
  std::vector<std::string> warnings;  ///< of the report
};

/// Reads every file, with the gains of StationXML among them, and puts components of one station
/// and event together, by their headers, the report and their names; what is not processed beside
/// its processed version, channels of a structure (or, with `roof`, all others), what is no record
/// and what belongs to none is left out, with the reason. Throws InputError where an input or the
/// report is not there, there are too many files, or `roof` names no channel; IoError where a file
/// or a folder cannot be read.
SuiteImport import_suite(const ImportOptions& options);

/// Whether a path is to be read as a suite file: named .toml, or with a line [suite]; not a folder
/// or a record.
bool is_suite_file(const std::filesystem::path& path);

struct ImportedSuiteHead {
  std::string name;
  std::vector<std::string> comments;       ///< lines at the head of the file
  std::optional<AccelerationUnits> units;  ///< of files that do not state theirs
  bool of_roof = false;
};
/// The suite file, to be written into `folder`: files by relative paths, with their SHA-256.
std::string imported_suite_toml(const SuiteImport& found, const ImportedSuiteHead& head,
                                const std::filesystem::path& folder);

}  // namespace glissade
