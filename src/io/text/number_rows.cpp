// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/number_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

std::string trouble_with(const std::vector<std::string_view>& parts, std::size_t columns,
                         std::vector<double>& values) {
  if (parts.size() != columns) {
    return std::to_string(parts.size()) + " column(s) where the header has " +
           std::to_string(columns);
  }
  for (const std::string_view part : parts) {
    const auto value = parse_number(part);
    if (!value || !std::isfinite(*value)) return in_quotes(part) + " is not a finite number";
    values.push_back(*value);
  }
  return "";
}

std::string headers_of(const std::vector<NumberRows>& known) {
  std::vector<std::string> headers;
  for (const NumberRows& rows : known)
    headers.push_back(fmt::format("{}", fmt::join(rows.header, ",")));
  return fmt::format("{}", fmt::join(headers, " or "));
}

}  // namespace

void read_number_rows(const std::filesystem::path& file, const std::vector<NumberRows>& known) {
  const std::string text = read_text_file(file);
  ProblemList problems;
  LineReader reader(text);
  const NumberRows* kind = nullptr;
  constexpr std::size_t most_shown = 3;
  std::size_t rows = 0, wrong = 0;
  while (reader.next()) {
    if (is_blank_or_comment(reader.line())) continue;
    const auto parts = fields(reader.line());
    if (kind == nullptr) {
      const auto found = std::ranges::find(known, parts, &NumberRows::header);
      if (found == known.end()) {
        refuse_semicolons(place(file, reader.number()), reader.line());
        throw InputError(
            {place(file, reader.number()),
             in_quotes(trimmed(reader.line())) + " is not the header " + headers_of(known),
             "make the first line " + headers_of(known), ""});
      }
      kind = &*found;
      continue;
    }
    ++rows;
    std::vector<double> values;
    std::string trouble = trouble_with(parts, kind->header.size(), values);
    if (trouble.empty()) trouble = kind->take_row(values, reader.number());
    if (!trouble.empty() && ++wrong <= most_shown)
      problems.add({place(file, reader.number()), trouble, "",
                    "  " + std::string(reader.line().substr(0, 100))});
  }
  if (wrong > most_shown)
    problems.add({file.string(), fmt::format("{} more such rows", wrong - most_shown), "", ""});
  if (rows == 0) {
    problems.add({file.string(),
                  kind != nullptr ? "there are no rows below the header" : "the file is empty",
                  "begin with " + headers_of(known) + " and give a row for each value", ""});
  }
  problems.throw_if_any();
}

}  // namespace glissade
