// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/history_table.hpp"

#include "glissade/study/config.hpp"

namespace glissade {

KeptFields::KeptFields(const StudyConfig& config)
    : vector(config.two_axes()),
      by_axis(config.two_axes() && (config.clearance || config.hazard)),
      base_shear(config.base_shear),
      tips(config.tipping.has_value()),
      crossings(config.impact) {}

double bytes_of(const StudyConfig& config, std::size_t records, std::size_t cases) {
  const KeptFields kept(config);
  const double levels = static_cast<double>(config.intensity.levels.size());
  const double thresholds = static_cast<double>(config.thresholds_m().size());
  const double numbers = 1.0 + kept.vector + 4.0 * kept.by_axis + 2.0 * kept.base_shear;
  const double flags = 2.0 + kept.tips;
  const double crossings = kept.crossings ? 2.0 * levels * thresholds : 0.0;
  const double bytes =
      levels * (numbers * sizeof(double) + flags) + (thresholds + crossings) * sizeof(double);
  return bytes * static_cast<double>(records) * static_cast<double>(cases);
}

}  // namespace glissade
