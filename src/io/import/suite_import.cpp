// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/suite_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <iterator>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/core/printable.hpp"
#include "import/component_name.hpp"
#include "import/found_files.hpp"
#include "import/pairing.hpp"
#include "records/formats/reading.hpp"
#include "records/packed_files.hpp"
#include "records/station_metadata.hpp"
#include "suites/record_entry.hpp"
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

/// The report that was given, of an archive one in it.
struct GivenReport {
  explicit GivenReport(const fs::path& given) {
    const ComponentAddress address = split_address(given.string());
    RecordStore store;
    const RecordStore::Found found = store.find(address.file, address.component);
    content =
        read_search_report({found.path, std::string(record_text(found.path, *found.bytes).text)});
    file = address.file;
    member = address.component;
  }
  bool is(const FileToRead& read) const {
    std::error_code error;
    const bool is_same =
        read.member == member && (read.file == file || fs::equivalent(read.file, file, error));
    if (error && error.value() != ENOTSUP && error.value() != ENOSYS)  // of two pipes
      throw_read_error(read.file, "cannot be looked up", error.value());
    return is_same;
  }

  SearchReport content;
  fs::path file;
  std::string member;
};

/// The file itself, or each file in an archive.
template <class Take>
void for_each_member(const fs::path& file, std::vector<LeftOut>& left_out, Take take) {
  try {
    const std::string bytes = read_text_file(file);
    if (!is_archive(bytes)) return take(FileToRead{file, "", bytes});
    std::ranges::move(unpack(file, bytes,
                             [&](const PackedFile& member) {
                               take(FileToRead{file, member.name, member.bytes});
                             }),
                      std::back_inserter(left_out));
  } catch (const IoError&) {  // says nothing of what it holds
    throw;
  } catch (const InputError& error) {
    left_out.push_back({file.string(), reason_of(error)});
  }
}

/// The gains of all StationXML; what cannot be read is reported with the components.
StationMetadata stations_of(const std::vector<fs::path>& files) {
  StationMetadata stations;
  std::vector<LeftOut> reported_later;
  for (const fs::path& file : files) {
    for_each_member(file, reported_later, [&](const FileToRead& member) {
      const RecordText text{member.shown(), member.bytes};
      try {
        if (is_station_xml(text)) stations.add(text);
      } catch (const InputError& error) {
        reported_later.push_back({member.shown(), reason_of(error)});
      }
    });
  }
  return stations;
}

/// The components of files, or the reasons why they have none.
class ComponentReader {
 public:
  ComponentReader(const ImportOptions& options, const std::optional<GivenReport>& report,
                  SuiteImport& found)
      : options_(options),
        report_(report),
        found_(found),
        files_(found_files(options.inputs, found.left_out)) {}

  void add_all() {
    for (const fs::path& file : files_) {
      if (printable_name(file.string()) != file.string())
        found_.left_out.push_back(
            {file.string(), "its name has control characters or is no UTF-8: rename it"});
      else
        for_each_member(file, found_.left_out, [&](const FileToRead& member) { add(member); });
    }
  }

 private:
  void add(const FileToRead& file) {
    if (report_ && report_->is(file)) return;
    try {
      constexpr std::size_t looked_at = 1000;
      const RecordText beginning{file.shown(), std::string_view(file.bytes).substr(0, looked_at)};
      if (is_station_xml(beginning)) return StationMetadata().add({file.shown(), file.bytes});
      if (miniseed_format.matches(beginning) && !stations_) {  // which alone needs them
        stations_ = stations_of(files_);
        options_.missing.stations = &*stations_;
      }
      for (FoundComponent& component : read_components(file, options_.missing)) {
        if (options_.directions_from_names && !component.suggested_direction.empty())
          component.header.direction = component.suggested_direction;
        found_.components.push_back(std::move(component));
      }
    } catch (const InputError& error) {
      found_.left_out.push_back({file.shown(), reason_of(error)});
    }
  }

  ImportOptions options_;
  const std::optional<GivenReport>& report_;
  SuiteImport& found_;
  std::vector<fs::path> files_;
  std::optional<StationMetadata> stations_;
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
  const fs::file_status status = status_of(path);
  if (fs::is_directory(status)) return false;
  if (path.extension() == ".toml" || !fs::exists(status)) return true;
  const std::string text = read_text_file(path);
  for (LineReader lines(text); lines.next();)
    if (trimmed(lines.line()).starts_with("[suite]")) return true;
  return false;
}

SuiteImport import_suite(const ImportOptions& options) {
  std::optional<GivenReport> report;
  if (options.report) report.emplace(*options.report);
  SuiteImport found;
  ComponentReader(options, report, found).add_all();
  if (report) found.warnings = report->content.warnings;
  pair_components(found, report ? &report->content : nullptr, options);
  return found;
}

std::string imported_suite_toml(const SuiteImport& found, const ImportedSuiteHead& head,
                                const fs::path& folder) {
  std::string text;
  for (const std::string& comment : head.comments) text += "# " + printable_name(comment) + "\n";
  text += fmt::format("\n[suite]\nname = {}\n", quoted(head.name));
  if (head.of_roof) text += "motions = \"roof\"\n";
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
