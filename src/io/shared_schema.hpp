// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results_archive.hpp"

// What results files of every kind hold alike.
namespace glissade {

/// Which motion a row is of; the number of rows is the number of ids.
template <class Archive, class Records>
void exchange_identity(const Archive& archive, Records& records) {
  make_rows(archive, "id", records);
  column(
      archive, "id", {"-", "name of the motion in its suite"}, records,
      [](auto& r) -> auto& { return r.id; });
  column(
      archive, "event", {"-", "earthquake"}, records, [](auto& r) -> auto& { return r.event; });
  column(
      archive, "station", {"-", "station"}, records, [](auto& r) -> auto& { return r.station; });
  column(
      archive, "dt_s", {"s", "time step"}, records, [](auto& r) -> auto& { return r.dt_s; });
}

template <class Archive, class Records>
void exchange_source(const Archive& archive, Records& records) {
  column(
      archive, "magnitude", {"-", "moment magnitude; 0 where not told"}, records,
      [](auto& r) -> auto& { return r.magnitude; });
  column(
      archive, "distance_km", {"km", "rupture distance; 0 where not told"}, records,
      [](auto& r) -> auto& { return r.distance_km; });
}

/// What the spectra of a suite are: as scaled where, and of which target.
struct SpectraLabels {
  const char *records, *target;
};

template <class Archive, class Spectra>
void exchange_curves(const Archive& archive, Spectra& spectra, const SpectraLabels& labels) {
  list(archive, "period_s", {"s", "periods of the spectra"}, spectra.periods_s);
  make_rows(archive, "srss_g", spectra.srss_g, 2);
  matrix(
      archive, "srss_g", {"g", labels.records}, spectra.srss_g,
      [](auto& row) -> auto& { return row; });
  list(archive, "average_srss_g", {"g", "average over the records"}, spectra.average_srss_g);
  list(archive, "target_g", {"g", labels.target}, spectra.target_g);
}

}  // namespace glissade
