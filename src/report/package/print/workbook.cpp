// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/print/workbook.hpp"

#ifdef GLISSADE_WORKBOOK

#include <fmt/format.h>
#include <xlsxwriter.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "glissade/core/error.hpp"
#include "glissade/report/format.hpp"

namespace glissade {
namespace {

/// As the tables of the page have it.
double shown_value(const NumberCell& quantity) {
  const auto& [count, are_significant] = quantity.digits;
  if (count < 0) return quantity.value;
  if (are_significant) return rounded_to(quantity.value, count);
  return std::strtod(fmt::format("{:.{}f}", quantity.value, count).c_str(), nullptr);
}

/// Of Excel: 0.0" in", "< "General.
std::string number_format(const NumberCell& quantity) {
  const auto& [count, are_significant] = quantity.digits;
  const auto quoted = [](const std::string& text) {
    return text.empty() ? text : "\"" + text + "\"";
  };
  const std::string decimals = count > 0 ? "." + std::string(count, '0') : "";
  return quoted(quantity.sign) + (count < 0 || are_significant ? "General" : "0" + decimals) +
         quoted(quantity.unit.empty() ? "" : " " + quantity.unit);
}

/// What is open is closed and freed once, in close().
class Workbook {
 public:
  explicit Workbook(const std::filesystem::path& file)
      : book_(workbook_new(file.c_str())), bold_(workbook_add_format(book_)) {
    lxw_doc_properties properties{};
    properties.created = 1;  // the same tables give the same bytes
    workbook_set_properties(book_, &properties);
    format_set_bold(bold_);
  }
  void add(const Table& table) {
    lxw_worksheet* sheet = workbook_add_worksheet(book_, table.name.text().c_str());
    lxw_row_t row = 0;
    write(sheet, row++, 0, table.title, bold_);
    for (const std::string& note : table.notes) write(sheet, row++, 0, note, nullptr);
    std::size_t at = 0;
    for (const Column& column : table.columns) {
      write(sheet, row, at++, column.heading, bold_);
      if (column.with_interval)
        for (const char* end : {"low 95 %", "high 95 %"}) write(sheet, row, at++, end, bold_);
    }
    for (const std::vector<Cell>& cells : table.rows) {
      ++row;
      at = 0;
      for (std::size_t c = 0; c < cells.size(); ++c) {
        add(sheet, row, at++, table.columns[c], cells[c]);
        if (!table.columns[c].with_interval) continue;
        const Interval interval = estimate_of(cells[c]).interval;
        for (const double end : {interval.low, interval.high}) add(sheet, row, at++, end);
      }
    }
  }
  bool close() { return workbook_close(book_) == LXW_NO_ERROR; }

 private:
  static void write(lxw_worksheet* sheet, lxw_row_t row, std::size_t column,
                    const std::string& text, lxw_format* format) {
    worksheet_write_string(sheet, row, static_cast<lxw_col_t>(column), text.c_str(), format);
  }
  static void add(lxw_worksheet* sheet, lxw_row_t row, std::size_t at, double value,
                  lxw_format* format = nullptr) {
    if (std::isfinite(value))
      worksheet_write_number(sheet, row, static_cast<lxw_col_t>(at), value, format);
  }
  void add(lxw_worksheet* sheet, lxw_row_t row, std::size_t at, const Column& column,
           const Cell& cell) {
    const double value = estimate_of(cell).value;
    const bool is_dash = column.kind == ColumnKind::text && !std::isfinite(value);
    if (is_dash || std::holds_alternative<std::string>(cell))
      return write(sheet, row, at, cell_text(column, cell), nullptr);
    if (const auto* quantity = std::get_if<NumberCell>(&cell))
      return add(sheet, row, at, shown_value(*quantity), format_of(number_format(*quantity)));
    add(sheet, row, at, value);
  }
  lxw_format* format_of(const std::string& code) {
    if (code == "General") return nullptr;
    lxw_format*& format = formats_[code];
    if (format == nullptr) {
      format = workbook_add_format(book_);
      format_set_num_format(format, code.c_str());
    }
    return format;
  }

  lxw_workbook* book_;
  lxw_format* bold_;
  std::map<std::string, lxw_format*> formats_;
};

}  // namespace

void write_workbook(const std::vector<Table>& tables, const std::filesystem::path& file) {
  Workbook book(file);
  for (const Table& table : tables) book.add(table);
  if (!book.close())
    throw InputError({file.string(), "cannot be written", "see whether the disk is full", ""});
}

}  // namespace glissade

#else

namespace glissade {
void write_workbook(const std::vector<Table>&, const std::filesystem::path&) {}
}  // namespace glissade

#endif
