// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

// Records that depend on each other, as those of one event, are one independent unit. `unit_of`
// numbers the units from 0, by record; empty: each record is one.
namespace glissade {

inline std::size_t unit_at(const std::vector<std::size_t>& unit_of, std::size_t record) {
  return unit_of.empty() ? record : unit_of[record];
}
inline std::size_t unit_count(const std::vector<std::size_t>& unit_of, std::size_t records) {
  return unit_of.empty() ? records : 1 + *std::ranges::max_element(unit_of);
}

}  // namespace glissade
