// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/suite_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "glissade/core/error.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/io/recipe_writer.hpp"
#include "suites/record_entry.hpp"
#include "toml/toml_text.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

struct Library {
  std::optional<AccelerationUnits> units;  ///< of files that do not state theirs
  std::map<std::string, RecordEntry> entries;
};

Library read_library(const fs::path& file) {
  TomlDocument document(file);
  document.root().ignore_unknown();
  const TomlTable head = document.root().table("suite");
  head.ignore_unknown();
  Library library{read_units(head), {}};
  const MotionProcessing of_all = read_processing(document.root());
  for (const TomlTable& record : document.root().tables("record")) {
    RecordEntry entry = read_record_entry(record);
    entry.processing = entry.processing.or_else(of_all);
    for (const char* key : {"first", "second", "vertical"}) {
      if (auto component = read_component_entry(record, key))
        entry.components[key] = std::move(*component);
    }
    const std::string id = entry.metadata.id;
    library.entries[id] = std::move(entry);
  }
  document.finish();
  return library;
}

/// How a file of the library is named in a suite file in `folder`.
std::string renamed(const std::string& name, const fs::path& library, const fs::path& folder) {
  const fs::path beside = library.parent_path() / name;
  if (fs::path(name).is_absolute()) return name;
  if (!fs::exists(status_of(beside))) {
    const auto [file, component] = split_address(name);
    return component.empty() ? name : renamed(file, library, folder) + "#" + component;
  }
  return relative_path(beside, folder);
}

std::string target_of(const std::optional<StatedTarget>& head, const fs::path& library,
                      const fs::path& folder) {
  TomlDocument document(library);
  if (!head && !document.root().has("target")) return "";
  const StatedTarget stated = head ? *head : read_stated_target(library);
  if (stated.target.period_s.empty()) return target_toml(stated.target);
  return fmt::format("[target]\nedition = {}\nspectrum = {}\n",
                     quoted(to_string(stated.target.edition)),
                     path_from(stated.spectrum_file, folder));
}

InputError no_entry(const fs::path& library, const std::string& id) {
  return InputError({library.string(), "has no entry \"" + id + "\"",
                     "name records that are in the library", ""});
}

/// The recipe of some of its motions.
std::string suite_of_motions_toml(const fs::path& library, const SuiteHead& head,
                                  const std::vector<ScaledRecord>& records) {
  SyntheticRecipe recipe = glissade::read_recipe(library);
  recipe.name = head.name;
  recipe.description = head.description;
  recipe.nearest_to_target = head.nearest_to_target;
  if (head.target) recipe.target = head.target->target;
  std::vector<SyntheticMotion> motions;
  for (const ScaledRecord& record : records) {
    const auto found = std::ranges::find(recipe.motions, record.id, &SyntheticMotion::id);
    if (found == recipe.motions.end()) throw no_entry(library, record.id);
    motions.push_back(*found);
    motions.back().scale = record.scale;
  }
  recipe.motions = std::move(motions);
  return recipe_toml(recipe, head.comments);
}

}  // namespace

std::string suite_of_records_toml(const fs::path& library, const SuiteHead& head,
                                  const std::vector<ScaledRecord>& records,
                                  const fs::path& folder) {
  if (is_recipe(library)) return suite_of_motions_toml(library, head, records);
  const auto [units, entries] = read_library(library);
  std::string text;
  for (const std::string& comment : head.comments) text += "# " + comment + "\n";
  text += fmt::format("\n[suite]\nname = {}\ndescription = {}\n{}{}\n{}", quoted(head.name),
                      quoted(head.description),
                      head.nearest_to_target ? "selection = \"nearest_to_target\"\n" : "",
                      units ? fmt::format("units = {}\n", quoted(to_string(*units))) : "",
                      target_of(head.target, library, folder));
  for (const ScaledRecord& record : records) {
    const auto found = entries.find(record.id);
    if (found == entries.end()) throw no_entry(library, record.id);
    RecordEntry entry = found->second;
    entry.metadata.scale = record.scale;
    for (auto& [key, component] : entry.components)
      component.file = renamed(component.file, library, folder);
    text += record_toml(entry);
  }
  return text;
}

}  // namespace glissade
