// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/sampling_progress.hpp"

#include <algorithm>
#include <functional>

namespace glissade {

SamplingProgress::SamplingProgress(const Plan& plan)
    : plan_(plan),
      capacities_{plan.records.size(),
                  plan.cases.size(),
                  plan.config.intensity.levels.size(),
                  plan.config.thresholds_m().size(),
                  {}} {
  if (plan.config.sampling.target)
    capacities_.fields.capacity.resize(capacities_.records * capacities_.cases *
                                       capacities_.thresholds);
}

HistoryValues<double>::iterator SamplingProgress::place(std::size_t record, std::size_t c) {
  return capacities_.fields.capacity.begin() +
         static_cast<std::ptrdiff_t>((record * capacities_.cases + c) * capacities_.thresholds);
}

void SamplingProgress::add(const UnitResult& unit) {
  if (!plan_.config.sampling.target) return;
  const WorkUnit& work = plan_.units[unit.unit];
  const auto depth = static_cast<std::ptrdiff_t>(capacities_.thresholds);
  auto from = unit.fields.capacity.begin();
  for (std::size_t i = 0; i < work.count; ++i, from += depth)
    std::copy_n(from, depth, place(work.record, plan_.order[work.first + i]));
}

void SamplingProgress::end_block() {
  if (!plan_.config.sampling.target) return;
  const SampleBlocks blocks = plan_.config.sampling.blocks();
  for (std::size_t i = 0; i < plan_.cases.size(); ++i) {
    if (plan_.same_as[i] == i || plan_.cases.block(i, blocks) != medians_.blocks()) continue;
    for (std::size_t record = 0; record < plan_.records.size(); ++record)
      std::copy_n(place(record, plan_.same_as[i]), capacities_.thresholds, place(record, i));
  }
  medians_.add(plan_.cases, std::cref(plan_.cases), capacities_,
               plan_.config.intensity.levels.back(), blocks);
}

bool SamplingProgress::is_enough() const {
  const SamplingConfig& sampling = plan_.config.sampling;
  if (!sampling.target || medians_.blocks() < sampling.scrambles_to_target) return false;
  for (std::size_t row = 0; row < medians_.rows(); ++row) {
    if (half_width(medians_.standard_error(row), medians_.blocks()) > sampling.target->error)
      return false;
  }
  return true;
}

}  // namespace glissade
