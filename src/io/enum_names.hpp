// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/fragility/fit.hpp"
#include "glissade/study/config.hpp"
#include "toml_table.hpp"

namespace glissade {

// The names enumerations have in study files and in results files.

inline EnumNames<IntensityMeasure> measure_names() {
  static constexpr EnumNames<IntensityMeasure> names = {{"sds_g", IntensityMeasure::sds_g},
                                                        {"pga_g", IntensityMeasure::pga_g},
                                                        {"sa_g", IntensityMeasure::sa_g},
                                                        {"avg_sa_g", IntensityMeasure::avg_sa_g},
                                                        {"ppa_g", IntensityMeasure::ppa_g}};
  return names;
}

inline EnumNames<Standard> standard_names() {
  static constexpr EnumNames<Standard> names = {{"seaoc_pv1_2012", Standard::seaoc_pv1_2012},
                                                {"asce7_16", Standard::asce7_16}};
  return names;
}

inline EnumNames<Provenance> provenance_names() {
  static constexpr EnumNames<Provenance> names = {{"checked", Provenance::checked},
                                                  {"recalled", Provenance::recalled}};
  return names;
}

inline EnumNames<FitStatus> fit_status_names() {
  static constexpr EnumNames<FitStatus> names = {
      {"failed", FitStatus::failed},
      {"maximum_likelihood", FitStatus::maximum_likelihood},
      {"jeffreys_penalised", FitStatus::jeffreys_penalised},
      {"lower_bound", FitStatus::lower_bound},
      {"upper_bound", FitStatus::upper_bound},
      {"no_trend", FitStatus::no_trend},
      {"always_exceeds", FitStatus::always_exceeds}};
  return names;
}

}  // namespace glissade
