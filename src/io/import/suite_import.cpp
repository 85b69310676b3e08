// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/suite_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/printable.hpp"
#include "import/component_name.hpp"
#include "import/found_files.hpp"
#include "import/pairing.hpp"
#include "records/packed_files.hpp"
#include "records/record_entry.hpp"
#include "records/station_metadata.hpp"
#include "text/scan.hpp"
#include "toml/toml_text.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// What is wrong with a file, without its name.
std::string reason_of(const InputError& error) {
  const Problem& problem = error.problems().front();
  return problem.what + (problem.suggestion.empty() ? "" : "; " + problem.suggestion);
}

/// A report, of an archive one in it.
std::optional<SearchReport> report_of(const ImportOptions& options) {
  if (!options.report) return std::nullopt;
  const ComponentAddress address = split_address(options.report->string());
  RecordStore store;
  const RecordStore::Found found = store.find(address.file, address.component);
  return read_search_report({found.path, *found.bytes});
}

bool is_same_file(const fs::path& one, const std::optional<fs::path>& other) {
  std::error_code ignored;
  return other && (one == *other || fs::equivalent(one, *other, ignored));
}

std::string beginning_of(const fs::path& file) {
  std::string bytes(1000, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

/// The components of files, or the reasons why they have none.
class ComponentReader {
 public:
  ComponentReader(const ImportOptions& options, SuiteImport& found)
      : options_(options), found_(found) {
    options_.missing.stations = &stations_;
  }

  /// Takes the gains of a file that has them, before the components are read.
  void add_metadata(const fs::path& file) {
    const std::string beginning = beginning_of(file);
    if (!is_archive(beginning) && !is_station_xml({file, beginning})) return;
    try {
      const std::string bytes = read_text_file(file);
      if (!is_archive(bytes)) return stations_.add({file, bytes});
      for (const PackedFile& member : unpacked(file, bytes).files)
        if (is_station_xml({member.name, member.bytes})) stations_.add({member.name, member.bytes});
    } catch (const InputError&) {
      // Reported where the components are read.
    }
  }

  void add_all(const fs::path& file) {
    try {
      const std::string bytes = read_text_file(file);
      if (!is_archive(bytes)) return add({file, "", bytes});
      UnpackedArchive archive = unpacked(file, bytes);
      std::ranges::move(archive.left_out, std::back_inserter(found_.left_out));
      for (const PackedFile& member : archive.files) add({file, member.name, member.bytes});
    } catch (const InputError& error) {
      found_.left_out.push_back({file.string(), reason_of(error)});
    }
  }

 private:
  void add(const FileToRead& file) {
    if (is_same_file(file.shown(), options_.report)) return;
    try {
      if (const RecordText text{file.shown(), file.bytes}; is_station_xml(text))
        return StationMetadata().add(text);
      for (FoundComponent& component : read_components(file, options_.missing))
        found_.components.push_back(std::move(component));
    } catch (const InputError& error) {
      found_.left_out.push_back({file.shown(), reason_of(error)});
    }
  }

  ImportOptions options_;
  SuiteImport& found_;
  StationMetadata stations_;
};

ComponentEntry entry_of(const FoundComponent& component, const fs::path& folder) {
  ComponentEntry entry;
  entry.file = relative_path(component.file, folder) + component.whole_address();
  entry.options.dt_s = component.stated_dt_s;
  if (component.counts_per_mps2) {
    entry.options.units = AccelerationUnits::mps2;
    entry.options.counts_per_unit = component.counts_per_mps2;
  }
  if (const auto direction = component_direction(component.header.direction))
    entry.azimuth_deg = direction->azimuth_deg;
  entry.sha256 = component.sha256;
  return entry;
}

}  // namespace

bool is_suite_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return false;
  if (path.extension() == ".toml" || !fs::exists(path, ignored)) return true;
  const std::string text = read_text_file(path);
  for (LineReader lines(text); lines.next();)
    if (trimmed(lines.line()).starts_with("[suite]")) return true;
  return false;
}

SuiteImport import_suite(const ImportOptions& options) {
  const std::optional<SearchReport> report = report_of(options);
  SuiteImport found;
  ComponentReader reader(options, found);
  const std::vector<fs::path> files = found_files(options.inputs, found.left_out);
  for (const fs::path& file : files) reader.add_metadata(file);
  for (const fs::path& file : files) {
    if (printable_name(file.string()) != file.string()) {
      found.left_out.push_back(
          {file.string(), "its name has control characters or is no UTF-8: rename it"});
      continue;
    }
    reader.add_all(file);
  }
  if (report) found.warnings = report->warnings;
  pair_components(found, report ? &*report : nullptr, options);
  return found;
}

std::string imported_suite_toml(const SuiteImport& found, const ImportedSuiteHead& head,
                                const fs::path& folder) {
  std::string text;
  for (const std::string& comment : head.comments) text += "# " + printable_name(comment) + "\n";
  text += fmt::format("\n[suite]\nname = {}\n", quoted(head.name));
  if (head.units) text += fmt::format("units = {}\n", quoted(to_string(*head.units)));
  constexpr const char* keys[] = {"first", "second", "vertical"};
  for (const ImportedRecord& record : found.records) {
    RecordEntry entry;
    entry.metadata.id = record.id;
    entry.metadata.event = record.event;
    entry.metadata.station = record.station;
    entry.metadata.magnitude = record.magnitude;
    entry.metadata.distance_km = record.distance_km;
    entry.metadata.vs30_mps = record.vs30_mps;
    entry.metadata.scale = record.scale;
    entry.magnitude_kind = record.magnitude_kind == "Mw" ? "" : record.magnitude_kind;
    entry.distance_kind = record.distance_kind == "rupture" ? "" : record.distance_kind;
    entry.step_s = record.step_s;
    entry.end_s = record.end_s;
    for (std::size_t i = 0; i < record.components.size(); ++i)
      if (record.components[i])
        entry.components[keys[i]] = entry_of(found.components[*record.components[i]], folder);
    text += record_toml(entry);
  }
  return text;
}

}  // namespace glissade
