// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"

// What results files of every kind hold alike.
namespace glissade {

/// How datasets of intensities are named, and their unit.
struct IntensityScale {
  const char* unit;
  std::string suffix;  ///< "_g"
  std::string level = "level" + suffix;
};

/// A choice as an attribute.
template <class E, class Archive, class Value>
void name_attribute(const Archive& archive, const std::string& name, EnumNames<E> names,
                    Value& value) {
  std::string text;
  if constexpr (!Archive::reads) text = name_of<E>(names, value);
  archive.attribute(name, text);
  if constexpr (Archive::reads) value = value_of<E>(names, text);
}

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
      archive, "magnitude", {"-", "moment magnitude; 0 where not given"}, records,
      [](auto& r) -> auto& { return r.magnitude; });
  column(
      archive, "distance_km", {"km", "rupture distance; 0 where not given"}, records,
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
  // The average over the target from 0 to 2 s, between the periods above too; nan without a target.
  archive.attribute("lowest_ratio_to_target", spectra.to_target.lowest.ratio);
  archive.attribute("lowest_ratio_at_period_s", spectra.to_target.lowest.period_s);
  archive.attribute("highest_ratio_to_target", spectra.to_target.highest.ratio);
  archive.attribute("highest_ratio_at_period_s", spectra.to_target.highest.period_s);
}

}  // namespace glissade
