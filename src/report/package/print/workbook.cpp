// SPDX-License-Identifier: GPL-3.0-or-later
#include "package/print/workbook.hpp"

#ifdef GLISSADE_WORKBOOK

#include <fmt/format.h>
#include <xlsxwriter.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <new>
#include <string>
#include <utility>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/report/format.hpp"
#include "plot/child_program.hpp"

namespace glissade {

const bool makes_workbooks = true;

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

void check_memory(lxw_error error) {
  if (error == LXW_ERROR_MEMORY_MALLOC_FAILED) throw std::bad_alloc();
}

template <class Made>
Made* checked(Made* made) {
  if (made == nullptr) throw std::bad_alloc();
  return made;
}

class Workbook {
 public:
  /// @param folder of files while it is written
  Workbook(const std::string& file, std::string folder) {
    lxw_workbook_options options{};
    options.tmpdir = folder.data();
    book_ = checked(workbook_new_opt(file.c_str(), &options));
    lxw_doc_properties properties{};
    properties.created = 1;  // the same tables give the same bytes
    check_memory(workbook_set_properties(book_, &properties));
    bold_ = checked(workbook_add_format(book_));
    format_set_bold(bold_);
  }
  Workbook(const Workbook&) = delete;
  Workbook& operator=(const Workbook&) = delete;
  ~Workbook() { lxw_workbook_free(book_); }
  void add(const Table& table) {
    lxw_worksheet* sheet = checked(workbook_add_worksheet(book_, table.name.text().c_str()));
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
  lxw_error close() { return workbook_close(std::exchange(book_, nullptr)); }

 private:
  static void write(lxw_worksheet* sheet, lxw_row_t row, std::size_t column,
                    const std::string& text, lxw_format* format) {
    check_memory(
        worksheet_write_string(sheet, row, static_cast<lxw_col_t>(column), text.c_str(), format));
  }
  static void add(lxw_worksheet* sheet, lxw_row_t row, std::size_t at, double value,
                  lxw_format* format = nullptr) {
    if (std::isfinite(value))
      check_memory(worksheet_write_number(sheet, row, static_cast<lxw_col_t>(at), value, format));
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
      format = checked(workbook_add_format(book_));
      format_set_num_format(format, code.c_str());
    }
    return format;
  }

  lxw_workbook* book_ = nullptr;
  lxw_format* bold_ = nullptr;
  std::map<std::string, lxw_format*> formats_;
};

}  // namespace

namespace {

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
  Number number{};
  if (at + sizeof number <= bytes.size()) std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// Of a part, from its entry in the directory.
std::string inflated(std::string_view bytes, std::size_t entry) {
  const auto packed = number_at<std::uint32_t>(bytes, entry + 20),
             size = number_at<std::uint32_t>(bytes, entry + 24);
  const std::size_t at = number_at<std::uint32_t>(bytes, entry + 42),
                    data = at + 30 + number_at<std::uint16_t>(bytes, at + 26) +
                           number_at<std::uint16_t>(bytes, at + 28);
  if (data + packed > bytes.size() || size > (std::uint32_t{1} << 28)) return "";
  std::string text(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data() + data));
  stream.avail_in = packed;
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = size;
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  return result == Z_STREAM_END && stream.avail_out == 0 ? text : "";
}

/// A file of XML ends with the end of the element that it begins with.
bool is_whole_xml(const std::string& text) {
  std::size_t begin = text.find('<');
  if (text.starts_with("<?")) begin = text.find('<', text.find("?>"));
  if (begin == std::string::npos) return false;
  const std::string name = text.substr(begin + 1, text.find_first_of(" />\n", begin) - begin - 1);
  return text.ends_with("</" + name + ">") || text.ends_with("</" + name + ">\n") ||
         (text.rfind('<') == begin && text.ends_with("/>"));
}

std::string made_of(const std::vector<Table>& tables, const std::filesystem::path& file) {
  const MemoryFile memory(file);
  Workbook book(memory.name(), file.parent_path().string());
  for (const Table& table : tables) book.add(table);
  if (const lxw_error error = book.close(); error != LXW_NO_ERROR)
    throw InputError({file.string(), std::string("cannot be written: ") + lxw_strerror(error),
                      "see whether the disk is full", ""});
  return memory.read();
}

}  // namespace

bool is_whole_workbook(std::string_view bytes) {
  constexpr std::size_t end_bytes = 22;
  if (bytes.size() < end_bytes || !bytes.substr(bytes.size() - end_bytes).starts_with("PK\5\6"))
    return false;
  const auto parts = number_at<std::uint16_t>(bytes, bytes.size() - 12);
  std::size_t entry = number_at<std::uint32_t>(bytes, bytes.size() - 6);
  for (int i = 0; i < parts; ++i) {
    if (!bytes.substr(std::min(entry, bytes.size())).starts_with("PK\1\2") ||
        !is_whole_xml(inflated(bytes, entry)))
      return false;
    entry += 46 + number_at<std::uint16_t>(bytes, entry + 28) +
             number_at<std::uint16_t>(bytes, entry + 30) +
             number_at<std::uint16_t>(bytes, entry + 32);
  }
  return parts > 0;
}

// libxlsxwriter does not notice what it could not write or read again: it writes to memory, and
// twice, since its parts go through files.
void write_workbook(const std::vector<Table>& tables, const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  const std::vector<std::filesystem::path> before = files_in(folder);
  const std::string book = made_of(tables, file);
  if (!is_whole_workbook(book) || made_of(tables, file) != book)
    throw InputError({file.string(), "cannot be written: a part of it is lost",
                      "see whether the disk is full", ""});
  for (const std::filesystem::path& left : files_in(folder))  // nor what it could not remove
    if (left.filename().string().starts_with("tmp.") && !std::ranges::binary_search(before, left))
      remove_file(left);
  write_text_file(file, book);
}

}  // namespace glissade

#else

namespace glissade {
const bool makes_workbooks = false;
bool is_whole_workbook(std::string_view) { return false; }
void write_workbook(const std::vector<Table>&, const std::filesystem::path&) {}
}  // namespace glissade

#endif
