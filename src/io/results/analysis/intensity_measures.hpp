// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"

namespace glissade {

template <class Archive, class Rows>
void exchange_intensity_measures(const Archive& archive, Rows& rows) {
  const Columns column(archive, rows, "measure");
  column("measure", {"-", "intensity measure, or two"}, &RankedMeasure::name);
  column("run", {"-", "position of the run"}, &RankedMeasure::run);
  column("threshold_m", {"m", "clearance threshold"}, &RankedMeasure::threshold_m);
  column("pair", {"-", "1: of two measures"}, &RankedMeasure::pair);
  column("dispersion", {"-", "standard deviation of the records' ln capacity in it"},
         &RankedMeasure::dispersion);
  column("dispersion", {"-", "95 % interval of that"}, &RankedMeasure::interval);
  column("smallest_share", {"-", "share of the resamples of the records in which it ranks first"},
         &RankedMeasure::smallest_share);
  column("magnitude_slope", {"-", "of ln capacity per unit of magnitude; nan: not known"},
         &RankedMeasure::magnitude_slope);
  column("magnitude_p", {"-", "p-value of that"}, &RankedMeasure::magnitude_p);
  column("distance_slope", {"-", "of ln capacity per unit of ln distance; nan: not known"},
         &RankedMeasure::distance_slope);
  column("distance_p", {"-", "p-value of that"}, &RankedMeasure::distance_p);
  column("censored_records", {"-", "records of which half do not reach the threshold"},
         &RankedMeasure::censored_records);
}

}  // namespace glissade
