// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "glissade/study/config.hpp"
#include "glissade/study/run/history_table.hpp"
#include "run/histories.hpp"

namespace glissade {

/// Appends the capacities of cases whose levels are the last in `fields`.
void find_capacities(const StudyConfig& config, std::span<const std::unique_ptr<Histories>> cases,
                     TwoAxisBatch& batch, HistoryFields& fields, WorkCount& count);

}  // namespace glissade
