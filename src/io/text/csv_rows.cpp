// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/csv_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "glissade/core/error.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

/// The first rows of each kind of trouble, and how many more there are: a file has thousands.
class Troubles {
 public:
  explicit Troubles(std::size_t shown) : shown_(shown) {}
  void add(const RowTrouble& trouble, const std::string& where, std::string_view line) {
    std::size_t& count = count_[trouble.kind];
    if (++count > shown_) return;
    if (count == shown_) last_[trouble.kind] = problems_.size();
    problems_.push_back(
        {where, trouble.what, trouble.suggestion, "  " + std::string(line.substr(0, 100))});
  }
  void throw_if_any() {
    ProblemList list;
    for (const auto& [kind, at] : last_) {
      if (const std::size_t more = count_[kind] - shown_; more > 0)
        problems_[at].what += fmt::format(" (and so {} more)", more);
    }
    for (const Problem& problem : problems_) list.add(problem);
    list.throw_if_any();
  }

 private:
  std::size_t shown_;
  std::vector<Problem> problems_;
  std::map<std::string, std::size_t> count_, last_;  ///< by kind: rows, the last that is shown
};

std::string headers_of(const std::vector<NumberRows>& known) {
  std::vector<std::string> headers;
  for (const NumberRows& rows : known)
    headers.push_back(fmt::format("{}", fmt::join(rows.header, ",")));
  return fmt::format("{}", fmt::join(headers, " or "));
}

/// Reads the rows of one file of numbers.
class NumberFile {
 public:
  NumberFile(const std::vector<NumberRows>& known, BesideNumbers beside)
      : known_(known), beside_(beside) {}

  bool take_header(const std::string& where, std::string_view line, const Cells& names) {
    Cells wanted = names;
    const auto take = [&](std::string_view name) {
      if (beside_ != BesideNumbers::record_and_weight || std::ranges::count(names, name) != 1)
        return false;
      std::erase(wanted, name);
      return true;
    };
    row_.has_record = take("record");
    row_.has_event = take("event");
    row_.has_weight = take("weight");
    const auto found = std::ranges::find_if(known_, [&](const NumberRows& rows) {
      return std::ranges::is_permutation(rows.header, wanted);
    });
    if (found == known_.end()) {
      refuse_separators(where, line, ";");
      const std::string headers = headers_of(known_);
      throw InputError(
          {where,
           in_quotes(trimmed(line)) + " is not the header " + headers +
               (beside_ == BesideNumbers::record_and_weight ? " (record, event and weight may be "
                                                              "added)"
                                                            : ""),
           "make the first line " + headers, ""});
    }
    rows_ = &*found;
    row_.values.resize(rows_->header.size());
    names_.assign(names.begin(), names.end());
    return true;
  }

  RowTrouble take_row(const Cells& cells, std::size_t line) {
    row_.line = line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool is_record = names_[i] == "record" && row_.has_record,
                 is_event = names_[i] == "event" && row_.has_event;
      if (is_record || is_event) {
        if (cells[i].empty())
          return {names_[i] + " is not named here, but in other rows",
                  "name it in every row, or leave the column out", names_[i]};
        Numbers& numbers = is_record ? records_ : events_;
        (is_record ? row_.record : row_.event) =
            numbers.emplace(cells[i], numbers.size()).first->second;
        continue;
      }
      const bool may_be_infinite = names_[i] == rows_->may_be_infinite;
      auto value = parse_number(cells[i]);
      if (may_be_infinite && rows_->may_be_empty && cells[i].empty()) value = INFINITY;
      if (!value || !(std::isfinite(*value) || (may_be_infinite && *value > 0.0)))
        return {in_quotes(cells[i]) + " is not a finite number", "", "number"};
      if (names_[i] == "weight" && row_.has_weight) {
        if (*value < 0.0) return {"weight is below 0", ""};
        row_.weight = *value;
        any_weight_ |= *value > 0.0;
      } else {
        const auto at = std::ranges::find(rows_->header, names_[i]) - rows_->header.begin();
        row_.values[static_cast<std::size_t>(at)] = *value;
      }
    }
    if (row_.has_record && row_.has_event &&
        event_of_.emplace(row_.record, row_.event).first->second != row_.event)
      return {"the record is of another event in a row above", "give each record one event",
              "event"};
    return rows_->take_row(row_);
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all(records_.size());
    for (const auto& [name, number] : records_) all[number] = name;
    return all;
  }
  bool has_no_weight() const { return row_.has_weight && !any_weight_; }

 private:
  const std::vector<NumberRows>& known_;
  BesideNumbers beside_;
  const NumberRows* rows_ = nullptr;
  std::vector<std::string> names_;
  using Numbers = std::map<std::string, std::size_t, std::less<>>;
  Numbers records_, events_;
  std::map<std::size_t, std::size_t> event_of_;  // by record
  NumberRow row_;
  bool any_weight_ = false;
};

