// SPDX-License-Identifier: GPL-3.0-or-later
#include "product/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/report/format.hpp"

namespace glissade {
namespace {

std::string unit_of(const ProductSheet& sheet) { return to_string(sheet.product.unit); }

/// As many as the step of rounding has.
int decimals_of(const Product& product) {
  const double step = in_unit(product.unit, product.round_up_m);
  int decimals = 0;
  while (decimals < 3 && std::abs(step * std::pow(10.0, decimals) -
                                  std::round(step * std::pow(10.0, decimals))) > 1e-6)
    ++decimals;
  return decimals;
}

Column length_column(const ProductSheet& sheet, const std::string& stem, const std::string& heading,
                     int more_decimals = 0) {
  return {.stem = stem,
          .unit = unit_of(sheet),
          .heading = heading + ", " + unit_of(sheet),
          .decimals = decimals_of(sheet.product) + more_decimals};
}

/// Without the last digits, which the change of units makes; text where the array slides without an
/// earthquake.
Cell cell_of(const ProductSheet& sheet, double length_m) {
  constexpr int digits = 12;
  if (std::isinf(length_m)) return std::string("slides");
  return rounded_to(in_unit(sheet.product.unit, length_m), digits);
}

Cell rounded(const ProductSheet& sheet, double length_m) {
  return cell_of(sheet, rounded_up(length_m, sheet.product.round_up_m));
}

std::vector<Column> target_columns() {
  return {{.stem = "sds", .unit = "g", .heading = "S_DS, g", .decimals = 3},
          {.stem = "sd1", .unit = "g", .heading = "S_D1, g", .decimals = 3},
          {.stem = "slope", .unit = "deg", .heading = "Slope, degrees", .decimals = 2}};
}

std::vector<Cell> target_cells(const SheetTarget& of, double slope_deg) {
  return {of.target.target.sds_g, of.target.target.sd1_g, slope_deg};
}

/// "1.1 x the mean of the records".
std::string analysis_text(const ProductSheet& sheet) {
  const TargetDisplacements& found = sheet.targets.front().found;
  return fmt::format("{:g} x the {} of the records", found.factor,
                     found.of_largest ? "largest" : "mean");
}

std::string note_on_design(const ProductSheet& sheet) {
  return fmt::format(
      "{}, rounded up to {:.3g} {}. Between rows and columns: the next larger S_DS and S_D1, the "
      "next steeper slope, the next lower friction. slides: the array slides without an "
      "earthquake.",
      analysis_text(sheet), in_unit(sheet.product.unit, sheet.product.round_up_m), unit_of(sheet));
}

/// Where ASCE 7-16 has a least value, and where not.
std::string note_on_least(const ProductSheet& sheet) {
  std::string outside;
  for (const double mu : sheet.targets.front().found.mu)
    if (!is_within(Standard::asce7_16, {.friction = mu}))
      outside += fmt::format("{}{:g}", outside.empty() ? "" : ", ", mu);
  return fmt::format(
      "At slopes of {:.3g} degrees or less and friction of {:g} or more: not below 80 % of the "
      "value that ASCE 7-16, 13.6.12, prescribes; less only after a peer review.{}",
      slope_limit_deg(Standard::asce7_16), friction_limit(Standard::asce7_16),
      outside.empty() ? ""
                      : " Friction " + outside +
                            " is outside of that exception for arrays without "
                            "anchors.");
}

void add_frictions(const ProductSheet& sheet, Table& table) {
  for (const double mu : sheet.targets.front().found.mu)
    table.columns.push_back(
        length_column(sheet, fmt::format("mu_{:g}", mu), fmt::format("Friction {:g}", mu)));
}

}  // namespace

Table design_displacements_table(const ProductSheet& sheet) {
  Table table{"design_displacements",
              "Design displacement by site, slope and friction",
              target_columns(),
              {},
              {note_on_design(sheet), note_on_least(sheet)}};
  add_frictions(sheet, table);
  for (const SheetTarget& of : sheet.targets)
    for (std::size_t s = 0; s < of.found.slope_deg.size(); ++s) {
      std::vector<Cell> row = target_cells(of, of.found.slope_deg[s]);
      for (std::size_t m = 0; m < of.found.mu.size(); ++m)
        row.push_back(rounded(sheet, of.found.points[s * of.found.mu.size() + m].design_m));
      table.add(std::move(row));
    }
  return table;
}

Table displacements_by_period_table(const ProductSheet& sheet) {
  Table table{"displacements_by_period",
              "Displacement by building period, by the analysis alone",
              target_columns(),
              {},
              {note_on_design(sheet)}};
  table.columns.push_back({.stem = "period", .unit = "s", .heading = "Period, s"});
  add_frictions(sheet, table);
  for (const SheetTarget& of : sheet.targets)
    for (std::size_t s = 0; s < of.found.slope_deg.size(); ++s)
      for (std::size_t t = 0; t < of.found.period_s.size(); ++t) {
        std::vector<Cell> row = target_cells(of, of.found.slope_deg[s]);
        row.emplace_back(of.found.period_s[t]);
        for (std::size_t m = 0; m < of.found.mu.size(); ++m)
          row.push_back(rounded(sheet, of.found.points[s * of.found.mu.size() + m].by_period_m[t]));
        table.add(std::move(row));
      }
  return table;
}

Table life_displacements_table(const ProductSheet& sheet) {
  const HazardConfig& hazard = *sheet.targets.front().target.hazard;
  Table table{
      "life_displacements",
      fmt::format("Displacement in the {:g}-year event, and in {:g} years of smaller ones",
                  sheet.product.event_years, hazard.design_life_years),
      target_columns(),
      {},
      {fmt::format(
           "Event: the design displacement at the S_DS that is exceeded once in {:g} years. "
           "Smaller events: the expected sum of the mean displacements of all earthquakes "
           "below it in {:g} years, as if each moved the array farther in one direction: "
           "an upper bound of what is left. Total: both, rounded up.",
           sheet.product.event_years, hazard.design_life_years),
       hazard.is_assumed
           ? "The hazard curves are those of no site: each is assumed from S_DS of its row by the "
             "risk target of ASCE 7."
           : "Hazard curve: " + hazard.source + "."}};
  table.columns.push_back({.stem = "mu", .heading = "Friction", .decimals = 2});
  table.columns.push_back(
      {.stem = "event_sds", .unit = "g", .heading = "S_DS of the event, g", .decimals = 3});
  for (const auto& [stem, heading] : {std::pair{"event", "Event"}, {"smaller", "Smaller events"}})
    table.columns.push_back(length_column(sheet, stem, heading, 1));
  table.columns.push_back(length_column(sheet, "total", "Total"));
  bool slides_below = false;
  for (const SheetTarget& of : sheet.targets)
    for (const ProductDisplacement& d : of.found.points) {
      std::vector<Cell> row = target_cells(of, d.slope_deg);
      row.insert(row.end(), {d.mu, of.found.event_g, cell_of(sheet, d.event_m),
                             cell_of(sheet, d.smaller_m), rounded(sheet, d.event_m + d.smaller_m)});
      table.add(std::move(row));
      slides_below = slides_below || d.slides_below;
    }
  if (slides_below)
    table.notes.emplace_back(
        "At some frictions the array slides at a twentieth of the event already: smaller "
        "earthquakes are not counted, and their sum is a lower bound there.");
  return table;
}

Table all_displacements_table(const ProductSheet& sheet) {
  Table table{"displacements",
              "Displacement by site, slope and friction, with all digits",
              target_columns(),
              {},
              {sheet.targets.front().counted}};
  table.columns.push_back({.stem = "mu", .heading = "Friction", .decimals = 2});
  for (const auto& [stem, heading] : {std::pair{"mean", "Mean"},
                                      {"p84", "84th percentile"},
                                      {"p95", "95th percentile"},
                                      {"largest", "Largest record"},
                                      {"analysis", "By the analysis"},
                                      {"design", "Design"},
                                      {"rounded", "Rounded up"}})
    table.columns.push_back(length_column(sheet, stem, heading, 2));
  table.columns.push_back(
      {.stem = "governing_period", .unit = "s", .heading = "Governing period, s"});
  for (const SheetTarget& of : sheet.targets)
    for (const ProductDisplacement& d : of.found.points) {
      std::vector<Cell> row = target_cells(of, d.slope_deg);
      row.emplace_back(d.mu);
      for (const double length_m :
           {d.slip.mean_m, d.slip.p84_m, d.slip.p95_m, d.slip.envelope_m, d.analysis_m, d.design_m})
        row.push_back(cell_of(sheet, length_m));
      row.push_back(rounded(sheet, d.design_m));
      row.emplace_back(d.period_s);
      table.add(std::move(row));
    }
  const std::vector<RecordSummary>& records = sheet.targets.front().records;
  const std::size_t units = unit_count(event_units(records), records.size());
  table.add_note(open_percentile(units, units < records.size() ? "events" : "records"));
  return table;
}

Table prescribed_displacements_table(const ProductSheet& sheet) {
  Table table{
      "prescribed_displacements",
      "Displacement that ASCE 7-16, 13.6.12, prescribes for I_e = 1",
      {{.stem = "sds", .unit = "g", .heading = "S_DS, g", .decimals = 3},
       length_column(sheet, "prescribed", "Prescribed", 1),
       length_column(sheet, "least", "80 % of it", 1)},
      {},
      {fmt::format("For slopes of {:.3g} degrees or less and friction of {:g} or more, and further "
                   "conditions. Confirm against the adopted code.",
                   slope_limit_deg(Standard::asce7_16), friction_limit(Standard::asce7_16))}};
  std::vector<double> levels;
  for (const SheetTarget& of : sheet.targets) levels.push_back(of.target.target.sds_g);
  std::ranges::sort(levels);
  levels.erase(std::ranges::unique(levels).begin(), levels.end());
  for (const double sds_g : levels) {
    const double prescribed_m = asce7_16_displacement(sds_g, 1.0).value_m;
    table.add({sds_g, cell_of(sheet, prescribed_m),
               cell_of(sheet, least_share(Standard::asce7_16) * prescribed_m)});
  }
  return table;
}

std::string largest_sentence(const ProductSheet& sheet) {
  const SheetTarget* at = nullptr;
  const ProductDisplacement* largest = nullptr;
  bool slides = false;
  for (const SheetTarget& of : sheet.targets)
    for (const ProductDisplacement& d : of.found.points) {
      slides = slides || std::isinf(d.design_m);
      if (std::isinf(d.design_m) || (largest != nullptr && d.design_m <= largest->design_m))
        continue;
      at = &of;
      largest = &d;
    }
  if (largest == nullptr) return "The array slides without an earthquake at every point.";
  return fmt::format(
      "Largest of the table: {:.{}f} {}, at S_DS {:g} g and S_D1 {:g} g, on {:.3g} degrees with "
      "friction {:g}{}.",
      in_unit(sheet.product.unit, rounded_up(largest->design_m, sheet.product.round_up_m)),
      decimals_of(sheet.product), unit_of(sheet), at->target.target.sds_g, at->target.target.sd1_g,
      largest->slope_deg, largest->mu,
      slides ? ", of the points where the array does not slide without an earthquake" : "");
}

}  // namespace glissade
