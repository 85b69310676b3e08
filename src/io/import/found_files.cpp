// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/found_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>
#include <system_error>

#include "glissade/core/hash.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/sample_faults.hpp"
#include "import/component_name.hpp"
#include "import/search_report.hpp"
#include "records/formats/reading.hpp"
#include "records/packed_files.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 20'000, most_components = 64;

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

/// Where a link leads, or nothing.
std::optional<fs::path> real_path(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  return error ? std::nullopt : std::optional(real);
}

bool is_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

void add_folder(const fs::path& folder, std::set<fs::path>& files, std::vector<LeftOut>& left_out) {
  const fs::path top = real_path(folder).value_or(folder);
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (is_hidden(entry->path())) {
      if (entry->is_directory(ignored)) entry.disable_recursion_pending();
      continue;
    }
    if (entry->is_symlink(ignored)) {
      const auto real = real_path(entry->path());
      if (!real || !is_below(*real, top)) {
        left_out.push_back({entry->path().string(), "a link out of the folder: name the file"});
        continue;
      }
    }
    if (entry->is_directory(ignored)) continue;
    files.insert(entry->path());
    if (files.size() > most_files)
      throw InputError({folder.string(), fmt::format("has more than {} files", most_files),
                        "name the folder that holds the records", ""});
  }
  if (error) throw InputError({folder.string(), "cannot be listed: " + error.message(), "", ""});
}

/// "#U1" by its name, where that names no other, else "#2"; "" of the only one.
std::string address_of(const fs::path& file, const std::vector<FileComponent>& components,
                       std::size_t at) {
  if (components.size() == 1) return "";
  const std::string& name = components[at].name;
  const bool is_word = !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
  });
  try {
    if (is_word && picked_component(file, components, name) == at) return "#" + name;
  } catch (const InputError&) {
    // Two components have this name.
  }
  return fmt::format("#{}", at + 1);
}

/// As the header states it; else by the name of the component, or of the file.
std::string direction_of(const FileComponent& component, const fs::path& file) {
  const std::string& stated = component.header.direction;
  if (component_direction(stated)) return stated;
  if (component_direction(component.name)) return plain_direction(component.name);
  const SplitName name = split_direction(stem_of(file));
  if (!name.direction.empty()) return name.direction;
  return stated.empty() ? component.name : stated;
}

FoundComponent found_component(const FileToRead& file, const RecordFormat& format,
                               const FileComponent& component, const std::string& address) {
  const Record& record = component.record;
  FoundComponent found;
  found.file = file.file;
  found.member = file.member;
  found.address = address;
  found.name = plain_line(component.name);
  found.format = format.name;
  found.header = component.header;
  found.header.direction = direction_of(component, found.file_name());
  for (std::string* text :
       {&found.header.event, &found.header.station, &found.header.direction,
        &found.header.location, &found.header.channel, &found.header.unit, &found.header.event_id,
        &found.header.magnitude_kind})
    *text = plain_line(*text);
  while (found.header.unit.ends_with('.')) found.header.unit.pop_back();
  found.dt_s = record.dt_s;
  found.samples = record.acceleration_mps2.size();
  found.pga_g = peak_ground_acceleration_mps2(record.acceleration_mps2) / standard_gravity_mps2;
  found.is_dead = std::ranges::adjacent_find(record.acceleration_mps2, std::not_equal_to<>()) ==
                  record.acceleration_mps2.end();
  found.counts_per_mps2 = component.counts_per_mps2;
  found.notes = record.notes;
  found.faults = sample_faults({record.acceleration_mps2.data(), found.samples});
  found.samples_hash = Hasher()
                           .number(record.dt_s)
                           .numbers({record.acceleration_mps2.data(), found.samples})
                           .value();
  return found;
}

}  // namespace

std::vector<fs::path> found_files(const std::vector<fs::path>& inputs,
                                  std::vector<LeftOut>& left_out) {
  std::set<fs::path> files;
  ProblemList problems;
  for (const fs::path& input : inputs) {
    std::error_code error;
    if (!fs::exists(input, error))
      problems.add({input.string(), "No such file or directory", "name a folder or files", ""});
    else if (fs::is_directory(input, error))
      add_folder(input, files, left_out);
    else
      files.insert(input);
  }
  problems.throw_if_any();
  return {files.begin(), files.end()};
}

std::vector<FoundComponent> read_components(const FileToRead& file,
                                            const RecordFileOptions& missing) {
  if (is_archive(file.bytes))
    refuse_record(file.shown(), "is an archive in an archive", "unpack it");
  const RecordText text = record_text(file.shown(), file.bytes);
  const RecordFormat& format = format_of(text);
  if (!format.is_binary && is_search_report(text.text))
    refuse_record(file.shown(), "is a report of a search", "give it with --report " + file.shown());
  RecordFileOptions options = missing;
  options.dt_s = std::nullopt;
  std::optional<double> stated_dt_s;
  options.component = "1";
  const auto read = [&] {
    try {
      return format.read(text, options);
    } catch (const InputError&) {
      if (!missing.dt_s || options.dt_s) throw;
      options.dt_s = stated_dt_s = missing.dt_s;
      return format.read(text, options);
    }
  };
  std::vector<FileComponent> components = read();
  if (components.size() > most_components)
    refuse_record(file.shown(), fmt::format("has {} components", components.size()),
                  "name those of the record in a suite file: file#name");
  std::vector<FoundComponent> found;
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i].record.acceleration_mps2.empty()) {  // a table is read column by column
      options.component = std::to_string(i + 1);
      components[i] = read()[i];
    }
    check_readable(components[i].record);
    found.push_back(
        found_component(file, format, components[i], address_of(text.path, components, i)));
    found.back().stated_dt_s = stated_dt_s;
  }
  const std::string sha256 = sha256_of(file.bytes);
  for (FoundComponent& component : found) component.sha256 = sha256;
  return found;
}

}  // namespace glissade
