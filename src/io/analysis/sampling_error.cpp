// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {
namespace {

void check_reached_target(const ReachedTarget& target, const Results& results) {
  expect_fit(target.scrambles > 0 && target.scrambles <= target.most_scrambles &&
                 results.cases.samples % target.scrambles == 0,
             "scrambles", "samples");
}

}  // namespace

AnalysisInFiles SamplingErrorAnalysis::in_files() {
  return {
      .exchange = Exchange::of([](const auto& root, const char*, const auto&, auto& results) {
        if_there(
            root, "sampling_error", results.sampling_errors, [](const auto& group, auto& rows) {
              const Columns column(group, rows, "threshold_m");
              column("threshold_m", {"m", "clearance threshold"}, &SamplingErrorRow::threshold_m);
              column("label", {"-", "of the run"}, &SamplingErrorRow::label);
              column("median", {"-", "median of the fit on capacities"}, &SamplingErrorRow::median);
              column("record_error",
                     {"-", "standard error of ln median from the number of records"},
                     &SamplingErrorRow::record_error);
              column("sampling_error", {"-", "standard error of ln median from the samples"},
                     &SamplingErrorRow::sampling_error);
            });
        if_there(root, "reached_target", results.reached_target,
                 [](const auto& group, auto& target) {
                   group.attribute("target_error", target.target_error);
                   group.attribute("error", target.error);
                   group.attribute("scrambles", target.scrambles);
                   group.attribute("most_scrambles", target.most_scrambles);
                 });
      }),
      .check = if_found<&Results::reached_target, check_reached_target>};
}

}  // namespace glissade
