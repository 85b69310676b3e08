// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/fragility/fit.hpp"
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

/// Maximum likelihood, or what the data allow instead. `start` is any line of positive slope.
PointFit fit_point(const StripeData& data, const ProbitLine& start);
PointFit fit_point_jeffreys(const StripeData& data, const ProbitLine& start);
PointFit fit_point(const CapacityData& data, const ProbitLine& start);

ProbitLine first_guess(const StripeData& data);
ProbitLine first_guess(const CapacityData& data);

/// Throw InputError listing every entry that breaks its rule; `where` names the data.
void check(const std::vector<Stripe>& stripes, const std::string& where);
void check(const CapacitySample& sample, const std::string& where);

StripeData to_data(const std::vector<Stripe>& stripes);
CapacityData to_data(const CapacitySample& sample, double center);
double mean_log(const std::vector<double>& values);  ///< 0 if there are none

/// The summary of stripes none or all of whose trials exceeded (all of one kind).
FitSummary summarise_bound(const StripeData& data);
inline constexpr auto note_on_floor =
    "a share (the floor) exceeds without any shaking; median and log_std are those of the rest";
void add_sentence(std::string& note, const std::string& sentence);

/// The summary where every history exceeds without shaking.
FitSummary summarise_always();

}  // namespace glissade::fragility
