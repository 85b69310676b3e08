// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "plot/view.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// What one standard prescribes: a line, points where it was checked, hollow where it was recalled.
void add_standard(Panel& panel, const Results& results, const RunResults& run, Standard standard,
                  Look style, int hollow_symbol) {
  if (std::ranges::count(run.standards, standard, &StandardComparison::standard) == 0) return;
  const std::string name = standard_name(standard);
  Look hollow = style;
  hollow.symbol = hollow_symbol;
  View view{standards_table(results),
            "sds",
            {{name, style, as_line, "prescribed"}},
            {{"run", run.label}, {"standard", name}}};
  for (const auto& [which, points, provenance] :
       {std::tuple{", checked", style, Provenance::checked},
        std::tuple{", recalled", hollow, Provenance::recalled}})
    view.lines.push_back({name + which,
                          points,
                          as_points,
                          "prescribed",
                          {{"provenance", provenance_label(provenance)}}});
  view.in_key = false;
  add_lines(panel, view);
  panel.series.push_back({DataSeries::Kind::line_and_points, style, "", name});
}

}  // namespace

Figure slip_vs_sds_figure(const Results& results, const RunResults& run) {
  const bool has_standards = !run.standards.empty();
  const std::string open = open_percentile(results);
  Figure figure{"slip_vs_sds",
                std::string("Slip at increasing design intensity") +
                    (has_standards ? ", and what the standards prescribe" : ""),
                run_below(results, run),
                "Peak slip in plan over all histories at each S_DS: median, 84th and 95th "
                "percentile and mean; shaded: 95 % intervals of the median and of the 84th "
                "percentile over " +
                    units_name(results) + ". " + (open.empty() ? "" : open + " ") + "Friction " +
                    friction_and_listed(results, run) + "."};
  if (has_standards) {
    figure.caption +=
        " On the right: displacements prescribed by the standards; hollow points rest on "
        "provisions recalled from memory and must be verified against the standard. Values: "
        "tables/standards.csv.";
  }
  figure.labels_at_lines = true;
  const auto panel_of_slips = [&](const char* title, const std::vector<ViewLine>& lines) {
    Panel panel{title, {results.intensity_label, 0.0, results.levels.back()}};
    add_lines(panel, {slip_table(results), "level", lines, {{"run", run.label}}});
    return panel;
  };
  const auto with_height = [](Panel panel) {
    double top_m = 0.0;  // of the lines
    for (const DataSeries& series : panel.series) top_m = std::max(top_m, largest(series.y));
    panel.y = length_axis("Peak slip in plan", top_m > 0.0 ? 1.05 * top_m : 1.0);
    return panel;
  };
  const ViewLine p95{"95th", look(Role::p95), as_line, "p95_slip"},
      p84{"84th", look(Role::p84), as_line, "p84_slip", {}, "p84_slip_low95", "p84_slip_high95"},
      mean{"mean", look(Role::mean), as_line, "mean_slip"},
      median{"median", look(Role::median), as_line, "median_slip"};
  ViewLine median_with_band = median;
  median_with_band.low = "median_slip_low95";
  median_with_band.high = "median_slip_high95";
  figure.panels.push_back(with_height(panel_of_slips("Slip", {p95, p84, mean, median_with_band})));
  if (!has_standards) return figure;
  Panel compared = panel_of_slips("Slip and prescribed displacements", {p95, median});
  // The two standards agree over a wide range: the wide line is drawn below the narrow one.
  add_standard(compared, results, run, Standard::asce7_16, {{0x999999}, 5.0, 1, 5, 1.5}, 4);
  add_standard(compared, results, run, Standard::seaoc_pv1_2012, {{0x5e3c99}, 1.5, 5, 7, 0.8}, 6);
  figure.panels.push_back(with_height(std::move(compared)));
  return figure;
}

}  // namespace glissade
