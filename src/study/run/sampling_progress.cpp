// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/sampling_progress.hpp"

#include <algorithm>

namespace glissade {

void SamplingProgress::add_block(const std::vector<UnitResult>& units) {
  if (!plan_.config.sampling.target) return;
  const std::uint64_t block = medians_.blocks();
  const SampleBlocks blocks = plan_.config.sampling.blocks();
  const std::size_t begin = block == 0 ? 0 : plan_.unit_ends[block - 1],
                    depth = capacities_.thresholds;
  std::vector<double>& all = capacities_.fields.capacity;
  all.resize(capacities_.records * capacities_.cases * depth);
  const auto place = [&](std::size_t record, std::size_t c) {
    return all.begin() + static_cast<std::ptrdiff_t>((record * capacities_.cases + c) * depth);
  };
  for (const UnitResult& unit : units) {
    if (unit.unit < begin || unit.unit >= plan_.unit_ends[block]) continue;
    const WorkUnit& work = plan_.units[unit.unit];
    auto from = unit.fields.capacity.begin();
    for (std::size_t i = 0; i < work.count; ++i, from += static_cast<std::ptrdiff_t>(depth))
      std::copy_n(from, depth, place(work.record, plan_.order[work.first + i]));
  }
  for (std::size_t i = 0; i < plan_.cases.size(); ++i) {
    if (plan_.same_as[i] == i || plan_.cases.block(i, blocks) != block) continue;
    for (std::size_t record = 0; record < plan_.records.size(); ++record)
      std::copy_n(place(record, plan_.same_as[i]), depth, place(record, i));
  }
  medians_.add(plan_.cases, capacities_, plan_.config.intensity.levels.back(), blocks);
}

bool SamplingProgress::is_enough() const {
  const auto& target = plan_.config.sampling.target;
  if (!target || medians_.blocks() < least_scrambles) return false;
  for (std::size_t row = 0; row < medians_.rows(); ++row) {
    if (half_width(medians_.standard_error(row), medians_.blocks()) > target->error) return false;
  }
  return true;
}

}  // namespace glissade
