// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/suite_import.hpp"
#include "glissade/report/table.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"
#include "suite/import_output.hpp"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ImportCommand {
  std::vector<std::string> inputs;
  std::string report, out, name, roof;
  MissingOptions missing;
  bool trim = false, resample = false, keep_single = false, directions_from_names = false,
       json = false, overwrite = false;
};

ImportOptions options_of(const ImportCommand& o) {
  ImportOptions options;
  options.inputs.assign(o.inputs.begin(), o.inputs.end());
  if (!o.report.empty()) options.report = o.report;
  options.missing = o.missing.of_files();
  options.trim = o.trim;
  options.resample = o.resample;
  options.keep_single = o.keep_single;
  options.directions_from_names = o.directions_from_names;
  if (!o.roof.empty()) options.roof = o.roof;
  return options;
}

/// "4.6 ML", "88.1 epi"; moment magnitudes and distances to the rupture go without.
std::string with_kind(double value, const std::string& kind) {
  if (value <= 0.0) return "-";
  const char* shown = kind == "Mw" || kind == "rupture" ? ""
                      : kind == "epicentral"            ? "epi"
                      : kind == "joyner_boore"          ? "JB"
                                                        : kind.c_str();
  return fmt::format("{:.3g} {}", value, shown);
}

/// "0, 90, UP".
std::string directions_of(const ImportedRecord& record, const SuiteImport& found) {
  std::string list;
  for (const auto& component : record.components)
    if (component)
      list += (list.empty() ? "" : ", ") + found.components[*component].header.direction;
  return list;
}

Table records_table(const SuiteImport& found) {
  Table table{"records",
              "Imported records",
              {text_column("id", "Record"),
               text_column("magnitude", "M"),
               text_column("distance", "R, km"),
               {"vs30", "mps", "Vs30, m/s", ColumnKind::number, "", false, 0},
               {"scale", "", "Factor"},
               text_column("components", "Components")},
              {}};
  for (const ImportedRecord& r : found.records)
    table.add({r.id, with_kind(r.magnitude, r.magnitude_kind),
               with_kind(r.distance_km, r.distance_kind),
               r.vs30_mps > 0.0 ? r.vs30_mps : std::nan(""), r.scale > 0.0 ? r.scale : 1.0,
               directions_of(r, found)});
  const bool has_factors = std::ranges::any_of(
      found.records, [](const ImportedRecord& r) { return r.scale > 0.0 && r.scale != 1.0; });
  return has_factors ? table : table.without("scale");
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json to_json(const SuiteImport& found) {
  constexpr const char* keys[] = {"first", "second", "vertical"};
  Json json{{"records", Json::array()}, {"left_out", Json::array()}, {"warnings", found.warnings}};
  for (const ImportedRecord& r : found.records) {
    Json record{{"id", r.id},
                {"event", text_or_null(r.event)},
                {"station", text_or_null(r.station)},
                {"magnitude", or_null(r.magnitude)},
                {"magnitude_kind", text_or_null(r.magnitude_kind)},
                {"distance_km", or_null(r.distance_km)},
                {"distance_kind", text_or_null(r.distance_kind)},
                {"vs30_mps", or_null(r.vs30_mps)},
                {"scale", or_null(r.scale)}};
    for (std::size_t i = 0; i < r.components.size(); ++i) {
      if (!r.components[i]) continue;
      const FoundComponent& c = found.components[*r.components[i]];
      record[keys[i]] = {{"file", c.file.string() + c.whole_address()},
                         {"format", c.format},
                         {"direction", c.header.direction},
                         {"direction_is_of_name", c.has_direction_of_name()},
                         {"location", text_or_null(c.header.location)},
                         {"channel", text_or_null(c.header.channel)},
                         {"dt_s", c.dt_s},
                         {"samples", c.samples},
                         {"pga_g", c.pga_g},
                         {"sha256", c.sha256}};
    }
    record["warnings"] = r.warnings;
    json["records"].push_back(std::move(record));
  }
  for (const LeftOut& left : found.left_out)
    json["left_out"].push_back({{"what", left.what}, {"reason", left.reason}});
  return json;
}

/// Every file and why it is left out, where nothing is left.
void check_any(const SuiteImport& found, bool are_listed) {
  if (!found.records.empty()) return;
  const Table channels = channels_table(found);
  const std::string list = are_listed ? ""
                           : channels.rows.empty()
                               ? left_out_text(found)
                               : to_text(channels) + "\n" + left_out_text(found);
  throw InputError(
      {"suite import", "no record was found in the files", "see what was left out", list});
}

std::string suite_text(const ImportCommand& o, const SuiteImport& found) {
  namespace fs = std::filesystem;
  const fs::path out(o.out);
  ImportedSuiteHead head{o.name.empty() ? out.stem().string() : o.name,
                         {"Made by: glissade suite import",
                          fmt::format("{}; distances are to the rupture, magnitudes moment "
                                      "magnitudes, where no other kind is stated",
                                      counted(found.records.size(), "record"))},
                         o.missing.of_files().units_if_not_stated,
                         !o.roof.empty()};
  if (o.directions_from_names)
    head.comments.emplace_back("Directions that no header states are those of the files' names");
  if (head.of_roof) head.comments.push_back("Channels of a structure: --roof " + o.roof);
  return imported_suite_toml(found, head, out.parent_path());
}

void run_import(const ImportCommand& o) {
  check_output_file(o.out, "--out", o.overwrite);
  const SuiteImport found = import_suite(options_of(o));
  if (o.json) put_json(to_json(found));
  check_any(found, o.json);
  if (!o.out.empty()) write_text_file(o.out, suite_text(o, found));
  if (o.json) return;
  put("{}", to_text(records_table(found)));
  put_warnings(found);
  if (const Table channels = channels_table(found); !channels.rows.empty())
    put("\n{}", to_text(channels));
  put_left_out(found);
  if (!o.out.empty()) put("\nsuite file   {}\n", o.out);
}

}  // namespace

void add_suite_import(CLI::App& suite) {
  auto o = std::make_shared<ImportCommand>();
  CLI::App* command =
      suite.add_subcommand("import", "Make a suite of record files as they are downloaded");
  command->add_option("files", o->inputs, "record files, folders and archives of them")->required();
  command->add_option("--report", o->report,
                      "PEER's _SearchResults.csv (in an archive: FILE.zip#_SearchResults.csv), or "
                      "the flatfile of ESM: magnitudes, distances, "
                      "V_S30, factors");
  o->missing.add_to(*command);
  command->add_flag("--trim", o->trim, "end the components of a record with its shortest");
  command->add_flag("--resample", o->resample,
                    "interpolate components to the shortest step of their record");
  command->add_flag("--keep-single", o->keep_single, "keep records with one horizontal only");
  command->add_flag("--directions-from-names", o->directions_from_names,
                    "take directions that nothing states as the files' names suggest them: "
                    "A-000.txt with A-090.txt");
  command->add_option("--roof", o->roof,
                      "motions of a roof (motions = \"roof\"): channels of a structure, CSMIP or "
                      "COSMOS, by words of their location, --roof roof, or by their numbers, "
                      "--roof 7,8 [motions of the ground]");
  command->add_option("--name", o->name, "name of the suite [that of its file]");
  command->add_option("--out", o->out, "new suite file [none is written]");
  add_overwrite(*command, o->overwrite);
  command->add_flag("--json", o->json, "print one JSON object");
  command->callback([o] { run_import(*o); });
}

}  // namespace glissade::cli
