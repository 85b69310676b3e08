// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/fit_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "text/csv_rows.hpp"

namespace glissade {
namespace {

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

FitColumns columns_of(const NumberRow& row) {
  return {row.has_record, row.has_event, row.has_weight};
}

/// Significant digits of a decimal number; 0 of infinity.
std::size_t digits_of(double x) {
  if (!std::isfinite(x)) return 0;
  std::string digits = fmt::format("{:.14e}", x);
  digits.resize(digits.find('e'));
  return digits.find_last_not_of(".0") == std::string::npos
             ? 0
             : std::max<std::size_t>(1, digits.find_last_not_of("0"));
}

/// The numbers of each record, and whether they are too many to be another's by coincidence.
class RecordNumbers {
 public:
  void add(const NumberRow& row, std::size_t evidence) {
    if (!row.has_record) return;
    auto& [rows, sum] = of_[row.record];
    rows.push_back(row.values);
    sum += evidence;
  }
  SameRecords same(const std::vector<std::string>& names, std::size_t enough) {
    std::map<Rows, std::size_t> first;
    for (auto& [record, of] : of_) {
      std::ranges::sort(of.first);
      if (of.second < enough) continue;
      const auto [at, is_new] = first.emplace(of.first, record);
      if (!is_new && record < names.size()) return names[at->second] + " and " + names[record];
    }
    return "";
  }

 private:
  using Rows = std::vector<std::vector<double>>;
  std::map<std::size_t, std::pair<Rows, std::size_t>> of_;
};
constexpr std::size_t enough_digits = 6, enough_levels = 6;

}  // namespace

CountsInput read_counts(const std::filesystem::path& file) {
  CountsInput counts;
  RecordNumbers of_records;
  std::map<std::pair<double, std::size_t>, std::size_t> line_of;
  const auto take = [&](const NumberRow& row) -> RowTrouble {
    const Stripe stripe{row.values[0], row.values[1], row.values[2], row.weight, row.unit()};
    if (std::string trouble = trouble_with(stripe); !trouble.empty()) return {trouble};
    const auto [first, is_new] = line_of.emplace(std::pair(stripe.intensity, row.record), row.line);
    if (!is_new && !row.has_weight && (row.has_record || !row.has_event))
      return {fmt::format("this im is already on line {}: add the counts up", first->second), "",
              "again"};
    counts.has = columns_of(row);
    counts.rows.push_back(stripe);
    const bool some = stripe.exceedances > 0 && stripe.exceedances < stripe.trials;
    of_records.add(row, some && stripe.trials >= 10 ? 1 : 0);
    return {};
  };
  const std::vector<std::string> names = read_number_rows(
      file, {{{"im", "num_gms", "num_exceed"}, take}}, BesideNumbers::record_and_weight);
  counts.same = of_records.same(names, enough_levels);
  return counts;
}

CapacitiesInput read_capacities(const std::filesystem::path& file) {
  CapacitiesInput capacities;
  RecordNumbers of_records;
  const auto keep = [&](const NumberRow& row) {
    capacities.has = columns_of(row);
    capacities.brackets = row.values.size() == 2;
    capacities.rows.push_back({row.values.front(), row.values.back(), row.weight, row.unit()});
    of_records.add(row, capacities.brackets ? 0 : digits_of(row.values.front()));
    return RowTrouble();
  };
  const auto take = [&](const NumberRow& row) -> RowTrouble {
    const double capacity = row.values.front();
    if (!(capacity >= 0.0)) return {"im_cap is below 0"};
    if (capacity == 0.0 && row.has_weight)
      return {"im_cap is 0 (exceeds without shaking), which weights do not allow"};
    return keep(row);
  };
  const auto take_bracket = [&](const NumberRow& row) -> RowTrouble {
    const double low = row.values.front(), high = row.values.back();
    if (!(low >= 0.0 && high > 0.0 && low <= high))
      return {"im_low to im_high is not a range: 0 <= im_low <= im_high"};
    return keep(row);
  };
  const std::vector<std::string> names = read_number_rows(
      file, {{{"im_cap"}, take, "im_cap"}, {{"im_low", "im_high"}, take_bracket, "im_high", true}},
      BesideNumbers::record_and_weight);
  capacities.same = of_records.same(names, enough_digits);
  return capacities;
}

CloudInput read_cloud(const std::filesystem::path& file) {
  CloudInput cloud;
  RecordNumbers of_records;
  const auto take = [&](const NumberRow& row) -> RowTrouble {
    if (!(row.values[0] > 0.0)) return {"im is not above 0"};
    if (!(row.values[1] >= 0.0)) return {"edp is below 0"};
    cloud.has = columns_of(row);
    cloud.rows.push_back({row.values[0], row.values[1], row.weight,
                          cloud.has.unit() ? row.unit() : cloud.rows.size()});
    of_records.add(row, digits_of(row.values[1]));
    return {};
  };
  const std::vector<std::string> names =
      read_number_rows(file, {{{"im", "edp"}, take, "edp"}}, BesideNumbers::record_and_weight);
  cloud.same = of_records.same(names, enough_digits);
  return cloud;
}

}  // namespace glissade
