// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

template <class Archive, class R>
void exchange_rare(const Archive& archive, const IntensityScale& scale, R& rare) {
  archive.attribute("widening", rare.widening);
  list(archive, "weight", {"-", "by sample: probability over that of the widened distributions"},
       rare.weights);
  const Columns column(archive, rare.rows, "threshold_m");
  column("threshold_m", {"m", "clearance threshold"}, &RareRow::threshold_m);
  column("first_case", {"-", "position in `cases` of the combination's first"},
         &RareRow::first_case);
  column("condition", {"-", "which combination of what the study lists"}, &RareRow::condition);
  column(scale.level, {scale.unit, "intensity level"}, &RareRow::level);
  column("probability", {"-", "that displacement reaches the threshold"}, &RareRow::probability);
  column("sampling", {"-", "95 % interval of the samples, on these records"},
         &RareRow::sampling_interval);
  column("record", {"-", "95 % interval, bootstrap over records"}, &RareRow::record_interval);
  column("effective_records", {"-", "number of records that carry the probability"},
         &RareRow::effective_records);
  column("plain_samples", {"-", "samples of plain Monte Carlo with the same sampling error"},
         &RareRow::plain_samples);
  column("effective_samples", {"-", "number of samples that carry the probability"},
         &RareRow::effective_samples);
}

/// A group of its own, where there are any.
template <class Archive, class Rows>
void exchange_sampling_errors(const Archive& archive, Rows& rows) {
  constexpr auto group = "sampling_error";
  if constexpr (Archive::reads) {
    if (!archive.has(group)) return;
  } else {
    if (rows.empty()) return;
  }
  const auto inside = archive.group(group);
  const Columns column(inside, rows, "threshold_m");
  column("threshold_m", {"m", "clearance threshold"}, &SamplingErrorRow::threshold_m);
  column("label", {"-", "of the run"}, &SamplingErrorRow::label);
  column("median", {"-", "median of the fit on capacities"}, &SamplingErrorRow::median);
  column("record_error", {"-", "standard error of ln median from the number of records"},
         &SamplingErrorRow::record_error);
  column("sampling_error", {"-", "standard error of ln median from the samples"},
         &SamplingErrorRow::sampling_error);
}

template <class Archive, class T>
void exchange_reached_target(const Archive& archive, T& target) {
  archive.attribute("target_error", target.target_error);
  archive.attribute("error", target.error);
  archive.attribute("scrambles", target.scrambles);
  archive.attribute("most_scrambles", target.most_scrambles);
}

}  // namespace glissade
