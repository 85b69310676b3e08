// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/fit_input.hpp"

#include <fmt/format.h>

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

}  // namespace

CountsInput read_counts(const std::filesystem::path& file) {
  CountsInput counts;
  std::map<std::pair<double, std::size_t>, std::size_t> line_of;
  const auto take = [&](const NumberRow& row) -> RowTrouble {
    const Stripe stripe{row.values[0], row.values[1], row.values[2], row.weight, row.record};
    if (std::string trouble = trouble_with(stripe); !trouble.empty()) return {trouble};
    const auto [first, is_new] = line_of.emplace(std::pair(stripe.intensity, row.record), row.line);
    if (!is_new && !row.has_weight)
      return {fmt::format("this im is already on line {}: add the counts up", first->second), "",
              "again"};
    counts.has = {row.has_record, row.has_weight};
    counts.rows.push_back(stripe);
    return {};
  };
  read_number_rows(file, {{{"im", "num_gms", "num_exceed"}, take}},
                   BesideNumbers::record_and_weight);
  return counts;
}

CapacitiesInput read_capacities(const std::filesystem::path& file) {
  CapacitiesInput capacities;
  const auto keep = [&](const NumberRow& row) {
    capacities.has = {row.has_record, row.has_weight};
    capacities.brackets = row.values.size() == 2;
    capacities.rows.push_back({row.values.front(), row.values.back(), row.weight, row.record});
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
  read_number_rows(
      file, {{{"im_cap"}, take, "im_cap"}, {{"im_low", "im_high"}, take_bracket, "im_high", true}},
      BesideNumbers::record_and_weight);
  return capacities;
}

CloudInput read_cloud(const std::filesystem::path& file) {
  CloudInput cloud;
  const auto take = [&](const NumberRow& row) -> RowTrouble {
    if (!(row.values[0] > 0.0)) return {"im is not above 0"};
    if (!(row.values[1] >= 0.0)) return {"edp is below 0"};
    cloud.has = {row.has_record, row.has_weight};
    cloud.rows.push_back({row.values[0], row.values[1], row.weight, row.record});
    return {};
  };
  read_number_rows(file, {{{"im", "edp"}, take}}, BesideNumbers::record_and_weight);
  return cloud;
}

}  // namespace glissade