/// Spreadsheets write empty cells behind the last column, and rows of them. Of a row that holds
/// something the first `width` cells stay.
void drop_empty_end(Cells& cells, std::size_t width) {
  const auto used = std::ranges::find_if(cells.rbegin(), cells.rend(),
                                         [](std::string_view cell) { return !cell.empty(); });
  const auto count = static_cast<std::size_t>(cells.rend() - used);
  if (count == 0) return cells.clear();
  cells.resize(std::min(cells.size(), std::max(count, width)));
}

}  // namespace

Cells quoted_cells(std::string_view line, char separator) {
  const bool are_pairs = std::ranges::count(line, '"') % 2 == 0;  // else they are inches
  Cells cells;
  bool is_quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') is_quoted = are_pairs && !is_quoted;
    const bool has_room = cells.size() + 1 < most_fields;
    if (i < line.size() && (line[i] != separator || is_quoted || !has_room)) continue;
    std::string_view cell = trimmed(line.substr(begin, i - begin));
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"')
      cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back(cell);
    begin = i + 1;
  }
  return cells;
}

void read_csv(const TextFile& file, const CsvReader& csv) {
  refuse_no_text(file.path, file.text);
  LineReader lines(file.text);
  Troubles troubles(csv.shown_of_a_kind);
  std::size_t width = 0, rows = 0;
  while (lines.next()) {
    if (is_blank_or_comment(lines.line())) continue;
    Cells cells = csv.split(lines.line());
    drop_empty_end(cells, width);
    if (cells.empty()) continue;  // a row of commas
    const std::string where = place(file.path, lines.number());
    if (width == 0) {
      if (!csv.take_header(where, lines.line(), cells)) return;
      width = cells.size();
      continue;
    }
    ++rows;
    const RowTrouble trouble =
        cells.size() == width
            ? csv.take_row(cells, lines.number())
            : RowTrouble{fmt::format("{} column(s) where the header has {}", cells.size(), width),
                         "", "columns"};
    if (!trouble.what.empty()) troubles.add(trouble, where, lines.line());
  }
  troubles.throw_if_any();
  if (rows == 0)
    throw InputError({file.path.string(),
                      width > 0 ? "there are no rows below the header" : "the file is empty",
                      "begin with " + csv.begin_with, ""});
}

std::vector<std::string> read_number_rows(const TextFile& file,
                                          const std::vector<NumberRows>& known,
                                          BesideNumbers beside) {
  NumberFile numbers(known, beside);
  read_csv(file, {.split = fields,
                  .begin_with = headers_of(known) + " and give a row for each value",
                  .take_header =
                      [&](const auto&... of_header) { return numbers.take_header(of_header...); },
                  .take_row = [&](const auto&... of_row) { return numbers.take_row(of_row...); }});
  if (numbers.has_no_weight())
    throw InputError({file.path.string(), "every weight is 0", "give at least one above 0", ""});
  return numbers.names();
}

}  // namespace glissade
