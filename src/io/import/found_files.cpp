// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/found_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>

#include "glissade/core/folder.hpp"
#include "glissade/core/hash.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/sample_faults.hpp"
#include "import/component_name.hpp"
#include "import/search_report.hpp"
#include "records/formats/reading.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 20'000, most_components = 64;

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

bool is_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

/// The files of the inputs.
struct FileSearch {
  std::set<fs::path> files;
  std::vector<LeftOut>& left_out;

  /// @param top real path of the folder that was named
  void add_below(const fs::path& folder, const fs::path& top) {
    for (const fs::path& entry : files_in(folder)) {
      if (is_hidden(entry)) continue;
      const bool is_link = fs::is_symlink(link_status_of(entry));
      const fs::file_status status = status_of(entry);
      if (is_link && (!fs::exists(status) || !is_below(real_path(entry), top)))
        left_out.push_back({entry.string(), "a link out of the folder: name the file"});
      else if (!fs::is_directory(status))
        files.insert(entry);
      else if (!is_link)
        add_below(entry, top);
      if (files.size() > most_files)
        throw InputError({folder.string(), fmt::format("has more than {} files", most_files),
                          "name the folder that holds the records", ""});
    }
  }
};

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

void take_direction(FoundComponent& found, const FileComponent& component,
                    const RecordFormat& format) {
  const std::string stated = stated_direction(component, format, found.file_name());
  if (!stated.empty())
    found.header.direction = stated;
  else if (found.header.direction.empty())
    found.header.direction = component.name;
  if (stated.empty() && found.address.empty())
    found.suggested_direction = split_direction(stem_of(found.file_name()), std::nullopt).direction;
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
  take_direction(found, component, format);
  for (std::string* text :
       {&found.header.event, &found.header.station, &found.header.direction, &found.header.unit,
        &found.header.event_id, &found.header.magnitude_kind, &found.header.location,
        &found.header.channel, &found.suggested_direction})
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
  FileSearch search{{}, left_out};
  ProblemList problems;
  for (const fs::path& input : inputs) {
    const fs::file_status status = status_of(input);
    if (!fs::exists(status))
      problems.add({input.string(), "No such file or directory", "name a folder or files", ""});
    else if (fs::is_directory(status))
      search.add_below(input, real_path(input));
    else
      search.files.insert(input);
  }
  problems.throw_if_any();
  return {search.files.begin(), search.files.end()};
}

std::vector<FoundComponent> read_components(const FileToRead& file,
                                            const RecordFileOptions& missing) {
  const RecordText text = record_text(file.shown(), file.bytes);
  const RecordFormat& format = format_of(text);
  if (!format.is_binary && is_search_report(text.text))
    refuse_record(file.shown(), "is a report of a search", "give it with --report " + file.shown());
  RecordFileOptions options = missing;
  options.component = "1";
  std::vector<FileComponent> components = format.read(text, options);
  if (components.size() > most_components)
    refuse_record(file.shown(), fmt::format("has {} components", components.size()),
                  "name those of the record in a suite file: file#name");
  std::vector<FoundComponent> found;
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i].record.acceleration_mps2.empty()) {  // a table is read column by column
      options.component = std::to_string(i + 1);
      components[i] = format.read(text, options)[i];
    }
    check_readable(components[i].record);
    found.push_back(
        found_component(file, format, components[i], address_of(text.path, components, i)));
    found.back().stated_dt_s = missing.dt_s;
  }
  const std::string sha256 = sha256_of(file.bytes);
  for (FoundComponent& component : found) component.sha256 = sha256;
  return found;
}

}  // namespace glissade
