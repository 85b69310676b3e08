// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/fit_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "glissade/core/file.hpp"
#include "text/scan.hpp"

namespace glissade {
namespace {

using Names = std::vector<std::string_view>;

/// A row's numbers, by the columns that are required, and where it belongs.
struct FitRow {
  std::vector<double> values;
  double weight = 1.0;
  std::size_t record = 0;
  std::size_t line = 0;
};

/// Reads one file: its header decides which of `known` columns it has.
class FitFile {
 public:
  FitFile(const std::filesystem::path& file, std::vector<Names> known)
      : file_(file), text_(read_text_file(file)), known_(std::move(known)) {}

  /// `take` says why a row is refused: nothing if it is taken.
  void read(const std::function<std::string(const FitRow&)>& take) {
    LineReader reader(text_);
    ProblemList problems;
    std::size_t rows = 0;
    while (reader.next()) {
      if (is_blank_or_comment(reader.line())) continue;
      const auto parts = fields(reader.line());
      if (header_.empty()) {
        read_header(reader, parts);
        continue;
      }
      ++rows;
      FitRow row{.line = reader.number()};
      std::string trouble = trouble_with(parts, row);
      if (trouble.empty()) trouble = take(row);
      if (!trouble.empty())
        problems.add({place(file_, reader.number()), trouble, "",
                      "  " + std::string(reader.line().substr(0, 100))});
    }
    if (rows == 0)
      problems.add({file_.string(),
                    header_.empty() ? "the file is empty" : "there are no rows below the header",
                    "begin with " + headers() + " and give a row for each value", ""});
    if (rows > 0 && has.weight && !any_weight_ && problems.empty())
      problems.add({file_.string(), "every weight is 0", "give at least one above 0", ""});
    problems.throw_if_any();
  }

  FitColumns has;
  std::size_t kind = 0;  ///< which of `known`

 private:
  std::string headers() const {
    std::vector<std::string> all;
    for (const Names& names : known_) all.push_back(fmt::format("{}", fmt::join(names, ",")));
    return fmt::format("{}", fmt::join(all, " or "));
  }

  void read_header(const LineReader& reader, const std::vector<std::string_view>& parts) {
    Names wanted(parts.begin(), parts.end());
    const auto take = [&](std::string_view name) {
      const auto at = std::ranges::find(wanted, name);
      if (at == wanted.end()) return false;
      wanted.erase(at);
      return true;
    };
    has = {.record = take("record"), .weight = take("weight")};
    const auto found = std::ranges::find_if(
        known_, [&](const Names& names) { return std::ranges::is_permutation(names, wanted); });
    if (found == known_.end()) {
      throw InputError({place(file_, reader.number()),
                        in_quotes(trimmed(reader.line())) + " is not the header " + headers() +
                            " (record and weight may be added)",
                        "make the first line " + headers(), ""});
    }
    kind = static_cast<std::size_t>(found - known_.begin());
    for (const std::string_view part : parts) header_.emplace_back(part);
  }

  std::string trouble_with(const std::vector<std::string_view>& parts, FitRow& row) {
    if (parts.size() != header_.size())
      return fmt::format("{} column(s) where the header has {}", parts.size(), header_.size());
    const Names& names = known_[kind];
    row.values.resize(names.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (header_[i] == "record") {
        row.record = records_.emplace(parts[i], records_.size()).first->second;
        continue;
      }
      auto value = parse_number(parts[i]);
      if (header_[i] == "im_high" && parts[i].empty()) value = INFINITY;
      const bool may_be_infinite = header_[i] == "im_high" && value && *value > 0.0;
      if (!value || std::isnan(*value) || (std::isinf(*value) && !may_be_infinite))
        return in_quotes(parts[i]) + " is not a finite number";
      if (header_[i] == "weight") {
        if (*value < 0.0) return "weight is below 0";
        row.weight = *value;
        any_weight_ |= *value > 0.0;
      } else {
        const auto at = std::ranges::find(names, std::string_view(header_[i])) - names.begin();
        row.values[static_cast<std::size_t>(at)] = *value;
      }
    }
    return "";
  }

  std::filesystem::path file_;
  std::string text_;
  std::vector<Names> known_;
  std::vector<std::string> header_;
  std::map<std::string, std::size_t, std::less<>> records_;
  bool any_weight_ = false;
};

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

CountsInput read_counts(const std::filesystem::path& file) {
  FitFile in(file, {{"im", "num_gms", "num_exceed"}});
  CountsInput counts;
  std::map<std::pair<double, std::size_t>, std::size_t> line_of;
  in.read([&](const FitRow& row) {
    const Stripe stripe{row.values[0], row.values[1], row.values[2]};
    std::string trouble = trouble_with(stripe);
    if (!trouble.empty()) return trouble;
    const auto [first, is_new] = line_of.emplace(std::pair(stripe.intensity, row.record), row.line);
    if (!is_new && !in.has.weight)
      return fmt::format("this im is already on line {}: add the counts up", first->second);
    counts.rows.push_back({stripe, row.weight, row.record});
    return trouble;
  });
  counts.has = in.has;
  return counts;
}

CapacitiesInput read_capacities(const std::filesystem::path& file) {
  FitFile in(file, {{"im_cap"}, {"im_low", "im_high"}});
  CapacitiesInput capacities;
  in.read([&](const FitRow& row) -> std::string {
    const double low = row.values.front(), high = row.values.back();
    if (in.kind == 0 && !(low >= 0.0)) return "im_cap is below 0";
    if (in.kind == 1 && !(low >= 0.0 && high > 0.0 && low <= high))
      return "im_low to im_high is not a range: 0 <= im_low <= im_high";
    if (in.kind == 0 && low == 0.0 && in.has.weight)
      return "im_cap is 0 (exceeds without shaking), which weights do not allow";
    capacities.rows.push_back({low, high, row.weight, row.record});
    return "";
  });
  capacities.has = in.has;
  capacities.brackets = in.kind == 1;
  return capacities;
}

CloudInput read_cloud(const std::filesystem::path& file) {
  FitFile in(file, {{"im", "edp"}});
  CloudInput cloud;
  in.read([&](const FitRow& row) -> std::string {
    if (!(row.values[0] > 0.0)) return "im is not above 0";
    if (!(row.values[1] >= 0.0)) return "edp is below 0";
    cloud.rows.push_back({row.values[0], row.values[1], row.weight, row.record});
    return "";
  });
  cloud.has = in.has;
  return cloud;
}

}  // namespace glissade
