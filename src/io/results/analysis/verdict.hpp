// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

template <class Column, class Row>
void exchange_probability(const Column& column, const std::string& at, const char* what,
                          VerdictProbability Row::*of) {
  column(at + "_probability", {"-", what}, member(of, &VerdictProbability::probability));
  column(at + "_probability", {"-", "95 % interval of that"},
         member(of, &VerdictProbability::interval));
  column(at + "_period_s", {"s", "building period where it is largest"},
         member(of, &VerdictProbability::period_s));
}

template <class Archive, class Rows>
void exchange_separations(const Archive& archive, Rows& separations) {
  const Columns column(archive, separations, "row");
  column("row", {"-", "position of the prescribed displacement in `verdict`"},
         &VerdictSeparation::row);
  column("what", {"-", "between what"}, &VerdictSeparation::what);
  column("factor", {"-", "on the prescribed displacement"}, &VerdictSeparation::factor);
  column("value_m", {"m", "the separation"}, &VerdictSeparation::value_m);
  exchange_probability(column, "dbe", "that more is needed at S_DS", &VerdictSeparation::dbe);
  exchange_probability(column, "mce", "the same at 1.5 S_DS", &VerdictSeparation::mce);
}

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
  exchange_probability(column, "dbe", "that the prescribed displacement is exceeded at S_DS",
                       &VerdictRow::dbe);
  exchange_probability(column, "mce", "the same at 1.5 S_DS", &VerdictRow::mce);
  column("displacement_m", {"m", "exceeded at S_DS with each probability, by (row, probability)"},
         &VerdictRow::displacement_m);
  column("displacement_m", {"m", "95 % intervals of these"}, &VerdictRow::displacement_interval);
  exchange_separations(archive.group("separations"), verdict.separations);
}

}  // namespace glissade
