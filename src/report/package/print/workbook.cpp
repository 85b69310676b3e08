// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/print/workbook.hpp"

#ifdef GLISSADE_WORKBOOK

#include <xlsxwriter.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "glissade/core/error.hpp"

namespace glissade {
namespace {

/// A number as it is written, with its decimals and unit.
struct WrittenQuantity {
  double value = 0.0;
  std::string format;  ///< of Excel: 0.0" in"
};

/// Of "12.7", "12.7 in" and "12.7 in (0.323 m)"; none of any other text.
std::optional<WrittenQuantity> quantity_in(const std::string& text) {
  WrittenQuantity found;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), found.value);
  if (error != std::errc() || !std::isfinite(found.value)) return std::nullopt;
  const std::string number(text.data(), end);
  constexpr std::size_t most_digits = 15;  // of a number of Excel
  const bool is_code =
      number.size() > most_digits || (number.size() > 1 && number[0] == '0' && number[1] != '.');
  if (is_code) return std::nullopt;  // "0012345", of a licence
  std::string unit(end, text.data() + text.size());
  unit = unit.substr(0, unit.find(" ("));
  const bool is_unit = unit.empty() || (unit[0] == ' ' && unit.size() > 1 &&
                                        std::ranges::all_of(unit.substr(1), [](unsigned char c) {
                                          return std::isalpha(c) != 0 || c == '%';
                                        }));
  if (!is_unit) return std::nullopt;
  const std::size_t point = number.find('.');
  found.format = "0";
  if (point != std::string::npos) found.format += "." + std::string(number.size() - point - 1, '0');
  if (!unit.empty()) found.format += "\"" + unit + "\"";
  return found;
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
  static void add(lxw_worksheet* sheet, lxw_row_t row, std::size_t at, double value) {
    if (std::isfinite(value))
      worksheet_write_number(sheet, row, static_cast<lxw_col_t>(at), value, nullptr);
  }
  /// A bound has its sign: "< 9.6e-5".
  void add(lxw_worksheet* sheet, lxw_row_t row, std::size_t place, const Column& column,
           const Cell& cell) {
    const auto at = static_cast<lxw_col_t>(place);
    const auto* estimate = std::get_if<SignedEstimate>(&cell);
    if (estimate != nullptr && !estimate->sign.empty())
      return write(sheet, row, place, cell_text(column, cell), nullptr);
    if (const auto* text = std::get_if<std::string>(&cell)) {
      if (const auto quantity = quantity_in(*text))
        worksheet_write_number(sheet, row, at, quantity->value, format_of(quantity->format));
      else
        write(sheet, row, place, *text, nullptr);
      return;
    }
    add(sheet, row, place, estimate_of(cell).value);
  }
  lxw_format* format_of(const std::string& number_format) {
    lxw_format*& format = formats_[number_format];
    if (format == nullptr) {
      format = workbook_add_format(book_);
      format_set_num_format(format, number_format.c_str());
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
