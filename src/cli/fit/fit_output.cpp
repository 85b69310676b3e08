// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit/fit_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Interval& interval) { return {interval.low, interval.high}; }

const char* key_of(ShapeModel model) {
  constexpr const char* keys[] = {"lognormal", "logit",    "complementary_log_log",
                                  "two_part",  "monotone", "one_surface"};
  return keys[static_cast<std::size_t>(model)];
}

bool is_fitted(const ModelScore& model) { return !std::isnan(model.score); }

void show(const char* name, double value, const Interval& interval) {
  if (std::isnan(value)) return;
  fmt::print("{:<18} {:.6g}", name, value);
  if (!std::isnan(interval.low))
    fmt::print("   95 % interval {:.4g} to {:.4g}", interval.low, interval.high);
  fmt::print("\n");
}

void show(const char* name, const std::string& text) {
  if (!text.empty()) fmt::print("{:<18} {}\n", name, text);
}

std::string any_text(FitStatus status) {
  if (status == FitStatus::lower_bound) return "none slips";
  return status == FitStatus::upper_bound ? "all slip" : to_string(status);
}

std::string size_text(FitStatus status) {
  return status == FitStatus::failed               ? "fewer than three slip, or all on one line"
         : status == FitStatus::maximum_likelihood ? "least squares"
                                                   : to_string(status);
}

Json json_of(const FitOutput& output) {
  const FitSummary& f = output.fit;
  Json json{{"median", f.curve.median},
            {"log_std", f.curve.log_std},
            {"floor", f.curve.floor},
            {"p50", f.curve.intensity_at(0.5)},
            {"median_interval_95", to_json(f.median_interval)},
            {"log_std_interval_95", to_json(f.log_std_interval)},
            {"floor_interval_95", to_json(f.floor_interval)},
            {"log_likelihood", f.log_likelihood},
            {"method", f.method},
            {"interval_method", f.interval_method},
            {"status", to_string(f.status)},
            {"converged", f.converged()},
            {"note", f.note}};
  if (!std::isnan(f.effective_records)) json["effective_records"] = f.effective_records;
  if (!std::isnan(output.lognormal.p_value))
    json["goodness_of_fit"] = {{"p_value", output.lognormal.p_value},
                               {"distance", output.lognormal.distance},
                               {"largest_gap", output.lognormal.largest_gap},
                               {"gap_intensity", output.lognormal.gap_intensity}};
  if (output.models) {
    json["models"] = {{"status", to_string(output.models->status)}};
    for (const ModelScore& model : output.models->models) {
      if (is_fitted(model))
        json["models"][key_of(model.model)] = {{"score", model.score},
                                               {"difference", model.difference},
                                               {"standard_error", model.standard_error},
                                               {"probability", model.probability}};
    }
  }
  return json;
}

void show_models(const ShapeComparison& comparison) {
  fmt::print("models             {}\n", to_string(comparison.status));
  for (const ModelScore& model : comparison.models) {
    if (is_fitted(model))
      fmt::print("  {:<22} score {:.5f}, to lognormal {:+.5f} (standard error {:.5f})\n",
                 key_of(model.model), model.score, model.difference, model.standard_error);
  }
}

}  // namespace

void print(const FitOutput& output, bool json) {
  if (json) return fmt::print("{}\n", json_of(output).dump(2));
  const FitSummary& f = output.fit;
  show("median", f.curve.median, f.median_interval);
  show("log_std", f.curve.log_std, f.log_std_interval);
  if (f.curve.floor > 0.0) {
    show("floor", f.curve.floor, f.floor_interval);
    show("50 % of all at", f.curve.intensity_at(0.5), {});
  }
  show("effective records", f.effective_records, {});
  show("log likelihood", f.log_likelihood, {});
  show("method", f.method);
  show("intervals", f.interval_method);
  const GoodnessOfFit& fit = output.lognormal;
  if (!std::isnan(fit.p_value))
    fmt::print("goodness of fit    p = {:.3g}, largest gap {:.3g} at {:.4g}{}\n", fit.p_value,
               fit.largest_gap, fit.gap_intensity,
               departs_from_lognormal(fit) ? ": not lognormal" : "");
  if (output.models) show_models(*output.models);
  show("status", to_string(f.status));
  show("note", f.note);
}

void print(const CloudSummary& cloud, bool json) {
  const TwoPartFit& f = cloud.fit;
  if (json) {
    Json of{{"any_slip",
             {{"status", any_text(f.any_status)},
              {"median", f.any.median},
              {"median_interval_95", to_json(cloud.any_median_interval)},
              {"log_std", f.any.log_std},
              {"log_std_interval_95", to_json(cloud.any_log_std_interval)}}},
            {"size",
             {{"status", size_text(f.size_status)},
              {"intercept", f.intercept},
              {"intercept_interval_95", to_json(cloud.intercept_interval)},
              {"slope", f.slope},
              {"slope_interval_95", to_json(cloud.slope_interval)},
              {"log_std", f.log_std},
              {"log_std_interval_95", to_json(cloud.log_std_interval)}}},
            {"effective_records", cloud.effective_records},
            {"converged", f.has_curve()},
            {"thresholds", Json::array()}};
    for (const CloudMedian& row : cloud.medians)
      of["thresholds"].push_back({{"threshold", row.threshold},
                                  {"p50", row.p50},
                                  {"p50_interval_95", to_json(row.p50_interval)}});
    return fmt::print("{}\n", of.dump(2));
  }
  fmt::print("any slip           {}\n", any_text(f.any_status));
  show("  median", f.any.median, cloud.any_median_interval);
  show("  log_std", f.any.log_std, cloud.any_log_std_interval);
  fmt::print("size of slip       {}\n", size_text(f.size_status));
  show("  intercept", f.intercept, cloud.intercept_interval);
  show("  slope", f.slope, cloud.slope_interval);
  show("  log_std", f.log_std, cloud.log_std_interval);
  for (const CloudMedian& row : cloud.medians)
    show(fmt::format("50 % above {:g} at", row.threshold).c_str(), row.p50, row.p50_interval);
  show("effective records", cloud.effective_records, {});
  fmt::print("status             {}\n", f.has_curve() ? "two-part fit" : "no curve");
}

}  // namespace glissade::cli
