// SPDX-License-Identifier: GPL-3.0-or-later
#include "keys/hazard_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/motion/design_spectrum.hpp"
#include "text/csv_rows.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

/// The columns are the study's intensity measure and the annual rate of exceeding it.
std::optional<HazardCurve> read_curve(const TomlTable& table, const std::string& measure) {
  const std::string name = table.required_text("curve");
  table.hash_without_folders("curve");
  if (name.empty()) return {};
  std::vector<HazardPoint> points;
  const auto take = [&](const NumberRow& of_file) -> RowTrouble {
    const std::vector<double>& row = of_file.values;
    if (!(row[0] > 0.0)) return {"the intensity is not above 0"};
    if (!(row[1] > 0.0)) return {"the annual rate is not above 0: leave the row out"};
    if (!points.empty() &&
        !(row[0] > points.back().intensity && row[1] < points.back().annual_rate))
      return {"intensities must rise, and annual rates fall, from row to row"};
    points.push_back({row[0], row[1]});
    return {};
  };
  try {
    read_number_rows(table.text_file(name), {{{measure, "annual_rate"}, take}});
    return HazardCurve(points);
  } catch (const InputError& error) {
    table.report("curve", error);
    return {};
  }
}

}  // namespace

std::optional<HazardConfig> read_hazard(const TomlTable& table, const std::string& measure,
                                        double sds_g) {
  const bool by_file = table.has("curve"), by_law = table.has("k0") || table.has("k");
  // k beside S_DS alone: the law is that of the risk target.
  const bool by_target = by_law && sds_g > 0.0 && !table.has("k0");
  std::optional<HazardCurve> curve;
  std::string source;
  if (by_file == by_law)
    table.report(by_file ? "curve" : "", "[hazard] needs one hazard curve",
                 "give curve = \"FILE.csv\", or k0 and k of the annual rate k0 x^-k, or sds_g and "
                 "k of one that meets the risk target of ASCE 7");
  if (by_file) {
    curve = read_curve(table, measure);
    source = table.text("curve").value_or("");
  }
  if (by_law) {
    for (const auto& [key, example] : {std::pair{"k0", "k0 = 1e-3"}, std::pair{"k", "k = 2.2"}}) {
      if (!table.has(key) && !(by_target && std::string(key) == "k0"))
        table.report_missing(key, std::string("for example: ") + example);
    }
    const double k0 = table.number("k0", above_zero).value_or(0.0),
                 k = table.number("k", above_zero).value_or(0.0);
    if (k0 > 0.0 && k > 0.0) curve = HazardCurve::power_law(k0, k);
    source = fmt::format("{:g} x^-{:g}", k0, k);
    if (by_target && k > 0.0) {
      curve = HazardCurve::of_risk_target(mce_over_dbe * sds_g, k);
      source =
          fmt::format("assumed from S_DS = {:g} g by the risk target of ASCE 7, x^-{:g}", sds_g, k);
    }
  }
  if (!table.has("design_life_years"))
    table.report_missing("design_life_years", "for example: design_life_years = 25");
  const double years = table.number("design_life_years", above_zero).value_or(0.0);
  if (!curve || !(years > 0.0)) return std::nullopt;
  return HazardConfig{*curve, source, years, {}, sds_g, by_target};
}

void check_events(const TomlTable& table, const HazardConfig& hazard, double lowest,
                  const std::string& remedy) {
  constexpr double most_events = 1000.0;
  const double events = hazard.design_life_years * hazard.curve.annual_rate(lowest);
  if (events > most_events)
    table.report(table.has("k0") ? "k0" : "curve",
                 fmt::format("the hazard curve has {:.4g} earthquakes above the lowest level, "
                             "{:g}, in the design life; at most {:g} can be followed",
                             events, lowest, most_events),
                 remedy);
}

}  // namespace glissade
