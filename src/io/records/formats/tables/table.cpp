// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as spreadsheets and programs of analysis write them: ETABS and SAP 2000 exports, OpenSees
// recorders (time and n columns), SeismoSignal, SCEC BBP ("File Format Guide", 2022: time, N-S,
// E-W, U-D), CSV, TSV, semicolons with decimal commas. Names and units are those of the heading.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "records/at2_header.hpp"
#include "records/formats/reading.hpp"
#include "records/formats/tables/table_shape.hpp"
#include "records/time_column.hpp"

namespace glissade {
namespace {

bool is_table(const RecordText& file) {
  const auto table = find_table(file);
  return table &&
         (table->has_text_above || table->style.separator == ';' || table->style.decimal_comma ||
          table->is_number.size() > 2 || !table->is_all_numbers());
}

/// What is read of a table.
struct TablePlan {
  TableShape shape;
  At2Header stated;  ///< by the lines above: units, step, count
  std::vector<TableColumn> columns;
  std::optional<std::size_t> time;
  std::vector<std::size_t> components;  ///< columns
  bool has_heading = false;
};

/// The step number of SAP 2000 and ETABS is the time where the column StepType says so.
std::optional<std::size_t> step_number(const TablePlan& plan, const RecordText& file) {
  LineReader lines(file.text);
  while (lines.number() < plan.shape.first_row && lines.next()) continue;
  const auto row = row_cells(lines.line(), plan.shape.style);
  std::optional<std::size_t> number;
  bool is_time_step = false;
  for (std::size_t i = 0; i < plan.columns.size() && i < row.size(); ++i) {
    std::string name = lower_case(plan.columns[i].name);
    std::erase(name, ' ');
    if (name == "stepnum" || name == "stepnumber") number = i;
    if (name == "steptype") is_time_step = lower_case(row[i]) == "time";
  }
  return is_time_step ? number : std::nullopt;
}

/// Without a heading the first of three and more columns is the time, which must show.
void check_is_time(const RecordText& file, const TableShape& shape) {
  std::vector<double> times;
  LineReader lines(file.text);
  while (times.size() < 2 && lines.next()) {
    if (lines.number() < shape.first_row || is_blank_or_comment(lines.line())) continue;
    const auto row = row_cells(lines.line(), shape.style);
    times.push_back(row.empty() ? 0.0 : table_number(row[0], shape.style).value_or(0.0));
  }
  if (times.size() == 2 && times[1] > times[0]) return;
  refuse_record(
      file.at(shape.first_row),
      fmt::format("{} columns without a heading, the first of which is no time",
                  shape.is_number.size()),
      "put a line of names and units above them: time_s, ax_g, ay_g; or, where the values "
      "follow one another in the lines, NPTS= and DT= of a PEER file");
}

/// The columns without a heading: the time, then components; one is a component.
void plan_without_heading(const RecordText& file, TablePlan& plan) {
  const std::size_t count = plan.shape.is_number.size();
  if (!plan.shape.is_all_numbers())
    refuse_record(file.at(plan.shape.first_row),
                  fmt::format("has {} columns, of which some are text, without a heading", count),
                  "put a line of their names and units above them: Time (s), U1 (m/s2)");
  if (count > 2) check_is_time(file, plan.shape);
  plan.columns.resize(count);
  if (count > 1) plan.time = 0;
  for (std::size_t i = count > 1 ? 1 : 0; i < count; ++i) plan.components.push_back(i);
}

std::string listed_headings(const TablePlan& plan) {
  std::vector<std::string> names;
  for (const TableColumn& column : plan.columns) names.push_back(in_quotes(column.heading));
  names.resize(std::min<std::size_t>(names.size(), 20));
  return fmt::format("{}", fmt::join(names, ", "));
}

void plan_by_heading(const RecordText& file, TablePlan& plan) {
  const std::size_t count = plan.columns.size();
  if (const std::string column = spectrum_column(plan.columns); !column.empty())
    refuse_spectrum(file.at(plan.shape.first_row), column);
  for (std::size_t i = 0; i < count && !plan.time; ++i)
    if (plan.shape.is_number[i] && is_time(plan.columns[i])) plan.time = i;
  if (!plan.time) plan.time = step_number(plan, file);
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < count; ++i) {
    if (!plan.shape.is_number[i] || i == plan.time) continue;
    if (is_acceleration(plan.columns[i]))
      plan.components.push_back(i);
    else if (plan.columns[i].meaning.kind == UnitKind::none)
      unknown.push_back(i);
  }
  if (plan.components.empty() && plan.time && count == 2) plan.components = unknown;
  if (plan.components.empty())
    refuse_record(file.at(plan.shape.first_row),
                  "has no column of accelerations: " + listed_headings(plan),
                  "name them and their unit in the heading: U1 (m/s2), acc_g");
}

TablePlan plan_of(const RecordText& file) {
  TablePlan plan{*find_table(file), {}, {}, {}, {}, false};
  std::vector<std::string> headings;
  for (const TableLine& line : plan.shape.above)
    if (!read_header_line(line.text, line.number, plan.stated))
      headings.emplace_back(without_comment_mark(line.text));
  plan.columns = table_columns(headings, plan.shape.style.separator, plan.shape.is_number.size());
  plan.has_heading = !plan.columns.empty();
  if (plan.has_heading)
    plan_by_heading(file, plan);
  else
    plan_without_heading(file, plan);
  return plan;
}

/// A column that is no component and has one value: "Joint", "OutputCase". Others are more than one
/// history.
struct LabelColumn {
  std::size_t column;
  std::string value;
};

std::vector<LabelColumn> label_columns(const TablePlan& plan) {
  std::vector<LabelColumn> labels;
  for (std::size_t i = 0; i < plan.columns.size(); ++i)
    if (!plan.shape.is_number[i] ||
        (plan.has_heading && i != plan.time && lower_case(plan.columns[i].unit) == "text"))
      labels.push_back({i, ""});
  return labels;
}

void check_labels(const RecordText& file, const TablePlan& plan, std::size_t line,
                  const std::vector<std::string_view>& row, std::vector<LabelColumn>& labels) {
  for (LabelColumn& label : labels) {
    const std::string_view value = row[label.column];
    if (line == plan.shape.first_row) label.value = value;
    if (value != label.value)
      refuse_record(file.at(line),
                    fmt::format("the column {} goes from {} to {}: several histories in one table",
                                in_quotes(plan.columns[label.column].heading),
                                in_quotes(label.value), in_quotes(value)),
                    "export the table of one joint and one case");
  }
}

double cell_number(const RecordText& file, std::size_t line, std::string_view cell,
                   const TableStyle& style, const char* what) {
  if (const auto value = table_number(cell, style); value && std::isfinite(*value)) return *value;
  return parse_finite(file, line, cell, what);
}

TimedSamples read_rows(const RecordText& file, const TablePlan& plan, std::size_t column,
                       double unit_mps2) {
  TimedSamples rows;
  std::vector<LabelColumn> labels = label_columns(plan);
  const TableStyle& style = plan.shape.style;
  LineReader lines(file.text);
  while (lines.number() + 1 < plan.shape.first_row && lines.next()) continue;
  while (lines.next()) {
    if (is_blank_or_comment(lines.line())) continue;
    const std::size_t line = lines.number();
    const auto row = row_cells(lines.line(), style);
    if (row.size() != plan.columns.size())
      refuse_record(file.at(line),
                    fmt::format("{} columns, {} above", row.size(), plan.columns.size()),
                    "the file is cut short, or holds more than one table: give one");
    check_labels(file, plan, line, row, labels);
    if (plan.time) {
      const double time = cell_number(file, line, row[*plan.time], style, "the time");
      std::string token(row[*plan.time]);
      if (style.decimal_comma) std::ranges::replace(token, ',', '.');
      rows.time.add(time, token, line);
    }
    const double value = cell_number(file, line, row[column], style, "the value");
    add_sample(file, line, shortest_decimal(value), unit_mps2, rows.samples_mps2);
  }
  return rows;
}

double table_step(const RecordText& file, const TablePlan& plan, TimedSamples& rows,
                  const RecordFileOptions& options, std::vector<std::string>& notes) {
  if (!plan.time) {
    if (!options.dt_s && !plan.stated.dt_s)
      refuse_record(file.at(plan.shape.first_row),
                    plan.has_heading ? "no column is the time: " + listed_headings(plan)
                                     : std::string("one column does not give the time step"),
                    "head the time Time (s), or give the step with dt_s");
    return at2_step(file.path, plan.stated, options.dt_s);
  }
  const HeaderUnit& unit = plan.columns[*plan.time].meaning;
  rows.time.scale(unit.kind == UnitKind::time ? unit.si : 1.0);
  return step_of_rows(file, rows, plan.stated, options, notes);
}

std::vector<FileComponent> read_table(const RecordText& file, const RecordFileOptions& options) {
  const TablePlan plan = plan_of(file);
  std::vector<FileComponent> components;
  for (const std::size_t column : plan.components) {
    components.push_back(file_component(file, plan.columns[column].name, 0.0, {}));
    components.back().direction = plan.columns[column].heading;
  }
  const std::size_t picked = picked_component(file.path, components, options.component);
  const TableColumn& column = plan.columns[plan.components[picked]];
  const StatedUnit unit = column.unit.empty()
                              ? StatedUnit{plan.stated.units, plan.stated.units_line}
                              : StatedUnit{column.unit, plan.shape.first_row - 1};
  if (unit.text.empty()) refuse_seismometer(file, column.name);
  const bool has_step = plan.time || options.dt_s || plan.stated.dt_s;
  const double unit_mps2 = stated_unit(file, unit, has_step, options);
  TimedSamples rows = read_rows(file, plan, plan.components[picked], unit_mps2);
  if (plan.stated.npts) check_at2_count(file.path, plan.stated, rows.samples_mps2.size());
  Record& record = components[picked].record;
  record.dt_s = table_step(file, plan, rows, options, record.notes);
  record.acceleration_mps2 = std::move(rows.samples_mps2);
  components[picked].header.unit = unit.text;
  if (plan.shape.style.decimal_comma)
    record.notes.emplace_back("commas are taken for decimal commas");
  return components;
}

}  // namespace

const RecordFormat table_format{"a table", is_table, read_table};

}  // namespace glissade
