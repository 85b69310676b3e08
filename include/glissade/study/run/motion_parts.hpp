// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/plan/plan.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

// What the results contain of the motions alone, mostly spectra: as much work as thousands of
// histories, in parts that any rank computes, in any order.
std::size_t motion_part_count(const Plan& plan);
std::vector<double> motion_part(const Plan& plan, std::size_t part);

/// Suites and records of the results, from all parts.
void put_motions(const Plan& plan, const std::vector<std::vector<double>>& parts, Results& results);

}  // namespace glissade
