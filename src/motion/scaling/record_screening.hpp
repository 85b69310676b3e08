// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glissade/motion/record_selection.hpp"

namespace glissade {

struct Screening {
  std::vector<std::size_t> candidates;  ///< indices in the library, by id
  std::vector<LeftOutRecord> left_out;
};

/// The records of the library that meet the criteria. InputError if the criteria contradict each
/// other or leave fewer records than required.
/// @param can_be_scaled asked of records that meet all else; none: every record can
Screening screen(const Suite& library, const SelectionCriteria& criteria,
                 const std::function<bool(std::size_t record)>& can_be_scaled = {});

/// Whether candidate `k` may replace the one at index `out` of a choice (its size: be added).
bool may_join(const std::vector<std::size_t>& choice, std::size_t out, std::size_t k,
              const std::vector<const std::string*>& events, std::optional<std::size_t> per_event);

}  // namespace glissade
