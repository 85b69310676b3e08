// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// Share of histories exceeding each threshold over intensity, for one run: observed points, the
/// fit on capacities, its 95 % band.
Figure fragility_figure(const Results& results, const RunResults& run);
/// Incremental dynamic analysis: intensity (y) over slip (x), as is the convention; each record's
/// median over samples in grey, 16th, 50th and 84th percentile over all histories.
Figure ida_figure(const Results& results, const RunResults& run);
/// Slip percentiles and what the standards prescribe, over S_DS.
Figure slip_vs_sds_figure(const Results& results, const RunResults& run);
/// Speed on first reaching each threshold, given that it is reached, over the thresholds at a few
/// levels; kinetic energy by mass beside it. Without panels where fewer than three records reach
/// any.
Figure impact_figure(const Results& results, const RunResults& run);
/// The suite's spectra, their average and the target.
Figure spectra_figure(const Results& results);

/// Every figure the results can fill: per run the fragility, then of the first run IDA and
/// slip_vs_sds (sds_g only) and impact (where the study computes it), spectra; of a design chart
/// chart_contours, chart_friction, chart_slope, with several levels chart_intensity and
/// chart_slope_levels, with several building periods chart_period, spectra.
std::vector<Figure> make_figures(const Results& results);

}  // namespace glissade
