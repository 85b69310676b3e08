// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/fit_input.hpp"

#include <cmath>
#include <map>

#include "text/number_rows.hpp"

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

std::vector<Stripe> read_counts(const std::filesystem::path& file) {
  std::vector<Stripe> stripes;
  std::map<double, std::size_t> line_of;
  const auto take = [&](const std::vector<double>& values, std::size_t line) {
    const Stripe stripe{values[0], values[1], values[2]};
    std::string trouble = trouble_with(stripe);
    if (!trouble.empty()) return trouble;
    if (const auto [first, is_new] = line_of.emplace(stripe.intensity, line); !is_new)
      return "this im is already on line " + std::to_string(first->second) + ": add the counts up";
    stripes.push_back(stripe);
    return trouble;
  };
  read_number_rows(file, {{{"im", "num_gms", "num_exceed"}, take}});
  return stripes;
}

std::vector<double> read_capacities(const std::filesystem::path& file) {
  std::vector<double> capacities;
  const auto take = [&](const std::vector<double>& values, std::size_t) -> std::string {
    if (!(values[0] >= 0.0)) return "im_cap is below 0";
    capacities.push_back(values[0]);
    return "";
  };
  read_number_rows(file, {{{"im_cap"}, take}});
  return capacities;
}

}  // namespace glissade
