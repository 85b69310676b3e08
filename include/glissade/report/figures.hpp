// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/core/file_name.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// A figure as gnuplot needs it, and as a reader does.
struct Figure {
  FileName name = "figure";  ///< of its files: "fragility"
  std::string title;         ///< one line: what is shown
  std::string caption;       ///< what to read from it and how it was made
  std::string body;  ///< gnuplot commands after the terminal and title, ending in one `plot`
  std::string data;  ///< blocks the body reads by name from NAME.dat
  int key_rows = 0;  ///< lines of the key below the plot: the drawing grows by them
};

/// Share of histories exceeding each threshold over intensity, for one run: observed points, the
/// fit on capacities, its 95 % band.
Figure fragility_figure(const Results& results, const RunResults& run);
/// Incremental dynamic analysis: intensity (y) over slip (x), as is the convention; each record's
/// median over samples in grey, 16th, 50th and 84th percentile over all histories.
Figure ida_figure(const Results& results, const RunResults& run);
/// Slip percentiles and what the standards prescribe, over S_DS.
Figure slip_vs_sds_figure(const Results& results, const RunResults& run);
/// Speed on first reaching each threshold, given that it is reached, over the thresholds at a few
/// levels; kinetic energy by mass beside it. Without data where fewer than three records reach any.
Figure impact_figure(const Results& results, const RunResults& run);
/// The suite's spectra, their average and the target.
Figure spectra_figure(const Results& results);

/// Every figure the results can fill: per run the fragility, then of the first run IDA and
/// slip_vs_sds (sds_g only) and impact (where the study asks for it), spectra; of a design chart
/// chart_contours, chart_friction, chart_slope, with several levels chart_intensity and
/// chart_slope_levels, with several building periods chart_period, spectra.
std::vector<Figure> make_figures(const Results& results);

/// Writes NAME.gp and NAME.dat and runs gnuplot on them: NAME.svg and NAME.pdf in `folder`. The
/// same figure gives the same bytes (with the same gnuplot, cairo and fonts): the PDF's creation
/// date is set to 1970. `cd folder && gnuplot NAME.gp` draws it again. Throws InputError where
/// gnuplot is not installed or does not manage, telling its message.
void render_figure(const Figure& figure, const std::filesystem::path& folder);

}  // namespace glissade
