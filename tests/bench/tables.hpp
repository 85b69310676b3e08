// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fragility_error.hpp"
#include "glissade/report/table.hpp"
#include "roof_times.hpp"
#include "work_precision.hpp"

namespace glissade::bench {

Table scheme_table(const WorkPrecision& measured);
Table group_table(const WorkPrecision& measured);
/// What the issue asks for: exact schemes to the floor, the published scheme to the exact ones,
/// with to without vertical.
Table ratio_table(const WorkPrecision& measured);
Table agreement_table(const WorkPrecision& measured);
Table roof_table(const RoofTimes& times);
Table histories_table(const FragilityError& measured);
Table fragility_table(const FragilityError& measured);
/// Schemes over one set of histories, the floor first.
Table trial_table(const std::string& name, const std::string& title,
                  const std::vector<SchemeResult>& results);

/// Every number is finite.
bool is_complete(const Table& table);

}  // namespace glissade::bench
