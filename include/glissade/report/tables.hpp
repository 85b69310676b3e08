// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

// The tables of a study. Every displacement is in plan; every interval is 95 %. Levels and medians
// have the unit of the intensity measure, which the title names.

/// Per run, threshold and method (stripes, capacities): the lognormal fragility and what it rests
/// on.
Table fragility_table(const Results& results);
/// Per run: what friction is, and where its cases are.
Table combinations_table(const Results& results);
/// Per run and threshold: is the fit on capacities one that the capacities can come from.
Table goodness_of_fit_table(const Results& results);
/// Per run and threshold: the fit on capacities by intensity, with its band.
Table fragility_band_table(const Results& results, std::span<const RunResults> runs);
/// Per run and threshold: the records that recross.
Table recrossing_table(const Results& results);
/// The fit to use per run and threshold, for reading: one row each.
Table fragility_summary_table(const Results& results);
/// Slip statistics per run and level.
Table slip_table(const Results& results);
/// Prescribed values beside what came out, per run, standard and S_DS. Empty without standards.
Table standards_table(const Results& results);
/// Counts of exceedances per run, threshold and level: what the stripes fit rests on.
Table stripes_table(const Results& results, std::span<const RunResults> runs);
/// Probabilities of exceedance at the levels that are the DBE or the MCE, per run and threshold:
/// the shares of the histories. Without columns of levels where the study has neither.
Table earthquakes_table(const Results& results);
/// Speed and time of first reaching each threshold per run, threshold and level, given that it is
/// reached. Empty unless the study has [impact].
Table impact_table(const Results& results);
Table records_table(const Results& results);
/// One column per record, then the average and the target where there is one.
Table spectra_table(const Results& results);
/// The sampled parameters. Friction is that of the "sampled" run.
Table samples_table(const Results& results);

/// All of the above that are files of their own, in this order; of a design chart chart (the
/// interpolation table), chart_by_period, chart_readings, chart_standards, records, spectra.
std::vector<Table> csv_tables(const Results& results);
/// Those of what the analyses found, for results.h5.
std::vector<DataTable> data_tables(const Results& results);

/// The fit on capacities where it converged, else the one on stripes where that did, else the one
/// on capacities.
const FitSummary& preferred_fit(const ThresholdFragility& fragility);

}  // namespace glissade
