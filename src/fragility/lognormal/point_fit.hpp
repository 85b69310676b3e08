// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "lognormal/likelihood.hpp"

namespace glissade::fragility {

/// A fit without its intervals. A bound has no line.
struct PointFit {
  FitStatus status = FitStatus::failed;
  ProbitLine line = ProbitLine::Zero();
  std::string note = {};

  bool is_bound() const {
    return status == FitStatus::lower_bound || status == FitStatus::upper_bound;
  }
};

/// Maximum likelihood, of exact capacities with n - 1; or what the rows allow instead.
PointFit fit_point(const LogRows& rows, const ProbitLine& start);
/// The same of the penalised likelihood.
PointFit fit_jeffreys(const LogRows& counts);
/// Maximum likelihood; penalised where the counts are separated.
PointFit fit_counts(const LogRows& counts);

/// A line of positive slope to start from.
ProbitLine first_guess(const LogRows& rows);

/// The summary where none of the trials exceeded, or all of them did.
FitSummary summarise_bound(const LogRows& trials);
inline constexpr auto note_on_floor =
    "a share (the floor) exceeds without any shaking; median and log_std are those of the rest";
void add_sentence(std::string& note, const std::string& sentence);

/// The summary where every history exceeds without shaking.
FitSummary summarise_always();

}  // namespace glissade::fragility
