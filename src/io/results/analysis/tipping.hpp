// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

template <class Archive, class T>
void exchange_tipping(const Archive& archive, const IntensityScale& scale, T& tipping) {
  archive.attribute("centre_of_mass_height_m", tipping.body.centre_of_mass_height_m);
  archive.attribute("base_width_m", tipping.body.width_m);
  archive.attribute("least_friction", tipping.least_friction);
  const Columns column(archive, tipping.shares, "first_case");
  column(
      "first_case",
      {"-", "position in `cases` of the combination's first; one for each sample and orientation"},
      &TippingShare::first_case);
  column("condition", {"-", "what the study lists of it"}, &TippingShare::condition);
  column(scale.level, {scale.unit, "intensity level"}, &TippingShare::level);
  column("share", {"-", "share of histories in which the body begins to tip"},
         &TippingShare::share);
  column("share_by_record", {"-", "the same of each record, by (row, record)"},
         &TippingShare::by_record);
}

}  // namespace glissade
