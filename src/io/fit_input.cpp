// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/fit_input.hpp"

#include <cmath>
#include <functional>
#include <map>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "scan.hpp"

namespace glissade {
namespace {

/// Why a row is refused: nothing if it is taken.
using TakeRow = std::function<std::string(const std::vector<double>& values, std::size_t line)>;

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

/// Reads the rows below `header`, which must be there, collecting the problems of all rows.
void read_table(const std::filesystem::path& file, const std::vector<std::string_view>& header,
                const TakeRow& take_row) {
  std::string header_text;
  for (const std::string_view name : header)
    header_text += (header_text.empty() ? "" : ",") + std::string(name);
  const std::string text = read_text_file(file);
  ProblemList problems;
  LineReader reader(text);
  bool has_header = false;
  std::size_t rows = 0;
  while (reader.next()) {
    if (is_blank_or_comment(reader.line())) continue;
    const auto parts = fields(reader.line());
    if (!has_header) {
      if (parts != header) {
        throw InputError({place(file, reader.number()),
                          in_quotes(trimmed(reader.line())) + " is not the header " + header_text,
                          "make the first line " + header_text, ""});
      }
      has_header = true;
      continue;
    }
    ++rows;
    std::vector<double> values;
    std::string trouble = trouble_with(parts, header.size(), values);
    if (trouble.empty()) trouble = take_row(values, reader.number());
    if (!trouble.empty())
      problems.add({place(file, reader.number()), trouble, "",
                    "  " + std::string(reader.line().substr(0, 100))});
  }
  if (rows == 0) {
    problems.add({file.string(),
                  has_header ? "there are no rows below the header" : "the file is empty",
                  "begin with " + header_text + " and give a row for each value", ""});
  }
  problems.throw_if_any();
}

std::string trouble_with(const Stripe& stripe) {
  const auto is_whole = [](double x) { return x == std::floor(x) && x < 1e15; };
  if (!(stripe.intensity > 0.0)) return "im is not above 0";
  if (!is_whole(stripe.trials) || stripe.trials < 1.0)
    return "num_gms is not a whole number above 0";
  if (!is_whole(stripe.exceedances) || stripe.exceedances < 0.0)
    return "num_exceed is not a whole number, 0 or more";
  if (stripe.exceedances > stripe.trials) return "num_exceed is larger than num_gms";
  return "";
}

}  // namespace

std::vector<Stripe> read_counts(const std::filesystem::path& file) {
  std::vector<Stripe> stripes;
  std::map<double, std::size_t> line_of;
  read_table(file, {"im", "num_gms", "num_exceed"},
             [&](const std::vector<double>& values, std::size_t line) {
               const Stripe stripe{values[0], values[1], values[2]};
               std::string trouble = trouble_with(stripe);
               if (!trouble.empty()) return trouble;
               if (const auto [first, is_new] = line_of.emplace(stripe.intensity, line); !is_new) {
                 return "this im is already on line " + std::to_string(first->second) +
                        ": add the counts up";
               }
               stripes.push_back(stripe);
               return trouble;
             });
  return stripes;
}

std::vector<double> read_capacities(const std::filesystem::path& file) {
  std::vector<double> capacities;
  read_table(file, {"im_cap"}, [&](const std::vector<double>& values, std::size_t) -> std::string {
    if (!(values[0] >= 0.0)) return "im_cap is below 0";
    capacities.push_back(values[0]);
    return "";
  });
  return capacities;
}

}  // namespace glissade
