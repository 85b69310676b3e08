// SPDX-License-Identifier: GPL-3.0-or-later
#include "suite/import_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "glissade/core/error.hpp"
#include "shared/option_errors.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

double given(double value) { return value > 0.0 ? value : std::nan(""); }

const char* processing(const RecordHeader& header) {
  if (!header.is_processed) return "not stated";
  return *header.is_processed ? "yes" : "no";
}

}  // namespace

void MissingOptions::add_to(CLI::App& command) {
  command.add_option("--units", units, "units of files that do not state theirs: g, m/s2, cm/s2");
  command.add_option("--dt-s", dt_s,
                     "step of files that do not state theirs, or print it with too few digits");
}

RecordFileOptions MissingOptions::of_files() const {
  RecordFileOptions options;
  if (dt_s && !(std::isfinite(*dt_s) && *dt_s > 0.0))
    throw InputError({"--dt-s", fmt::format("{} s is not above 0", *dt_s), "give the step", ""});
  options.dt_s = dt_s;
  if (!units.empty())
    options.units_if_not_stated =
        of_option("--units", [&] { return parse_acceleration_units(units); });
  return options;
}

Table components_table(const SuiteImport& found) {
  Table table{"components",
              "As read of each file; processed as its header states.",
              {text_column("file", "File"),
               text_column("component", "Component"),
               text_column("location", "Location"),
               detail(text_column("format", "Format")),
               text_column("unit", "Unit"),
               {"dt", "s", "Step, s", ColumnKind::number, "", false, 4},
               {"samples", "", "Samples", ColumnKind::count},
               {"pga", "g", "PGA, g", ColumnKind::number, "", false, 4},
               text_column("processed", "Processed"),
               detail(text_column("event", "Event")),
               detail(text_column("station", "Station")),
               detail({"magnitude", "", "M", ColumnKind::number, "", false, 2}),
               detail(text_column("magnitude_kind", "Magnitude is")),
               detail({"epicentral", "km", "Epicentral distance, km"}),
               detail({"vs30", "mps", "Vs30, m/s", ColumnKind::number, "", false, 0}),
               detail(text_column("notes", "Notes"))},
              {}};
  for (const FoundComponent& c : found.components) {
    const RecordHeader& h = c.header;
    std::vector<std::string> notes = c.notes;
    notes.insert(notes.end(), c.faults.begin(), c.faults.end());
    const std::string direction =
        c.suggested_direction.empty() ? h.direction : c.suggested_direction + " by its name";
    table.add({c.shown(), direction, h.location, c.format, h.unit.empty() ? "not stated" : h.unit,
               c.dt_s, static_cast<double>(c.samples), c.pga_g, std::string(processing(h)), h.event,
               h.station, given(h.magnitude), h.magnitude_kind, given(h.epicentral_km),
               given(h.vs30_mps), fmt::format("{}", fmt::join(notes, "; "))});
  }
  const bool has_locations = std::ranges::any_of(
      found.components, [](const FoundComponent& c) { return !c.header.location.empty(); });
  return has_locations ? table : table.without("location");
}

void put_warnings(const SuiteImport& found) {
  for (const std::string& warning : found.warnings) put_warning("the report " + warning);
  for (const ImportedRecord& record : found.records)
    for (const std::string& warning : record.warnings) put_warning(record.id + ": " + warning);
}

Table channels_table(const SuiteImport& found) {
  Table table{
      "channels",
      "Channels of structures; --roof LOCATION or --roof CHANNELS takes some as a motion of "
      "the roof",
      {text_column("location", "Location"),
       text_column("channel", "Channel"),
       text_column("direction", "Direction"),
       {"pga", "g", "Peak, g", ColumnKind::number, "", false, 4},
       text_column("file", "File")},
      {}};
  std::vector<const FoundComponent*> channels;
  for (const FoundComponent& c : found.components)
    if (!c.header.location.empty()) channels.push_back(&c);
  std::ranges::stable_sort(channels, {}, [](const FoundComponent* c) {
    const RecordHeader& h = c->header;
    return std::tuple(h.event, h.station, h.location, h.channel.size(), h.channel);
  });
  for (const FoundComponent* c : channels)
    table.add({c->header.location, c->header.channel, c->header.direction, c->pga_g, c->shown()});
  return table;
}

std::string left_out_text(const SuiteImport& found) {
  constexpr std::size_t most = 100;
  if (found.left_out.empty()) return "";
  std::string text = "left out:\n";
  for (std::size_t i = 0; i < std::min(most, found.left_out.size()); ++i)
    text += "  " +
            wrapped(found.left_out[i].what + ": " + found.left_out[i].reason, terminal_width, 4) +
            "\n";
  if (found.left_out.size() > most)
    text += fmt::format("  and {} more: --json lists all\n", found.left_out.size() - most);
  return text + "Units and steps that files do not state: --units, --dt-s\n";
}

void put_left_out(const SuiteImport& found) {
  if (!found.left_out.empty()) put("\n{}", left_out_text(found));
}

}  // namespace glissade::cli
