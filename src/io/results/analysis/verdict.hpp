// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

template <class Archive, class T>
void exchange_verdict(const Archive& archive, T& verdict) {
  list(archive, "exceedance",
       {"-", "probabilities of exceedance, the first accepted at the design earthquake (DBE)"},
       verdict.exceedance);
  exchange_prescriptions(archive, verdict.rows);
  const Columns column(archive, verdict.rows);
  column("first_case", {"-", "position in `cases` of the first building period's first"},
         &VerdictRow::first_case);
  column("condition", {"-", "what the study lists of it but the building period"},
         &VerdictRow::condition);
  column("mu", {"-", "coefficient of friction, mean over the samples"}, &VerdictRow::mu);
  column("slope_deg", {"deg", "slope of the roof, mean over the samples"}, &VerdictRow::slope_deg);
  column("within_conditions", {"-", "1: slope and friction meet the standard's conditions"},
         &VerdictRow::within_conditions);
  column("dbe_probability", {"-", "that the prescribed displacement is exceeded at S_DS"},
         member(&VerdictRow::dbe, &VerdictProbability::probability));
  column("dbe_probability", {"-", "95 % interval of that"},
         member(&VerdictRow::dbe, &VerdictProbability::interval));
  column("dbe_period_s", {"s", "building period where it is largest"},
         member(&VerdictRow::dbe, &VerdictProbability::period_s));
  column("mce_probability", {"-", "the same at 1.5 S_DS"},
         member(&VerdictRow::mce, &VerdictProbability::probability));
  column("mce_probability", {"-", "95 % interval of that"},
         member(&VerdictRow::mce, &VerdictProbability::interval));
  column("mce_period_s", {"s", "building period where it is largest"},
         member(&VerdictRow::mce, &VerdictProbability::period_s));
  column("displacement_m", {"m", "exceeded at S_DS with each probability, by (row, probability)"},
         &VerdictRow::displacement_m);
  column("displacement_m", {"m", "95 % intervals of these"}, &VerdictRow::displacement_interval);
}

}  // namespace glissade
