// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"
#include "toml/number_list.hpp"

namespace glissade {
namespace {

void read_intensity_measures(const TomlTable& root, StudyConfig& study) {
  const TomlTable table = root.table("intensity_measures");
  constexpr NumberRule period_rule{"from 0.02 to 4",
                                   [](double x) { return x >= 0.02 && x <= 4.0; }};
  IntensityMeasuresConfig& ranked = study.intensity_measures.emplace();
  if (table.has("sa_periods_s"))
    ranked.sa_periods_s = read_increasing(table, "sa_periods_s", period_rule);
}

void check_intensity_measures(const std::vector<RankedMeasure>& ranked, const Results& results) {
  for (const RankedMeasure& row : ranked)
    expect_fit(row.run < results.runs.size(), "run", "intensity_measures");
}

}  // namespace

AnalysisInFiles IntensityMeasuresAnalysis::in_files() {
  return {
      .table = "intensity_measures",
      .read = read_intensity_measures,
      .keys = {{"sa_periods_s", list_value, "0.2, 0.5, 1, 2",
                "intensity measures are ranked, spectral accelerations at these periods (0.02 to 4 "
                "s) among them"}},
      .needs = {needs_fragility,
                {"another intensity.measure than \"ppa_g\", whose factor on a record depends on "
                 "the roof",
                 [](const TomlTable&, const StudyConfig& s) {
                   return s.intensity.measure != IntensityMeasure::ppa_g;
                 }}},
      .of_any_run = true,
      .exchange = Exchange::in_group<&Results::intensity_measures>([](const auto& archive,
                                                                      const auto&, auto& rows) {
        const Columns column(archive, rows, "measure");
        column("measure", {"-", "intensity measure, or two"}, &RankedMeasure::name);
        column("run", {"-", "position of the run"}, &RankedMeasure::run);
        column("threshold_m", {"m", "clearance threshold"}, &RankedMeasure::threshold_m);
        column("pair", {"-", "1: of two measures"}, &RankedMeasure::pair);
        column("dispersion", {"-", "standard deviation of the records' ln capacity in it"},
               &RankedMeasure::dispersion);
        column("smallest_share",
               {"-", "share of the resamples of the records in which it ranks first"},
               &RankedMeasure::smallest_share);
        column("magnitude_slope", {"-", "of ln capacity per unit of magnitude; nan: not known"},
               &RankedMeasure::magnitude_slope);
        column("magnitude_p", {"-", "p-value of that"}, &RankedMeasure::magnitude_p);
        column("distance_slope", {"-", "of ln capacity per unit of ln distance; nan: not known"},
               &RankedMeasure::distance_slope);
        column("distance_p", {"-", "p-value of that"}, &RankedMeasure::distance_p);
        column("censored_records", {"-", "records of which half do not reach the threshold"},
               &RankedMeasure::censored_records);
      }),
      .check = if_found<&Results::intensity_measures, check_intensity_measures>};
}

}  // namespace glissade
