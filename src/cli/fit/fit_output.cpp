// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit/fit_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "glissade/core/finite.hpp"
#include "glissade/report/format.hpp"
#include "shared/finding.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* key_of(ShapeModel model) {
  constexpr const char* keys[] = {"lognormal", "logit",    "complementary_log_log",
                                  "two_part",  "monotone", "one_surface"};
  return keys[static_cast<std::size_t>(model)];
}

bool is_fitted(const ModelScore& model) { return !std::isnan(model.score); }

void show(const char* name, const std::string& text) {
  if (!text.empty()) put("{:<18} {}\n", name, text);
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

std::vector<Finding> findings_of(const FitSummary& f) {
  const bool has_floor = f.curve.floor > 0.0;
  const bool is_known = has_floor || !std::isnan(f.curve.median);
  return {{"median", "median", f.curve.median, f.median_interval},
          {"log_std", f.is_bound() ? "log_std (assumed)" : "log_std", f.curve.log_std,
           f.log_std_interval},
          {"floor", has_floor ? "floor" : "", is_known ? f.curve.floor : nan, f.floor_interval},
          {"p50", has_floor ? "50 % of all at" : "", f.curve.intensity_at(0.5), f.p50_interval},
          {"log_likelihood", "log likelihood", f.log_likelihood}};
}

Finding effective_records(double number) {
  return {"effective_records", "effective records", number};
}

std::string note_of(const FitOutput& output) {
  std::string note = output.cloud ? "" : output.fit.note;
  for (const std::string& one : output.notes) note += (note.empty() ? "" : "; ") + one;
  return note;
}

Json json_of(const FitOutput& output) {
  const FitSummary& f = output.fit;
  Json json = to_json(findings_of(f));
  json.update({{"method", f.method},
               {"interval_method", f.interval_method},
               {"status", to_string(f.status)},
               {"converged", f.converged()},
               {"note", note_of(output)},
               {"warning", output.warning}});
  if (!std::isnan(f.effective_records))
    json.update(to_json({effective_records(f.effective_records)}));
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
  put("models             {}; score: log likelihood of a record that the fit has not seen\n",
      to_string(comparison.status));
  for (const ModelScore& model : comparison.models) {
    if (is_fitted(model))
      put("  {:<22} score {:.5f}, less that of the lognormal {:+.5f} (standard error {:.5f})\n",
          key_of(model.model), model.score, model.difference, model.standard_error);
  }
}

void print_cloud(const FitOutput& output, bool json);

}  // namespace

void print(const FitOutput& output, bool json) {
  if (output.cloud) return print_cloud(output, json);
  if (json) return put_json(json_of(output));
  const FitSummary& f = output.fit;
  std::vector<Finding> findings = findings_of(f);
  findings.push_back(effective_records(f.effective_records));
  const Table table = to_table("Lognormal fragility", findings);
  put("{}", table.rows.empty() ? "Lognormal fragility: not fitted\n" : to_text(table));
  show("method", f.method);
  show("intervals", f.interval_method);
  const GoodnessOfFit& fit = output.lognormal;
  if (!std::isnan(fit.p_value))
    put("goodness of fit    {}, largest gap {:.3g} at {:.4g}{}\n", format_p(fit.p_value),
        fit.largest_gap, fit.gap_intensity, departs_from_lognormal(fit) ? ": not lognormal" : "");
  if (output.models) show_models(*output.models);
  show("status", to_string(f.status));
  show("note", note_of(output));
}

namespace {

void print_cloud(const FitOutput& output, bool json) {
  const CloudSummary& cloud = *output.cloud;
  const TwoPartFit& f = cloud.fit;
  const std::vector<Finding> any{{"median", "median", f.any.median, cloud.any_median_interval},
                                 {"log_std", "log_std", f.any.log_std, cloud.any_log_std_interval}};
  const std::vector<Finding> size{{"intercept", "intercept", f.intercept, cloud.intercept_interval},
                                  {"slope", "slope", f.slope, cloud.slope_interval},
                                  {"log_std", "log_std", f.log_std, cloud.log_std_interval}};
  const Finding effective = effective_records(cloud.effective_records);
  if (json) {
    Json of{{"any_slip", {{"status", any_text(f.any_status)}}},
            {"size", {{"status", size_text(f.size_status)}}},
            {"effective_records", effective.value},
            {"converged", f.has_curve()},
            {"note", note_of(output)},
            {"warning", output.warning},
            {"thresholds", Json::array()}};
    of["any_slip"].update(to_json(any));
    of["size"].update(to_json(size));
    if (cloud.collapse) {
      of["collapse"] = to_json(findings_of(*cloud.collapse));
      of["collapse"]["status"] = to_string(cloud.collapse->status);
    }
    for (const CloudMedian& row : cloud.medians) {
      of["thresholds"].push_back({{"threshold", row.threshold}});
      of["thresholds"].back().update(to_json({{"p50", "", row.p50, row.p50_interval}}));
    }
    return put_json(of);
  }
  std::vector<Finding> medians;
  for (const CloudMedian& row : cloud.medians)
    medians.push_back(
        {"p50", fmt::format("above {:g} at", row.threshold), row.p50, row.p50_interval});
  medians.push_back(effective);
  if (cloud.collapse)
    put("{}\n",
        to_text(to_table(fmt::format("Collapse (edp inf): {}", to_string(cloud.collapse->status)),
                         findings_of(*cloud.collapse))));
  put("{}\n{}\n{}", to_text(to_table(fmt::format("Any slip: {}", any_text(f.any_status)), any)),
      to_text(to_table(fmt::format("Size of slip: {}", size_text(f.size_status)), size)),
      to_text(to_table("Intensity at which 50 % exceed", medians)));
  show("status", f.has_curve() ? "two-part fit" : "no curve");
  show("note", note_of(output));
}

}  // namespace

}  // namespace glissade::cli
