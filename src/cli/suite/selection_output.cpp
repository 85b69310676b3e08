// SPDX-License-Identifier: GPL-3.0-or-later
#include "suite/selection_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>

#include "glissade/io/suite_file.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

std::vector<const char*> reasons_of(const LeftOutRecord& record) {
  std::vector<const char*> reasons;
  for (const LeftOutFor reason : record.reasons) reasons.push_back(to_string(reason));
  return reasons;
}

}  // namespace

void by_option(Problem& problem) {
  static const std::map<std::string, std::string> options = {
      {"count", "--count"},
      {"magnitude", "--min-magnitude, --max-magnitude"},
      {"distance_km", "--min-distance-km, --max-distance-km"},
      {"vs30_mps", "--min-vs30-mps, --max-vs30-mps"},
      {"max_scale", "--max-scale"},
      {"per_event", "--per-event"}};
  if (const auto option = options.find(problem.where); option != options.end())
    problem.where = option->second;
}

Suite load_library(const std::string& file) {
  Suite library = load_suite(file);
  if (library.of_roof)
    throw InputError({file,
                      "has motions of a roof: records are selected by magnitude, distance and the "
                      "spectrum of the ground",
                      "select ground motions, and give the motions of the roof under them", ""});
  return library;
}

Table selected_table(const Suite& library, const std::vector<SelectedRecord>& records) {
  Table table{"records",
              "Selected records",
              {{"id", "", "record", ColumnKind::text},
               {"event", "", "event", ColumnKind::text},
               {"magnitude", "", "M", ColumnKind::number, "", false, 2},
               {"distance", "km", "R, km", ColumnKind::number, "", false, 1},
               {"vs30", "mps", "Vs30, m/s", ColumnKind::number, "", false, 0},
               {"scale", "", "factor", ColumnKind::number, "", false, 4},
               {"misfit", "", "misfit", ColumnKind::number, "", false, 3}},
              {}};
  const auto given = [](double value) { return value > 0.0 ? value : std::nan(""); };
  for (const SelectedRecord& r : records) {
    const Motion& m = library.motions[r.record];
    table.add({m.id, m.event, given(m.magnitude), given(m.distance_km), given(m.vs30_mps), r.scale,
               r.misfit});
  }
  return table;
}

Json selected_json(const Suite& library, const std::vector<SelectedRecord>& records) {
  Json json = Json::array();
  for (const SelectedRecord& r : records) {
    const Motion& m = library.motions[r.record];
    json.push_back({{"id", m.id},
                    {"event", m.event},
                    {"magnitude", or_null(m.magnitude)},
                    {"distance_km", or_null(m.distance_km)},
                    {"vs30_mps", or_null(m.vs30_mps)},
                    {"scale", r.scale},
                    {"misfit", r.misfit}});
  }
  return json;
}

void put_left_out(const Suite& library, const std::vector<LeftOutRecord>& left_out) {
  if (left_out.empty()) return;
  put("\nleft out:\n");
  for (const LeftOutRecord& record : left_out)
    put("  {}: {}\n", library.motions[record.record].id, fmt::join(reasons_of(record), ", "));
}

Json left_out_json(const Suite& library, const std::vector<LeftOutRecord>& left_out) {
  Json json = Json::array();
  for (const LeftOutRecord& record : left_out)
    json.push_back({{"id", library.motions[record.record].id}, {"reasons", reasons_of(record)}});
  return json;
}

}  // namespace glissade::cli
